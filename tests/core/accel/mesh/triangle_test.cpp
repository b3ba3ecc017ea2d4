// The triangle's test against barycentric coordinates in long double, and one thing at a time
// against a register of them.
#include "core/accel/mesh/triangle.h"

#include <gtest/gtest.h>

#include "core/accel/mesh/mesh_index.h"
#include "core/boxes/lone_ray.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;

struct Corners {
  std::array<std::array<float, 3>, 3> at;
  float operator()(std::size_t corner, std::size_t axis) const { return at[corner][axis]; }
};
Corners random_corners(Random& random) {
  Corners corners;
  const Vec3d middle = random.point(1);
  const double size = std::pow(10, random.in(-3, 0));
  for (auto& corner : corners.at) {
    const Vec3d p = middle + random.point(size);
    corner = {static_cast<float>(p.x), static_cast<float>(p.y), static_cast<float>(p.z)};
  }
  return corners;
}

Vec3f aimed_at(const Corners& corners, const Vec3f& from, Random& random) {
  const double u = random.in(-0.2, 1.2), v = random.in(-0.2, 1.2), w = 1 - u - v;
  const auto coordinate = [&](std::size_t axis) {
    return static_cast<float>(u * corners(0, axis) + v * corners(1, axis) + w * corners(2, axis));
  };
  return normalize(Vec3f{coordinate(0), coordinate(1), coordinate(2)} - from);
}

ShearedRay<float> sheared(const Vec3f& from, const Vec3f& way) {
  const LongestAxis<float> longest(way);
  ShearedRay<float> ray(from, way, longest);
  ray.turn_to(longest.of(0));
  return ray;
}

// Cramer's rule for from + t way = a + v (b - a) + w (c - a); `margin` is the least of the three
// weights, `width` the share of the edges' product that is seen as area. Source: Moeller, Trumbore,
// "Fast, Minimum Storage Ray/Triangle Intersection" (1997).
struct Exact {
  long double t, margin, width;
};
Exact exact(const Corners& corners, const Vec3f& from, const Vec3f& way) {
  using Vec3l = Vec3<long double>;
  const auto corner = [&](std::size_t i) -> Vec3l {
    return {corners(i, 0), corners(i, 1), corners(i, 2)};
  };
  const Vec3l d = static_cast<Vec3l>(way), a = corner(0);
  const Vec3l e1 = corner(1) - a, e2 = corner(2) - a, s = static_cast<Vec3l>(from) - a;
  const Vec3l p = cross(d, e2), q = cross(s, e1);
  const long double determinant = dot(e1, p);
  const long double v = dot(s, p) / determinant, w = dot(d, q) / determinant;
  return {dot(e2, q) / determinant, std::min({v, w, 1 - v - w}),
          std::fabs(determinant) / std::sqrt(dot(e1, e1) * dot(e2, e2))};
}

TEST(Triangle, IsHitWhereBarycentricCoordinatesSaySo) {
  Random random(410);
  int hits = 0, misses = 0;
  for (int i = 0; i < 100'000; ++i) {
    const Corners corners = random_corners(random);
    const Vec3f from = lift<float>(random.point(4));
    const Vec3f way = aimed_at(corners, from, random);
    const Exact expected = exact(corners, from, way);
    const TriangleHit<float> hit = intersect(sheared(from, way), corners);
    // What float tells apart at a size of 1e-3 seen from 4.
    if (!(std::fabs(expected.margin) > 0.05L && expected.width > 0.05L)) continue;
    EXPECT_EQ(hit.inside, expected.margin > 0) << i;
    if (!hit.inside) {
      ++misses;
      continue;
    }
    ++hits;
    EXPECT_NEAR(hit.t, static_cast<double>(expected.t), 1e-4) << i;
  }
  EXPECT_GT(hits, 10'000);
  EXPECT_GT(misses, 20'000);
}

TEST(Triangle, ManyAtOnceAreHitAsOneIsBitForBit) {
  constexpr std::size_t n = FloatRegister::size;
  Random random(411);
  int hits = 0;
  for (int round = 0; round < 10'000; ++round) {
    std::array<Corners, n> each;
    for (Corners& corners : each) corners = random_corners(random);
    const Vec3f from = lift<float>(random.point(4));
    const ShearedRay<float> ray = sheared(from, aimed_at(each[0], from, random));
    const auto all =
        intersect(ShearedRay<FloatRegister>(ray), [&](std::size_t k, std::size_t axis) {
          std::array<float, n> words;
          for (std::size_t i = 0; i < n; ++i) words[i] = each[i](k, axis);
          return FloatRegister::load_unaligned(words.data());
        });
    std::array<float, n> t;
    all.t.store_unaligned(t.data());
    for (std::size_t i = 0; i < n; ++i) {
      const TriangleHit<float> one = intersect(ray, each[i]);
      ASSERT_EQ((bits(all.inside) >> i & 1U) != 0, one.inside);
      if (one.inside) {
        ASSERT_EQ(std::bit_cast<std::uint32_t>(t[i]), std::bit_cast<std::uint32_t>(one.t));
      }
      hits += one.inside;
    }
  }
  EXPECT_GT(hits, 2'000);
}

// What a box of its own leaves out is no hit: slivers, and rays in the triangle's very plane, of
// which rounding says now this, now that.
TEST(Triangle, HitsAreWithinItsBoxHoweverThinItIsSeen) {
  Random random(413);
  int hits = 0;
  for (int i = 0; i < 200'000; ++i) {
    Corners corners = random_corners(random);
    if (i % 2 == 0) {  // a sliver
      const double thin = std::pow(10, random.in(-7, -1)), along = random.unit();
      for (std::size_t k = 0; k < 3; ++k)
        corners.at[2][k] = static_cast<float>(
            corners(0, k) + along * (corners(1, k) - corners(0, k)) + random.in(-thin, thin));
    }
    const auto corner = [&](std::size_t k) -> Vec3d {
      return {corners(k, 0), corners(k, 1), corners(k, 2)};
    };
    const Vec3d aside = random.point(1e-6);
    const Vec3d from = corner(0) + (corner(1) - corner(0)) * random.in(-3, 3) +
                       (corner(2) - corner(0)) * random.in(-3, 3) +
                       (i % 4 < 2 ? aside : random.point(2));
    const Vec3f origin = lift<float>(from), way = aimed_at(corners, origin, random);
    const TriangleHit<float> hit = intersect(sheared(origin, way), corners);
    if (!hit.inside || !(hit.t > 0) || !(hit.t < 8)) continue;
    ++hits;
    constexpr float room = tolerance::mesh_box;
    Vec3f low{infinity, infinity, infinity}, high = -low;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto p = static_cast<Vec3f>(corner(k));
      low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
    }
    BoxSet box;
    box.add({low - Vec3f{room, room, room}, high + Vec3f{room, room, room}});
    const BoxRay<float> ray(origin, way, 0);
    BoxSet::Floats near;
    EXPECT_EQ(LoneRay<true>(ray, 0).enters(box, LoneRay<true>::limit(hit.t), near), 1U) << i;
    EXPECT_EQ(RayInterval(ray, true).enters(box, hit.t, near), 1U) << i;
  }
  EXPECT_GT(hits, 20'000);
}

// However far the eye is, whatever the mesh's size: to the digits that its own measure keeps.
TEST(MeshRay, MeetsAMeshFromAfarWhereItMeetsItFromNearby) {
  Random random(412);
  for (int i = 0; i < 2'000; ++i) {
    const double size = std::pow(10, random.in(-20, 8));
    Mesh mesh;
    const Vec3d middle = random.point(10) * size;
    for (int corner = 0; corner < 3; ++corner) {
      const Vec3d p = middle + random.point(size);
      mesh.positions.values.insert(mesh.positions.values.end(), {p.x, p.y, p.z});
    }
    mesh.indices.values = {0, 1, 2};
    const MeshIndex index(mesh);
    if (index.degenerate > 0) continue;
    const Vec3d target = (index.corner(0, 0) + index.corner(0, 1) + index.corner(0, 2)) * (1 / 3.0);
    const Vec3d way = random.direction();
    const double away = size * std::pow(10, random.in(0, 12));
    const RootRay<double> root(Ray<double>{target - way * away, way});
    const MeshRay<double> ray(index, root, random.chance(0.5), 0);
    const double t = ray.t_of(length(index.measured(target) - ray.origin));
    EXPECT_NEAR(t, away, 1e-9 * away + 1e-9 * size);
    EXPECT_LT(length(ray.origin), 10) << "starts next to the mesh";
  }
}

}  // namespace
}  // namespace tia
