#include "core/radio/radio_beam.h"

#include <cmath>

#include "core/math/onb.h"

namespace tia {

bool RadioBeam::holds(const Vec3d& p, double slack) const {
  for (const Side& each : sides)
    if (dot(each.inward, p) < each.from - slack) return false;
  return true;
}

bool RadioBeam::misses(const Aabb& box, double slack) const {
  const Vec3d middle = box.center(), half = box.size() * 0.5;
  for (const Side& each : sides) {
    const Vec3d& n = each.inward;
    const double reach =
        std::fabs(n.x) * half.x + std::fabs(n.y) * half.y + std::fabs(n.z) * half.z;
    if (dot(n, middle) + reach < each.from - slack) return true;
  }
  return false;
}

namespace {

// Whether one side of a beam has a whole polygon before it, which most facets in a beam's boxes do.
bool is_before_a_side(const std::vector<Vec3d>& polygon, const RadioBeam& beam, double slack) {
  for (const RadioBeam::Side& side : beam.sides) {
    bool is_before = true;
    for (std::size_t i = 0; i < polygon.size() && is_before; ++i)
      is_before = dot(side.inward, polygon[i]) - side.from + slack < 0;
    if (is_before) return true;
  }
  return false;
}

}  // namespace

std::vector<Vec3d> clipped(const std::vector<Vec3d>& polygon, const RadioBeam& beam, double slack) {
  if (is_before_a_side(polygon, beam, slack)) return {};
  std::vector<Vec3d> left, next;
  left.reserve(polygon.size() + beam.sides.size());  // each side of a beam adds a corner at most
  next.reserve(polygon.size() + beam.sides.size());
  left = polygon;
  for (const RadioBeam::Side& side : beam.sides) {
    next.clear();
    for (std::size_t i = 0; i < left.size(); ++i) {
      const Vec3d &a = left[i], &b = left[(i + 1) % left.size()];
      const double at_a = dot(side.inward, a) - side.from + slack;
      const double at_b = dot(side.inward, b) - side.from + slack;
      if (at_a >= 0) next.push_back(a);
      if ((at_a >= 0) != (at_b >= 0)) next.push_back(a + (b - a) * (at_a / (at_a - at_b)));
    }
    left.swap(next);
    if (left.empty()) break;
  }
  return left;
}

bool sees(const RadioBeam& beam, const std::vector<Vec3d>& polygon, double slack) {
  if (is_before_a_side(polygon, beam, slack)) return false;
  for (const Vec3d& corner : polygon)
    if (beam.holds(corner, slack)) return true;
  return !clipped(polygon, beam, slack).empty();
}

RadioBeam mirrored_beam(const RadioBeam& earlier, const Facet& facet, int side, const Vec3d& image,
                        const std::vector<Vec3d>& seen) {
  const Vec3d front = facet.face.normal * static_cast<double>(side);
  RadioBeam beam{{{front, facet.face.offset * side}}};
  if (facet.endless) {
    for (const RadioBeam::Side& each : earlier.sides) {
      const Vec3d inward = facet.face.mirror_way(each.inward);
      const Vec3d foot = facet.face.mirror(each.inward * each.from);
      beam.sides.push_back({inward, dot(inward, foot)});
    }
    return beam;
  }
  Vec3d middle{};
  for (const Vec3d& p : seen) middle = middle + p * (1.0 / static_cast<double>(seen.size()));
  for (std::size_t i = 0; i < seen.size(); ++i) {
    const Vec3d a = seen[i] - image, b = seen[(i + 1) % seen.size()] - image;
    Vec3d inward = cross(a, b);
    const double size = length(inward);
    // A side too short to tell a plane bounds nothing.
    if (!(size > 1e-6 * length(a) * length(b))) continue;
    inward = inward * (1 / size);
    if (dot(inward, middle - image) < 0) inward = -inward;
    beam.sides.push_back({inward, dot(inward, image)});
  }
  return beam;
}

}  // namespace tia
