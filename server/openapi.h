// The interface as an OpenAPI 3.1 document, made from the tables that serve requests.
#pragma once

#include <string>

#include "server/routes.h"

namespace tia::server {

/// The document. Cost: milliseconds.
Value openapi_document();

/// "/scenes/{name}": a route's path with the name of what its {} stands for.
std::string path_template(const Route& route);

}  // namespace tia::server
