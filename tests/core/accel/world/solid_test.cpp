// CSG in the world: volumes by summed spans, the algebra of sets in pictures, materials.
#include "core/accel/world/solid.h"

#include <gtest/gtest.h>

#include "tests/core/accel/worlds.h"

namespace tia {
namespace {

using test::ball;
using test::hit_of;
using test::matte;
using test::object_of;
using test::Random;
using test::world_of;

Object csg(Operation operation, const std::vector<Object>& children) {
  return object_of(Csg{operation, children});
}
Object intersection_of(const std::vector<Object>& children) {
  return csg(Operation::intersection, children);
}
Object union_of(const std::vector<Object>& children) { return csg(Operation::union_, children); }
Object difference_of(const std::vector<Object>& children) {
  return csg(Operation::difference, children);
}

TransformSteps rotated_by(const Vec3d& degrees) {
  TransformSteps placement;
  placement.steps = {RotateDegrees{degrees}};
  return placement;
}

// ---- volumes ----------------------------------------------------------------------------------

// The lengths within a solid, summed over n x n parallel lines through the middles of squares that
// tile [-reach, reach]^2, the solid turned so that no face is along them. The rule of midpoints:
// its error for edges that meet at an angle is some (reach / n)^1.5.
double volume(const Object& solid, double reach, int n = 200) {
  Group all;
  all.children = {solid};
  const World world = world_of({union_of({object_of(all, rotated_by({31, 17, 58}))})});
  const Geometry& geometry = *world.of_objects;
  const double side = 2 * reach / n;
  WorkCounter work;
  double sum = 0;
  for (int i = 0; i < n * n; ++i) {
    const double x = (i % n + 0.5) * side - reach, y = (i / n + 0.5) * side - reach;
    const Spans& held =
        spans(geometry.solids[0], geometry.primitives, {{x, y, 10 * reach}, {0, 0, -1}}, work);
    for (std::size_t k = 0; k + 1 < held.size(); k += 2) sum += held[k + 1].t - held[k].t;
  }
  return sum * side * side;
}

Object rod(const Vec3d& half, double radius) { return object_of(Cylinder{-half, half, radius}); }

TEST(SolidVolume, OfTwoCrossedCylindersIsThatOfArchimedes) {
  // Steinmetz: 16 r^3 / 3. The cross section at height z is a square of side 2 sqrt(r^2 - z^2).
  for (const double r : {1e-3, 0.7, 1e3}) {
    const Object solid = intersection_of({rod({2 * r, 0, 0}, r), rod({0, 2 * r, 0}, r)});
    EXPECT_NEAR(volume(solid, 1.6 * r) / (16 * r * r * r / 3), 1, 5e-4) << r;
  }
}

TEST(SolidVolume, OfThreeCrossedCylinders) {
  // 8 (2 - sqrt 2) r^3.
  const double r = 0.8;
  const Object solid = intersection_of({rod({2, 0, 0}, r), rod({0, 2, 0}, r), rod({0, 0, 2}, r)});
  EXPECT_NEAR(volume(solid, 1.2), 8 * (2 - std::sqrt(2.0)) * r * r * r, 1e-3);
}

TEST(SolidVolume, OfANapkinRingDependsOnItsHeightAlone) {
  // A ball of radius R, drilled through by a = sqrt(R^2 - h^2/4): pi h^3 / 6 whatever R is.
  const double h = 1.2;
  for (const double radius : {0.7, 1.0, 1.5}) {
    const double hole = std::sqrt(radius * radius - h * h / 4);
    const Object ring = difference_of({ball({}, radius), rod({0, 2, 0}, hole)});
    EXPECT_NEAR(volume(ring, 1.5 * radius, 300), pi * h * h * h / 6, 2e-3) << radius;
  }
}

TEST(SolidVolume, OfALensOfTwoBalls) {
  // Two balls of radius R whose centres are d apart: pi (4 R + d) (2 R - d)^2 / 12.
  const double r = 1;
  for (const double d : {0.1, 0.8, 1.7}) {
    const Object lens = intersection_of({ball({-d / 2, 0, 0}, r), ball({d / 2, 0, 0}, r)});
    EXPECT_NEAR(volume(lens, 1.1), pi * (4 * r + d) * (2 * r - d) * (2 * r - d) / 12, 2e-3);
  }
}

TEST(SolidVolume, OfACubeWithoutABall) {
  const Object cube = object_of(Box{{-1, -1, -1}, {1, 1, 1}});
  EXPECT_NEAR(volume(difference_of({cube, ball({}, 0.9)}), 1.8), 8 - 4 * pi / 3 * 0.9 * 0.9 * 0.9,
              5e-3);
  // An eighth of a ball is cut from a corner.
  EXPECT_NEAR(volume(difference_of({cube, ball({1, 1, 1}, 1)}), 1.8), 8 - pi / 6, 5e-3);
}

TEST(SolidVolume, OfAUnionIsTheSumLessWhatIsCommon) {
  const Object a = ball({-0.3, 0, 0}, 0.8), b = object_of(Box{{-0.2, -0.5, -0.7}, {1, 0.6, 0.5}});
  EXPECT_NEAR(volume(union_of({a, b}), 1.6) + volume(intersection_of({a, b}), 1.6),
              volume(a, 1.6) + volume(b, 1.6), 1e-9);
}

TEST(SolidVolume, PlanesAreHalfSpaces) {
  const Object below = object_of(Plane{{0, 0, 0}, {0, 1, 0}});
  EXPECT_NEAR(volume(intersection_of({ball({}, 1), below}), 1.1), 2 * pi / 3, 2e-3)
      << "half a ball";
  std::vector<Object> faces;
  for (const Vec3d& n : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}}) {
    faces.push_back(object_of(Plane{n * 0.5, n}));
    faces.push_back(object_of(Plane{n * -0.5, -n}));
  }
  EXPECT_NEAR(volume(intersection_of(faces), 1, 300), 1, 2e-3) << "a cube of six";
}

// ---- membership -------------------------------------------------------------------------------

TEST(Solid, NestedTwentyDeepHoldsJustWhatTheOperationsKeep) {
  Random random(310);
  for (int i = 0; i < 60; ++i) {
    std::vector<Sphere> balls{{random.point(1), 2}};
    std::vector<Operation> operations;
    Object solid = object_of(balls[0]);
    for (int depth = 0; depth < 20; ++depth) {
      const Vec3d center = random.point(2);
      balls.push_back({center, random.in(0.3, 2)});
      const int kind = random.below(5);  // seldom an intersection, or nothing would be left
      operations.push_back(kind == 0  ? Operation::intersection
                           : kind < 3 ? Operation::union_
                                      : Operation::difference);
      solid = csg(operations.back(), {solid, object_of(balls.back())});
    }
    const World world = world_of({solid});
    const Geometry& geometry = *world.of_objects;
    const auto kept = [&](const Vec3d& p) {
      const auto in = [&](const Sphere& s) { return length(p - s.center) < s.radius; };
      bool inside = in(balls[0]);
      for (std::size_t k = 0; k < operations.size(); ++k) {
        const bool other = in(balls[k + 1]);
        if (operations[k] == Operation::union_) inside = inside || other;
        else inside = inside && (operations[k] == Operation::intersection) == other;
      }
      return inside;
    };
    WorkCounter work;
    for (int k = 0; k < 20; ++k) {
      const Ray<double> ray{random.point(3), random.direction()};
      const Spans& held = spans(geometry.solids[0], geometry.primitives, ray, work);
      for (double t = -9.987; t < 10; t += 0.0371) {
        bool inside = false, near = false;
        for (const Boundary& each : held) {
          inside = inside != (each.t <= t);
          near = near || std::fabs(each.t - t) < 1e-9;
        }
        ASSERT_TRUE(near || inside == kept(ray.at(t))) << t;
      }
    }
  }
}

TEST(Solid, HitIsTheFirstBoundaryAheadFromOutsideAndFromInside) {
  // A cube [-2, 2]^3 with a ball of radius 1 taken out of its middle.
  const World world =
      world_of({difference_of({object_of(Box{{-2, -2, -2}, {2, 2, 2}}), ball({}, 1)})});
  const auto t_from = [&](double z) { return hit_of(world, Ray<double>{{0, 0, z}, {0, 0, -1}}).t; };
  EXPECT_EQ(t_from(5), 3) << "outside: the face at 2";
  EXPECT_EQ(t_from(1.5), 0.5) << "in the shading: the hollow's wall at 1";
  EXPECT_EQ(t_from(0.25), 1.25) << "in the hollow: its far wall at -1";
  EXPECT_EQ(t_from(-1.5), 0.5) << "in the shading beyond: the face at -2";
  EXPECT_EQ(t_from(-3), infinity);
}

TEST(Solid, CutFaceTurnsToTheViewerAndKeepsItsBallsElementAndNormal) {
  const World world =
      world_of({difference_of({object_of(Box{{-2, -2, -2}, {2, 2, 2}}), ball({0, 0, 2}, 1)})});
  const Ray<double> ray{{0, 0, 5}, {0, 0, -1}};  // into the dent, to its bottom at z = 1
  const auto hit = hit_of(world, ray);
  EXPECT_EQ(hit.t, 4);
  EXPECT_EQ(surface(world, ray, hit, static_cast<int>(hit.primitive), true).n, (Vec3d{0, 0, 1}));
}

TEST(Solid, GroupAsOperandIsTheUnionOfItsChildrenInItsPlace) {
  Random random(311);
  TransformSteps place;
  place.steps = {Scale{Vec3d{1, 2, 0.5}}, Translate{{0.2, 0.1, 0}}};
  const Object a = ball({-0.4, 0, 0}, 0.6), b = ball({0.4, 0, 0}, 0.5);
  const Object cube = object_of(Box{{-1, -1, -1}, {1, 1, 1}});
  Object moved_a = a, moved_b = b;
  moved_a.transform = moved_b.transform = place;
  const World grouped = world_of({difference_of({cube, object_of(Group{{a, b}, {}}, place)})});
  const World apart = world_of({difference_of({cube, moved_a, moved_b})});
  for (int i = 0; i < 2000; ++i) {
    const Ray<double> ray{random.point(3), random.direction()};
    EXPECT_EQ(hit_of(grouped, ray).t, hit_of(apart, ray).t);
  }
}

TEST(Solid, OfNothingIsNeverHitAndIsInNoIndex) {
  const World apart = world_of({intersection_of({ball({-3, 0, 0}, 1), ball({3, 0, 0}, 1)})});
  EXPECT_TRUE(apart.of_objects->spaces[0].items.empty());
  const World gone = world_of({difference_of({ball({}, 1), ball({}, 2)})});
  const World same = world_of({difference_of({ball({}, 1), ball({}, 1)})});
  const Object box = object_of(Box{{-1, -1, -1}, {1, 1, 1}}, rotated_by({30, 20, 10}));
  const World turned_same = world_of({difference_of({box, box})});
  Random random(312);
  for (int i = 0; i < 1000; ++i) {
    const Ray<double> ray{random.point(3), random.direction()};
    for (const World* world : {&apart, &gone, &same, &turned_same})
      ASSERT_EQ(hit_of(*world, ray).t, infinity);
  }
}

// ---- materials --------------------------------------------------------------------------------

TEST(Solid, CutFaceShowsTheMaterialOfTheOperandWhoseSurfaceItIs) {
  Object cube = object_of(Box{{-2, -2, -2}, {2, 2, 2}});
  cube.material = matte({1, 0, 0});
  Object bare = ball({1.5, 1.5, 2}, 0.4);
  bare.material.reset();
  Object whole = difference_of({cube, ball({0, 0, 2}, 1, matte({0, 1, 0})), bare});
  whole.material = matte({0, 0, 1});
  const World world = world_of({whole});
  const auto color = [&](double x, double y) {
    const auto hit = hit_of(world, Ray<double>{{x, y, 5}, {0, 0, -1}});
    return world.shading_of(static_cast<int>(hit.primitive)).albedo.exact;
  };
  EXPECT_EQ(color(-1.5, -1.5), (Vec3d{1, 0, 0})) << "the cube's face";
  EXPECT_EQ(color(0.1, 0), (Vec3d{0, 1, 0})) << "the dent is the ball's";
  EXPECT_EQ(color(1.5, 1.5), (Vec3d{0, 0, 1})) << "a ball without its own: the solid's";
}

// ---- pictures ---------------------------------------------------------------------------------

// Where two feature images differ.
int feature_differences(const Object& one, const Object& other, IntegratorName feature) {
  Scene scene;
  scene.camera.location = {4, 3, 7};
  scene.camera.look_at = Vec3d{0, 0, 0};
  RenderOptions options;
  options.integrator = feature;
  scene.objects = {one};
  const Image a = test::picture(scene, 160, 120, options).image;
  scene.objects = {other};
  const Image b = test::picture(scene, 160, 120, options).image;
  int count = 0;
  for (std::size_t i = 0; i < a.rgb.size(); i += 3) {
    bool same = true;
    for (std::size_t k = i; k < i + 3; ++k) {
      // Both infinite, or as near as float's rounding of t or of a normal.
      same = same && (a.rgb[k] == b.rgb[k] || std::fabs(a.rgb[k] - b.rgb[k]) < 1e-5F);
    }
    count += !same;
  }
  return count;
}

void expect_equal_pictures(const Object& one, const Object& other) {
  for (const IntegratorName feature :
       {IntegratorName::normal, IntegratorName::depth, IntegratorName::object})
    EXPECT_LE(feature_differences(one, other, feature), 4) << "silhouette pixels aside";
}

TEST(Solid, DeMorgansLawsAreEqualPictures) {
  Random random(313);
  const Object x = object_of(Box{{-1, -1, -1}, {1, 1, 1}});
  for (int i = 0; i < 4; ++i) {
    const Object a =
        object_of(test::random_solid(random, random.point(0.8), 0.8), rotated_by(random.point(90)));
    const Object b =
        object_of(test::random_solid(random, random.point(0.8), 0.8), rotated_by(random.point(90)));
    expect_equal_pictures(difference_of({x, union_of({a, b})}),
                          intersection_of({difference_of({x, a}), difference_of({x, b})}));
    expect_equal_pictures(difference_of({x, intersection_of({a, b})}),
                          union_of({difference_of({x, a}), difference_of({x, b})}));
    expect_equal_pictures(difference_of({x, a, b}), difference_of({difference_of({x, a}), b}));
    expect_equal_pictures(intersection_of({x, a}), difference_of({x, difference_of({x, a})}));
  }
}

// ---- what it costs ------------------------------------------------------------------------------

// n balls of which no two overlap, along one line.
Object row_of_balls(int n) {
  std::vector<Object> balls;
  for (int i = 0; i < n; ++i) balls.push_back(ball({3.0 * i, 0, 0}, 1));
  return union_of(balls);
}

// Halves are merged with halves: each boundary is gone over once for each doubling.
TEST(Solid, MergingIsWorkThatGrowsLittleFasterThanTheBoundaries) {
  for (const int n : {64, 1024, 8192}) {
    const World world = world_of({row_of_balls(n)});
    const Geometry& geometry = *world.of_objects;
    std::int64_t done = 0;
    WorkCounter work([&](std::int64_t portion) { done += portion; });
    for (int ray = 0; ray < 2 * WorkCounter::portion / n + 2; ++ray)
      EXPECT_EQ(
          spans(geometry.solids[0], geometry.primitives, {{-5, 0, 0}, {1, 0, 0}}, work).size(),
          std::size_t(2 * n));
    const double per_ray =
        static_cast<double>(done) / static_cast<double>(2 * WorkCounter::portion / n + 2);
    EXPECT_GT(per_ray, n * std::log2(n) / 4) << n;  // a quarter of 2 n, at each of the levels
    EXPECT_LT(per_ray, n * (std::log2(n) + 4)) << n;
  }
}

TEST(Solid, ARayThroughManyOperandsCanBeEnded) {
  const World world = world_of({row_of_balls(20'000)});
  const Geometry& geometry = *world.of_objects;
  WorkCounter work([](std::int64_t) { throw Stopped(); });
  EXPECT_THROW(spans(geometry.solids[0], geometry.primitives, {{-5, 0, 0}, {1, 0, 0}}, work),
               Stopped);
}

}  // namespace
}  // namespace tia
