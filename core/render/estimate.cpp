#include "core/render/estimate.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace tia {
namespace {

// The variance of the mean of n values, by their own: the sums are those of the values' deviations
// from any constant and of their squares. Domain: n > 1.
double variance_of_mean(double sum, double squares, int n) {
  return std::max(squares - sum * sum / n, 0.0) / (n - 1) / n;
}

// On a ground the backdrop is seen, too, which the light alone does not have.
Vec3d watched_mean(const Estimate& e) {
  const double share = 1.0 / e.count;
  const bool on_ground = e.ground.z > 0;
  return on_ground ? static_cast<Vec3d>(e.first) + e.deviations * share : e.light * share;
}

// The standard error of each channel's mean.
Vec3d error_of_mean(const Estimate& e) {
  const auto of = [&](double sum, double squares) {
    return std::sqrt(variance_of_mean(sum, squares, e.count));
  };
  return {of(e.deviations.x, e.squares.x), of(e.deviations.y, e.squares.y),
          of(e.deviations.z, e.squares.z)};
}

/// SignalBounds: between what the curve of sRGB is, which rises: a table, where its power takes
/// tens of times as long. Its steps are even in the light's root, so that they are in the signal,
/// too, but for a factor of 2.
class SignalBounds {
 public:
  SignalBounds() {
    const ToneMap srgb(Tone{});
    for (int i = 0; i <= steps; ++i) {
      const double root = static_cast<double>(i) / steps;
      signals_[static_cast<std::size_t>(i)] = srgb.signal(Vec3d{1, 1, 1} * (root * root)).x;
    }
  }
  /// The least and the most that it may be, but for rounding.
  std::pair<double, double> of(double light) const {
    const double step = std::sqrt(std::clamp(light, 0.0, 1.0)) * steps;
    const auto below = static_cast<std::size_t>(std::min(step, steps - 1.0));
    return {signals_[below], signals_[below + 1]};
  }

 private:
  static constexpr int steps = 1024;
  std::array<double, steps + 1> signals_{};
};

Vec3d change(const Vec3d& a, const Vec3d& b) {
  return {std::fabs(a.x - b.x), std::fabs(a.y - b.y), std::fabs(a.z - b.z)};
}
Vec3d larger(const Vec3d& a, const Vec3d& b) {
  return {std::max(a.x, b.x), std::max(a.y, b.y), std::max(a.z, b.z)};
}

}  // namespace

Vec3f Estimate::variance() const {
  const auto of = [&](double sum, double all_squares) {
    return static_cast<float>(variance_of_mean(sum, all_squares, count));
  };
  return {of(deviations.x, squares.x), of(deviations.y, squares.y), of(deviations.z, squares.z)};
}

bool Convergence::settle(Estimate& e) const {
  const double n = e.count;
  if (shows_) {
    if (rule_.noise == 0) return false;
    e.error = static_cast<float>(shown_error(e));
    return n >= std::max(least_samples, rule_.blur_steps) && e.error < rule_.noise;
  }
  const double most = rule_.threshold * rule_.threshold * n;
  const auto known = [&](double sum, double squares) {
    return (squares - sum * sum / n) / (n - 1) <= most;
  };
  return clamps() && known(e.deviations.x, e.squares.x) && known(e.deviations.y, e.squares.y) &&
         known(e.deviations.z, e.squares.z);
}

float Convergence::largest_error(const std::vector<Estimate>& estimates) const {
  float most = 0;
  for (const Estimate& each : estimates) {
    if (rule_.noise > 0) most = std::max(most, each.error);
    else if (most_error(each) >= static_cast<double>(most))
      most = std::max(most, static_cast<float>(shown_error(each)));
  }
  return most;
}

// What shown_error() cannot be beyond, by a table, where the curve is sRGB's and each channel is
// shown for itself.
double Convergence::most_error(const Estimate& e) const {
  static const SignalBounds bounds;
  constexpr double rounding = 1e-6;
  if (e.count < 2 || rule_.tone.transfer != Transfer::srgb || rule_.tone.white_balance_kelvin)
    return 1;
  const Vec3d mean = watched_mean(e), by = error_of_mean(e);
  const double all = by.x + by.y + by.z + mean.x + mean.y + mean.z;
  if (!std::isfinite(all)) return 1;
  const Vec3d shown = tone_.developed(mean), more = tone_.developed(mean + by),
              less = tone_.developed(mean - by);
  double most = 0;
  for (const auto axis : {&Vec3d::x, &Vec3d::y, &Vec3d::z}) {
    const auto [from, to] = bounds.of(shown.*axis);
    most = std::max({most, bounds.of(more.*axis).second - from, to - bounds.of(less.*axis).first});
  }
  return most + rounding;
}

double Convergence::shown_error(const Estimate& e) const {
  if (e.count < 2) return 1;
  const Vec3d mean = watched_mean(e), shown = tone_.signal(mean);
  const auto moved = [&](const Vec3d& by) {
    return larger(change(tone_.signal(mean + by), shown), change(tone_.signal(mean - by), shown));
  };
  const Vec3d error = error_of_mean(e);
  const Vec3d all = moved({error.x, 0, 0}) + moved({0, error.y, 0}) + moved({0, 0, error.z});
  return std::min(std::max({all.x, all.y, all.z}), 1.0);
}

}  // namespace tia
