#include "core/shapes/simple/sphere.h"

#include <gtest/gtest.h>

#include <array>
#include <optional>

#include "tests/core/support.h"

namespace tia {
namespace {

using test::Long;
using test::Random;

// ---- an independent answer: the quadratic in long double ------------------------------------

// The nearest root t > 0 of |o + t d - c|^2 = r^2, by the form without cancellation
// (Press et al., Numerical Recipes, 5.6).
std::optional<Long> exact_root(const Sphere& s, const Ray<double>& ray) {
  const auto o = static_cast<Vec3<Long>>(ray.origin) - static_cast<Vec3<Long>>(s.center);
  const auto d = static_cast<Vec3<Long>>(ray.direction);
  const Long a = dot(d, d), b = dot(o, d), r = s.radius;
  // The discriminant from the foot of the perpendicular: b^2 - ac would lose the digits.
  const auto foot = o - d * (b / a);
  const Long discriminant = a * (r * r - dot(foot, foot));
  if (discriminant < 0) return std::nullopt;
  const Long q = -(b + std::copysign(std::sqrt(discriminant), b));
  const Long c = dot(o, o) - r * r;
  const Long t0 = std::min(q / a, c / q), t1 = std::max(q / a, c / q);
  if (t0 > 0) return t0;
  if (t1 > 0) return t1;
  return std::nullopt;
}

// The ray as the scalar holds it, and the same values in double for the exact answer.
template <class Real>
struct Aimed {
  Ray<Real> ray;
  Ray<double> exact;
  Aimed(const Vec3d& origin, const Vec3d& towards)
      : ray{lift<Real>(origin), normalize(lift<Real>(towards))},
        exact{lane_of(ray.origin), lane_of(ray.direction)} {}

 private:
  static Vec3d lane_of(const Vec3<Real>& v) { return {lane(v.x, 0), lane(v.y, 0), lane(v.z, 0)}; }
};

template <class Real>
double root(const Sphere& sphere, const Ray<Real>& ray) {
  const Real t = intersect(sphere, RootRay<Real>(ray));
  return lane(t, lanes<Real> - 1);
}

template <class Real>
class SphereRoots : public testing::Test {
 public:
  static constexpr bool is_double = std::is_same_v<Real, double>;
  // One rounding at the door, and 1e-7 squared where the direction was normalized in float.
  static constexpr double relative = is_double ? 1e-13 : 1e-7;
  static std::vector<double> scales() {
    return is_double ? std::vector{1e-6, 1e-3, 1.0, 1e3, 1e6} : std::vector{1e-3, 1.0, 1e3};
  }
};
using Scalars = testing::Types<float, double, Wide>;
TYPED_TEST_SUITE(SphereRoots, Scalars);

TYPED_TEST(SphereRoots, EqualTheQuadraticsFromOutsideAtEveryScale) {
  Random random(10);
  for (const double scale : this->scales()) {
    for (int i = 0; i < 5000; ++i) {
      const Sphere sphere{random.point(10) * scale, random.in(0.01, 5) * scale};
      const double away = sphere.radius * random.in(1.01, 20);
      const Vec3d origin = sphere.center + random.direction() * away;
      const Vec3d target = sphere.center + random.vector(0, 0.99 * sphere.radius);
      const Aimed<TypeParam> aim(origin, target - origin);
      const auto exact = exact_root(sphere, aim.exact);
      ASSERT_TRUE(exact.has_value());
      const auto t = static_cast<double>(*exact);
      EXPECT_NEAR(root(sphere, aim.ray), t, this->relative * (t + sphere.radius)) << scale;
    }
  }
}

TYPED_TEST(SphereRoots, EqualTheQuadraticsFromInsideWhicheverWayTheRayLooks) {
  Random random(11);
  for (const double scale : this->scales()) {
    for (int i = 0; i < 5000; ++i) {
      const Sphere sphere{random.point(10) * scale, random.in(0.01, 5) * scale};
      const Vec3d origin = sphere.center + random.vector(0, 0.99 * sphere.radius);
      const Aimed<TypeParam> aim(origin, random.direction());
      const auto exact = exact_root(sphere, aim.exact);
      ASSERT_TRUE(exact.has_value());
      const auto t = static_cast<double>(*exact);
      EXPECT_NEAR(root(sphere, aim.ray), t, this->relative * (t + 10 * scale)) << scale;
    }
  }
}

TYPED_TEST(SphereRoots, HitAndMissPartAtTheRadius) {
  Random random(12);
  int hits = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Sphere sphere{random.point(10), random.in(0.5, 5)};
    const Vec3d origin = sphere.center + random.vector(1.5 * sphere.radius, 4 * sphere.radius);
    const Vec3d side = normalize(cross(origin - sphere.center, random.direction()));
    const double share = random.chance(0.5) ? 0.999 : 1.001;
    // The tangent's foot: the line to it passes the centre at share * radius exactly.
    const double distance = length(origin - sphere.center), r = share * sphere.radius;
    const Vec3d way = normalize(sphere.center - origin);
    const Vec3d foot = sphere.center + (-way) * (r * r / distance) +
                       side * (r * std::sqrt(1 - r * r / (distance * distance)));
    const Aimed<TypeParam> aim(origin, foot - origin);
    const bool hit = root(sphere, aim.ray) < 1e30;
    EXPECT_EQ(hit, share < 1);
    hits += hit;
  }
  EXPECT_GT(hits, 9000);
  EXPECT_LT(hits, 11'000);
}

TYPED_TEST(SphereRoots, OriginInsideLookingAwayFromTheCentreHits) {
  // The ball spans z = -16 .. -24; from z = -22 along -z its back lies 2 away.
  const Sphere thesis_ball{{0, 0, -20}, 4};
  EXPECT_EQ(root(thesis_ball, Aimed<TypeParam>({0, 0, -22}, {0, 0, -1}).ray), 2);
}

TYPED_TEST(SphereRoots, GrazingRayHitsAtTheFootOfTheCentre) {
  // Centre 5 deep, ray 1 beside it: d2 = 1 = r^2, so t = tca = 5.
  const Sphere sphere{{0, 0, -5}, 1};
  EXPECT_EQ(root(sphere, Aimed<TypeParam>({1, 0, 0}, {0, 0, -1}).ray), 5);
  EXPECT_EQ(root(sphere, Aimed<TypeParam>({0, -1, 0}, {0, 0, -1}).ray), 5);
  EXPECT_EQ(root(sphere, Aimed<TypeParam>({1.001, 0, 0}, {0, 0, -1}).ray), infinity);
}

TYPED_TEST(SphereRoots, SphereBehindIsNeverHit) {
  Random random(13);
  for (int i = 0; i < 5000; ++i) {
    const Sphere sphere{random.point(10), random.in(0.01, 5)};
    const Vec3d out = random.direction();
    const Vec3d origin = sphere.center + out * (sphere.radius * random.in(1.001, 10));
    const Vec3d away = random.direction();
    const Vec3d leaving = dot(away, out) >= 0 ? away : -away;
    EXPECT_EQ(root(sphere, Aimed<TypeParam>(origin, leaving).ray), infinity);
  }
}

TYPED_TEST(SphereRoots, FromTheSurfaceItselfOnlyTheFarSideCounts) {
  const Sphere sphere{{0, 0, -5}, 1};
  EXPECT_EQ(root(sphere, Aimed<TypeParam>({0, 0, -4}, {0, 0, -1}).ray), 2);
  EXPECT_EQ(root(sphere, Aimed<TypeParam>({0, 0, -4}, {0, 0, 1}).ray), infinity);
}

TYPED_TEST(SphereRoots, ThesisFloorKeepsItsDigits) {
  // From the eye, 10 003.99 away from the floor's centre: r^2 - d2 is a difference of 1e8s.
  const Sphere floor{{0, -10004, -20}, 10000};
  Random random(14);
  int hits = 0;
  for (int i = 0; i < 20'000; ++i) {
    const Vec3d way{random.in(-0.3, 0.3), random.in(-0.3, -0.03), -1};
    const Aimed<TypeParam> aim({0, 0, 0}, way);
    const auto exact = exact_root(floor, aim.exact);
    if (!exact) continue;
    ++hits;
    EXPECT_NEAR(root(floor, aim.ray) / static_cast<double>(*exact), 1, 1e-6) << way.y;
  }
  EXPECT_GT(hits, 15'000);
}

TYPED_TEST(SphereRoots, SmallBallFarAwayKeepsItsOutline) {
  // 1e-3 at a distance of 1e3: |L|^2 - tca^2 would be a difference of 1e6s against r^2 = 1e-6.
  const Sphere small{{0, 0, -1000}, 1e-3};
  const auto at = [&](double x) {
    return root(small, Aimed<TypeParam>({x, 0, 0}, {0, 0, -1}).ray);
  };
  EXPECT_NEAR(at(0.99e-3), 1000, 1e-3);
  EXPECT_EQ(at(1.01e-3), infinity);
}

// ---- rays that are none ---------------------------------------------------------------------

TYPED_TEST(SphereRoots, NaNRayNeverHits) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const Sphere around{{0, 0, 0}, 10};
  for (int part = 0; part < 6; ++part) {
    std::array<double, 6> v{0.5, 0.25, 0.125, 0.6, 0, -0.8};
    v[static_cast<std::size_t>(part)] = nan;
    const Ray<TypeParam> ray{lift<TypeParam>({v[0], v[1], v[2]}),
                             lift<TypeParam>({v[3], v[4], v[5]})};
    EXPECT_EQ(root(around, ray), infinity) << part;
  }
}

TYPED_TEST(SphereRoots, RayWithoutDirectionNeverHits) {
  const TypeParam zero(0);
  const Ray<TypeParam> still{{zero, zero, zero}, {zero, zero, zero}};
  EXPECT_EQ(root(Sphere{{0, 0, -5}, 1}, still), infinity) << "from outside";
  EXPECT_EQ(root(Sphere{{0, 0, -5}, 10}, still), infinity) << "from inside";
  EXPECT_EQ(root(Sphere{{0, 0, -5}, 5}, still), infinity) << "from the surface";
}

TYPED_TEST(SphereRoots, InfiniteRayNeverHits) {
  const double inf = infinity;
  const Sphere around{{0, 0, 0}, 10};
  for (int part = 0; part < 6; ++part) {
    std::array<double, 6> v{0.5, 0.25, 0.125, 0.6, 0, -0.8};
    v[static_cast<std::size_t>(part)] = inf;
    const Ray<TypeParam> ray{lift<TypeParam>({v[0], v[1], v[2]}),
                             lift<TypeParam>({v[3], v[4], v[5]})};
    EXPECT_EQ(root(around, ray), infinity) << part;
  }
}

// ---- the normal -----------------------------------------------------------------------------

TYPED_TEST(SphereRoots, NormalIsUnitAndPointsFromTheCentre) {
  Random random(15);
  for (const double scale : this->scales()) {
    for (int i = 0; i < 1000; ++i) {
      const Sphere sphere{random.point(2) * scale, random.in(0.5, 5) * scale};
      const Vec3d n = random.direction();
      const auto p = lift<TypeParam>(sphere.center + n * sphere.radius);
      const Vec3<TypeParam> found = normal(sphere, p);
      const Vec3d got{lane(found.x, 0), lane(found.y, 0), lane(found.z, 0)};
      EXPECT_NEAR(length(got), 1, this->is_double ? 1e-15 : 5e-7);
      EXPECT_NEAR(length(got - n), 0, this->is_double ? 1e-14 : 5e-6);
    }
  }
}

}  // namespace
}  // namespace tia
