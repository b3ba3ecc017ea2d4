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

void PathGroups::add(const PathRecord& path, const World& world) {
  all_.light = all_.light + static_cast<Vec3d>(path.color);
  ++all_.count;
  const double share = path.clamp;
  for_each_light(
      path, [&](const PathVertex&, const GatheredLight& light, const std::string& by, int over) {
        if (light.value == Vec3f{0, 0, 0}) return;
        const Vec3d value = static_cast<Vec3d>(light.value) * share;
        Vec3d& sum = sums_[by].of_path;
        sum = sum + value;
        if (over < 0) return;
        Sums& surface = over_[world.primitive(over).object];
        surface.of_path = surface.of_path + value;
      });
  for (auto& each : sums_) each.second.end_path();
  for (auto& each : over_) each.second.end_path();
}

void PathGroups::Sums::end_path() {
  if (of_path == Vec3d{0, 0, 0}) return;
  light = light + of_path;
  squares = squares + of_path * of_path;
  ++paths;
  of_path = {0, 0, 0};
}

PathShare PathGroups::share_of(const Sums& of) const {
  const int n = all_.count;
  const double all = luminance_of(all_.light);
  const Vec3d &sum = of.light, &squares = of.squares;
  const Vec3d error{error_of(sum.x, squares.x, n), error_of(sum.y, squares.y, n),
                    error_of(sum.z, squares.z, n)};
  return {sum * (1.0 / n), error, all > 0 ? luminance_of(sum) / all : 0, of.paths};
}

std::vector<PathGroup> PathGroups::groups() const {
  std::vector<PathGroup> groups;
  for (const auto& [expression, sums] : sums_) groups.push_back({share_of(sums), expression});
  std::ranges::stable_sort(groups, std::ranges::greater{}, &PathGroup::share);
  return groups;
}

std::vector<PathSurface> PathGroups::surfaces() const {
  std::vector<PathSurface> surfaces;
  for (const auto& [object, sums] : over_) surfaces.push_back({share_of(sums), object});
  std::ranges::stable_sort(surfaces, std::ranges::greater{}, &PathSurface::share);
  if (surfaces.size() > most_surfaces) surfaces.resize(most_surfaces);
  return surfaces;
}

}  // namespace tia
