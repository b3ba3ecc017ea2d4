#include "server/handlers/known_job.h"

#include "server/http/error.h"
#include "server/jobs/jobs.h"

namespace tia::server {

Job known_job(const std::string& id, const Request& request, Service& service) {
  auto job = service.jobs.store().find(id);
  if (!job) throw HttpError("not-found", "no job has that id, any more");
  service.access.check_owner(request, key_of(*job));
  return std::move(*job);
}

}  // namespace tia::server
