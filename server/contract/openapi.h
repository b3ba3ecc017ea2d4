// The interface as an OpenAPI 3.1 document, made from the tables that serve requests.
#pragma once

#include <string>
#include <vector>

#include "server/contract/route.h"

namespace tia::server {

/// The document of these routes. Cost: milliseconds.
Value openapi_document(const std::vector<Route>& routes);

/// "/scenes/{name}": a route's path with the name of what its {} stands for.
std::string path_template(const Route& route);

}  // namespace tia::server
