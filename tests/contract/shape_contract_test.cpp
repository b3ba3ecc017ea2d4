// The contract of the list of shapes: every kind obeys these laws. A new kind brings a Specimen.
#include <gtest/gtest.h>

#include <array>

#include "core/integrators/thesis.h"
#include "core/shapes/shape.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;

// ---- specimens: what the laws need to know of a kind ----------------------------------------

template <class S>
struct Specimen;

template <>
struct Specimen<Sphere> {
  static constexpr bool convex = true;
  static Sphere make(Random& random, double scale) {
    return {random.point(3) * scale, random.in(0.2, 3) * scale};
  }
  /// A ball that holds the shape.
  static Sphere bounds(const Sphere& s) { return s; }
  /// Below 0 inside, above 0 outside, in scene units near the surface.
  static double inside(const Sphere& s, const Vec3d& p) { return length(p - s.center) - s.radius; }
};

// ---- the laws -------------------------------------------------------------------------------

template <class S>
class ShapeContract : public testing::Test {
 public:
  static std::vector<double> scales(bool is_double) {
    return is_double ? std::vector{1e-6, 1e-3, 1.0, 1e3, 1e6} : std::vector{1e-3, 1.0, 1e3};
  }
  // A ray from near the shape, towards it more often than not.
  static Ray<double> ray_near(Random& random, const Sphere& ball) {
    const Vec3d origin = ball.center + random.vector(0, 4 * ball.radius);
    const Vec3d target = ball.center + random.vector(0, 1.3 * ball.radius);
    return {origin, normalize(target - origin)};
  }
  template <class Real>
  static Ray<Real> in(const Ray<double>& ray) {
    return {lift<Real>(ray.origin), normalize(lift<Real>(ray.direction))};
  }
};

template <class List>
struct TypesOf;
template <class... Kinds>
struct TypesOf<std::variant<Kinds...>> {
  using Types = testing::Types<Kinds...>;
};
TYPED_TEST_SUITE(ShapeContract, TypesOf<Shape>::Types);

TYPED_TEST(ShapeContract, HitPointLiesOnTheSurfaceAndInsideTheBounds) {
  using S = Specimen<TypeParam>;
  Random random(20);
  int hits = 0;
  const auto check = [&]<class Real>(Real, double relative) {
    for (const double scale : this->scales(std::is_same_v<Real, double>)) {
      for (int i = 0; i < 2000; ++i) {
        const TypeParam shape = S::make(random, scale);
        const auto ray = this->template in<Real>(this->ray_near(random, S::bounds(shape)));
        const Real t = intersect(shape, RootRay<Real>(ray));
        if (!(t < Real(infinity))) continue;
        ++hits;
        EXPECT_GT(t, 0);
        const Vec3d p = widen(ray.at(t));
        const Sphere ball = S::bounds(shape);
        const double slack = relative * (length(ball.center) + 5 * ball.radius);
        EXPECT_NEAR(S::inside(shape, p), 0, slack);
        EXPECT_LE(length(p - ball.center), ball.radius + slack);
      }
    }
  };
  check(0.0F, 3e-7);
  check(0.0, 3e-15);
  EXPECT_GT(hits, 5000);
}

TYPED_TEST(ShapeContract, NearestHitEqualsABruteForceMarch) {
  using S = Specimen<TypeParam>;
  Random random(21);
  for (int i = 0; i < 500; ++i) {
    const TypeParam shape = S::make(random, 1);
    const Sphere ball = S::bounds(shape);
    const Ray<double> ray = this->ray_near(random, ball);
    const double t = intersect(shape, RootRay<double>(ray));
    const double step = 1e-3 * ball.radius, end = 8 * ball.radius;
    const bool starts_inside = S::inside(shape, ray.origin) < 0;
    double marched = 0;
    while (marched < end && (S::inside(shape, ray.at(marched)) < 0) == starts_inside)
      marched += step;
    if (marched >= end) {
      // A chord shorter than a step may be stepped over.
      if (t < end)
        EXPECT_NEAR(S::inside(shape, ray.at(t + step / 2)), 0, step);
      else
        EXPECT_EQ(t, infinity);
    } else {
      EXPECT_GE(marched, t);
      EXPECT_LT(marched - t, 1.001 * step);
    }
  }
}

TYPED_TEST(ShapeContract, NormalIsUnitAndPointsTowardsTheOutside) {
  using S = Specimen<TypeParam>;
  Random random(22);
  int hits = 0;
  for (int i = 0; i < 2000; ++i) {
    const TypeParam shape = S::make(random, 1);
    const Ray<double> ray = this->ray_near(random, S::bounds(shape));
    const double t = intersect(shape, RootRay<double>(ray));
    if (!(t < 1e30)) continue;
    ++hits;
    const Vec3d p = ray.at(t), n = normal(shape, p);
    EXPECT_NEAR(length(n), 1, 1e-15);
    const double step = 1e-6 * S::bounds(shape).radius;
    EXPECT_GT(S::inside(shape, p + n * step), 0);
    EXPECT_LT(S::inside(shape, p - n * step), 0);
  }
  EXPECT_GT(hits, 1000);
}

TYPED_TEST(ShapeContract, LeavingRayDoesNotRehit) {
  using S = Specimen<TypeParam>;
  if (!S::convex) return;
  Random random(23);
  int left = 0;
  const auto check = [&]<class Real>(Real) {
    for (const double scale : this->scales(std::is_same_v<Real, double>)) {
      for (int i = 0; i < 2000; ++i) {
        const TypeParam shape = S::make(random, scale);
        const auto ray = this->template in<Real>(this->ray_near(random, S::bounds(shape)));
        const Real t = intersect(shape, RootRay<Real>(ray));
        if (!(t < Real(infinity)) || S::inside(shape, widen(ray.origin)) < 0) continue;
        const Vec3<Real> p = ray.at(t), n = normal(shape, p);
        auto away = lift<Real>(random.direction());
        away = normalize(dot(away, n) < 0 ? -away : away);
        const Vec3<Real> start = p + n * shadow_offset(t, p);
        EXPECT_EQ(intersect(shape, RootRay<Real>({start, away})), Real(infinity)) << scale;
        ++left;
      }
    }
  };
  check(0.0F);
  check(0.0);
  EXPECT_GT(left, 4000);
}

TYPED_TEST(ShapeContract, WideEqualsFloatBitForBitLaneByLane) {
  using S = Specimen<TypeParam>;
  Random random(24);
  constexpr int n = lanes<Wide>;
  for (const double scale : {1e-3, 1.0, 1e3}) {
    for (int i = 0; i < 5000; ++i) {
      const TypeParam shape = S::make(random, scale);
      alignas(32) std::array<std::array<float, n>, 6> parts{};
      std::array<Ray<float>, n> alone;
      for (std::size_t k = 0; k < n; ++k) {
        alone[k] = this->template in<float>(this->ray_near(random, S::bounds(shape)));
        const auto& [o, d] = alone[k];
        const std::array<float, 6> all{o.x, o.y, o.z, d.x, d.y, d.z};
        for (std::size_t part = 0; part < 6; ++part) parts[part][k] = all[part];
      }
      const auto load = [&](std::size_t part) { return Wide::load_unaligned(parts[part].data()); };
      const Ray<Wide> among{{load(0), load(1), load(2)}, {load(3), load(4), load(5)}};
      const Wide t = intersect(shape, RootRay<Wide>(among));
      const Vec3<Wide> normals = normal(shape, among.origin);
      for (int k = 0; k < n; ++k) {
        const Ray<float>& ray = alone[static_cast<std::size_t>(k)];
        const float t_alone = intersect(shape, RootRay<float>(ray));
        EXPECT_EQ(std::bit_cast<std::uint32_t>(lane(t, k)), std::bit_cast<std::uint32_t>(t_alone));
        const Vec3f lane_normal{lane(normals.x, k), lane(normals.y, k), lane(normals.z, k)};
        EXPECT_EQ(lane_normal, normal(shape, ray.origin));
      }
    }
  }
}

TYPED_TEST(ShapeContract, PowersOfTwoScaleEveryRootExactly) {
  // Doubling all lengths shifts exponents and nothing else.
  using S = Specimen<TypeParam>;
  Random random(25);
  for (int i = 0; i < 2000; ++i) {
    const Random same = random;
    Random once = same, scaled = same;
    const TypeParam small = S::make(once, 1), big = S::make(scaled, 1024);
    const Ray<double> ray = this->ray_near(once, S::bounds(small));
    const Ray<double> far{ray.origin * 1024.0, ray.direction};
    const float t = intersect(small, RootRay<float>(this->template in<float>(ray)));
    EXPECT_EQ(intersect(big, RootRay<float>(this->template in<float>(far))), 1024 * t);
    random = once;
  }
}

}  // namespace
}  // namespace tia
