#include "server/jobs/job_request.h"

#include <utility>

namespace tia::server {

JobRequest read_job_request(Value body, const std::stop_token& stop) {
  JobRequest job;
  if (auto* members = body.as<Value::Object>()) {
    const auto take = [&](const char* name, std::optional<Value>& to) {
      for (auto& [key, value] : *members)
        if (key == name) to = std::move(value);
      std::erase_if(*members, [&](const auto& member) { return member.first == name; });
    };
    take("request", job.request);
    take("requests", job.requests);
    take("grid", job.grid);
    take("views", job.views);
  }
  job.terms = read_described<JobTerms>(body, {}, stop);
  return job;
}

const Value& needed(const std::optional<Value>& member, const char* pointer, const char* allowed) {
  if (!member) throw InputError({FaultKind::missing, pointer, std::nullopt, allowed});
  return *member;
}

void refuse_member(const std::optional<Value>& member, const char* pointer, const char* allowed) {
  if (member) throw InputError({FaultKind::conflict, pointer, excerpt(*member), allowed});
}

}  // namespace tia::server
