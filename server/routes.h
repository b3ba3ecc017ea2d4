// One table of method, path, meaning and handler, of what a request may bring and what its answer
// may be. It answers requests; the OpenAPI document and the page of documentation come from it.
#pragma once

#include <atomic>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "server/config.h"
#include "server/contract.h"
#include "server/http/message.h"
#include "server/known_targets.h"
#include "server/metrics.h"
#include "server/operation/admission.h"
#include "server/operation/cost_memory.h"
#include "server/operation/memory_account.h"
#include "server/picture_store.h"

namespace tia::server {

/// Service: what handlers share. Everything in it is const or its own guard.
struct Service {
  const Config& config;
  Studio studio;
  MemoryAccount& memory;
  Admission& admission;
  LongWork& long_work;
  CostMemory& costs;
  Metrics& metrics;
  PictureStore& pictures;
  KnownTargets targets{};
  std::function<int()> connections = [] { return 0; };  ///< that are open
  std::atomic<bool> draining = false;                   ///< the server goes down
};

/// A handler takes the request and what the path's {} stands for, percent-decoded.
using Handler = Response (*)(const Request&, const std::string& name, Service&);

/// Pace: whether an answer waits for a worker, or costs so little that it waits for nothing.
enum class Pace { in_turn, at_once };

struct Route {
  std::string_view method;  ///< GET answers HEAD too
  std::string_view path;    ///< exact, or ending in {}: one more segment
  std::string_view name;    ///< that programs call it by
  std::string_view about;
  Pace pace = Pace::at_once;
  Handler handler = nullptr;
  std::vector<Answer> answers = {};  ///< but for problems
  /// The media types of which Accept must allow one; empty = it is not asked, or by the handler.
  std::vector<std::string_view> gives = {};
  bool chooses = false;  ///< whether the handler lets Accept choose among the answer's types
  Value::Array (*query)(Definitions&) = nullptr;  ///< the parameters of a query
  std::vector<Content> body = {};                 ///< what may be sent, one of them
  Segment segment = {};                           ///< what the path's {} stands for
  std::vector<std::string_view> segments = {};    ///< all that there are; none = any text
  /// Which paths there are, where it shares its place with what is not here; null = all that fit.
  bool (*has)(std::string_view path) = nullptr;
  std::vector<std::string_view> examples = {};  ///< targets, of GET
};

/// What the {} of its path may be.
Value segment_schema(const Route& route);

/// All routes. Where two fit a path, the first is meant.
const std::vector<Route>& routes();

/// The whole service as a function: whatever fails becomes a problem document.
/// Errors: std::bad_alloc where there is no memory even for that one.
Response answer(const Request& request, Service& service);

/// The same answer where it costs next to nothing, for what it sends is there already; else none.
/// Errors: std::bad_alloc.
std::optional<Response> answer_from_memory(const Request& request, Service& service);

/// The answer to a request that failed before it came to answer(). Errors: as answer().
Response refusal(const std::exception_ptr& failure, const Request& request, const Service& service);

/// The word by which a request is counted: its route's path, "none" for what is not here; few,
/// however many targets are asked for.
std::string_view route_label(const Request& request);

/// Whether the request's route, if it has one, is answered at once.
bool is_answered_at_once(const Request& request);

}  // namespace tia::server
