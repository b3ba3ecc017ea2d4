// Where time goes.
#pragma once

#include <chrono>

namespace tia::server {

/// Timing: where a picture's time went, in ms.
struct Timing {
  double queue = 0, wait = 0, parse = 0, build = 0, trace = 0, encode = 0;  ///< wait: for memory
};

/// Stopwatch: milliseconds between laps.
class Stopwatch {
 public:
  /// Time since the last lap, or since the start.
  double lap_ms() {
    const auto now = Clock::now();
    const std::chrono::duration<double, std::milli> lap = now - last_;
    last_ = now;
    return lap.count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  Clock::time_point last_ = Clock::now();
};

}  // namespace tia::server
