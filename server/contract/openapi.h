// The interface as an OpenAPI 3.1 document, made from the tables that serve requests.
#pragma once

#include <string>
#include <vector>

#include "server/contract/route.h"

namespace tia::server {

/// The document of these routes, in their order. Extensions: `x-examples` of an operation are
/// targets to try, `x-problems` is the table of problems: type, title, status, description and the
/// header that comes with it.
/// Cost: milliseconds.
Value openapi_document(const std::vector<Route>& routes);

/// "/scenes/{name}": a route's path with the name of what its {} stands for.
std::string path_template(const Route& route);

}  // namespace tia::server
