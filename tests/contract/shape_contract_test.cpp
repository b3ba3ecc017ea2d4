// The contract of the list of shapes: every kind of surface obeys these laws, as the tracer finds
// it in a world of its own. A new kind brings a specimen.
#include <gtest/gtest.h>

#include <array>

#include "core/integrators/world_view.h"
#include "tests/contract/formula_specimens.h"

namespace tia {
namespace {

using test::Random;
using test::Reach;
using test::Specimen;

template <class S>
class ShapeContract : public testing::Test {
 public:
  static constexpr bool solid = decltype(prepare(std::declval<const S&>()))::solid;

  static constexpr bool fixed_size = requires { Specimen<S>::fixed_size; };
  static constexpr bool rounds_at_start = requires { Specimen<S>::rounds_at_start; };
  /// Of n rounds as many as a kind takes that is costly to compile. Sanitizers look at memory, not
  /// at numbers: few rounds lead them everywhere, and how many find something is not asked.
  static int rounds(int n) {
    int share = 1;
    if constexpr (requires { Specimen<S>::share; }) share = Specimen<S>::share;
    if (test::sanitized()) return std::max(1, n / (share > 1 ? 1000 : 100));
    return n / share;
  }
  static int least(int n) { return test::sanitized() ? -1 : rounds(n); }

  static std::vector<double> scales(bool is_double) {
    if (test::sanitized()) return {1.0};
    if (fixed_size) return std::vector(is_double ? 5 : 3, 1.0);
    return is_double ? std::vector{1e-6, 1e-3, 1.0, 1e3, 1e6} : std::vector{1e-3, 1.0, 1e3};
  }
  static World world_of(const S& shape) {
    Scene scene;
    scene.objects.push_back({"", shape, {}, {}});
    return compile(scene);
  }
  static bool regular(const S& shape, const Vec3d& p) {
    if constexpr (requires { Specimen<S>::regular(shape, p); })
      return Specimen<S>::regular(shape, p);
    return true;
  }
  // How far off a root may be: two searches for it start at other places.
  static double rounding(const S& shape, const Ray<double>& ray, double t) {
    double least = 1e-14 * (1 + t);
    if constexpr (requires { Specimen<S>::rounding(shape, Vec3d{}, Vec3d{}); })
      least = std::max(least, Specimen<S>::rounding(shape, ray.at(t), ray.direction));
    return least;
  }
  // A ray from near the shape, towards it more often than not.
  static Ray<double> ray_near(Random& random, const Reach& ball) {
    const Vec3d origin = ball.center + random.vector(0, 4 * ball.radius);
    const Vec3d target = ball.center + random.vector(0, 1.3 * ball.radius);
    return {origin, normalize(target - origin)};
  }
  template <class Real>
  static Ray<Real> in(const Ray<double>& ray) {
    return {lift<Real>(ray.origin), normalize(lift<Real>(ray.direction))};
  }
  // A ray of the scene.
  template <class Real>
  static Hit<Real> hit_of(const World& world, const Ray<Real>& ray) {
    WorkCounter work;
    const Ray<Real> near{ray.origin - lift<Real>(world.origin), ray.direction};
    return closest_hit(world, near, iota<Real>() >= Real(0), work);
  }
};

template <class List, class... Found>
struct SurfacesOf;
template <class... Found, class Kind, class... Kinds>
struct SurfacesOf<std::variant<Kind, Kinds...>, Found...>
    : std::conditional_t<IsSurface<Kind>, SurfacesOf<std::variant<Kinds...>, Found..., Kind>,
                         SurfacesOf<std::variant<Kinds...>, Found...>> {};
template <class... Found>
struct SurfacesOf<std::variant<>, Found...> {
  using Types = testing::Types<Found...>;
};
TYPED_TEST_SUITE(ShapeContract, SurfacesOf<Shape>::Types);

TYPED_TEST(ShapeContract, HitPointLiesOnTheSurfaceAndInsideTheBounds) {
  using S = Specimen<TypeParam>;
  Random random(20);
  int hits = 0;
  const auto check = [&]<class Real>(Real, double relative) {
    for (const double scale : this->scales(std::is_same_v<Real, double>)) {
      for (int i = 0; i < this->rounds(500); ++i) {
        const TypeParam shape = S::make(random, scale);
        const Reach near = S::reach(shape);
        const auto ray = this->template in<Real>(this->ray_near(random, near));
        const Real t = this->hit_of(this->world_of(shape), ray).t;
        if (!(t < Real(infinity))) continue;
        EXPECT_GT(t, 0);
        const Vec3d p = widen(ray.at(t));
        if (!this->regular(shape, p)) continue;
        ++hits;
        const double slack = relative * (length(near.center) + 5 * near.radius + double(t));
        ASSERT_NEAR(S::distance(shape, p), 0, slack) << scale;
        const Aabb box = bounds(prepare(shape));
        EXPECT_TRUE(lower(p, box.min - Vec3d{slack, slack, slack}) != p);
        EXPECT_TRUE(upper(p, box.max + Vec3d{slack, slack, slack}) != p);
      }
    }
  };
  check(0.0F, 4e-7);
  check(0.0, 2e-14);
  EXPECT_GT(hits, this->least(1000));
}

TYPED_TEST(ShapeContract, NearestHitEqualsABruteForceMarch) {
  using S = Specimen<TypeParam>;
  if (!this->solid) GTEST_SKIP() << "has no inside to march through";
  Random random(21);
  for (int i = 0; i < this->rounds(200); ++i) {
    const TypeParam shape = S::make(random, 1);
    const Reach near = S::reach(shape);
    const Ray<double> ray = this->ray_near(random, near);
    const double t = this->hit_of(this->world_of(shape), ray).t;
    const double step = 1e-3 * near.radius, end = 8 * near.radius;
    const bool starts_inside = S::distance(shape, ray.origin) < 0;
    int steps = 1;
    while (steps * step < end && (S::distance(shape, ray.at(steps * step)) < 0) == starts_inside)
      ++steps;
    const double marched = steps * step;
    if (marched < end) {
      EXPECT_GE(marched, t);
    }
    // A chord shorter than a step may be stepped over.
    if (t < std::min(marched, end) - 1.001 * step) {
      EXPECT_NEAR(S::distance(shape, ray.at(t + step / 2)), 0, step);
    }
  }
}

TYPED_TEST(ShapeContract, NormalIsUnitAndLeadsAwayFromTheSurface) {
  using S = Specimen<TypeParam>;
  Random random(22);
  int hits = 0;
  for (int i = 0; i < this->rounds(1000); ++i) {
    const TypeParam shape = S::make(random, 1);
    const Ray<double> ray = this->ray_near(random, S::reach(shape));
    const World world = this->world_of(shape);
    const auto hit = this->hit_of(world, ray);
    if (!(hit.t < 1e30)) continue;
    const Vec3d p = ray.at(hit.t);
    if (!this->regular(shape, p)) continue;
    ++hits;
    const Normals at = normals_at(world, p, 0, static_cast<int>(hit.element), 0);
    EXPECT_NEAR(length(at.n), 1, 1e-15);
    EXPECT_EQ(at.n, at.ng);
    const double step = 1e-6 * S::reach(shape).radius;
    EXPECT_NEAR(S::distance(shape, p + at.n * step), step, 1e-3 * step);
    EXPECT_NEAR(S::distance(shape, p - at.n * step), this->solid ? -step : step, 1e-3 * step);
    const auto seen = surface(world, ray, hit, 0, true);
    EXPECT_LE(dot(seen.ng, ray.direction), 0) << "turned to the viewer";
  }
  EXPECT_GT(hits, this->least(300));
}

TYPED_TEST(ShapeContract, LeavingRayDoesNotRehit) {
  using S = Specimen<TypeParam>;
  if (!S::convex) GTEST_SKIP() << "may be hit twice from outside";
  Random random(23);
  int left = 0;
  const auto check = [&]<class Real>(Real) {
    for (const double scale : this->scales(std::is_same_v<Real, double>)) {
      for (int i = 0; i < this->rounds(500); ++i) {
        const TypeParam shape = S::make(random, scale);
        const World world = this->world_of(shape);
        const auto ray = this->template in<Real>(this->ray_near(random, S::reach(shape)));
        const Hit<Real> hit = this->hit_of(world, ray);
        if (!(hit.t < Real(infinity))) continue;
        if (this->solid && S::distance(shape, widen(ray.origin)) < 0) continue;
        const SurfacePoint<Real> at = surface(world, ray, hit, 0, true);
        auto away = lift<Real>(random.direction());
        away = normalize(dot(away, at.ng) < 0 ? -away : away);
        const Vec3<Real> start = at.p + at.ng * offset_of(hit.t, at.p);
        EXPECT_EQ(this->hit_of(world, Ray<Real>{start, away}).t, Real(infinity)) << scale;
        ++left;
      }
    }
  };
  check(0.0F);
  check(0.0);
  EXPECT_GT(left, this->least(800));
}

TYPED_TEST(ShapeContract, FirstCrossingIsTheLeastOfAllAhead) {
  using S = Specimen<TypeParam>;
  Random random(28);
  int found = 0;
  for (int i = 0; i < this->rounds(1000); ++i) {
    const TypeParam shape = S::make(random, 1);
    const World world = this->world_of(shape);
    const Ray<double> ray = this->ray_near(random, S::reach(shape));
    double least = Aabb::far;
    crossings(world.primitive(0), ray,
              [&](double t, int) { least = t > 0 ? std::min(least, t) : least; });
    const double nearest = nearest_crossing(world.primitive(0), ray, Aabb::far).at.t;
    if (this->rounds_at_start && least < Aabb::far) {
      EXPECT_NEAR(nearest, least, this->rounding(shape, ray, least));
    } else {
      EXPECT_EQ(nearest, least);
    }
    // One at the limit counts: of what is equally far the first in the scene wins.
    EXPECT_EQ(nearest_crossing(world.primitive(0), ray, nearest).at.t, nearest);
    const double beyond = nearest_crossing(world.primitive(0), ray, nearest / 2).at.t;
    EXPECT_TRUE(beyond == nearest || beyond == Aabb::far) << beyond;
    found += least < Aabb::far;
  }
  EXPECT_GT(found, this->least(300));
}

TYPED_TEST(ShapeContract, WideEqualsFloatBitForBitLaneByLane) {
  using S = Specimen<TypeParam>;
  Random random(24);
  constexpr int n = lanes<Wide>;
  for (const double scale : this->scales(false)) {
    for (int i = 0; i < this->rounds(100); ++i) {
      const TypeParam shape = S::make(random, scale);
      const World world = this->world_of(shape);
      std::array<std::array<float, n>, 6> parts{};
      std::array<Ray<float>, n> alone;
      for (std::size_t k = 0; k < n; ++k) {
        alone[k] = this->template in<float>(this->ray_near(random, S::reach(shape)));
        const auto& [o, d] = alone[k];
        const std::array<float, 6> all{o.x, o.y, o.z, d.x, d.y, d.z};
        for (std::size_t part = 0; part < 6; ++part) parts[part][k] = all[part];
      }
      const auto load = [&](std::size_t part) { return Wide::load_unaligned(parts[part].data()); };
      const Ray<Wide> among{{load(0), load(1), load(2)}, {load(3), load(4), load(5)}};
      const Hit<Wide> hit = this->hit_of(world, among);
      const auto at = surface(world, among, hit, 0, hit.t < Wide(infinity));
      for (int k = 0; k < n; ++k) {
        const Ray<float>& ray = alone[static_cast<std::size_t>(k)];
        const Hit<float> expected = this->hit_of(world, ray);
        EXPECT_EQ(lane(hit.t, k), expected.t);
        EXPECT_EQ(lane(hit.element, k), expected.element);
        if (!(expected.t < infinity)) continue;
        const auto expected_at = surface(world, ray, expected, 0, true);
        EXPECT_EQ((Vec3f{lane(at.n.x, k), lane(at.n.y, k), lane(at.n.z, k)}), expected_at.n);
        EXPECT_EQ((Vec3f{lane(at.p.x, k), lane(at.p.y, k), lane(at.p.z, k)}), expected_at.p);
      }
    }
  }
}

TYPED_TEST(ShapeContract, PowersOfTwoScaleEveryRootExactly) {
  // Doubling all lengths shifts exponents and nothing else.
  using S = Specimen<TypeParam>;
  if (this->fixed_size) GTEST_SKIP() << "comes in one size";
  Random random(25);
  for (int i = 0; i < this->rounds(500); ++i) {
    Random once = random, scaled = random;
    const TypeParam small = S::make(once, 1), big = S::make(scaled, 1024);
    const Ray<double> ray = this->ray_near(once, S::reach(small));
    const Ray<double> far{ray.origin * 1024.0, ray.direction};
    const float t = this->hit_of(this->world_of(small), this->template in<float>(ray)).t;
    EXPECT_EQ(this->hit_of(this->world_of(big), this->template in<float>(far)).t, 1024 * t);
    random = once;
  }
}

TYPED_TEST(ShapeContract, SpansAreAscendingPairsAroundTheInside) {
  using S = Specimen<TypeParam>;
  if constexpr (ShapeContract<TypeParam>::solid) {
    Random random(26);
    int pairs = 0;
    for (int i = 0; i < this->rounds(1000); ++i) {
      const TypeParam shape = S::make(random, 1);
      const World world = this->world_of(shape);
      const Ray<double> ray = this->ray_near(random, S::reach(shape));
      std::vector<double> t;
      spans(world.primitive(0), ray, [&](double at, int) { t.push_back(at); });
      ASSERT_EQ(t.size() % 2, 0U);
      EXPECT_TRUE(std::is_sorted(t.begin(), t.end()));
      for (std::size_t k = 0; k + 1 < t.size(); k += 2) {
        if (std::isinf(t[k]) || std::isinf(t[k + 1])) continue;
        EXPECT_LT(S::distance(shape, ray.at((t[k] + t[k + 1]) / 2)), 1e-12);
        if (k > 0) {
          EXPECT_GT(S::distance(shape, ray.at((t[k - 1] + t[k]) / 2)), -1e-12);
        }
        ++pairs;
      }
    }
    EXPECT_TRUE(pairs > this->least(300) || (std::is_same_v<TypeParam, Plane>));
  }
}

TYPED_TEST(ShapeContract, RaysOfNothingHitNothing) {
  using S = Specimen<TypeParam>;
  Random random(27);
  const double nan = std::nan("");
  for (int i = 0; i < (test::sanitized() ? 2 : 50); ++i) {
    const TypeParam shape = S::make(random, 1);
    const World world = this->world_of(shape);
    const Ray<double> ray = this->ray_near(random, S::reach(shape));
    for (const Vec3d& bad : {Vec3d{nan, nan, nan}, Vec3d{nan, 0.5, 0.5}, Vec3d{0.6, 0.8, nan}}) {
      EXPECT_EQ(this->hit_of(world, Ray<double>{bad, ray.direction}).t, infinity);
      EXPECT_EQ(this->hit_of(world, Ray<double>{ray.origin, bad}).t, infinity);
    }
    EXPECT_EQ(this->hit_of(world, Ray<double>{ray.origin, {0, 0, 0}}).t, infinity);
    EXPECT_EQ(this->hit_of(world, Ray<double>{{nan, nan, nan}, {nan, nan, nan}}).t, infinity);
  }
}

}  // namespace
}  // namespace tia
