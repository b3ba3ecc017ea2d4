// Cylinder and cone, both closed by flat ends: two descriptions of one form, the frustum.
#pragma once

#include <string_view>

#include "core/input/errors.h"
#include "core/input/fields.h"
#include "core/math/onb.h"
#include "core/shapes/simple/chord.h"

namespace tia {

/// Cylinder. Surface: the distance from the axis base..cap is the radius; two discs close it.
/// Space/units: scene units, object space.
struct Cylinder {
  static constexpr std::string_view type = "cylinder";
  Vec3d base{}, cap{};
  double radius = 0;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("base", &Cylinder::base,
          Spec{.about = "the centre of one end", .min = -1e9, .max = 1e9, .required = true});
    visit("cap", &Cylinder::cap,
          Spec{.about = "the centre of the other end", .min = -1e9, .max = 1e9, .required = true});
    visit("radius", &Cylinder::radius,
          Spec{.about = "the radius", .min = 0, .max = 1e9, .open_min = true, .required = true});
  }
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Cylinder&) const = default;
};

/// Cone. Surface: the distance from the axis runs from base_radius to cap_radius; discs close it.
/// Space/units: scene units, object space.
struct Cone {
  static constexpr std::string_view type = "cone";
  Vec3d base{}, cap{};
  double base_radius = 0, cap_radius = 0;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("base", &Cone::base,
          Spec{.about = "the centre of one end", .min = -1e9, .max = 1e9, .required = true});
    visit("base_radius", &Cone::base_radius,
          Spec{.about = "the radius there", .min = 0, .max = 1e9, .required = true});
    visit("cap", &Cone::cap,
          Spec{.about = "the centre of the other end", .min = -1e9, .max = 1e9, .required = true});
    visit("cap_radius", &Cone::cap_radius,
          Spec{.about = "the radius there; 0 is a point", .min = 0, .max = 1e9});
  }
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Cone&) const = default;
};

/// Frustum: what a circle sweeps on its way along an axis while its radius changes evenly.
/// Its elements: the side, the base, the cap.
struct Frustum {
  static constexpr bool solid = true;
  enum Part { side, base, cap };
  Vec3d middle{};  ///< of the axis
  Onb frame{};     ///< n runs from base to cap
  double half_height = 0;
  double base_radius = 0, cap_radius = 0;
  double cosine = 1, sine = 0;  ///< of the side's slope: height and growth over slant height

  double radius_at(double z) const {
    return ((base_radius + cap_radius) + (cap_radius - base_radius) * (z / half_height)) / 2;
  }
};

Frustum prepare(const Cone& cone);
inline Frustum prepare(const Cylinder& c) {
  return prepare(Cone{c.base, c.cap, c.radius, c.radius});
}
inline int elements(const Frustum&) { return 3; }
Aabb bounds(const Frustum& frustum);

/// A line in the base's plane runs inside, one in the cap's plane outside.
Chord chord(const Frustum& frustum, const Line& line);

template <class Emit>
void crossings(const Frustum& frustum, const Line& line, Emit&& emit) {
  emit_ends(chord(frustum, line), emit);
}

/// At a cone's tip, where there is none, the way along the axis.
Vec3d normal(const Frustum& frustum, const Vec3d& p, int element);
/// Returns: on the side the turn around the axis and the share of the way from base to cap; on the
/// ends the place in the square around the disc.
Vec2d uv(const Frustum& frustum, const Vec3d& p, int element);

static_assert(IsForm<Frustum>);

}  // namespace tia
