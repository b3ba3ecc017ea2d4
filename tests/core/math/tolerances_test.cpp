// That each tolerance exceeds what it is there for, and the errors that were measured.
#include "core/math/tolerances.h"

#include <gtest/gtest.h>

#include "core/accel/mesh/triangle.h"
#include "tests/core/support.h"

namespace tia::test {
namespace {

static_assert(tolerance::box_t >= 4 * tolerance::rounding);
static_assert(tolerance::box_face >= 2 * tolerance::rounding &&
              tolerance::group_origin >= 2 * tolerance::rounding);
static_assert(tolerance::grid_box >= 2 * tolerance::box_face);
static_assert(tolerance::search_t >= 2 * tolerance::rounding);
static_assert(tolerance::mesh_box >= 2 * tolerance::mesh_error);
static_assert(tolerance::ray_offset * tolerance::mesh_large > tolerance::mesh_error,
              "small meshes do not shadow themselves");
static_assert(tolerance::texture_point * tolerance::mesh_large > tolerance::mesh_error);
static_assert(tolerance::mesh_near * tolerance::mesh_behind > tolerance::mesh_error);
static_assert(tolerance::mesh_near_plane > tolerance::mesh_near);
static_assert(tolerance::mesh_settled > tolerance::mesh_near);
static_assert(tolerance::cell_box >= 8 * tolerance::rounding);

// (2 + sqrt 3) 2^-24 of the larger of t and the coordinates. The exact point is that of the ray as
// it is in float.
TEST(Tolerances, APointOfARayIsOffByFourRoundingsAtMost) {
  Random random(77);
  for (int i = 0; i < 300'000; ++i) {
    const double scale = std::exp2(random.in(-20, 20));
    const Ray<float> ray{lift<float>(random.point(scale)), lift<float>(random.direction())};
    const double t = scale * std::exp2(random.in(-10, 10));
    const Vec3f p = ray.at(static_cast<float>(t));
    const Vec3d exact = static_cast<Vec3d>(ray.origin) + static_cast<Vec3d>(ray.direction) * t;
    const Vec3d off = static_cast<Vec3d>(p) - exact;
    const double extent = std::max({t, std::fabs(exact.x), std::fabs(exact.y), std::fabs(exact.z)});
    ASSERT_LE(length(off), 3.74 * tolerance::rounding * extent);
    ASSERT_LE(20 * length(off), tolerance::ray_offset * extent);
  }
}

// A triangle within a mesh's unit, large or small, perhaps a sliver.
struct MeshTriangle {
  std::array<Vec3d, 3> at;

  explicit MeshTriangle(Random& random) {
    const double size = std::exp2(random.in(-8, 0));
    const Vec3d middle = random.point(1);
    for (Vec3d& corner : at) {
      const Vec3d p = middle + random.point(size);
      corner = upper(lower(p, {1, 1, 1}), {-1, -1, -1});
    }
  }
};

TEST(Tolerances, AHitOfATriangleIsOffItsPlaneByTheErrorOfMeshesAtMost) {
  Random random(78);
  int hits = 0, close = 0;
  for (int i = 0; i < 500'000; ++i) {
    const MeshTriangle triangle(random);
    const auto& [a, b, c] = triangle.at;
    const double u = random.unit(), v = random.unit() * (1 - u);
    const Vec3d origin = random.point(2.4), to = a + (b - a) * u + (c - a) * v - origin;
    const Vec3d normal = cross(b - a, c - a);
    if (length(to) < 1e-3 || length(normal) < 1e-14) continue;
    const Vec3d direction = normalize(to);
    const LongestAxis<float> longest(lift<float>(direction));
    ShearedRay<float> ray(lift<float>(origin), lift<float>(direction), longest);
    ray.turn_to(longest.of(0));
    const TriangleHit<float> hit = intersect(ray, [&](std::size_t corner, std::size_t axis) {
      const Vec3f p = lift<float>(triangle.at[corner]);
      return axis == 0 ? p.x : axis == 1 ? p.y : p.z;
    });
    if (!hit.inside) continue;
    const Vec3d p = origin + direction * static_cast<double>(hit.t);
    const double off = std::fabs(dot(normalize(normal), p - a));
    ASSERT_LE(off, tolerance::mesh_error) << i;
    ++hits;
    close += off < 0x1p-22;
  }
  EXPECT_GT(hits, 450'000);
  EXPECT_GT(close, 0.93 * hits);
}

}  // namespace
}  // namespace tia::test
