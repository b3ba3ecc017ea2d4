// A route as data: method, path, meaning and handler, what a request may bring and what its answer
// may be. The table of them (handlers/route_table) answers requests; the OpenAPI document comes
// from it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "server/contract/contract.h"
#include "server/contract/rights.h"
#include "server/http/head.h"
#include "server/http/message.h"

namespace tia::server {

struct Config;   // the options (operation/config.h)
struct Service;  // what handlers share (handlers/service.h)

/// A handler takes the request and what the path's {} stands for, percent-decoded.
using Handler = Response (*)(const Request&, const std::string& name, Service&);

/// Pace: whether an answer waits for a worker, or costs so little that it waits for nothing.
enum class Pace { in_turn, at_once };

struct Route {
  std::string_view method;  ///< GET answers HEAD too
  std::string_view path;    ///< exact, or with {} in place of one segment
  std::string_view name;    ///< that programs call it by
  std::string_view about;
  std::vector<Right> rights = {};  ///< that a key needs for it, all of them; none: it needs no key
  Pace pace = Pace::at_once;
  Handler handler = nullptr;
  std::vector<Answer> answers = {};  ///< but for problems
  /// The media types of which Accept must allow one; empty = it is not asked, or by the handler.
  std::vector<std::string_view> gives = {};
  bool tells_result =
      false;             ///< whether it answers what a job has come to, or why there is nothing
  bool prefers = false;  ///< whether the handler reads the header Prefer
  bool chooses = false;  ///< whether the handler lets Accept choose among the answer's types
  Value::Array (*query)(Definitions&) = nullptr;  ///< the parameters of a query
  std::vector<Content> body = {};                 ///< what may be sent, one of them
  /// How long the body may be; null = as long as all others.
  BodyLimit (*body_limit)(const Config&) = nullptr;
  BodyLimit (*form_limit)(const Config&) = nullptr;  ///< the same of one that is a form
  bool keeps_body = false;  ///< a long one goes to the folder of kept models as it comes
  Segment segment = {};     ///< what the path's {} stands for
  /// What its second one does, which ends the path: the handler's name is all from the first one
  /// on.
  Segment last_segment = {};
  std::vector<std::string_view> segments = {};  ///< all that there are; none = any text
  /// Which paths there are, where it shares its place with what is not here; null = all that fit.
  bool (*has)(std::string_view path) = nullptr;
  std::vector<std::string_view> examples = {};  ///< targets, of GET
};

/// What the {} of its path may be.
Value segment_schema(const Route& route);

}  // namespace tia::server
