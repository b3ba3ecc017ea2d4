// Which problems the requests of a route may meet: it follows from what the route takes.
#pragma once

#include <vector>

#include "server/contract/problem_table.h"
#include "server/contract/route.h"

namespace tia::server {

/// Whether any request may meet it, and it says no more than what went wrong.
bool is_met_by_all(const ProblemRow& row);

/// The statuses of the others that a request of the route may meet, in order.
std::vector<int> problem_statuses(const Route& route);

std::vector<ProblemRow> problems_of(int status);

}  // namespace tia::server
