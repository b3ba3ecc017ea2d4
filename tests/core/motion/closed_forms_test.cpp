// Motions that mechanics knows in closed form, of the exact solver, for parameters by chance.
#include <gtest/gtest.h>

#include "tests/core/motion/balls.h"

namespace tia {
namespace {

using test::knot_at;
using test::place_at;
using test::Random;

constexpr std::size_t events_enough = 1'000'000;
constexpr double weight = 9.81;

// A block of 100^n times the mass comes to a ball that rests before a wall: without a loss there
// are floor(10^n pi) collisions. Galperin, "Playing pool with pi", Regular and Chaotic Dynamics 8
// (2003).
TEST(ClosedForms, ABlockABallAndAWallCountTheDigitsOfPi) {
  const std::array<std::size_t, 4> counts{3, 31, 314, 3141};
  double mass = 1;
  for (const std::size_t count : counts) {
    ExactWorld world;
    world.duration = 100;
    world.fixed = {FixedPlane{{}, {1, 0, 0}}};
    world.balls = {{{2, 0, 0}, {}, 0.5, 1}, {{4, 0, 0}, {-1, 0, 0}, 0.5, mass}};
    const Motion motion = solve_exact(world, events_enough);
    EXPECT_EQ(motion.contacts.size(), count);
    EXPECT_NEAR(motion.energy.back().kinetic, mass / 2, 1e-11 * mass);
    mass *= 100;
  }
}

// Bounces on a slope: along the normal a drop under g cos, with times of flight 2 e^k t0, t0 =
// sqrt(2 h / g); along the slope nothing acts but g sin, so that s = g sin t^2 / 2 all the time.
TEST(ClosedForms, BouncesDownASlope) {
  Random random(1);
  for (int i = 0; i < 100; ++i) {
    const double slope = random.in(0.05, 1.3), h = random.in(0.1, 3), e = random.in(0.3, 1);
    const double radius = random.in(0.1, 2), g = random.in(1, 30);
    const Vec3d n{std::sin(slope), std::cos(slope), 0}, down{std::cos(slope), -std::sin(slope), 0};
    ExactWorld world;
    world.gravity = {0, -g, 0};
    world.duration = 1e3;
    world.fixed = {FixedPlane{{3, 4, 5}, n}};
    const Vec3d start = Vec3d{3, 4, 5} + n * (radius + h * std::cos(slope));
    world.balls = {{start, {}, radius, random.in(0.1, 9)}};
    world.restitution = [e](std::size_t, std::size_t) { return e; };
    const double t0 = std::sqrt(2 * h / g);
    world.duration = t0 * (1 + 2 * e + 2 * e * e + 1.5 * e * e * e);
    const Motion motion = solve_exact(world, events_enough);
    ASSERT_EQ(motion.contacts.size(), 3U);
    double time = t0, flight = 2 * t0;
    for (const BodyContact& contact : motion.contacts) {
      EXPECT_NEAR(contact.time, time, 1e-12 * time);
      const double way = g * std::sin(slope) * time * time / 2;
      const Vec3d at = start - n * (radius + h * std::cos(slope)) + down * way;
      EXPECT_LT(length(contact.point - at), 1e-11 * (1 + way));
      flight *= e;
      time += flight;
    }
  }
}

// In a hollow cylinder of radius R a ball of radius r is a circle's billiard of radius R - r: all
// chords are as far from the middle as the first, b, and each turns by 2 acos(b / (R - r)).
// Tabachnikov, Geometry and Billiards (2005), chapter 2.
TEST(ClosedForms, ACirclesBilliard) {
  Random random(2);
  for (int i = 0; i < 20; ++i) {
    const double inner = random.in(0.5, 2), radius = random.in(0.1, 1), speed = random.in(0.5, 5);
    const double x = random.in(-0.9, 0.9) * inner, angle = random.in(0.2, pi - 0.2);
    ExactWorld world;
    world.fixed = {FixedCylinder{{0, 0, -9}, {0, 0, 9}, inner + radius}};
    world.balls = {{{x, 0, 0}, Vec3d{std::cos(angle), std::sin(angle), 0} * speed, radius}};
    const double b = x * std::sin(angle);  // about z: x v_y / v
    const double half = std::sqrt(inner * inner - b * b);
    const double first = (-x * std::cos(angle) + half) / speed;
    constexpr int hits = 40;
    world.duration = first + (hits - 0.5) * 2 * half / speed;
    const Motion motion = solve_exact(world, events_enough);
    ASSERT_EQ(motion.contacts.size(), std::size_t{hits});
    const Vec3d met = world.balls[0].center + world.balls[0].velocity * first;
    const double turn = 2 * std::acos(std::fabs(b) / inner) * (b < 0 ? -1 : 1);
    const double start = std::atan2(met.y, met.x);
    for (int k = 0; k < hits; ++k) {
      const BodyContact& contact = motion.contacts[static_cast<std::size_t>(k)];
      EXPECT_NEAR(contact.time, first + k * 2 * half / speed, 1e-10);
      const Vec3d out{std::cos(start + k * turn), std::sin(start + k * turn), 0};
      EXPECT_LT(length(contact.point - out * (inner + radius)), 1e-9) << k;
    }
  }
}

// A light ball on a heavy one, M, dropped together: the floor turns the heavy one to e v, they
// meet at (1 + e) v, and m goes up with v ((1 + e)^2 M / (M + m) - 1). Harter, "Velocity
// amplification in collision experiments involving superballs", Am. J. Phys. 39 (1971).
TEST(ClosedForms, ALightBallOnAHeavyOneIsThrownHigher) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const double heavy = random.in(3, 100), light = random.in(0.1, 0.7), e = random.in(0.7, 1);
    const double h = random.in(0.1, 5), r = random.in(0.2, 1), s = random.in(0.1, 0.2);
    ExactWorld world;
    world.gravity = {0, -weight, 0};
    world.fixed = {FixedPlane{}};
    world.balls = {{{0, h + r, 0}, {}, r, heavy}, {{0, h + 2 * r + s, 0}, {}, s, light}};
    world.restitution = [e](std::size_t, std::size_t) { return e; };
    const double t0 = std::sqrt(2 * h / weight), v = weight * t0;
    world.duration = t0 * 1.01;
    const Motion motion = solve_exact(world, events_enough);
    const double share = heavy / (heavy + light), up = v * ((1 + e) * (1 + e) * share - 1);
    const double other = e * v - (1 + e) * (1 + e) * v * light / (heavy + light);
    EXPECT_NEAR(velocity_at(knot_at(motion.paths[1], t0 * 1.005), t0).y, up, 1e-11 * up);
    EXPECT_NEAR(velocity_at(knot_at(motion.paths[0], t0 * 1.005), t0).y, other, 1e-11 * up);
  }
}

// Two equal balls of restitution e: one hits the other off its middle by b, with sin a = b / (2 r):
// the struck one leaves along the line of centres at v (1 + e) / 2 cos a; for e = 1 the paths are
// at a right angle. Landau, Lifshitz, Mechanics, section 17.
TEST(ClosedForms, AHitOffTheMiddlePartsEqualBalls) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    const double r = random.in(0.1, 2), e = i % 2 == 0 ? 1 : random.in(0, 1);
    const double a = random.in(-1.4, 1.4), v = random.in(0.5, 20);
    ExactWorld world;
    world.duration = 100 * r / v;
    world.balls = {{{-9 * r, 2 * r * std::sin(a), 0}, {v, 0, 0}, r}, {{}, {}, r}};
    world.restitution = [e](std::size_t, std::size_t) { return e; };
    const Motion motion = solve_exact(world, events_enough);
    ASSERT_EQ(motion.contacts.size(), 1U);
    EXPECT_NEAR(motion.contacts[0].time, (9 - 2 * std::cos(a)) * r / v, 1e-12 * r / v * 10);
    const Vec3d struck = motion.paths[1].back().velocity, rest = motion.paths[0].back().velocity;
    const Vec3d line{std::cos(a), -std::sin(a), 0};
    EXPECT_LT(length(struck - line * (v * (1 + e) / 2 * std::cos(a))), 1e-11 * v);
    EXPECT_LT(length(rest + struck - Vec3d{v, 0, 0}), 1e-12 * v);
    if (e == 1) EXPECT_NEAR(dot(struck, rest), 0, 1e-11 * v * v);
  }
}

}  // namespace
}  // namespace tia
