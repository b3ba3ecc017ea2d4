// What is said of a picture that its budget may have ended.
#pragma once

#include <cstdint>
#include <initializer_list>
#include <string>
#include <string_view>

#include "core/render/reached.h"
#include "server/http/message.h"

namespace tia::server {

/// Adds the headers that tell how far the rounds have come.
void tell_reached(const Reached& reached, Headers& headers);

/// The query without the parameters of these names, an & after each that is left.
std::string query_without(std::string_view query, std::initializer_list<std::string_view> names);

/// The same picture's address without what has ended it: the query with as many samples as it came
/// to. Returns: empty where that would be too long, and for a body.
std::string address_of_reached(const Request& request, int samples);
/// The same of a picture for a gaze, without the time that it had: with as many rays as that came
/// to.
std::string address_of_timed(const Request& request, std::int64_t gaze_rays);

}  // namespace tia::server
