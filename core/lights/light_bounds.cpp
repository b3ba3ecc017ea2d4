#include "core/lights/light_bounds.h"

#include <algorithm>

#include "core/math/deterministic.h"
#include "core/math/onb.h"

namespace tia {
namespace {

// Of cosines up to rounding.
double angle_of(double cosine) { return acos_of(std::clamp(cosine, -1.0, 1.0)); }

/// DirectionCone: directions within an angle of an axis. The smallest around two.
struct DirectionCone {
  Vec3d axis;
  double cosine;
};
DirectionCone around(const DirectionCone& a, const DirectionCone& b) {
  const double of_a = angle_of(a.cosine), of_b = angle_of(b.cosine);
  const double between = angle_of(dot(a.axis, b.axis));
  if (std::min(between + of_b, pi) <= of_a) return a;
  if (std::min(between + of_a, pi) <= of_b) return b;
  const double whole = (of_a + between + of_b) / 2;
  const Vec3d across = cross(a.axis, b.axis);
  if (whole >= pi || dot(across, across) == 0) return {a.axis, -1};
  const auto [sine, cosine] = sincos_of(whole - of_a);
  const Vec3d aside = cross(unit(across), a.axis);
  return {normalize(a.axis * cosine + aside * sine), cos_of(whole)};
}

}  // namespace

LightBounds around(const LightBounds& a, const LightBounds& b) {
  if (a.power == 0) return b;
  if (b.power == 0) return a;
  const DirectionCone cone = around(DirectionCone{a.axis, a.cos_o}, DirectionCone{b.axis, b.cos_o});
  return {around(a.box, b.box), a.power + b.power,          cone.axis,
          cone.cosine,          std::min(a.cos_e, b.cos_e), a.two_sided || b.two_sided};
}

}  // namespace tia
