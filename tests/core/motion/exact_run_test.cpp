// The run as a whole: entrances, errors, limits, jams, and what is told of it.
#include <gtest/gtest.h>

#include "core/motion/contact_forces.h"
#include "core/motion/falls.h"
#include "core/motion/shakes.h"
#include "core/motion/thinned.h"
#include "core/parallel/stopped.h"
#include "tests/core/motion/balls.h"

namespace tia {
namespace {

using test::place_at;
using test::Random;

constexpr std::size_t limit = 200'000;

// ---- entrances ----------------------------------------------------------------------------------

TEST(ExactRun, ABallEntersInMidAirAndLeaves) {
  ExactWorld world;
  world.duration = 10;
  world.balls = {{{0, 0, 0}, {}, 0.5},
                 {{-3, 0, 0}, {2, 0, 0}, 0.5, 1, 4, 7},
                 {{8, 0, 0}, {}, 0.5, 1, 0, 5}};  // gone before the first could meet it
  const Motion motion = solve_exact(world, limit);
  ASSERT_EQ(motion.contacts.size(), 1U);
  EXPECT_EQ(motion.contacts[0].time, 5);
  EXPECT_EQ(motion.paths[1].front().time, 4);
  EXPECT_EQ(motion.paths[1].front().center, (Vec3d{-3, 0, 0}));
  EXPECT_EQ(place_at(motion.paths[0], 10), (Vec3d{10, 0, 0}));
  EXPECT_EQ(motion.energy.back().kinetic, 2);
}

TEST(ExactRun, WhatComesOrGoesIsAStepOfTheEnergy) {
  ExactWorld world;
  world.duration = 3;
  world.balls = {{{0, 0, 0}, {2, 0, 0}, 0.5, 1, 1, 2}};
  std::vector<std::pair<double, double>> told;
  for (const BodyEnergy& each : solve_exact(world, limit).energy)
    told.emplace_back(each.time, each.kinetic);
  EXPECT_EQ(told, (std::vector<std::pair<double, double>>{{1, 0}, {1, 2}, {2, 2}, {2, 0}, {3, 0}}));
}

// What lay on a ball that leaves falls on.
TEST(ExactRun, WhatRestedOnABallThatLeavesFalls) {
  ExactWorld world;
  world.gravity = {0, -10, 0};
  world.duration = 3;
  world.fixed.push_back(FixedPlane{});
  world.balls = {{{0, 1, 0}, {}, 1, 1, 0, 2}, {{0, 3, 0}, {}, 1}};
  world.restitution = [](std::size_t, std::size_t) { return 0; };
  const Motion motion = solve_exact(world, limit);
  EXPECT_EQ(place_at(motion.paths[1], 2).y, 3);
  EXPECT_NEAR(place_at(motion.paths[1], 2.5).y, 3 - 10 * 0.25 / 2, 1e-14);
  EXPECT_NEAR(place_at(motion.paths[1], 3).y, 1, 1e-14);
}

void expect_overlap(const ExactWorld& world, std::size_t a, std::size_t b, double time) {
  try {
    solve_exact(world, limit);
    ADD_FAILURE() << "no overlap was found";
  } catch (const BodiesOverlap& overlap) {
    EXPECT_EQ(overlap.a, a);
    EXPECT_EQ(overlap.b, b);
    EXPECT_EQ(overlap.time, time);
  }
}

TEST(ExactRun, ABallThatAppearsInAnotherOrInAFixedThingIsAnError) {
  ExactWorld world;
  world.duration = 10;
  world.fixed = {FixedPlane{{0, -5, 0}}, FixedSphere{{0, 20, 0}, 1}};
  world.balls = {{{0, 0, 0}, {1, 0, 0}, 0.5}, {{5, 0, 0}, {}, 0.5}};
  world.balls[1].center.x = 0.999;
  expect_overlap(world, 0, 1, 0);
  world.balls[1] = {{4.2, 0, 0}, {}, 0.5, 1, 4};  // where the first has come to by then
  expect_overlap(world, 0, 1, 4);
  world.balls[1] = {{9, -4.6, 0}, {}, 0.5, 1, 3};
  expect_overlap(world, 1, 2, 3);
  world.balls[1] = {{0, 21.4, 0}, {}, 0.5};
  expect_overlap(world, 1, 3, 0);
  world.balls[1] = {{0, 20, 0}, {}, 0.5};  // within a hollow ball
  EXPECT_NO_THROW(solve_exact(world, limit));
}

// ---- limits and jams ----------------------------------------------------------------------------

TEST(ExactRun, EndsAtTheLimitOfEventsOrWhenItIsStopped) {
  Random random(1);
  ExactWorld world = test::balls_in_room(8, 4, 0.7, 10, random);
  world.duration = 1000;
  try {
    solve_exact(world, 500);
    ADD_FAILURE() << "it went on";
  } catch (const TooManyEvents& many) {
    EXPECT_EQ(many.most, 500U);
    EXPECT_GT(many.time, 0);
    EXPECT_LT(many.time, 1000);
  }
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(solve_exact(world, limit, source.get_token()), Stopped);
}

// Between two walls that leave no room, and elastic: its bounces have no time between them.
TEST(ExactRun, ABallThatIsJammedEndsAtTheLimit) {
  ExactWorld world;
  world.duration = 1;
  world.fixed = {FixedPlane{{-0.5, 0, 0}, {1, 0, 0}}, FixedPlane{{0.5, 0, 0}, {1, 0, 0}}};
  world.balls = {{{0, 0, 0}, {1, 0, 0}, 0.5}};
  EXPECT_THROW(solve_exact(world, 1000), TooManyEvents);
  world.balls[0].velocity = {0, 1, 0};  // but along the walls it moves freely
  EXPECT_EQ(place_at(solve_exact(world, 1000).paths[0], 1), (Vec3d{0, 1, 0}));
  world.balls[0].velocity = {1, 1, 0};  // and where every bounce takes some it comes to that
  world.restitution = [](std::size_t, std::size_t) { return 0.5; };
  const Motion motion = solve_exact(world, 1000);
  EXPECT_NEAR(place_at(motion.paths[0], 1).x, 0, 1e-11);
  EXPECT_EQ(place_at(motion.paths[0], 1).y, 1);
}

// Balls in a row on a floor between a wall and one that comes: they come to rest, without overlap.
TEST(ExactRun, ARowThatIsPushedDownhillRestsAtTheWall) {
  ExactWorld world;
  world.gravity = {2, -10, 0};
  world.duration = 20;
  world.fixed = {FixedPlane{}, FixedPlane{{10, 0, 0}, {1, 0, 0}}};
  for (int i = 0; i < 5; ++i) world.balls.push_back({{i * 1.5 + 1, 0.5, 0}, {}, 0.5});
  world.restitution = [](std::size_t, std::size_t) { return 0.4; };
  const Motion motion = solve_exact(world, limit);
  for (std::size_t i = 0; i < 5; ++i) {
    const Vec3d at = place_at(motion.paths[i], 20);
    EXPECT_NEAR(at.x, 5.5 + static_cast<double>(i), 1e-9);
    EXPECT_NEAR(at.y, 0.5, 1e-11);
  }
}

// A heap in a box comes to overlap nowhere, as long as it goes.
TEST(ExactRun, AHeapOfBallsNeverOverlaps) {
  Random random(2);
  ExactWorld world = test::balls_in_room(27, 4.5, 0.5, 1, random);
  world.gravity = {0, -9.81, 0};
  world.duration = 0.9;
  world.restitution = [](std::size_t, std::size_t) { return 0.5; };
  const Motion motion = solve_exact(world, limit);
  for (double t = 0; t < world.duration; t += 0.01)
    ASSERT_LT(test::deepest_overlap(world, motion, 4.5, t), 1e-9) << t;
}

// Two layers in a narrow box, whatever their restitution: they come to rest, energy never grows and
// nothing overlaps. At rest they are neither moved nor pulled, and the lower layer is on the floor.
TEST(ExactRun, AHeapOfBallsComesToRest) {
  Random random(6);
  for (const double e : {0.5, 0.0, 0.8}) {
    if (e != 0.5 && test::sanitized()) continue;
    ExactWorld world = test::balls_in_room(8, 2.2, 0.5, 1, random);
    world.gravity = {0, -9.81, 0};
    world.duration = 40;
    world.restitution = [e](std::size_t, std::size_t) { return e; };
    const Motion motion = solve_exact(world, limit);
    for (double t = 0; t < world.duration; t += t < 4 ? 0.02 : 1)
      ASSERT_LT(test::deepest_overlap(world, motion, 2.2, t), 1e-9) << e << " at " << t;
    double before = std::numeric_limits<double>::infinity();
    for (const BodyEnergy& each : motion.energy) {
      ASSERT_LE(each.kinetic + each.potential, before + 1e-8) << e << " at " << each.time;
      before = each.kinetic + each.potential;
    }
    int on_floor = 0;
    for (const auto& path : motion.paths) {
      EXPECT_LT(length(path.back().velocity), 1e-9) << e;
      EXPECT_LT(length(path.back().acceleration), 1e-7) << e;
      on_floor += path.back().center.y < 0.5 + 1e-9 ? 1 : 0;
    }
    EXPECT_GE(on_floor, 3) << e;
  }
}

// ---- what it does not depend on -----------------------------------------------------------------

// At a late time the clock's own digits are fewer: 2^-33 s at 10^6 s.
TEST(ExactRun, LateTimesLoseTheirDigitsAndNoMore) {
  ExactWorld world;
  world.duration = 2e6;
  world.fixed = test::room(4);
  world.balls = {{{2, 2, 2}, {1, 0, 0}, 0.5, 1, 1e6}};
  world.duration = 1e6 + 100;
  const Motion motion = solve_exact(world, limit);
  // To the wall 1.5, back and forth 3 each.
  ASSERT_EQ(motion.contacts.size(), 33U);
  EXPECT_NEAR(motion.contacts.back().time, 1e6 + 1.5 + 32 * 3, 1e-7);
}

// A mesh of a hundred balls that fall: as brute force over all pairs has it, no ball is in another.
TEST(ExactRun, ManyBallsInManyCellsMissNoContact) {
  Random random(3);
  ExactWorld world = test::balls_in_room(test::rounds(200, 4), 12, 0.6, 6, random);
  for (MovingBall& ball : world.balls) ball.radius = random.in(0.1, 0.9);
  world.gravity = {0, -9.81, 0};
  world.duration = 1;
  const Motion motion = solve_exact(world, limit);
  EXPECT_GT(motion.events, world.balls.size());
  for (double t = 0; t < 1; t += 1.0 / 64)
    ASSERT_LT(test::deepest_overlap(world, motion, 12, t), 1e-9) << t;
}

// ---- parts --------------------------------------------------------------------------------------

TEST(Falls, AreWhereAGapClosesAndWhereAnOverlapBegins) {
  const auto falls = [](std::vector<double> c, GapStart start = GapStart::apart) {
    const Falls all = falls_of(c, 100, start);
    return std::vector<double>(all.begin(), all.end());
  };
  EXPECT_EQ(falls({2, -1}), std::vector<double>{2});
  EXPECT_EQ(falls({2, 1}), std::vector<double>{});
  EXPECT_EQ(falls({2, -3, 1}), std::vector<double>{1});   // (t - 1)(t - 2)
  EXPECT_EQ(falls({-2, 3, -1}), std::vector<double>{2});  // the same, turned over
  EXPECT_EQ(falls({0, 1, -1}, GapStart::touching), std::vector<double>{1});
  EXPECT_EQ(falls({0, -1, 1}, GapStart::touching), std::vector<double>{});
  EXPECT_EQ(falls({-1, 1, -0.125}), std::vector<double>{4 + std::sqrt(8.0)});
  EXPECT_EQ(falls({-1, 1, -0.5}), std::vector<double>{1});  // below 0 all the time
  // (t - 1)(t - 2)(t - 3)(t - 4)
  const auto quartic = falls({24, -50, 35, -10, 1});
  ASSERT_EQ(quartic.size(), 2U);
  EXPECT_NEAR(quartic[0], 1, 1e-14);
  EXPECT_NEAR(quartic[1], 3, 1e-14);
}

// f >= 0, M f + b >= 0 and one of both 0 for each: what defines them, for random contacts of up to
// twelve on three bodies, so that most depend on each other.
TEST(ContactForces, PressWhereNothingGivesWayAndNowhereElse) {
  Random random(4);
  for (int i = 0; i < 300; ++i) {
    const std::size_t n = static_cast<std::size_t>(random.whole(1, 12));
    std::vector<Vec3d> rows(n);
    for (Vec3d& row : rows) row = random.direction();
    const Vec3d pull = random.point(1);
    ContactMatrix matrix(n);
    std::vector<double> b(n);
    for (std::size_t j = 0; j < n; ++j) {
      for (std::size_t k = 0; k < n; ++k) matrix.at(j, k) = dot(rows[j], rows[k]);
      b[j] = dot(rows[j], pull);
    }
    const std::vector<double> forces = nonnegative_forces(matrix, b, 1e-12);
    for (std::size_t j = 0; j < n; ++j) {
      double rate = b[j];
      for (std::size_t k = 0; k < n; ++k) rate += matrix.at(j, k) * forces[k];
      EXPECT_GE(forces[j], 0);
      EXPECT_GE(rate, -1e-9);
      EXPECT_NEAR(forces[j] * rate, 0, 1e-9);
    }
  }
}

// A free ball's bounces, each e times as long as the one before, from 1e-3 s on until they rest at
// 1e-6 s, never are; bounces that do not become shorter are after n with e^n < 1e-4, and until they
// are left alone for 1e-3 s.
TEST(Shakes, AreOfHeapsAndNotOfAFreeBall) {
  Random random(7);
  for (int i = 0; i < 100; ++i) {
    const double e = random.in(0.05, 0.99);
    Shakes free, heap;
    double now = random.in(0, 10);
    for (double apart = 2e-3; apart > 1e-6; now += apart, apart *= e) {
      free.note(1, now, e, false);
      ASSERT_FALSE(free.contains(1, now, true)) << e;
    }
    const double most = std::log(1e-4) / std::log(e);
    for (int bounces = 1; bounces < most + 2; ++bounces) {
      now += 5e-7;
      heap.note(1, now, e, heap.contains(1, now, false));
      EXPECT_EQ(heap.contains(1, now, false), bounces > most) << e;
    }
    EXPECT_FALSE(heap.contains(2, now, true));
    EXPECT_TRUE(heap.contains(1, now + 9e-4, false));
    EXPECT_FALSE(heap.contains(1, now + 1.1e-3, false));
    EXPECT_TRUE(heap.contains(1, now + 1.1e-3, true));  // rests until then
  }
}

TEST(Thinned, KeepsEveryKthTheFirstAndTheLast) {
  for (const int count : {0, 1, 5, 10, 11, 100, 1001}) {
    Thinned<int> list(10);
    for (int i = 0; i < count; ++i) list.add(i);
    const std::vector<int> kept = std::move(list).take();
    EXPECT_LE(kept.size(), 10U);
    if (count == 0) continue;
    EXPECT_EQ(kept.front(), 0);
    EXPECT_EQ(kept.back(), count - 1);
    for (std::size_t i = 2; i + 1 < kept.size(); ++i)
      EXPECT_EQ(kept[i] - kept[i - 1], kept[1] - kept[0]);
  }
}

}  // namespace
}  // namespace tia
