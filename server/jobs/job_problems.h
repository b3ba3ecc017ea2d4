// Problem documents of jobs: what is told of one that has failed.
#pragma once

#include <string>
#include <string_view>

#include "core/input/errors.h"

namespace tia::server {

/// One of that type of the table, without a request that it is of.
std::string job_problem(std::string_view type, const std::string& detail);
/// Of a part that has ended so often without a result.
std::string dead_part_problem(int n, int parts, int tries);

/// The same faults, where a job is bounded by options of its own, by their names.
InputError by_options_of_jobs(const InputError& error);

}  // namespace tia::server
