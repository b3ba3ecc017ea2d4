// QuadLight: a luminous parallelogram that shines to both sides. Rays hit it; it blocks the light
// of others and not its own.
#pragma once

#include <optional>
#include <string_view>

#include "core/input/errors.h"
#include "core/input/fields.h"
#include "core/lights/sphere_light.h"
#include "core/shapes/mesh/mesh.h"

namespace tia {

/// QuadLight. Space/units: world space, scene units: corner, corner + u, corner + u + v, corner +
/// v.
struct QuadLight {
  static constexpr std::string_view type = "quad";
  static constexpr bool endless = false;
  std::optional<Vec3d> corner;
  Vec3d u{}, v{};
  int samples = 1;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("corner", &QuadLight::corner, Spec{.about = "one corner", .min = -1e9, .max = 1e9});
    visit("u", &QuadLight::u,
          Spec{.about = "one edge from there", .min = -1e9, .max = 1e9, .required = true});
    visit("v", &QuadLight::v,
          Spec{.about = "the other edge from there", .min = -1e9, .max = 1e9, .required = true});
    visit("samples", &QuadLight::samples, light_samples);
  }
  /// Edges whose parallelogram has no area.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const QuadLight&) const = default;

  static constexpr const char* place_field = "corner";
  bool waits() const { return !corner; }
  /// Its middle.
  std::optional<Vec3d> place() const {
    if (!corner) return std::nullopt;
    return *corner + (u + v) * 0.5;
  }
  void move_to(const Vec3d& to, const Vec3d&) { corner = to - (u + v) * 0.5; }
  void move_by(const Vec3d& way) { corner = *corner + way; }
};

struct QuadForm {
  Constant middle, corner, u, v;
};
/// The surface that rays hit: two triangles.
Mesh surface(const QuadLight& light);
inline QuadForm prepare(const QuadLight& light) {
  return {*light.place(), *light.corner, light.u, light.v};
}
/// Uniform over its area.
template <class Real>
LightSample<Real> sample_li(const QuadForm& light, const Vec3<Real>& p, const Real& u,
                            const Real& v) {
  return sample_from(lift<Real>(light.corner) + lift<Real>(light.u) * u + lift<Real>(light.v) * v,
                     p);
}
/// The density of a direction by solid angle, where its point is at that distance.
template <class Real>
Real pdf_li(const QuadForm& light, const Vec3<Real>&, const Vec3<Real>& wi, const Real& distance) {
  // |u x v| times the cosine at the light.
  const Real facing = abs_of(dot(cross(lift<Real>(light.u), lift<Real>(light.v)), wi));
  return select(facing > Real(0), distance * distance / facing, Real(0));
}
static_assert(AreaForm<QuadForm>);

}  // namespace tia
