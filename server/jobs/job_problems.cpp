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
