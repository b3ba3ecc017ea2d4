// The sphere, by the geometric solution: project the centre onto the ray, compare distances.
#pragma once

#include <string_view>

#include "core/input/fields.h"
#include "core/math/onb.h"
#include "core/math/ray.h"
#include "core/shapes/crossing.h"

namespace tia {

/// Sphere. Surface: |p - center| = radius.
/// Space/units: scene units, object space.
struct Sphere {
  static constexpr std::string_view type = "sphere";
  static constexpr bool solid = true;
  Vec3d center{};
  double radius = 0;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("center", &Sphere::center,
          Spec{.about = "the centre", .min = -1e9, .max = 1e9, .required = true});
    visit("radius", &Sphere::radius,
          Spec{.about = "the radius", .min = 0, .max = 1e9, .open_min = true, .required = true});
  }
  bool operator==(const Sphere&) const = default;
};

/// Returns: the nearest positive root t, infinite where the ray misses. An origin inside always
/// hits, whichever way it looks; a ray that grazes (d2 = r^2) hits; NaN never does.
///
/// The roots need double: with the thesis' floor (r = 10 000) |L|^2 - r^2 has lost all of float's
/// digits, and a small ball seen from far away loses them in d2. In double both keep more than the
/// rounding of a float direction leaves, as long as t is measured in D's own length: a direction
/// 1e-7 too long would lift a point of that floor off it by 1e-3.
/// Domain: | |direction| - 1 | < 1e-6.
/// Source: Glassner (ed.), An Introduction to Ray Tracing (1989), ch. 2, 2.2, the thesis' geometric
/// solution: tca = L.D, thc^2 = r^2 - d2; what float loses in it: Haines, Guenther,
/// Akenine-Moeller, "Precision Improvements for Ray/Sphere Intersection", Ray Tracing Gems (2019).
template <class Real>
[[gnu::always_inline]] inline Real intersect_sphere(const Vec3<Precise<Real>>& center,
                                                    const Precise<Real>& square_of_radius,
                                                    const RootRay<Real>& ray) {
  using P = Precise<Real>;
  using std::sqrt;
  const Vec3<P> to_center = center - ray.origin;
  const P b = dot(to_center, ray.direction);
  const P c = dot(to_center, to_center) - square_of_radius;
  const P tca = b * ray.inverse_a;
  const P thc2 = (b * tca - c) * ray.inverse_a;
  // Spares most rays the root: d2 > r^2 misses, and so does one that leaves from outside. A lane
  // comes out the same whether or not the whole register returns here.
  const auto ahead =
      narrow<Real>(thc2) >= Real(0) && (narrow<Real>(tca) > Real(0) || narrow<Real>(c) < Real(0));
  if (!any(ahead)) return Real(infinity);

  const P thc = sqrt(thc2);
  const Real t0 = narrow<Real>(tca - thc);
  const Real t1 = narrow<Real>(tca + thc);
  const Real nearest = select(t0 > Real(0), t0, t1);
  return select(ahead && nearest > Real(0), nearest, Real(infinity));
}

template <class Real>
[[gnu::always_inline]] inline Real intersect(const Sphere& sphere, const RootRay<Real>& ray) {
  using P = Precise<Real>;
  return intersect_sphere<Real>(static_cast<Vec3<P>>(sphere.center),
                                P(sphere.radius * sphere.radius), ray);
}

/// Returns: the outward unit normal at a point p of the surface.
template <class Real>
Vec3<Real> normal(const Sphere& sphere, const Vec3<Real>& p) {
  return normalize(p - lift<Real>(sphere.center));
}

// ---- the sphere as a form: it is its own, for nothing is to be prepared -------------------------

inline Sphere prepare(const Sphere& sphere) { return sphere; }
inline int elements(const Sphere&) { return 1; }
inline Aabb bounds(const Sphere& s) {
  const Vec3d reach{s.radius, s.radius, s.radius};
  return {s.center - reach, s.center + reach};
}

/// The foot of the centre on the line, and half the chord to either side of it.
template <class Emit>
void crossings(const Sphere& sphere, const Line& line, Emit&& emit) {
  const Vec3d to_center = sphere.center - line.origin;
  const double middle = dot(to_center, line.direction);
  const Vec3d aside = to_center - line.direction * middle;
  const double square = sphere.radius * sphere.radius - dot(aside, aside);
  if (!(square >= 0)) return;
  const double half = std::sqrt(square);
  emit(middle - half, 0);
  emit(middle + half, 0);
}

inline Vec3d normal(const Sphere& sphere, const Vec3d& p, int) { return unit(p - sphere.center); }

/// Longitude and latitude of a direction: u turns around y, from +z towards +x, in [0,1); v rises
/// from the south pole, -y, to the north pole, in [0,1].
inline Vec2d longitude_latitude(const Vec3d& way) {
  const double aside = std::sqrt(way.x * way.x + way.z * way.z);
  return {turn_of(way.x, way.z), atan2_of(aside, -way.y) / pi};
}
inline Vec2d uv(const Sphere& sphere, const Vec3d& p, int) {
  return longitude_latitude(p - sphere.center);
}

/// A luminous one lights others from its centre.
inline Vec3d light_center(const Sphere& sphere) { return sphere.center; }

static_assert(IsForm<Sphere>);
static_assert(LightsFromCenter<Sphere>);

}  // namespace tia
