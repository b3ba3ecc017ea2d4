// Servers on real sockets, and clients: the library's, and one that sends any bytes.
#pragma once

#include <chrono>
#include <functional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <thread>

#include "server/http/http_server.h"
#include "tests/server/support.h"
#include "tests/server/witness.h"

namespace httplib {  // its header is long: it is for those who ask through its client
class Client;
class Result;
}  // namespace httplib

namespace tia::test {

using Clock = std::chrono::steady_clock;
using std::chrono::milliseconds;
using std::chrono::seconds;

/// Asks until the answer is yes or the time is up.
bool eventually(const std::function<bool()>& ask, Clock::duration timeout = seconds(20));

/// Server: the whole service on a free port of this machine, in this process.
class Server {
 public:
  Server();
  explicit Server(HttpOptions options);
  ~Server();
  int port() const { return http_.port(); }
  /// What the service would say without a socket.
  Host& host() { return host_; }
  httplib::Client client() const;

 private:
  Host host_;
  HttpServer http_;
  ServicePort served_{port()};
  std::thread running_;
};

/// One for all tests that need none of their own.
Server& shared_server();

/// A library's answer as a Response of ours, which the OpenAPI document must allow.
Response plain(const std::string& method, const std::string& target, const httplib::Result& result);

/// Connection: a plain socket to 127.0.0.1.
class Connection {
 public:
  /// judged: whether its answers are, which takes a watched program milliseconds each.
  explicit Connection(int port, bool judged = true);
  ~Connection();
  Connection(const Connection&) = delete;
  Connection& operator=(const Connection&) = delete;

  /// Sends all, or less where the server has closed.
  void send(std::string_view bytes);
  /// No more will be sent.
  void finish();
  bool readable(milliseconds wait = milliseconds(0)) const;
  /// The next answer (of a request that is not HEAD), or status 0 where the server closed without
  /// one. Errors: std::runtime_error if it does neither in time, or if the answer is cut.
  Response receive();
  /// Whether the server closes without a further byte.
  bool closed();

 private:
  bool more();

  Witness witness_;
  int socket_;
  std::string bytes_;  // received, not yet taken
};

/// One request on a connection of its own.
Response exchange(int port, std::string_view request);

}  // namespace tia::test
