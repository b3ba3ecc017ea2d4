#include "core/shapes/simple/torus.h"

#include <algorithm>

#include "core/input/codec.h"
#include "core/math/onb.h"
#include "core/math/roots.h"

namespace tia {
namespace {

// All below is in units of the major radius. The margin makes the stretch begin and end outside of
// the torus; it is far above the rounding of the stretch's ends, some 1e-15.
constexpr double margin = 1 + 1e-6;

double distance_from_axis(const Vec3d& p) { return std::sqrt(p.x * p.x + p.z * p.z); }

struct Stretch {
  double low = 0, high = -1;
};

// The line's stretch within a ball and between two planes that just hold the torus, from outside
// to outside.
Stretch stretch_near(double tube, const Line& line) {
  const double reach = (1 + tube) * margin, top = tube * margin;
  const double middle = -dot(line.origin, line.direction);
  const Vec3d foot = line.origin + line.direction * middle;
  const double square = reach * reach - dot(foot, foot);
  if (!(square > 0)) return {};
  Stretch s{middle - std::sqrt(square), middle + std::sqrt(square)};
  const double rise = line.direction.y, y = line.origin.y;
  if (rise == 0) return std::fabs(y) <= top ? s : Stretch{};
  const double one = (-top - y) / rise, other = (top - y) / rise;
  s.low = std::max(s.low, std::min(one, other));
  s.high = std::min(s.high, std::max(one, other));
  return s;
}

// The torus' quartic along a line, t = 0 at its origin: (|p|^2 + 1 - tube^2)^2 - 4 (x^2 + z^2).
// Its last coefficient as the product of the tube's circle and its mirror image, which keeps the
// digits of a thin tube.
// Source: Hanrahan, in Glassner (ed.), An Introduction to Ray Tracing (1989), ch. 3.
std::array<double, 5> quartic(double tube, const Line& line) {
  const Vec3d &o = line.origin, &d = line.direction;
  const double r = distance_from_axis(o), b = dot(o, d);
  const double shared = o.y * o.y - tube * tube;
  const double inner = (r - 1) * (r - 1) + shared, outer = (r + 1) * (r + 1) + shared;
  const double k = (inner + outer) / 2;
  return {inner * outer, 4 * b * k - 8 * (o.x * d.x + o.z * d.z),
          4 * b * b + 2 * k - 4 * (d.x * d.x + d.z * d.z), 4 * b, 1};
}

}  // namespace

void Torus::check(const Place& at, Faults& faults) const {
  if (!(minor_radius < major_radius))
    faults.add({FaultKind::out_of_range, at.at("minor_radius").pointer(), minor_radius,
                "below major_radius: a ring with a hole"});
}

Aabb bounds(const TorusForm& torus) {
  const double minor = torus.tube * torus.major_radius, reach = torus.major_radius + minor;
  return {{-reach, -minor, -reach}, {reach, minor, reach}};
}

TorusRoots roots(const TorusForm& torus, const Line& line) {
  Line scaled = line;
  scaled.origin = {line.origin.x / torus.major_radius, line.origin.y / torus.major_radius,
                   line.origin.z / torus.major_radius};
  const Stretch s = stretch_near(torus.tube, scaled);
  if (!(s.low < s.high)) return {};
  const double start = (s.low + s.high) / 2, reach = (s.high - s.low) / 2;
  scaled.origin = scaled.at(start);
  TorusRoots found;
  found.count = real_roots(quartic(torus.tube, scaled), -reach, reach, found.t, found.brackets);
  const auto placed = [&](double& t) { t = (t + start) * torus.major_radius; };
  for (double& t : found.t) placed(t);
  for (RootBracket& each : found.brackets) placed(each.low), placed(each.high);
  return found;
}

Vec3d normal(const TorusForm& torus, const Vec3d& p, int) {
  const double share = 1 - torus.major_radius / distance_from_axis(p);
  return unit({p.x * share, p.y, p.z * share});
}

Vec2d uv(const TorusForm& torus, const Vec3d& p, int) {
  return {turn_of(p.x, p.z), turn_of(p.y, distance_from_axis(p) - torus.major_radius)};
}

}  // namespace tia
