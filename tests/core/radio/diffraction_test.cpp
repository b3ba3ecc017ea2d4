// Diffraction by edges: the transition function, knife edges, wedges, and the field's continuity.
#include "core/radio/diffraction.h"

#include <gtest/gtest.h>

#include <complex>

#include "tests/core/radio/rooms.h"

namespace tia {
namespace {

using test::link;
using test::Random;
using Std = std::complex<double>;

// 2 j sqrt(x) e^{jx} times the integral of e^{-j t^2} from sqrt(x) on, turned onto the ray
// t = root + s e^{-j pi/4}, on which it falls as e^{-s^2}, by Simpson's rule.
Std transition_by_quadrature(double root) {
  const Std j{0, 1}, turned = std::polar(1.0, -pi / 4);
  constexpr int steps = 20'000;
  const double far = 8 / (1 + root / 4), h = far / steps;
  Std sum = 0;
  for (int i = 0; i <= steps; ++i) {
    const Std t = root + i * h * turned;
    sum += std::exp(-j * t * t) * (i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0);
  }
  return 2.0 * j * root * std::exp(j * root * root) * sum * (h / 3) * turned;
}

TEST(Diffraction, TransitionIsItsIntegral) {
  for (const double root : {1e-6, 0.01, 0.3, 1.0, 1.7, 1.9999, 2.0001, 2.5, 4.0, 9.0}) {
    const Complex got = transition(root);
    EXPECT_NEAR(std::abs(Std(got.re, got.im) - transition_by_quadrature(root)), 0, 1e-10) << root;
  }
  EXPECT_NEAR(transition(1e4).re, 1, 1e-8);
}

// A half plane x = 0, y <= 0, as the ends of a large sheet; its other ends are far away.
Scene half_plane() {
  return test::radio_scene(test::triangle_text({0, 0, -2e5}, {0, 0, 2e5}, {0, -4e5, 0}));
}
RadioQuestion over_edge(const Vec3d& from, const Vec3d& to, double hz, Polarization polarization) {
  RadioQuestion question = link(from, to, RadioMethod::image, hz);
  question.max_reflections = 1;
  question.max_diffractions = 1;
  question.transmitters[0].polarization = question.receivers[0].polarization = polarization;
  return question;
}
double total_db(const Scene& scene, const RadioQuestion& question) {
  return *radio_paths(scene, question).pairs[0].total.coherent_db;
}

// The loss behind a knife edge in dB: of (1 + j)/2 times the integral of e^{-j pi t^2/2} from v on,
// by Simpson's rule along t = v + s e^{-j pi/4}. Source: ITU-R P.526-15 (2019), (7), (27); Lee,
// "Mobile communications engineering" (1982), 4.2.
double knife_edge_loss(double v) {
  const Std j{0, 1}, turned = std::polar(1.0, -pi / 4);
  constexpr int steps = 4'000;
  constexpr double h = 8.0 / steps;
  Std sum = 0;
  for (int i = 0; i <= steps; ++i) {
    const Std t = v + i * h * turned;
    sum += std::exp(-j * (pi / 2) * t * t) * (i == 0 || i == steps ? 1.0 : i % 2 == 1 ? 4.0 : 2.0);
  }
  return -20 * std::log10(std::abs((1.0 + j) / 2.0 * sum * (h / 3)));
}

// ITU-R P.526-15 (2019), (31): J(v) = 6.9 + 20 log(sqrt((v - 0.1)^2 + 1) + v - 0.1) for v > -0.78;
// at v = 0 a half of the field, 6.02 dB.
TEST(Diffraction, KnifeEdgeIsP526s) {
  const Scene scene = half_plane();
  const double hz = 1e9, lambda = 299792458 / hz, d = 5000;
  for (const Polarization polarization : {Polarization::vertical, Polarization::horizontal}) {
    const auto loss = [&](double v) {
      const double h = v * std::sqrt(lambda * d / 4);  // v = h sqrt(2 (1/d1 + 1/d2)/lambda)
      const Vec3d from{-d, -h, 0}, to{d, -h, 0};
      const double free = 20 * std::log10(lambda / (4 * pi * 2 * d));
      return free - total_db(scene, over_edge(from, to, hz, polarization));
    };
    EXPECT_NEAR(loss(1e-7), 6.02, 0.05);
    for (const double v : {-0.7, -0.3, 0.5, 1.0, 2.0, 3.0})
      EXPECT_NEAR(loss(v), 6.9 + 20 * std::log10(std::hypot(v - 0.1, 1) + v - 0.1), 0.3) << v;
    for (const double v : {-1.0, -0.9, -0.4, 0.7, 3.0})
      EXPECT_NEAR(loss(v), knife_edge_loss(v), 0.11) << v;
  }
}

// Around a corner of 90 degrees (n = 3/2), across both shadow boundaries: 1e-4 degrees to either
// side.
TEST(Diffraction, TotalFieldIsContinuousOverBothShadowBoundaries) {
  for (const char* material : {R"({"type":"conductor"})", R"({"type":"itu","name":"concrete"})"}) {
    const Scene scene =
        test::radio_scene(test::box_text({-900, -900, -900}, {0, 0, 900}), material);
    for (const Polarization polarization : {Polarization::vertical, Polarization::horizontal}) {
      const auto at = [&](double degrees) {
        const double a = degrees * pi / 180;
        return total_db(scene, over_edge({-3, 4, 0.5}, {9 * std::cos(a), 9 * std::sin(a), 2}, 1e9,
                                         polarization));
      };
      // From {-3, 4} the incident shadow begins beyond the corner; by the face y = 0 what is
      // reflected ends over it.
      const double shadow = std::atan2(-4, 3) * 180 / pi, mirror = std::atan2(4, 3) * 180 / pi;
      for (const double boundary : {shadow, mirror})
        EXPECT_NEAR(at(boundary - 1e-4), at(boundary + 1e-4), 0.1) << material;
      EXPECT_LT(at(shadow - 20), at(shadow + 20) - 6);
    }
  }
}

// A conductor's wedge far from its boundaries is Keller's: D = e^{-j pi/4} sin(pi/n)/(n sqrt(2 pi
// k)) (1/(cos(pi/n) - cos((phi - phi')/n)) -+ 1/(cos(pi/n) - cos((phi + phi')/n))).
// Source: Keller, "Geometrical theory of diffraction", J. Opt. Soc. Am. 52 (1962), (8).
TEST(Diffraction, FarFromItsBoundariesAWedgeIsKellers) {
  Random random(2);
  RadioBody body;
  body.matter.kind = RadioMatter::conductor;
  for (int i = 0; i < 30; ++i) {
    const double n = random.in(1.2, 2), in = random.in(0.2, 1.2), hz = 1e12;
    const double out = n * pi - random.in(0.1, 0.3);
    if (std::fabs(out - in - pi) < 0.3) continue;
    const Wave wave{hz};
    const double k = wave.number();
    const Polarized got = edge_coefficients({in, out, 1, 50, 70}, n, body, wave);
    const double over = std::sin(pi / n) / (n * std::sqrt(2 * pi * k));
    const double less = 1 / (std::cos(pi / n) - std::cos((out - in) / n)),
                 more = 1 / (std::cos(pi / n) - std::cos((out + in) / n));
    const Std turned = std::polar(over, -pi / 4);
    const Std soft = turned * (less - more), hard = turned * (less + more);
    EXPECT_NEAR(std::abs(Std(got.perpendicular.re, got.perpendicular.im) - soft), 0,
                1e-3 * std::abs(turned * less));
    EXPECT_NEAR(std::abs(Std(got.parallel.re, got.parallel.im) - hard), 0,
                1e-3 * std::abs(turned * less));
  }
}

TEST(Diffraction, IsTheSameBothWaysAndByFermat) {
  const Scene scene = test::radio_scene(test::box_text({-5, -5, -5}, {0, 0, 5}),
                                        R"({"type":"itu","name":"brick"})");
  Random random(3);
  for (int i = 0; i < 10; ++i) {
    const Vec3d from = test::point_in(random, {-4, 0.4, -3}, {-2, 1, 3});
    const Vec3d to = test::point_in(random, {0.4, -4, -3}, {1, -2, 3});
    RadioQuestion question = over_edge(from, to, 3e8, Polarization::cross);
    question.max_reflections = 0;
    RadioQuestion back = question;
    std::swap(back.transmitters, back.receivers);
    const auto there = test::paths_of(scene, question), again = test::paths_of(scene, back);
    ASSERT_EQ(there.size(), again.size());
    ASSERT_GE(there.size(), 1U);
    const RadioInteraction& at = there[0].interactions.at(0);
    EXPECT_EQ(at.kind, RadioKind::diffraction);
    const auto way = [&](double z) {
      return length(Vec3d{0, 0, z} - from) + length(to - Vec3d{0, 0, z});
    };
    EXPECT_NEAR(at.point.x, 0, 1e-12);
    EXPECT_NEAR((way(at.point.z + 1e-4) - way(at.point.z - 1e-4)) / 2e-4, 0, 1e-8);
    for (std::size_t r = 0; r < 2; ++r)
      for (std::size_t t = 0; t < 2; ++t)
        EXPECT_NEAR(std::sqrt(norm_of(there[0].gain[r][t] - again[0].gain[t][r])), 0, 1e-14);
  }
}

}  // namespace
}  // namespace tia
