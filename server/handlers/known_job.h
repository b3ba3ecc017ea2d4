// The job that a path names.
#pragma once

#include <string>

#include "server/handlers/service.h"
#include "server/jobs/job.h"

namespace tia::server {

/// Errors: HttpError (not-found) where none is kept by that id; as Access::check_owner.
Job known_job(const std::string& id, const Request& request, Service& service);

}  // namespace tia::server
