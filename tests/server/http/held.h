// What tests of connections under hard use share: requests, and an application that holds them.
#pragma once

#include <atomic>

#include "tests/server/http/wire.h"

namespace tia::test {

inline Application echo_target(bool at_once) {
  Application application = answering([](const Request& request) { return text(request.target); });
  application.at_once = [at_once](const Request&) { return at_once; };
  return application;
}

/// Held: an application whose requests to /held wait, and all others are answered.
struct Held {
  Latch let_go;
  std::atomic<int> at_work = 0;
  Application application() {
    Application application = answering([this](const Request& request) {
      if (request.target == "/held") {
        ++at_work;
        let_go.wait();
      }
      return text("done");
    });
    application.at_once = [](const Request& request) { return request.target == "/at-once"; };
    application.retry_after = [] { return 7; };
    return application;
  }
};

inline HttpOptions one_worker() {
  HttpOptions options = any_port();
  options.workers = 1;
  return options;
}

}  // namespace tia::test
