#include "server/contract/refusals.h"

#include <set>

namespace tia::server {
namespace {

bool meets(const Route& route, Met met) {
  switch (met) {
    case Met::by_any: return true;
    case Met::by_body: return !route.body.empty();
    case Met::by_size: return !route.body.empty() || route.pace == Pace::in_turn;
    case Met::by_write: return route.method != "GET";
    case Met::by_right: return !route.rights.empty();
    case Met::by_input:  // what a job has come to may be that its input was at fault
      return route.query != nullptr || !route.body.empty() || route.prefers || route.tells_result;
    case Met::by_name: return route.path.find("{}") != route.path.npos && route.has == nullptr;
    case Met::by_job: return route.tells_result;
    case Met::by_accept: return !route.gives.empty() || route.chooses;
    case Met::by_method: return false;  // then it is no request of the route
  }
  return false;
}

}  // namespace

bool is_met_by_all(const ProblemRow& row) { return row.met == Met::by_any && row.header.empty(); }

std::vector<int> problem_statuses(const Route& route) {
  std::set<int> statuses;
  for (const ProblemRow& row : problem_rows())
    if (!is_met_by_all(row) && meets(route, row.met)) statuses.insert(row.status);
  return {statuses.begin(), statuses.end()};
}

std::vector<ProblemRow> problems_of(int status) {
  std::vector<ProblemRow> rows;
  for (const ProblemRow& row : problem_rows())
    if (row.status == status) rows.push_back(row);
  return rows;
}

}  // namespace tia::server
