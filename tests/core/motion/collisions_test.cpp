// Balls among balls: the textbook's collisions, cradles, what many of them keep.
#include <gtest/gtest.h>

#include "tests/core/motion/balls.h"

namespace tia {
namespace {

using test::knot_at;
using test::momentum_along;
using test::place_at;
using test::Random;

constexpr std::size_t many_events = 1'000'000;

// Two balls on their way to each other, that meet at the time 1 with centres along n.
ExactWorld meeting(const Vec3d& n, const Vec3d& v1, const Vec3d& v2, double m1, double m2) {
  ExactWorld world;
  world.duration = 3;
  const double r1 = 0.5, r2 = 0.25;
  world.balls.push_back({n * r1 - v1, v1, r1, m1});
  world.balls.push_back({n * -r2 - v2, v2, r2, m2});
  return world;
}

// Goldstein, Classical Mechanics (2001), 3.11: momentum is kept, the velocity along the line of
// centres is turned round and multiplied by e, across it nothing changes; so
// v1' = v1 - (1 + e) m2 / (m1 + m2) ((v1 - v2) . n) n.
TEST(Collisions, AreTheTextbooksHeadOnAndOblique) {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    const Vec3d n = random.direction(), v1 = random.point(3), v2 = random.point(3);
    const double approach = dot(v1 - v2, n);
    if (approach > -0.1) continue;
    const double m1 = random.in(0.1, 10), m2 = random.in(0.1, 10), e = random.in(0, 1);
    const bool head_on = i % 3 == 0;
    const Vec3d w1 = head_on ? n * -1.5 : v1, w2 = head_on ? n * 0.5 : v2;
    ExactWorld world = meeting(n, w1, w2, m1, m2);
    world.restitution = [&](std::size_t, std::size_t) { return e; };
    const Motion motion = solve_exact(world, many_events);
    ASSERT_EQ(motion.contacts.size(), 1U);
    const BodyContact& contact = motion.contacts[0];
    EXPECT_NEAR(contact.time, 1, 1e-13);
    const double along = dot(w1 - w2, n), impulse = -(1 + e) * along * m1 * m2 / (m1 + m2);
    EXPECT_NEAR(contact.impulse, impulse, 1e-12 * impulse);
    EXPECT_LT(length(contact.normal - n), 1e-12);
    EXPECT_LT(length(contact.point), 1e-12);
    EXPECT_LT(length(motion.paths[0].back().velocity - (w1 + n * (impulse / m1))), 1e-11);
    EXPECT_LT(length(motion.paths[1].back().velocity - (w2 - n * (impulse / m2))), 1e-11);
    for (const Vec3d& axis : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}})
      EXPECT_NEAR(momentum_along(axis, world, motion, 2), momentum_along(axis, world, motion, 0),
                  1e-12 * (m1 + m2));
  }
}

// So many balls leave a row of equal ones as come, as fast as they came; the others stand still.
TEST(Collisions, OfARowOfEqualBallsPassMomentumOnAsACradleDoes) {
  for (int come = 1; come <= 3; ++come) {
    for (const bool from_left : {true, false}) {
      ExactWorld world;
      world.duration = 2;
      for (int i = 0; i < 5; ++i) {
        const bool moves = from_left ? i < come : i >= 5 - come;
        const double way = from_left ? 1 : -1;
        world.balls.push_back({{i - (moves ? way : 0), 0, 0}, {moves ? way : 0, 0, 0}, 0.5});
      }
      const Motion motion = solve_exact(world, many_events);
      for (int i = 0; i < 5; ++i) {
        const bool goes = from_left ? i >= 5 - come : i < come;
        const Knot& last = motion.paths[static_cast<std::size_t>(i)].back();
        EXPECT_EQ(last.velocity, (Vec3d{goes ? (from_left ? 1.0 : -1.0) : 0, 0, 0}))
            << come << " from " << (from_left ? "left: ball " : "right: ball ") << i;
      }
    }
  }
}

// Three balls of unequal mass that meet at once: (0, 1) is solved before (1, 2), then both again.
// v: 0 has 1, 2 has -1; m: 1, 2, 1. (0,1): 0 gets -1/3, 1 gets 2/3. (1,2): approach 5/3, impulse
// 2 * 5/3 * 2/3 = 20/9: 1 gets 2/3 - 10/9 = -4/9, 2 gets 11/9. (0,1): approach 1/9, impulse
// 2/9 * 2/3 = 4/27: 0 gets -1/3 - 4/27 = -13/27, 1 gets -4/9 + 2/27 = -10/27.
TEST(Collisions, AtOneTimeAreSolvedPairByPairInTheOrderOfTheirNumbers) {
  ExactWorld world;
  world.duration = 2;
  world.balls = {
      {{-2, 0, 0}, {1, 0, 0}, 0.5, 1}, {{}, {}, 0.5, 2}, {{2, 0, 0}, {-1, 0, 0}, 0.5, 1}};
  const Motion motion = solve_exact(world, many_events);
  ASSERT_EQ(motion.contacts.size(), 3U);
  EXPECT_NEAR(motion.paths[0].back().velocity.x, -13.0 / 27, 1e-15);
  EXPECT_NEAR(motion.paths[1].back().velocity.x, -10.0 / 27, 1e-15);
  EXPECT_NEAR(motion.paths[2].back().velocity.x, 11.0 / 9, 1e-15);
}

TEST(Collisions, GrazingOrSideBySideChangeNothing) {
  ExactWorld world;
  world.duration = 4;
  world.balls = {{{-2, 1, 0}, {1, 0, 0}, 0.5},  // passes the second at a distance of exactly 1
                 {{}, {}, 0.5},
                 {{0, 5, 0}, {0, 1, 0}, 0.5},  // two that touch and fly alike
                 {{1, 5, 0}, {0, 1, 0}, 0.5}};
  const Motion motion = solve_exact(world, many_events);
  EXPECT_EQ(motion.contacts.size(), 0U);
  EXPECT_EQ(place_at(motion.paths[0], 4), (Vec3d{2, 1, 0}));
  for (const auto& path : motion.paths) EXPECT_EQ(path.size(), 1U);
}

// In a room without gravity: 10^4 collisions.
TEST(Collisions, OfEightBallsInARoomKeepEnergyAndLeaveNoOverlap) {
  Random random(2);
  ExactWorld world = test::balls_in_room(8, 4, 0.7, 10, random);
  world.duration = test::rounds(90, 5);
  const Motion motion = solve_exact(world, many_events);
  EXPECT_GT(motion.events, test::sanitized() ? 2000U : 10'000U);
  const double energy = motion.energy.front().kinetic;
  for (const BodyEnergy& each : motion.energy) ASSERT_NEAR(each.kinetic / energy, 1, 1e-10);
  for (std::size_t i = 0; i < motion.contacts.size(); i += 4)
    ASSERT_LT(test::deepest_overlap(world, motion, 4, motion.contacts[i].time), 1e-9);
}

TEST(Collisions, OfBallsThatFallInARoomKeepEnergyAndLeaveNoOverlap) {
  Random random(3);
  ExactWorld world = test::balls_in_room(8, 4, 0.7, 3, random);
  world.gravity = {0, -9.81, 0};
  world.duration = test::rounds(40, 5);
  const Motion motion = solve_exact(world, many_events);
  const double energy = motion.energy.front().kinetic + motion.energy.front().potential;
  for (const BodyEnergy& each : motion.energy)
    ASSERT_NEAR((each.kinetic + each.potential) / energy, 1, 1e-10);
  for (const BodyContact& each : motion.contacts)
    ASSERT_LT(test::deepest_overlap(world, motion, 4, each.time), 1e-9);
}

// Elastic motion is its own reverse. Errors grow by about the free way over the radius with each
// collision of a ball, so that some tens of them can be gone back.
TEST(Collisions, RunBackwardsBringAllBack) {
  Random random(4);
  for (int i = 0; i < 20; ++i) {
    ExactWorld world = test::balls_in_room(8, 4, 0.6, 3, random);
    world.gravity = {0, -9.81, 0};
    world.duration = 0.5;
    const Motion there = solve_exact(world, many_events);
    ASSERT_LT(there.events, 50U);
    ASSERT_GT(there.events, 5U);
    ExactWorld reversed = world;
    for (std::size_t k = 0; k < 8; ++k) {
      const Knot& knot = there.paths[k].back();
      reversed.balls[k].center = center_at(knot, world.duration);
      reversed.balls[k].velocity = -velocity_at(knot, world.duration);
    }
    const Motion back = solve_exact(reversed, many_events);
    EXPECT_EQ(back.contacts.size(), there.contacts.size());
    for (std::size_t k = 0; k < 8; ++k)
      EXPECT_LT(length(place_at(back.paths[k], world.duration) - world.balls[k].center), 1e-6);
  }
}

// A duration is no part of the motion: what is computed up to a later time begins the same.
TEST(Collisions, DoNotDependOnHowLongOneLooks) {
  Random random(5);
  ExactWorld world = test::balls_in_room(27, 6, 0.7, 5, random);
  world.gravity = {0, -9.81, 0};
  world.duration = 3;
  const Motion whole = solve_exact(world, many_events);
  world.duration = 1.7;
  const Motion part = solve_exact(world, many_events);
  for (std::size_t k = 0; k < part.paths.size(); ++k)
    for (std::size_t i = 0; i < part.paths[k].size(); ++i)
      EXPECT_EQ(part.paths[k][i], whole.paths[k][i]);
}

// The same by tiny steps: balls move on by dt, and pairs that overlap and approach are turned
// round. Its error goes with dt; so only until the third collision or so.
TEST(Collisions, AreThoseOfTinySteps) {
  Random random(6);
  constexpr double dt = 2e-5;
  for (int i = 0; i < test::rounds(6, 5); ++i) {
    ExactWorld world = test::balls_in_room(8, 4, 0.7, 2, random);
    world.gravity = {0, -9.81, 0};
    world.duration = 0.25;
    const Motion motion = solve_exact(world, many_events);
    std::vector<MovingBall> balls = world.balls;
    for (int step = 0; step < 12'500; ++step) {
      for (MovingBall& ball : balls) {
        ball.center = ball.center + (ball.velocity + world.gravity * (dt / 2)) * dt;
        ball.velocity = ball.velocity + world.gravity * dt;
        const auto bounce = [&](double x, double& v) {
          if ((x < ball.radius && v < 0) || (x > 4 - ball.radius && v > 0)) v = -v;
        };
        bounce(ball.center.x, ball.velocity.x);
        bounce(ball.center.y, ball.velocity.y);
        bounce(ball.center.z, ball.velocity.z);
      }
      for (std::size_t a = 0; a < 8; ++a) {
        for (std::size_t b = a + 1; b < 8; ++b) {
          const Vec3d way = balls[a].center - balls[b].center;
          if (dot(way, way) > 1.4 * 1.4) continue;
          const Vec3d n = way * (1 / length(way));
          const double rate = dot(n, balls[a].velocity - balls[b].velocity);
          if (rate >= 0) continue;
          const double impulse = -2 * rate / (1 / balls[a].mass + 1 / balls[b].mass);
          balls[a].velocity = balls[a].velocity + n * (impulse / balls[a].mass);
          balls[b].velocity = balls[b].velocity - n * (impulse / balls[b].mass);
        }
      }
    }
    for (std::size_t k = 0; k < 8; ++k)
      EXPECT_LT(length(place_at(motion.paths[k], 0.25) - balls[k].center), 2e-3) << i << ", " << k;
  }
}

}  // namespace
}  // namespace tia
