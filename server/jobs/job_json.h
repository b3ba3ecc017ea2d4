// What is told of jobs, as JSON.
#pragma once

#include "core/input/value.h"
#include "server/jobs/job.h"

namespace tia::server {

/// Its parts, rays and the seconds that are left.
Value progress_of(const Job& job, TimeMs now);
/// All that is known of it.
Value job_status(const Job& job, TimeMs now, bool is_durable);

}  // namespace tia::server
