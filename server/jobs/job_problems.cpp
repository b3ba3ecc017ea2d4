#include "server/jobs/job_problems.h"

#include "core/input/json.h"
#include "server/contract/problem_table.h"

namespace tia::server {

std::string job_problem(std::string_view type, const std::string& detail) {
  const ProblemRow& row = problem_row(type);
  return to_json(Value::Object{{"type", problem_uri(row)},
                               {"title", row.title},
                               {"status", row.status},
                               {"detail", detail}});
}

std::optional<AccessRefusal> beyond_limits(const NewJob& job, const OwnerSums& sums,
                                           std::int64_t bytes) {
  const auto refusal = [](std::string_view member, const std::string& got, std::int64_t allowed,
                          const char* advice) {
    return AccessRefusal("quota", member,
                         "got " + got + ", allowed: " + std::to_string(allowed) + " (" +
                             std::string(member) + " of the key, TIA_KEYS_FILE); " + advice,
                         {{"Retry-After", "10"}});
  };
  const OwnerLimits& may = job.limits;
  if (may.unfinished && sums.unfinished >= *may.unfinished)
    return refusal("jobs", std::to_string(sums.unfinished + 1) + " unfinished jobs",
                   *may.unfinished, "wait for one to end, or cancel one");
  if (may.bytes && sums.bytes + bytes > *may.bytes)
    return refusal("kept_bytes", std::to_string(sums.bytes + bytes) + " bytes of jobs", *may.bytes,
                   "delete jobs whose results you have");
  return std::nullopt;
}

InputError by_options_of_jobs(const InputError& error) {
  constexpr std::string_view of_pictures = "TIA_MAX_RAYS", of_jobs = "TIA_MAX_JOB_RAYS";
  std::vector<Fault> faults = error.faults();
  for (Fault& fault : faults)
    if (const auto at = fault.allowed.find(of_pictures); at != fault.allowed.npos)
      fault.allowed.replace(at, of_pictures.size(), of_jobs);
  return InputError(std::move(faults));
}

std::string dead_part_problem(int n, int parts, int tries) {
  const std::string what = n < parts ? "part " + std::to_string(n) : "putting the parts together";
  return job_problem("internal", what + " has ended without a result " + std::to_string(tries) +
                                     " times (option TIA_JOB_TRIES)");
}

}  // namespace tia::server
