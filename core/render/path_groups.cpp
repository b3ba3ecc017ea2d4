#include "core/render/path_groups.h"

#include <algorithm>
#include <cmath>

namespace tia {
namespace {

double luminance_of(const Vec3d& rgb) { return 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z; }

// Of the mean of n values, by their own.
double error_of(double sum, double squares, int n) {
  if (n < 2) return 0;
  return std::sqrt(std::max(squares - sum * sum / n, 0.0) / (n - 1) / n);
}

}  // namespace

void PathGroups::add(const PathRecord& path) {
  all_.light = all_.light + static_cast<Vec3d>(path.color);
  ++all_.count;
  const double share = path.clamp;
  for_each_light(path, [&](const PathVertex&, const GatheredLight& light, const std::string& by) {
    if (light.value == Vec3f{0, 0, 0}) return;
    Vec3d& sum = sums_[by].of_path;
    sum = sum + static_cast<Vec3d>(light.value) * share;
  });
  for (auto& [expression, sums] : sums_) {
    Vec3d& own = sums.of_path;
    if (own == Vec3d{0, 0, 0}) continue;
    sums.light = sums.light + own;
    sums.squares = sums.squares + own * own;
    ++sums.paths;
    own = {0, 0, 0};
  }
}

std::vector<PathGroup> PathGroups::groups() const {
  const int n = all_.count;
  const double all = luminance_of(all_.light);
  std::vector<PathGroup> groups;
  for (const auto& [expression, sums] : sums_) {
    const Vec3d &sum = sums.light, &squares = sums.squares;
    PathGroup& group = groups.emplace_back();
    group.expression = expression;
    group.mean = sum * (1.0 / n);
    group.error = {error_of(sum.x, squares.x, n), error_of(sum.y, squares.y, n),
                   error_of(sum.z, squares.z, n)};
    group.share = all > 0 ? luminance_of(sum) / all : 0;
    group.paths = sums.paths;
  }
  std::ranges::stable_sort(groups, std::ranges::greater{}, &PathGroup::share);
  return groups;
}

}  // namespace tia
