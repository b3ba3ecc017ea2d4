// SphereLight: a luminous ball. Rays hit it; it blocks the light of others and not its own.
#pragma once

#include <optional>
#include <string_view>

#include "core/input/fields.h"
#include "core/lights/light_sample.h"
#include "core/math/onb.h"
#include "core/math/warp.h"
#include "core/shapes/simple/sphere.h"

namespace tia {

/// The most samples of a light for one point that it lights.
inline constexpr int most_light_samples = 4096;
inline constexpr Spec light_samples{
    .about =
        "samples of its area for each point that it lights, evenly spread over what the point "
        "sees; 1: its middle",
    .min = 1,
    .max = most_light_samples};

/// SphereLight. Space/units: world space, scene units. The thesis lights with its centre alone.
struct SphereLight {
  static constexpr std::string_view type = "sphere";
  static constexpr bool endless = false;
  std::optional<Vec3d> position;
  double radius = 0;
  int samples = 1;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("position", &SphereLight::position, Spec{.about = "the centre", .min = -1e9, .max = 1e9});
    visit("radius", &SphereLight::radius,
          Spec{.about = "the radius", .min = 0, .max = 1e9, .open_min = true, .required = true});
    visit("samples", &SphereLight::samples, light_samples);
  }
  bool operator==(const SphereLight&) const = default;

  static constexpr const char* place_field = "position";
  bool waits() const { return !position; }
  std::optional<Vec3d> place() const { return position; }
  void move_to(const Vec3d& to, const Vec3d&) { position = to; }
  void move_by(const Vec3d& wi) { position = *position + wi; }
};

struct SphereForm {
  Constant middle;
  double radius;
};
/// The surface that rays hit.
inline Sphere surface(const SphereLight& light) { return {*light.position, light.radius}; }
inline SphereForm prepare(const SphereLight& light) { return {*light.position, light.radius}; }
/// Uniform over the solid angle that the ball fills, seen from p; where p is inside of it, all
/// samples are its centre.
/// Source: Shirley, Wang, "Direct lighting calculation by Monte Carlo integration", 1991: the
/// cosine to the axis of the cone is uniform between 1 and that of its edge.
template <class Real>
LightSample<Real> sample_li(const SphereForm& light, const Vec3<Real>& p, const Real& u,
                            const Real& v) {
  using std::sqrt;
  const LightSample<Real> middle = sample_middle(light, p);
  const Real radius = lift<Real>(light.radius);
  const Mask<Real> outside = middle.distance > radius;
  const Real sine = select(outside, radius / middle.distance, Real(0)), square = sine * sine;
  // 1 - cos of the edge, as sin^2 / (1 + cos), which subtracts no nearly equal numbers.
  const Real height = square / (Real(1) + sqrt(Real(1) - square));
  const DiscPoint<Real> at = square_to_disc(u, v);
  const Real rise = (at.x * at.x + at.y * at.y) * height;
  const Real aside = sqrt(height * (Real(2) - rise));
  const auto [x, y] = axes_around(middle.wi);
  const Vec3<Real> wi =
      normalize(middle.wi * (Real(1) - rise) + x * (at.x * aside) + y * (at.y * aside));
  // The distance to the near side of the ball, which does not block its own light.
  const Real along = dot(wi, middle.wi);
  const Real reach = square - (Real(1) - along * along);
  const Real near = middle.distance * (along - sqrt(max_of(reach, Real(0))));
  return {wi, select(outside, near, middle.distance), Real(1)};
}
/// The density of those directions by solid angle, from p outside of the ball; 0 inside, and where
/// rounding leaves open whether p is on its inner side.
template <class Real>
Real pdf_li(const SphereForm& light, const Vec3<Real>& p, const Vec3<Real>&, const Real&) {
  using std::sqrt;
  const Real radius = lift<Real>(light.radius);
  const Vec3<Real> to_middle = lift<Real>(light.middle) - p;
  const Real square = radius * radius / dot(to_middle, to_middle);
  const Real height = square / (Real(1) + sqrt(max_of(Real(1) - square, Real(0))));
  return select(square < Real(1 - 1e-5F), Real(0.159154943F) / height, Real(0));  // 1 / 2 pi
}
static_assert(AreaForm<SphereForm>);

}  // namespace tia
