// All about connections: cpp-httplib behind a function from Request to Response. Nothing else in
// the server knows the library.
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <string>

#include "server/http/message.h"

namespace tia::server {

struct HttpOptions {
  std::string host;
  int port = 0;  ///< 0 = any free one
  std::int64_t max_body_bytes = 4 << 20;
};

/// HttpServer: listens from its making on; serves while run() runs.
class HttpServer {
 public:
  using Answer = std::function<Response(const Request&)>;

  /// Errors: std::runtime_error if the address cannot be had, another Tia's port included.
  HttpServer(HttpOptions options, Answer answer);
  ~HttpServer();

  int port() const;
  /// Serves until stop(), then finishes the requests that have come and returns.
  void run();
  /// Stops accepting; safe from any thread, before or during run().
  void stop();

 private:
  class Listener;
  std::unique_ptr<Listener> listener_;
};

/// Whether GET path is answered there with 200 within two seconds.
bool answers(const std::string& host, int port, const std::string& path);

}  // namespace tia::server
