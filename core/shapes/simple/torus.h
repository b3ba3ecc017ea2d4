// The ring torus: a ball's path around the y axis. Its crossings are the roots of a quartic.
#pragma once

#include <array>
#include <string_view>

#include "core/input/errors.h"
#include "core/input/fields.h"
#include "core/shapes/roots_along.h"

namespace tia {

/// Torus. Surface: (sqrt(x^2 + z^2) - major_radius)^2 + y^2 = minor_radius^2.
/// Space/units: scene units, object space; around the y axis, at the origin.
struct Torus {
  static constexpr std::string_view type = "torus";
  double major_radius = 0, minor_radius = 0;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("major_radius", &Torus::major_radius,
          Spec{.about = "from the axis to the middle of the tube",
               .min = 0,
               .max = 1e9,
               .open_min = true,
               .required = true});
    visit("minor_radius", &Torus::minor_radius,
          Spec{.about = "the tube's radius, below major_radius: the ring has a hole",
               .min = 0,
               .max = 1e9,
               .open_min = true,
               .required = true});
  }
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Torus&) const = default;
};

struct TorusForm {
  static constexpr bool solid = true;
  double major_radius = 0;
  double tube = 0;  ///< minor_radius / major_radius
};

inline TorusForm prepare(const Torus& torus) {
  return {torus.major_radius, torus.minor_radius / torus.major_radius};
}
inline int elements(const TorusForm&) { return 1; }
inline int work_of(const TorusForm&) { return 16; }
Aabb bounds(const TorusForm& torus);

/// TorusRoots: at most four, ascending, always an even number.
struct TorusRoots {
  int count = 0;
  std::array<double, 4> t{};
  std::array<RootBracket, 4> brackets{};
};
TorusRoots roots(const TorusForm& torus, const Line& line);

template <class Emit>
void crossings(const TorusForm& torus, const Line& line, Emit&& emit) {
  const TorusRoots found = roots(torus, line);
  for (std::size_t i = 0; i < static_cast<std::size_t>(found.count); ++i)
    emit_root(emit, found.t[i], 0, explained(found.brackets[i], 4));
}

Vec3d normal(const TorusForm& torus, const Vec3d& p, int element);
/// Returns: the turns around the axis, from +z towards +x, and around the tube, from the outer
/// equator upwards, in [0,1).
Vec2d uv(const TorusForm& torus, const Vec3d& p, int element);

static_assert(IsForm<TorusForm>);
static_assert(TellsWork<TorusForm>);

}  // namespace tia
