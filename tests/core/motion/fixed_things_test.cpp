// Balls and fixed things: bounces, rest, sliding, faces, edges, corners and rims.
#include <gtest/gtest.h>

#include "tests/core/motion/balls.h"

namespace tia {
namespace {

using test::knot_at;
using test::place_at;
using test::Random;

constexpr std::size_t most_events = 1'000'000;
constexpr double g = 9.81;

auto bouncing(double e) {
  return [e](std::size_t, std::size_t) { return e; };
}
ExactWorld falling(const Vec3d& center, const Vec3d& velocity, double e) {
  ExactWorld world;
  world.gravity = {0, -g, 0};
  world.balls.push_back({center, velocity, 0.5});
  world.restitution = bouncing(e);
  return world;
}
FixedBox box(const Vec3d& low, const Vec3d& high) {
  const Vec3d size = high - low;
  return {low, {Vec3d{size.x, 0, 0}, Vec3d{0, size.y, 0}, Vec3d{0, 0, size.z}}};
}

// ---- bounces and rest ---------------------------------------------------------------------------

// From a height h it takes t0 = sqrt(2 h / g); bounce k leaves at v e^k, v = g t0, comes back after
// 2 e^k t0 and rises to h e^2k: a geometric series. It rests at the first bounce whose next would
// come within 1e-6 s.
TEST(FixedThings, ADropBouncesByTheGeometricSeriesAndRests) {
  for (const double e : {0.2, 0.5, 0.8, 0.95}) {
    const double h = 1.25, t0 = std::sqrt(2 * h / g);
    ExactWorld world = falling({0, h + 0.5, 0}, {1, 0, 0}, e);
    world.duration = 30;
    world.fixed.push_back(FixedPlane{});
    const Motion motion = solve_exact(world, most_events);
    const auto& path = motion.paths[0];
    double time = t0, share = 1;
    std::size_t bounce = 1;
    for (;; ++bounce) {
      ASSERT_LT(bounce, path.size());
      const Knot& knot = path[bounce];
      share *= e;
      EXPECT_NEAR(knot.time, time, 1e-12);
      EXPECT_NEAR(knot.center.y, 0.5, 1e-14);
      if (2 * share * t0 < 1e-6) break;
      EXPECT_NEAR(knot.velocity.y, share * g * t0, 1e-11);
      const double top = place_at(path, time + share * t0).y;
      EXPECT_NEAR(top - 0.5, h * share * share, 1e-12);
      time += 2 * share * t0;
    }
    EXPECT_EQ(bounce + 1, path.size());
    EXPECT_EQ(path.back().velocity, (Vec3d{1, 0, 0}));
    EXPECT_EQ(path.back().acceleration, Vec3d{});
    EXPECT_EQ(motion.contacts.size(), bounce);
  }
}

TEST(FixedThings, AFastBallDoesNotPassAThinWall) {
  for (const double at : {0.0, 0.3, 7.7}) {
    ExactWorld world;
    world.duration = 1;
    world.balls.push_back({{-at - 0.01, 0.1, 0.2}, {1000, 0, 0}, 0.002});
    world.fixed.push_back(box({0, -1, -1}, {0.001, 1, 1}));
    const Motion motion = solve_exact(world, most_events);
    ASSERT_EQ(motion.contacts.size(), 1U);
    EXPECT_NEAR(motion.contacts[0].time, (at + 0.008) / 1000, 1e-15);
    EXPECT_EQ(motion.paths[0].back().velocity, (Vec3d{-1000, 0, 0}));
  }
}

// Gravity without its part along the normal: g sin(slope) downhill.
TEST(FixedThings, ABallSlidesDownAnIncline) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const double slope = random.in(0.05, 1.5);
    const double sine = std::sin(slope), cosine = std::cos(slope);
    const Vec3d normal{sine, cosine, 0}, downhill{cosine, -sine, 0};
    ExactWorld world = falling(normal * 0.5, downhill * -0.3, 0.5);
    world.duration = 3;
    world.fixed.push_back(FixedPlane{{}, normal});
    const Motion motion = solve_exact(world, most_events);
    ASSERT_EQ(motion.paths[0].size(), 1U);
    const double way = -0.3 * 3 + g * sine * 9 / 2;
    EXPECT_LT(length(place_at(motion.paths[0], 3) - (normal * 0.5 + downhill * way)), 1e-12);
  }
}

// Of a groove the line is left, of a corner nothing.
TEST(FixedThings, ABallRestsInAGrooveAndInACorner) {
  ExactWorld world = falling({0.3, 3, 0}, {0, 0, 1}, 0.4);
  world.duration = 10;
  world.fixed = {FixedPlane{{}, {-1, 1, 0}}, FixedPlane{{}, {2, 1, 0}}};
  const Motion groove = solve_exact(world, most_events);
  const Knot& slides = groove.paths[0].back();
  EXPECT_LT(length(slides.velocity - Vec3d{0, 0, 1}), 1e-12);
  EXPECT_EQ(slides.acceleration, Vec3d{});
  world.gravity.z = 2;
  world.fixed.push_back(FixedPlane{{0, 0, 5}, {0.1, 0.1, -1}});
  const Motion corner = solve_exact(world, most_events);
  const Knot& rests = corner.paths[0].back();
  EXPECT_LT(length(rests.velocity), 1e-11);
  EXPECT_EQ(rests.acceleration, Vec3d{});
  EXPECT_LT(rests.time, 9);
  for (const FixedShape& shape : world.fixed) {
    const auto& plane = std::get<FixedPlane>(shape);
    EXPECT_NEAR(dot(plane.normal, rests.center - plane.point) / length(plane.normal), 0.5, 1e-11);
  }
}

// A ball that rests is struck by an equal one along the floor, and takes its velocity.
TEST(FixedThings, ABallThatRestsMayBeStruckAndLeft) {
  ExactWorld world = falling({0, 0.5, 0}, {}, 1);
  world.duration = 3;
  world.fixed.push_back(FixedPlane{});
  world.balls.push_back({{-3, 0.5, 0}, {2, 0, 0}, 0.5});
  const Motion motion = solve_exact(world, most_events);
  ASSERT_EQ(motion.contacts.size(), 1U);
  EXPECT_NEAR(motion.contacts[0].time, 1, 1e-14);
  EXPECT_LT(length(motion.paths[0].back().velocity - Vec3d{2, 0, 0}), 1e-15);
  EXPECT_LT(length(motion.paths[1].back().velocity), 1e-15);
}

// Off a table at a speed of v the ball turns about the edge while it presses, m v^2 / r < m g cos:
// faster than sqrt(g r) it flies at once.
TEST(FixedThings, AFastBallFliesOffATableAndASlowOneTurnsAboutItsEdge) {
  for (const bool fast : {true, false}) {
    const double v = fast ? 2.3 : 0.5;  // sqrt(9.81 / 2) = 2.215
    ExactWorld world = falling({0, 0.5, 0}, {v, 0, 0}, 0.5);
    world.duration = 1 / v + 0.2;
    world.fixed.push_back(box({-1, -1, -1}, {1, 0, 1}));
    const Motion motion = solve_exact(world, most_events);
    const Vec3d at = place_at(motion.paths[0], world.duration);
    const double flown = 0.5 - g * 0.04 / 2;
    if (fast) EXPECT_NEAR(at.y, flown, 1e-10);
    else EXPECT_NEAR(length(at - Vec3d{1, 0, 0}), 0.5, 1e-9);
  }
}

// ---- the parts of fixed things ------------------------------------------------------------------

// A ball that is thrown at a point of the offset surface whose nearest surface point and normal are
// known touches there: it is aimed along a straight line, and comes back by the mirrored velocity.
void expect_contact(const FixedShape& shape, const Vec3d& point, const Vec3d& normal,
                    Random& random) {
  const double r = random.in(0.1, 0.4);
  Vec3d velocity = random.vector(0.5, 2);
  const double along = dot(velocity, normal);
  velocity = velocity - normal * (along + std::fabs(along) + 0.3);
  ExactWorld world;
  world.duration = 2;
  const double before = 1e-3;  // so near that nothing else is met first
  world.balls.push_back({point + normal * r - velocity * before, velocity, r});
  world.fixed.push_back(shape);
  const Motion motion = solve_exact(world, most_events);
  ASSERT_GE(motion.contacts.size(), 1U);
  const BodyContact& contact = motion.contacts[0];
  EXPECT_NEAR(contact.time, before, 1e-12);
  EXPECT_LT(length(contact.point - point), 1e-10);
  EXPECT_LT(length(contact.normal - normal), 1e-9);
  EXPECT_EQ(contact.b, 1U);
  const Vec3d mirrored = velocity - normal * (2 * dot(velocity, normal));
  EXPECT_LT(length(velocity_at(knot_at(motion.paths[0], before * 1.01), before) - mirrored), 1e-8);
}

TEST(FixedThings, ATriangleIsMetAtItsFaceItsEdgesAndItsCorners) {
  Random random(2);
  FixedMesh mesh{{{0, 0, 0}, {3, 0, 0}, {0, 0, 3}}, {{0, 1, 2}}};
  for (int i = 0; i < 100; ++i) {
    const double x = random.in(0.2, 1.4), z = random.in(0.2, 1.4);
    const Vec3d up{0, random.chance(0.5) ? 1.0 : -1.0, 0};
    expect_contact(mesh, {x, 0, z}, up, random);
    // An edge is met from outside its own face, within half a turn.
    const double angle = random.in(0, 2 * pi);
    const Vec3d aside = Vec3d{-std::fabs(std::cos(angle)), std::sin(angle), 0};
    expect_contact(mesh, {0, 0, z}, aside, random);
    const Vec3d away = unit(Vec3d{-random.in(0.1, 1), random.in(-1, 1), -random.in(0.1, 1)});
    expect_contact(mesh, {0, 0, 0}, away, random);
  }
}

TEST(FixedThings, ABoxIsMetFromOutsideAndFromInside) {
  Random random(3);
  const FixedBox shape{{1, 2, 3}, {Vec3d{2, 1, 0}, Vec3d{-1, 2, 0}, Vec3d{0, 0, 3}}};
  for (int i = 0; i < 100; ++i) {
    const Vec3d on_face =
        shape.corner + shape.edges[0] * random.in(0.2, 0.8) + shape.edges[2] * random.in(0.2, 0.8);
    const Vec3d normal = unit(shape.edges[1]) * (random.chance(0.5) ? 1.0 : -1.0);
    expect_contact(shape, on_face, normal, random);
    const double angle = random.in(0.1, 1.4);
    const Vec3d out =
        unit(shape.edges[0]) * -std::cos(angle) + unit(shape.edges[1]) * -std::sin(angle);
    expect_contact(shape, shape.corner + shape.edges[2] * random.in(0, 1), out, random);
    const Vec3d far = -(unit(shape.edges[0]) * random.in(0.1, 1) +
                        unit(shape.edges[1]) * random.in(0.1, 1) + Vec3d{0, 0, random.in(0.1, 1)});
    expect_contact(shape, shape.corner, unit(far), random);
  }
}

TEST(FixedThings, ACylinderIsMetAtItsSideItsEndsAndItsRims) {
  Random random(4);
  const FixedCylinder shape{{0, 0, -1}, {0, 0, 2}, 1.5};
  for (int i = 0; i < 100; ++i) {
    const double turn = random.in(0, 2 * pi), way = random.chance(0.5) ? 1 : -1;
    const Vec3d out{std::cos(turn), std::sin(turn), 0};
    expect_contact(shape, out * 1.5 + Vec3d{0, 0, random.in(-0.4, 1.4)}, out * way, random);
    expect_contact(shape, out * random.in(0, 0.9) + Vec3d{0, 0, 2}, {0, 0, way}, random);
    const double angle = random.in(0.05, 1.5);
    expect_contact(shape, out * 1.5 + Vec3d{0, 0, 2},
                   out * std::cos(angle) + Vec3d{0, 0, std::sin(angle)}, random);
  }
}

TEST(FixedThings, ACapsuleAndASphereAreMetFromBothSides) {
  Random random(5);
  const FixedCapsule capsule{{0, 0, -1}, {0, 0, 2}, 1.5};
  const FixedSphere sphere{{3, 2, 1}, 2};
  for (int i = 0; i < 100; ++i) {
    const double turn = random.in(0, 2 * pi), way = random.chance(0.5) ? 1 : -1;
    const Vec3d out{std::cos(turn), std::sin(turn), 0};
    expect_contact(capsule, out * 1.5 + Vec3d{0, 0, random.in(-1, 2)}, out * way, random);
    Vec3d any = random.direction();
    expect_contact(sphere, sphere.center + any * 2.0, any * way, random);
    any.z = std::fabs(any.z);
    expect_contact(capsule, Vec3d{0, 0, 2} + any * 1.5, any * way, random);
  }
}

// ---- along what is curved -----------------------------------------------------------------------

// From rest near the top of a ball of radius R a point mass leaves it two thirds of the way up:
// m v^2 / R = m g cos, v^2 = 2 g R (1 - cos). The centre runs on R = 1 + 0.5.
TEST(FixedThings, ABallLeavesASphereAtTwoThirdsOfItsHeight) {
  const double start = 1e-2;
  ExactWorld world = falling({start, std::sqrt(2.25 - start * start), 0}, {}, 0);
  world.duration = 5;
  world.fixed.push_back(FixedSphere{{}, 1});
  const Motion motion = solve_exact(world, most_events);
  const Knot& leaves = motion.paths[0].back();
  const double height = world.balls[0].center.y * 2 / 3;
  EXPECT_NEAR(leaves.center.y, height, 1e-5);
  EXPECT_NEAR(length(leaves.velocity), std::sqrt(g * height), 1e-5);
  EXPECT_EQ(leaves.acceleration, world.gravity);
  for (const Knot& knot : motion.paths[0]) ASSERT_NEAR(length(knot.center), 1.5, 1e-9);
}

// In a hollow cylinder of radius R a ball of radius r swings as a pendulum of length l = R - r: of
// a small swing a the period is 2 pi sqrt(l / g) (1 + a^2 / 16). Landau, Lifshitz, Mechanics, 11.
TEST(FixedThings, ABallSwingsInAHollowCylinder) {
  const double l = 1, a = 0.05;
  ExactWorld world = falling({l * std::sin(a), -l * std::cos(a), 0}, {}, 0);
  const double period = 2 * pi * std::sqrt(l / g) * (1 + a * a / 16);
  world.duration = 3 * period;
  world.fixed.push_back(FixedCylinder{{0, 0, -2}, {0, 0, 2}, 1.5});
  const Motion motion = solve_exact(world, most_events);
  EXPECT_EQ(motion.contacts.size(), 0U);
  for (int k = 0; k <= 3; ++k) {
    EXPECT_NEAR(place_at(motion.paths[0], k * period).x, l * std::sin(a), 1e-6);
    if (k < 3) EXPECT_NEAR(place_at(motion.paths[0], (k + 0.5) * period).x, -l * std::sin(a), 1e-6);
  }
}

// ---- meshes -------------------------------------------------------------------------------------

FixedMesh floor_of_triangles(int n, double height) {
  FixedMesh mesh;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= n; ++j) mesh.points.push_back({i - n / 2.0, height, j - n / 2.0});
  const auto at = [&](int i, int j) { return static_cast<std::uint32_t>(i * (n + 1) + j); };
  for (int i = 0; i < n; ++i) {
    for (int j = 0; j < n; ++j) {
      mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j)});
      mesh.triangles.push_back({at(i, j + 1), at(i + 1, j + 1), at(i + 1, j)});
    }
  }
  return mesh;
}

TEST(FixedThings, AFlatMeshIsAPlane) {
  Random random(6);
  for (int i = 0; i < test::rounds(20, 5); ++i) {
    const Vec3d velocity{random.in(-1, 1), 0, random.in(-1, 1)};
    ExactWorld world = falling({random.in(-1, 1), random.in(0.5, 2), 0}, velocity, 0.5);
    world.duration = 3;
    world.fixed.push_back(floor_of_triangles(12, 0));
    const Motion mesh = solve_exact(world, most_events);
    world.fixed[0] = FixedPlane{};
    const Motion plane = solve_exact(world, most_events);
    ASSERT_EQ(mesh.contacts.size(), plane.contacts.size());
    for (const double t : {0.3, 1.0, 1.7, 3.0})
      EXPECT_LT(length(place_at(mesh.paths[0], t) - place_at(plane.paths[0], t)), 1e-11);
  }
}

}  // namespace
}  // namespace tia
