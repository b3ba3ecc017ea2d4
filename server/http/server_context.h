// What all connections of a server share.
#pragma once

#include <array>
#include <asio/io_context.hpp>
#include <asio/post.hpp>
#include <atomic>
#include <memory>
#include <new>
#include <optional>
#include <set>
#include <string>
#include <thread>
#include <unordered_map>

#include "server/http/application.h"
#include "server/http/timeouts.h"
#include "server/http/worker_threads.h"

namespace tia::server {

class Connection;

/// ServerContext: all but the atomics belongs to the connections' thread.
struct ServerContext {
  ServerContext(HttpOptions given, Application serving)
      : options(std::move(given)), application(std::move(serving)) {}

  HttpOptions options;
  Application application;
  asio::io_context io{1};
  WorkerThreads workers{options.workers};
  WorkerThreads writer{1};  ///< puts long bodies away
  int free_workers = options.workers;
  std::unordered_map<std::string, int> at_work;  ///< workers, by client; none of 0
  std::optional<Clock::time_point> last_work;    ///< none since the application was told of its end
  std::set<std::shared_ptr<Connection>> connections;
  std::atomic<int> open = 0;           ///< connections, for other threads
  std::atomic<bool> closing = false;   ///< no connection is used again after its answer
  std::size_t held_bytes = 0;          ///< of requests and answers, by all connections
  std::array<char, 64 << 10> scratch;  ///< where bytes are read to before they are taken

  /// Hands on to the connections' thread, as soon as there is memory to do so: nobody else could.
  /// Any thread may call.
  template <class Then>
  void tell(const Then& then) {
    for (;;) try {
        return asio::post(io, then);
      } catch (const std::bad_alloc&) {
        std::this_thread::sleep_for(timeouts::memory);
      }
  }
  void join() {
    workers.join();
    writer.join();
  }
  /// That connections hold so many bytes more, or fewer.
  void hold(std::ptrdiff_t more) {
    held_bytes += static_cast<std::size_t>(more);
    application.held(more);
  }
  /// Whether there is a worker for a request of that client: however many one client asks for, the
  /// last ones are for others.
  bool has_worker_for(const std::string& client) const {
    if (free_workers > options.spare_workers) return true;
    const auto own = at_work.find(client);
    return free_workers > 0 && (own == at_work.end() || own->second < 2);
  }
  bool holds_too_much() const { return held_bytes > options.most_held_bytes; }
};

}  // namespace tia::server
