// Implicit surfaces of many sheets, all of which a line must find.
#include <gtest/gtest.h>

#include "core/accel/world/all_hits.h"
#include "tests/core/shapes/isosurfaces.h"

namespace tia {
namespace {

using namespace test;

World world_of_implicit(const Implicit& implicit) {
  Scene scene;
  scene.objects.push_back({"", implicit, {}, {}});
  return compile(scene);
}

// By the form itself, by /all and by the first hit.
void expect_everywhere(const World& world, const SceneLine& line,
                       const std::vector<double>& expected, double tolerance) {
  const auto& form = std::get<IsosurfaceForm>(world.primitive(0).form);
  expect_distances(roots_along(form, line), expected, tolerance);
  const Ray<double> ray{line.origin, line.direction};
  std::vector<double> all;
  for (const Meeting& each : all_hits(world, ray)) all.push_back(each.t);
  expect_distances(all, expected, tolerance, "all hits: ");
  WorkCounter work;
  const double first = closest_hit(world, ray, true, work).t;
  if (expected.empty()) EXPECT_EQ(first, double(infinity));
  else EXPECT_NEAR(first, expected.front(), tolerance);
}

// ---- sums of Chebyshev polynomials -----------------------------------------------------------

// T_2, T_3 and T_5 of each other: T_m(T_n) = T_mn.
std::string chebyshev_text(std::string x, const std::vector<int>& factors) {
  for (const int n : factors) {
    const std::string a = "(" + x + ")";
    if (n == 2) x = "2*" + a + "^2-1";
    if (n == 3) x = "4*" + a + "^3-3*" + a;
    if (n == 5) x = "16*" + a + "^5-20*" + a + "^3+5*" + a;
  }
  return "(" + x + ")";
}
std::string sum_of(const std::function<std::string(const std::string&)>& term) {
  return term("x") + "+" + term("y") + "+" + term("z");
}

// T_n(cos a) = cos na: along x the roots are the cosines of (+-acos c + 2 pi k) / n.
std::vector<double> cosines(double c, int n) {
  std::vector<double> all;
  for (int k = 0; k <= n; ++k)
    for (const double sign : {-1.0, 1.0}) {
      const double angle = (sign * std::acos(c) + 2 * pi * k) / n;
      if (angle >= 0 && angle <= pi) all.push_back(std::cos(angle));
    }
  std::sort(all.begin(), all.end());
  return all;
}

TEST(ImplicitSheets, ChebyshevSumsHaveAllTheirRoots) {
  Random random(1);
  const std::map<int, std::vector<int>> factors{
      {2, {2}},       {3, {3}},     {4, {2, 2}},     {5, {5}},     {6, {2, 3}},
      {8, {2, 2, 2}}, {10, {2, 5}}, {12, {2, 2, 3}}, {15, {3, 5}}, {20, {2, 2, 5}}};
  int roots = 0;
  for (const auto& [n, parts] : factors) {
    if (sanitized() && n != 6) continue;
    const std::vector<int> of = parts;
    const Implicit polynomial{
        sum_of([&](const auto& x) { return chebyshev_text(x, of); }), cube_of(1), {}};
    const Implicit cosine{sum_of([](const auto& x) { return "cos(n*acos(" + x + "))"; }),
                          random.chance(0.5) ? cube_of(1) : cube_of(1.3),
                          {{"n", double(n)}}};
    const World one = world_of_implicit(polynomial), other = world_of_implicit(cosine);
    for (int i = 0; i < 25; ++i) {
      const double y = random.in(-1, 1), z = random.in(-1, 1);
      const double c = -(std::cos(n * std::acos(y)) + std::cos(n * std::acos(z)));
      if (std::fabs(c) > 0.999) continue;
      std::vector<double> expected = cosines(c, n);
      ASSERT_EQ(expected.size(), std::size_t(n));
      for (double& each : expected) each += 3;
      expect_everywhere(one, {{-3, y, z}, {1, 0, 0}}, expected, 1e-10);
      expect_everywhere(other, {{-3, y, z}, {1, 0, 0}}, expected, 1e-10);
      expect_distances(
          roots_along(std::get<IsosurfaceForm>(other.primitive(0).form), {{z, -3, y}, {0, 1, 0}}),
          expected, 1e-10);
      roots += n;
    }
  }
  EXPECT_GT(roots, rounds(800, 100));
}

// ---- the gyroid ------------------------------------------------------------------------------

// Along x it is a sin x + b cos x + c with a = cos y, b = sin z, c = sin y cos z, that is
// r sin(x + phi) + c with r^2 = a^2 + b^2: 0 where x + phi is asin(-c/r) or pi less that.
std::vector<double> gyroid_roots(double y, double z, double from, double to) {
  const double a = std::cos(y), b = std::sin(z), c = std::sin(y) * std::cos(z);
  const double r = std::sqrt(a * a + b * b), phi = std::atan2(b, a);
  std::vector<double> all;
  if (std::fabs(c) >= r) return all;
  const double turn = std::asin(-c / r);
  for (const double first : {turn - phi, pi - turn - phi}) {
    const double k = std::ceil((from - first) / (2 * pi));
    for (double x = first + 2 * pi * k; x <= to; x += 2 * pi) all.push_back(x);
  }
  std::sort(all.begin(), all.end());
  return all;
}

TEST(ImplicitSheets, GyroidHasAllItsRoots) {
  Random random(2);
  int roots = 0;
  for (const double half : {1.0, pi, 6 * pi, 40 * pi}) {
    const Implicit gyroid{"sin(x)*cos(y)+sin(y)*cos(z)+sin(z)*cos(x)", cube_of(half), {}};
    const World world = world_of_implicit(gyroid);
    const auto& form = std::get<IsosurfaceForm>(world.primitive(0).form);
    for (int i = 0; i < 60; ++i) {
      const double y = random.in(-half, half), z = random.in(-half, half), start = half + 2;
      std::vector<double> t = gyroid_roots(y, z, -half, half);
      bool touches = false;
      for (std::size_t k = 1; k < t.size(); ++k) touches = touches || t[k] - t[k - 1] < 1e-4;
      if (touches) continue;
      for (double& each : t) each += start;
      roots += static_cast<int>(t.size());
      // It is the same in x, y, z by turns.
      expect_distances(roots_along(form, {{-start, y, z}, {1, 0, 0}}), t, 1e-9);
      expect_distances(roots_along(form, {{z, -start, y}, {0, 1, 0}}), t, 1e-9);
      if (i < 10) expect_everywhere(world, {{y, z, -start}, {0, 0, 1}}, t, 1e-9);
    }
  }
  EXPECT_GT(roots, 2000);
}

TEST(ImplicitSheets, GyroidWithinABall) {
  Random random(3);
  const double radius = 9;
  int roots = 0;
  const auto form = implicit("sin(x)*cos(y)+sin(y)*cos(z)+sin(z)*cos(x)", ball_of(radius));
  for (int i = 0; i < 300; ++i) {
    const double y = random.in(-9, 9), z = random.in(-9, 9), left = radius * radius - y * y - z * z;
    if (left < 1e-3) continue;
    const double half = std::sqrt(left);
    std::vector<double> t = gyroid_roots(y, z, -half, half);
    bool touches = false;
    for (std::size_t k = 1; k < t.size(); ++k) touches = touches || t[k] - t[k - 1] < 1e-4;
    if (touches) continue;
    expect_distances(roots_along(form, {{0, y, z}, {1, 0, 0}}), t, 1e-9);
    roots += static_cast<int>(t.size());
  }
  EXPECT_GT(roots, 500);
}

}  // namespace
}  // namespace tia
