#include "core/render/estimate.h"

#include <algorithm>
#include <cmath>

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
    e.error = static_cast<float>(shown_error(e));
    return rule_.noise > 0 && n >= least_samples && e.error < rule_.noise;
  }
  const double most = rule_.threshold * rule_.threshold * n;
  const auto known = [&](double sum, double squares) {
    return (squares - sum * sum / n) / (n - 1) <= most;
  };
  return clamps() && known(e.deviations.x, e.squares.x) && known(e.deviations.y, e.squares.y) &&
         known(e.deviations.z, e.squares.z);
}

double Convergence::shown_error(const Estimate& e) const {
  if (e.count < 2) return 1;
  const Vec3d mean = watched_mean(e), shown = tone_.signal(mean);
  const auto moved = [&](const Vec3d& by) {
    return larger(change(tone_.signal(mean + by), shown), change(tone_.signal(mean - by), shown));
  };
  const auto error = [&](double sum, double squares) {
    return std::sqrt(variance_of_mean(sum, squares, e.count));
  };
  const Vec3d all = moved({error(e.deviations.x, e.squares.x), 0, 0}) +
                    moved({0, error(e.deviations.y, e.squares.y), 0}) +
                    moved({0, 0, error(e.deviations.z, e.squares.z)});
  return std::min(std::max({all.x, all.y, all.z}), 1.0);
}

}  // namespace tia
