// Eight lines side by side, for forms that search them together.
#pragma once

#include <array>

#include "core/math/octet.h"
#include "core/shapes/crossing.h"

namespace tia {

/// EightLines: what is asked of each lane is its first crossing with after < t < before.
/// Space/units: as a Line's; lanes that are not wanted may hold anything.
struct EightLines {
  Ray<Octet> line;
  Octet after, before;
  unsigned wanted = 0;  ///< lanes, as bits

  static EightLines one(const Line& line, double after, double before) {
    return {{static_cast<Vec3<Octet>>(line.origin), static_cast<Vec3<Octet>>(line.direction)},
            Octet(after),
            Octet(before),
            1};
  }
  Line line_of(int i) const {
    const auto of = [i](const Vec3<Octet>& v) -> Vec3d {
      return {lane(v.x, i), lane(v.y, i), lane(v.z, i)};
    };
    return {of(line.origin), of(line.direction)};
  }
};

/// EightCrossings: a FirstCrossing each, and the work of all.
struct EightCrossings {
  std::array<double, 8> t;
  std::array<int, 8> element{};
  std::int64_t work = 0;

  EightCrossings() { t.fill(Aabb::far); }
  FirstCrossing one() const { return {{t[0], element[0]}, work}; }
};

/// Optional, first_crossings: a form's first_crossing of eight lines at once, the same to the bit.
template <class F>
concept FindsEightFirstCrossings = requires(const F& form, const EightLines& lines) {
  { first_crossings(form, lines) } -> std::same_as<EightCrossings>;
};
/// Optional, normals: a form's normal at eight points of element 0 at once, the same to the bit.
template <class F>
concept HasEightNormals = requires(const F& form, const Vec3<Octet>& points) {
  { normals(form, points) } -> std::same_as<Vec3<Octet>>;
};

}  // namespace tia
