// All about connections: one thread reads requests and sends answers for all of them, workers make
// the answers. The rest of the server sees plain requests and responses.
#pragma once

#include <chrono>
#include <memory>
#include <string>

#include "server/http/application.h"

namespace tia::server {

/// HttpServer: listens from its making on; serves while run() runs.
class HttpServer {
 public:
  /// Errors: std::runtime_error if the address cannot be had, another Tia's port included.
  HttpServer(HttpOptions options, Application application);
  ~HttpServer();

  int port() const;
  /// Connections that are open now.
  int connections() const;
  /// Serves until stop(), then finishes the requests that have come and returns.
  void run();
  /// Stops accepting after `delay`; what is not answered `limit` after that is given up with a 503.
  /// Safe from any thread, before or during run().
  void stop(std::chrono::milliseconds delay = {},
            std::chrono::milliseconds limit = std::chrono::hours(24));

 private:
  class Listener;
  std::unique_ptr<Listener> listener_;
};

/// Whether GET path is answered there with 200 within two seconds.
bool answers(const std::string& host, int port, const std::string& path);

}  // namespace tia::server
