// What is said of a picture that its budget may have ended.
#pragma once

#include <string>

#include "core/render/reached.h"
#include "server/http/message.h"

namespace tia::server {

/// Adds the headers that tell how far the rounds have come.
void tell_reached(const Reached& reached, Headers& headers);

/// The same picture's address without what has ended it: the query with as many samples as it came
/// to. Returns: empty where that would be too long, and for a body.
std::string address_of_reached(const Request& request, int samples);

}  // namespace tia::server
