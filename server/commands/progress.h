// How a drawing is watched from the command line: a bar, and the file as it is by then.
#pragma once

#include <chrono>
#include <cstdint>
#include <mutex>
#include <optional>
#include <string>

#include "core/render/reached.h"

namespace tia::server {

/// Watching: what the command line wants to see of a drawing.
struct Watching {
  bool shows_progress = false;                          ///< on standard error
  std::optional<std::chrono::milliseconds> every = {};  ///< how often the file is written anew

  bool is_any() const { return shows_progress || every; }
};

/// A time such as 5s, 500ms or 2min. Errors: std::invalid_argument naming the option.
std::chrono::milliseconds time_from_text(const std::string& option, const std::string& text);

/// ProgressBar: one line on standard error that is written over: a bar, samples, noise, time left.
/// Any thread may call.
class ProgressBar {
 public:
  /// `samples`: the most that a pixel is going to have.
  explicit ProgressBar(int samples) : samples_(samples) {}
  /// That so many rays of all kinds have been traced.
  void has_traced(std::int64_t rays);
  /// That they have come to this; the noise where it is known.
  void has_reached(const Reached& reached, bool tells_noise, std::int64_t rays);
  /// Leaves the line as it is at the end.
  void end();

 private:
  using Clock = std::chrono::steady_clock;
  double share() const;
  void draw(double share);

  const int samples_;
  std::mutex mutex_;
  const Clock::time_point start_ = Clock::now();
  Clock::time_point drawn_{};
  std::int64_t rays_ = 0;
  double samples_a_ray_ = 0;  // 0: not known yet
  std::string noise_;
};

}  // namespace tia::server
