// What channels say between their keys, by formulas written out here.
#include "core/models/animation.h"

#include <gtest/gtest.h>

#include <complex>

#include "tests/core/support.h"

namespace tia::test {
namespace {

AnimationChannel channel_of(AnimatedPath path, Interpolation interpolation,
                            std::vector<float> times, std::vector<float> values) {
  return {0, path, interpolation, std::move(times), std::move(values)};
}

TEST(Animation, LinearIsOnTheLineBetweenKeys) {
  const AnimationChannel channel =
      channel_of(AnimatedPath::translation, Interpolation::linear, {1, 3}, {0, 0, 8, 4, 2, 0});
  EXPECT_EQ(sampled(channel, 2), (std::vector<double>{2, 1, 4}));
  EXPECT_EQ(sampled(channel, 1.5), (std::vector<double>{1, 0.5, 6}));
}

TEST(Animation, BeforeTheFirstKeyAndAfterTheLastIsTheirs) {
  for (const auto interpolation : {Interpolation::linear, Interpolation::step}) {
    const AnimationChannel channel =
        channel_of(AnimatedPath::scale, interpolation, {1, 3}, {1, 2, 3, 4, 5, 6});
    for (const double early : {-5.0, 0.0, 1.0})
      EXPECT_EQ(sampled(channel, early), (std::vector<double>{1, 2, 3}));
    for (const double late : {3.0, 50.0})
      EXPECT_EQ(sampled(channel, late), (std::vector<double>{4, 5, 6}));
  }
}

TEST(Animation, StepKeepsTheKeyBefore) {
  const AnimationChannel channel =
      channel_of(AnimatedPath::weights, Interpolation::step, {0, 1, 2}, {1, 2, 3});
  EXPECT_EQ(sampled(channel, 0.999), (std::vector<double>{1}));
  EXPECT_EQ(sampled(channel, 1), (std::vector<double>{2}));
  EXPECT_EQ(sampled(channel, 1.5), (std::vector<double>{2}));
}

// The quaternion of an angle about z, as (0, 0, sin, cos) of its half: between two of them the
// angle goes evenly, the short way round.
TEST(Animation, RotationsGoEvenlyTheShortWay) {
  Random random(3);
  for (int i = 0; i < 200; ++i) {
    const double from = random.in(-3, 3), to = from + random.in(-3.1, 3.1), share = random.unit();
    const float side = random.below(2) == 0 ? 1.0F : -1.0F;  // the same rotation
    const auto half = [](double angle, double (*f)(double)) {
      return static_cast<float>(f(angle / 2));
    };
    const AnimationChannel channel =
        channel_of(AnimatedPath::rotation, Interpolation::linear, {0, 2},
                   {0, 0, half(from, std::sin), half(from, std::cos), 0, 0,
                    side * half(to, std::sin), side * half(to, std::cos)});
    const std::vector<double> q = sampled(channel, 2 * share);
    const double angle = from + share * (to - from);
    const std::complex<double> got(q[3], q[2]);
    const auto wanted = std::polar(1.0, angle / 2);
    EXPECT_NEAR(std::abs((got * std::conj(wanted)).real()), 1, 1e-6);
    EXPECT_NEAR(std::abs(got), 1, 1e-12);
  }
}

TEST(Animation, EqualRotationsStay) {
  const AnimationChannel channel =
      channel_of(AnimatedPath::rotation, Interpolation::linear, {0, 1}, {0, 0, 0, 2, 0, 0, 0, 2});
  EXPECT_EQ(sampled(channel, 0.3), (std::vector<double>{0, 0, 0, 1}));
}

// A cubic with those values and slopes at its ends: a + b t + c t^2 + d t^3 by solving for it.
TEST(Animation, CubicSplinesAreThePolynomialOfTheirEnds) {
  Random random(4);
  for (int i = 0; i < 100; ++i) {
    std::array<float, 6> all;  // in-tangent, value, out-tangent of both keys
    for (float& each : all) each = static_cast<float>(random.in(-4, 4));
    const auto first = static_cast<float>(random.in(0, 2));
    const auto last = first + static_cast<float>(random.in(0.1, 3));
    const AnimationChannel channel = channel_of(AnimatedPath::weights, Interpolation::cubic_spline,
                                                {first, last}, {all.begin(), all.end()});
    const Long length = Long{last} - first;
    const double at = random.in(first, last);
    const Long s = at - Long{first};
    const Long p = all[1], q = all[4], m = all[2], k = all[3];
    const Long c = (3 * (q - p) / length - 2 * m - k) / length;
    const Long d = (2 * (p - q) / length + m + k) / (length * length);
    EXPECT_NEAR(sampled(channel, at)[0], static_cast<double>(p + m * s + c * s * s + d * s * s * s),
                1e-9);
  }
}

TEST(Animation, LastsUntilItsLastKey) {
  ModelAnimation animation;
  EXPECT_EQ(duration_of(animation), 0);
  animation.channels = {channel_of(AnimatedPath::weights, Interpolation::step, {0, 2.5F}, {1, 2}),
                        channel_of(AnimatedPath::weights, Interpolation::step, {0, 1}, {1, 2})};
  EXPECT_EQ(duration_of(animation), 2.5);
}

}  // namespace
}  // namespace tia::test
