// SpotLight: a point that shines into a cone.
#pragma once

#include <optional>
#include <string_view>

#include "core/input/errors.h"
#include "core/input/fields.h"
#include "core/lights/light_sample.h"
#include "core/lights/lit_spans.h"
#include "core/math/onb.h"
#include "core/math/powers.h"

namespace tia {

/// SpotLight. Space/units: world space, scene units; half angles in degrees from the cone's axis.
struct SpotLight {
  static constexpr std::string_view type = "spot";
  static constexpr bool endless = false;
  std::optional<Vec3d> position;
  Vec3d point_at{};
  double radius_degrees = 30, falloff_degrees = 45, tightness = 0;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("position", &SpotLight::position,
          Spec{.about = "where the light is", .min = -1e9, .max = 1e9});
    visit("point_at", &SpotLight::point_at,
          Spec{.about = "a point of the cone's axis", .min = -1e9, .max = 1e9});
    visit("radius_degrees", &SpotLight::radius_degrees,
          Spec{.about = "half angle within which the light is full", .min = 0, .max = 180});
    visit("falloff_degrees", &SpotLight::falloff_degrees,
          Spec{.about = "half angle beyond which there is none", .min = 0, .max = 180});
    visit("tightness", &SpotLight::tightness,
          Spec{.about = "exponent of the cosine from the axis", .min = 0, .max = 1000});
  }
  /// A falloff within the radius; a place at point_at.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const SpotLight&) const = default;

  static constexpr const char* place_field = "position";
  bool waits() const { return !position; }
  std::optional<Vec3d> place() const { return position; }
  void move_to(const Vec3d& to, const Vec3d&) { position = to; }
  void move_by(const Vec3d& way) { position = *position + way, point_at = point_at + way; }
};

struct SpotForm {
  Constant position, axis;         ///< the axis away from the light, unit
  double cos_radius, cos_falloff;  ///< cos_falloff <= cos_radius
  double tightness;
};
inline SpotForm prepare(const SpotLight& light) {
  const Vec3d axis = light.point_at - *light.position;
  return {*light.position, axis == Vec3d{} ? Vec3d{0, -1, 0} : unit(axis),
          cos_degrees(light.radius_degrees), cos_degrees(light.falloff_degrees), light.tightness};
}
/// cos^tightness times a smooth step of the cosine from the falloff's to the radius'.
template <class Real>
LightSample<Real> sample_li(const SpotForm& light, const Vec3<Real>& p) {
  LightSample<Real> sample = sample_from(lift<Real>(light.position), p);
  const Real cosine = -dot(sample.wi, lift<Real>(light.axis));
  const Real inner = lift<Real>(light.cos_radius), outer = lift<Real>(light.cos_falloff);
  const Real share = min_of(max_of((cosine - outer) / (inner - outer), Real(0)), Real(1));
  const Real smooth = share * share * (Real(3) - (share + share));
  sample.strength = select(cosine >= inner, Real(1), select(cosine > outer, smooth, Real(0)));
  if (light.tightness > 0)
    sample.strength =
        sample.strength * pow_of(max_of(cosine, Real(0)), lift<Real>(light.tightness));
  return sample;
}
static_assert(LitForm<SpotForm>);
/// What its cone holds of a line.
LitSpans lit_spans(const SpotForm& light, const Vec3d& origin, const Vec3d& direction);

}  // namespace tia
