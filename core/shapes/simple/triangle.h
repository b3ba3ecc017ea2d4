// The triangle: three points and what lies between. It has no inside.
#pragma once

#include <algorithm>
#include <string_view>

#include "core/input/errors.h"
#include "core/input/fields.h"
#include "core/math/onb.h"
#include "core/shapes/crossing.h"

namespace tia {

/// Triangle. Surface: a + u (b - a) + v (c - a) with u, v >= 0, u + v <= 1; seen from where its
/// normal points, a b c run counter-clockwise. Space/units: scene units, object space.
struct Triangle {
  static constexpr std::string_view type = "triangle";
  Vec3d a{}, b{}, c{};

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("a", &Triangle::a,
          Spec{.about = "the first corner", .min = -1e9, .max = 1e9, .required = true});
    visit("b", &Triangle::b,
          Spec{.about = "the second corner", .min = -1e9, .max = 1e9, .required = true});
    visit("c", &Triangle::c,
          Spec{.about = "the third corner, not on the line through the others",
               .min = -1e9,
               .max = 1e9,
               .required = true});
  }
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Triangle&) const = default;
};

struct TriangleForm {
  static constexpr bool solid = false;
  Vec3d a{}, n{};
  Vec3d to_u{}, to_v{};  ///< u = to_u . (p - a), v likewise
  Aabb box{};
};

TriangleForm prepare(const Triangle& triangle);
inline int elements(const TriangleForm&) { return 1; }
inline Aabb bounds(const TriangleForm& triangle) { return triangle.box; }

/// A line in the triangle's plane misses it; one through an edge or a corner hits.
template <class Emit>
void crossings(const TriangleForm& triangle, const Line& line, Emit&& emit) {
  const Vec3d from = line.origin - triangle.a;
  const double t = -dot(triangle.n, from) / dot(triangle.n, line.direction);
  const Vec3d q = from + line.direction * t;
  const double u = dot(triangle.to_u, q), v = dot(triangle.to_v, q);
  if (u >= 0 && v >= 0 && u + v <= 1) emit(t, 0);
}

inline Vec3d normal(const TriangleForm& triangle, const Vec3d&, int) { return triangle.n; }
/// Returns: the barycentric coordinates of b and c.
inline Vec2d uv(const TriangleForm& triangle, const Vec3d& p, int) {
  const Vec3d q = p - triangle.a;
  return {std::clamp(dot(triangle.to_u, q), 0.0, 1.0), std::clamp(dot(triangle.to_v, q), 0.0, 1.0)};
}

static_assert(IsForm<TriangleForm>);

}  // namespace tia
