// What a server serves and how, and what it tells of each request: all that connections and the
// rest of the server know of each other.
#pragma once

#include <chrono>
#include <cstdint>
#include <exception>
#include <functional>
#include <memory>
#include <optional>
#include <string>

#include "server/http/head.h"
#include "server/http/message.h"
#include "server/http/proxies.h"

namespace tia::server {

struct HttpOptions {
  std::string host;
  int port = 0;  ///< 0 = any free one
  std::int64_t max_body_bytes = 4 << 20;
  std::int64_t max_png_bytes = 64 << 20;  ///< of a body of type image/png
  int connections = 1024;                 ///< beyond them the one that has waited longest is closed
  int workers = 16;                       ///< requests that may be in work at once; beyond them 429
  int spare_workers = 0;  ///< of these, for clients that have fewer than two in work
  std::chrono::milliseconds deadline{30'000};  ///< from a request's last byte to its answer
  std::size_t most_held_bytes = 256 << 20;     ///< of requests and answers, of all connections
  TrustsProxy trusts_proxy = [](const std::string&) { return false; };
  /// By what clients are told apart, of their addresses.
  std::function<std::string(const std::string&)> share_of = [](const std::string& address) {
    return address;
  };
};

/// Exchange: a request that is done with.
struct Exchange {
  const Request& request;
  const Response& response;    ///< but for its body
  std::size_t body_bytes = 0;  ///< of the response
  double ms = 0;               ///< from the request's last byte to now
};

/// Application: what a server serves. All but `answer` are called on the connections' own thread.
struct Application {
  static constexpr int client_left = 499;  ///< the status of an exchange that got no answer

  /// Called on a worker, or on the connections' thread where at_once says so. What it throws is
  /// answered with `refuse`.
  std::function<Response(const Request&)> answer;
  /// The answer to what is no request, failed, or has no time or place here. Any thread may call.
  std::function<Response(const std::exception_ptr&, const Request&)> refuse;
  /// Called with each request before all others: notes who asks, and takes out what no log may
  /// know.
  std::function<void(Request&)> identify = [](Request&) {};
  /// Whether the answer costs so little that it need not wait for a worker.
  std::function<bool(const Request&)> at_once = [](const Request&) { return false; };
  /// The answer that is there already and costs next to nothing to send, or none. Called before
  /// anything that waits for a worker, or is refused for want of one.
  std::function<std::optional<Response>(const Request&)> from_memory = [](const Request&) {
    return std::nullopt;
  };
  /// How long the body of a request may be whose head this is, where it is not as all are.
  std::function<std::optional<BodyLimit>(const Request&)> body_limit = [](const Request&) {
    return std::nullopt;
  };
  /// Where the body of a request may go, as it comes, whose head this is, if it is longer than
  /// longest_held_body; null: nowhere but to memory.
  std::function<std::shared_ptr<LongBody>(const Request&)> long_body = [](const Request&) {
    return nullptr;
  };
  /// Seconds after which one who is refused for want of workers may ask again.
  std::function<int()> retry_after = [] { return 1; };
  /// Called once all work has been done and some time has passed.
  std::function<void()> rested = [] {};
  /// Told how many bytes more, or fewer, connections hold of requests and answers.
  std::function<void(std::ptrdiff_t)> held = [](std::ptrdiff_t) {};
  /// Told of every exchange before its answer's first byte is sent.
  std::function<void(const Exchange&)> answered = [](const Exchange&) {};
};

}  // namespace tia::server
