// The log: JSON lines on standard error, written by a thread of their own, so that nobody waits
// for whoever reads them.
#pragma once

#include <condition_variable>
#include <mutex>
#include <string>
#include <string_view>
#include <thread>

namespace tia::server {

struct Exchange;

/// Log: while one lives, lines are gathered for a moment and written together: one at a time they
/// cost a busy server half of its requests. Lines that find too many waiting are lost, and
/// counted in the next one. Without a Log they are written at once.
class Log {
 public:
  static constexpr std::size_t most_bytes = 1 << 20;  ///< that wait

  Log();
  ~Log();  ///< writes what waits, but gives up on a reader that takes nothing for a second
  Log(const Log&) = delete;
  Log& operator=(const Log&) = delete;

  void add(std::string_view line);

 private:
  void write(const std::stop_token& ending);

  std::mutex mutex_;
  std::condition_variable_any has_lines_;
  std::string lines_;
  long lost_ = 0;
  std::jthread writer_;
};

/// A line for a request: who asked for what, what came of it, how long it took.
void log_exchange(const Exchange& exchange);

/// A line for what no request has caused.
void log_event(std::string_view what);

/// A line for what went wrong while a request was answered, and is not for the client's eyes.
void log_failure(const std::string& id, std::string_view what);

}  // namespace tia::server
