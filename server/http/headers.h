// Headers that no single handler decides: what keeps a browser safe, which pages of other origins
// may read an answer (CORS), and fields that are lists.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "server/http/message.h"
#include "server/http/peers.h"

namespace tia::server {

/// Tells browsers to take an answer for nothing but what it says it is, and pages to load nothing
/// from elsewhere. Other sites may show pictures, for a URL is a picture, and load nothing else.
void guard(Response& response);

/// Lets the pages of these origins, and no others, read the answer; answers their preflights.
/// Source: WHATWG Fetch, 3.2 (CORS protocol).
void share(Response& response, const Request& request, const std::vector<Origin>& origins);

/// Says that the answer depends on this header of the request.
void add_vary(Headers& headers, std::string_view name);

/// All fields of that name as the one list that they are (RFC 9110, 5.3); "" where there is none.
std::string joined(const Request& request, std::string_view name);

std::string lower(std::string_view text);

}  // namespace tia::server
