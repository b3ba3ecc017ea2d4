// What POST /jobs takes: what is to be drawn, in the words of its kind, and how.
#pragma once

#include <array>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "server/jobs/job.h"

namespace tia::server {

/// JobTerms: what every job may say of itself.
struct JobTerms {
  static constexpr std::string_view schema_name = "job_terms";
  std::string kind, name;
  Priority priority = Priority::normal;
  std::optional<std::int64_t> max_rays;
  std::optional<int> deadline_s;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("kind", &JobTerms::kind,
          Spec{.about = "render: one picture, drawn in windows; batch: pictures; turntable: those "
                        "of a model that is turned",
               .required = true,
               .max_bytes = longest_name});
    visit("name", &JobTerms::name,
          Spec{.about = "a name to know it by", .max_bytes = longest_name});
    visit("priority", &JobTerms::priority, Spec{.about = "whether others of its kind go first"});
    visit("max_rays", &JobTerms::max_rays,
          Spec{.about = "most rays of all kinds, of all its pictures together; else as many as "
                        "TIA_MAX_JOB_RAYS",
               .min = 1,
               .max = 9007199254740991});
    visit("deadline_s", &JobTerms::deadline_s,
          Spec{.about = "what it may take from now on; beyond it the job has failed",
               .unit = "s",
               .min = 1,
               .max = 31'536'000});
  }
};

/// JobRequest: a job as it is asked for. Which of the members below its kind has, it checks itself.
struct JobRequest {
  JobTerms terms;
  std::optional<Value> request, requests, grid, views;
};

/// Errors: InputError, pointers into the job; Stopped.
JobRequest read_job_request(Value body, const std::stop_token& stop);

/// Does something with what stands at a place of the job: its faults have pointers into the job.
/// Errors: InputError; what it throws besides.
template <class Do>
auto at_place(const std::string& place, const Do& does) {
  try {
    return does();
  } catch (const InputError& error) {
    std::vector<Fault> faults = error.faults();
    for (Fault& fault : faults) fault.pointer = place + fault.pointer;
    throw InputError(std::move(faults));
  }
}

/// The value of a member that the kind needs. Errors: InputError (missing).
const Value& needed(const std::optional<Value>& member, const char* pointer, const char* allowed);
/// Errors: InputError (conflict) where there is a member that the kind does not have.
void refuse_member(const std::optional<Value>& member, const char* pointer, const char* allowed);

}  // namespace tia::server
