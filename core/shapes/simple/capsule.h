// The capsule: what a ball sweeps on its way along a segment.
#pragma once

#include <string_view>

#include "core/input/fields.h"
#include "core/math/onb.h"
#include "core/shapes/simple/chord.h"

namespace tia {

/// Capsule. Surface: the distance from the segment base..cap is the radius. Where base and cap are
/// one it is a ball.
/// Space/units: scene units, object space.
struct Capsule {
  static constexpr std::string_view type = "capsule";
  Vec3d base{}, cap{};
  double radius = 0;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("base", &Capsule::base,
          Spec{.about = "one end of the segment", .min = -1e9, .max = 1e9, .required = true});
    visit("cap", &Capsule::cap,
          Spec{.about = "the other end", .min = -1e9, .max = 1e9, .required = true});
    visit("radius", &Capsule::radius,
          Spec{.about = "the distance from the segment",
               .min = 0,
               .max = 1e9,
               .open_min = true,
               .required = true});
  }
  bool operator==(const Capsule&) const = default;
};

/// CapsuleForm. Its elements: the side, the half ball at the base, the one at the cap.
struct CapsuleForm {
  static constexpr bool solid = true;
  enum Part { side, base_ball, cap_ball };
  Vec3d base{}, cap{};
  double radius = 0;
  Onb frame{};  ///< n runs from base to cap
  double half_height = 0;

  Vec3d middle() const { return (base + cap) * 0.5; }
};

CapsuleForm prepare(const Capsule& capsule);
inline int elements(const CapsuleForm&) { return 3; }
inline int work_of(const CapsuleForm&) { return 4; }
Aabb bounds(const CapsuleForm& capsule);

Chord chord(const CapsuleForm& capsule, const Line& line);

template <class Emit>
void crossings(const CapsuleForm& capsule, const Line& line, Emit&& emit) {
  emit_ends(chord(capsule, line), emit);
}

Vec3d normal(const CapsuleForm& capsule, const Vec3d& p, int element);
/// Returns: the turn around the axis, and the share of the way along the surface from the base's
/// pole to the cap's.
Vec2d uv(const CapsuleForm& capsule, const Vec3d& p, int element);

static_assert(IsForm<CapsuleForm>);
static_assert(TellsWork<CapsuleForm>);

}  // namespace tia
