// Problem documents of jobs: what is told of one that has failed.
#pragma once

#include <string>
#include <string_view>

#include "core/input/errors.h"
#include "server/access/access.h"
#include "server/jobs/job.h"

namespace tia::server {

/// One of that type of the table, without a request that it is of.
std::string job_problem(std::string_view type, const std::string& detail);
/// Of a part that has ended so often without a result.
std::string dead_part_problem(int n, int parts, int tries);

/// Why a job that takes so many bytes is more than its owner may have; none where it is not.
std::optional<AccessRefusal> beyond_limits(const NewJob& job, const OwnerSums& sums,
                                           std::int64_t bytes);

/// The same faults, where a job is bounded by options of its own, by their names.
InputError by_options_of_jobs(const InputError& error);

}  // namespace tia::server
