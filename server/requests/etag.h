// Conditional requests: whether a client already has what would be sent.
#pragma once

#include <string_view>

#include "server/http/message.h"

namespace tia::server {

/// Whether If-None-Match lists this entity tag, or is "*". Tags compare weakly: W/ does not matter.
/// Source: RFC 9110, 13.1.2 and 8.8.3.
bool has_already(const Request& request, std::string_view etag);

}  // namespace tia::server
