// A farm as the options name it.
#pragma once

#include <memory>
#include <string>

#include "server/access/quotas.h"
#include "server/jobs/redis_jobs.h"
#include "server/operation/config.h"

namespace tia::server {

/// The longest name of a worker: letters, digits, '.', '-', '_'.
constexpr std::size_t longest_worker_name = 64;

/// The jobs of TIA_FARM, for a process of that name. `limits`: of jobs, by the options.
/// Errors: std::invalid_argument naming the option, or the name.
std::unique_ptr<RedisJobs> farm_jobs(const Config& config, const JobLimits& limits, FarmRole role,
                                     const std::string& name);

/// The store of TIA_STORE; null where there is none. Errors: std::invalid_argument naming the
/// option.
std::shared_ptr<Blobs> result_store(const Config& config);

/// What keys have asked for, counted by all who serve in the farm, where there is one; else in this
/// process. Errors: std::invalid_argument naming the option.
std::unique_ptr<Quotas> quotas_of(const Config& config);

/// This machine's name and the process' number.
std::string own_worker_name();

}  // namespace tia::server
