// ShadowGround: a plane that only catches shadows.
#pragma once

#include "core/shapes/simple/plane.h"

namespace tia {

/// ShadowGround: the plane is not among the objects: nothing is mirrored in it, and it lights and
/// hides nothing. Where rays of the camera meet no object and come to it from above, its normal's
/// side, the picture is black with alpha 1 - E / E0: E is the irradiance there, as the integrator
/// finds it, if the plane is black; E0 is the same without the objects. Of both the luminance
/// counts. A pixel's E and E0 are those of its samples that meet the plane, together.
struct ShadowGround {
  static constexpr std::string_view schema_name = "shadow_ground";
  Vec3d point{};
  Vec3d normal{0, 1, 0};

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("point", &ShadowGround::point,
          Spec{.about = "a point of the plane", .min = -1e9, .max = 1e9, .required = true});
    visit("normal", &ShadowGround::normal,
          Spec{.about = "the side from which its shadows are seen", .min = -1e9, .max = 1e9});
  }
  Plane plane() const { return {point, normal}; }
  void check(const Place& at, Faults& faults) const { plane().check(at, faults); }
  bool operator==(const ShadowGround&) const = default;
};

}  // namespace tia
