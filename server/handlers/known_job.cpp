#include "server/handlers/known_job.h"

#include "server/http/error.h"
#include "server/jobs/jobs.h"

namespace tia::server {

Job known_job(const std::string& id, Service& service) {
  if (auto job = service.jobs.store().find(id)) return std::move(*job);
  throw HttpError("not-found", "no job has that id, any more");
}

}  // namespace tia::server
