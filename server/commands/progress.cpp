#include "server/commands/progress.h"

#include <algorithm>
#include <cstdio>
#include <iostream>
#include <stdexcept>

namespace tia::server {

std::chrono::milliseconds time_from_text(const std::string& option, const std::string& text) {
  constexpr std::size_t most_digits = 6;
  const std::size_t digits = std::min(text.find_first_not_of("0123456789"), text.size());
  const std::string unit = text.substr(digits);
  const int ms = unit == "ms" ? 1 : unit == "s" ? 1000 : unit == "min" ? 60'000 : 0;
  const bool is_time = digits > 0 && digits <= most_digits && ms > 0;
  const long count = is_time ? std::stol(text.substr(0, digits)) : 0;
  if (count == 0)
    throw std::invalid_argument("option " + option + ": got " + text +
                                ", allowed: a time such as 5s, 500ms or 2min");
  return std::chrono::milliseconds(count) * ms;
}

void ProgressBar::has_traced(std::int64_t rays) {
  constexpr std::chrono::milliseconds between{100};
  const std::unique_lock lock(mutex_, std::try_to_lock);  // others trace
  if (!lock) return;
  rays_ = std::max(rays_, rays);
  if (Clock::now() - drawn_ >= between) draw(share());
}

void ProgressBar::has_reached(const Reached& reached, bool tells_noise, std::int64_t rays) {
  const std::lock_guard lock(mutex_);
  if (rays > 0) samples_a_ray_ = reached.mean / static_cast<double>(rays);
  char text[32];
  std::snprintf(text, sizeof text, ", noise %.4f", reached.noise);
  noise_ = tells_noise ? text : "";
  draw(share());
}

void ProgressBar::end() {
  const std::lock_guard lock(mutex_);
  draw(1);
  std::cerr << std::endl;
}

// How much of it is done, if each pixel takes all of its samples.
double ProgressBar::share() const {
  return std::min(static_cast<double>(rays_) * samples_a_ray_ / samples_, 1.0);
}

void ProgressBar::draw(double share) {
  drawn_ = Clock::now();
  const std::chrono::duration<double> taken = drawn_ - start_;
  const auto width = static_cast<std::size_t>(24 * share);
  char text[64];
  std::snprintf(text, sizeof text, "] %3.0f %%, %.0f of %d samples", 100 * share, share * samples_,
                samples_);
  std::string line = "\r[" + std::string(width, '#') + std::string(24 - width, ' ') + text + noise_;
  if (share > 0 && share < 1) {
    std::snprintf(text, sizeof text, ", %.0f s left", taken.count() * (1 - share) / share);
    line += text;
  }
  std::cerr << line << "\x1b[K" << std::flush;  // and nothing of a longer one before
}

}  // namespace tia::server
