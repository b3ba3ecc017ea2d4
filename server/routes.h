// One table of method, path, meaning and handler. It answers requests; OpenAPI and the documents
// will come from it too.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "server/config.h"
#include "server/http/message.h"
#include "server/picture.h"

namespace tia::server {

/// Service: what handlers share. Everything in it is const or its own guard.
struct Service {
  const Config& config;
  Studio studio;
  std::stop_token stopping;  ///< requested when renders must be given up
};

/// A handler takes the request and what the path's {} stands for, percent-decoded.
using Handler = Response (*)(const Request&, const std::string& name, Service&);

struct Route {
  std::string_view method;  ///< GET answers HEAD too
  std::string_view path;    ///< exact, or ending in {}: one more segment
  std::string_view about;
  Handler handler;
  /// The media types of which Accept must allow one; empty = it is not asked, or by the handler.
  std::vector<std::string_view> gives = {};
};

const std::vector<Route>& routes();

/// The whole service as a function: never throws, whatever fails becomes a problem document.
Response answer(const Request& request, Service& service);

}  // namespace tia::server
