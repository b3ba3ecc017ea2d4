// What a matt floor gets in path from lights with an area, whole and cut off: closed forms of
// irradiance.
#include "tests/core/integrators/paths.h"

namespace tia {
namespace {

using namespace test;

Light quad_light(const Vec3d& corner, const Vec3d& u, const Vec3d& v) {
  return light_of(QuadLight{corner, u, v});
}
Finish shining(double light) {
  Finish finish = dark();
  finish.emission = {light, light, light};
  return finish;
}

// ---- balls --------------------------------------------------------------------------------------

// A ball of radiance 1 above the horizon: E = pi (r / d)^2 cos.
// Source: Howell, "A catalog of radiation heat transfer configuration factors", sphere.
TEST(Irradiance, OfABallIsItsFormFactor) {
  Random random(823);
  for (int i = 0; i < rounds(6, 3); ++i) {
    LitFloor floor(random);
    const double d = random.in(2, 5), r = random.in(0.2, 0.9), slant = random.in(0, 0.9);
    const Vec3d up = normalize(floor.point(slant, 0, 1));
    floor.scene.lights = {sphere_light(up * d, r)};
    ASSERT_GT(d * dot(up, floor.frame.n), r);
    expect_mean(floor.irradiance(256), pi * r * r / (d * d) * dot(up, floor.frame.n));
  }
}

// Where the horizon cuts it: Lambert's integral over the rest of its disc in the sky.
// Source: Snyder, "Area light sources for real-time graphics" (1996); checked by quadrature.
TEST(Irradiance, OfABallInTheHorizonIsThatOfWhatIsAboveIt) {
  Random random(824);
  for (int i = 0; i < rounds(8, 4); ++i) {
    LitFloor floor(random);
    const double d = random.in(1, 4), sine = random.in(0.2, 0.9);
    const double c = random.in(-0.6, 0.9) * sine, s = std::sqrt(1 - c * c);
    floor.scene.lights = {sphere_light(floor.point(s, 0, c) * d, sine * d)};
    const double x = std::sqrt(1 / (sine * sine) - 1), y = -x * c / s;
    const double q = s * std::sqrt(1 - y * y);
    floor.eye = floor.point(-0.05, 0, 0.05);
    expect_mean(floor.irradiance(512), (c * std::acos(y) - x * q) * sine * sine + std::atan(q / x),
                1e-4);
  }
}

// ---- discs, polygons
// -----------------------------------------------------------------------------

// E = pi / 2 (1 - (h^2 + d^2 - r^2) / sqrt((h^2 + d^2 + r^2)^2 - 4 r^2 d^2)), d off its axis.
// Source: Howell, as above, disc in a parallel plane.
TEST(Irradiance, OfADiscBesideItsAxisIsItsFormFactor) {
  Random random(826);
  for (int i = 0; i < rounds(6, 3); ++i) {
    LitFloor floor(random);
    const double h = random.in(0.5, 2), r = random.in(0.3, 2), d = random.in(0, 2);
    floor.scene.objects.push_back(object(Disc{floor.point(d, 0, h), floor.frame.n, r}, shining(1)));
    const double sum = h * h + d * d + r * r;
    expect_mean(floor.irradiance(512),
                pi / 2 * (1 - (sum - 2 * r * r) / std::sqrt(sum * sum - 4 * r * r * d * d)), 1e-4);
  }
}

// Straight above a corner, parallel, and upright beside the point. Source: Howell, as above.
TEST(Irradiance, OfRectanglesFromTheirCornersIsTheirFormFactor) {
  Random random(827);
  for (int i = 0; i < rounds(6, 3); ++i) {
    LitFloor floor(random);
    const double a = random.in(0.3, 2), b = random.in(0.3, 2), c = random.in(0.5, 2);
    const auto across = [&](double x, double y) {
      const double far = std::hypot(x, c);
      return x / far * std::atan(y / far);
    };
    floor.scene.lights = {quad_light(floor.point(0, 0, c), floor.frame.u * a, floor.frame.v * b)};
    expect_mean(floor.irradiance(256), (across(a, b) + across(b, a)) / 2);
    floor.scene.lights = {quad_light(floor.point(c, 0, 0), floor.frame.v * a, floor.frame.n * b)};
    const double far = std::hypot(b, c);
    expect_mean(floor.irradiance(256), (std::atan(a / c) - c / far * std::atan(a / far)) / 2);
  }
}

// At any slant by Lambert's formula, be it one light or a mesh of several parts.
TEST(Irradiance, OfAQuadIsLambertsFormulaAndThatOfItsMesh) {
  Random random(828);
  for (int i = 0; i < rounds(6, 3); ++i) {
    LitFloor floor(random);
    const Vec3d corner = floor.point(random.in(-2, 1), random.in(-2, 1), random.in(1, 3));
    const Vec3d u = floor.point(random.in(0.5, 2), 0, random.in(0, 0.5));
    const Vec3d v = floor.point(0, random.in(0.5, 2), random.in(0, 0.5));
    const double expected =
        polygon_irradiance({corner, corner + u, corner + u + v, corner + v}, floor.frame.n);
    floor.scene.lights = {quad_light(corner, u, v)};
    const Mean quad = floor.irradiance(256);
    expect_mean(quad, expected);
    floor.scene.lights.clear();
    // A fan around a point within it.
    const Vec3d within = corner + u * random.in(0.2, 0.8) + v * random.in(0.2, 0.8);
    floor.scene.objects.push_back(
        object(mesh_of({corner, corner + u, corner + u + v, corner + v, within},
                       {0, 1, 4, 1, 2, 4, 2, 3, 4, 3, 0, 4}),
               shining(1)));
    const Mean mesh = floor.irradiance(512);
    expect_mean(mesh, expected, 1e-4);
    expect_equal(mesh, quad, 1e-4);
  }
}

// Across the penumbra of a straight edge: a half plane hides from x all of the light that lies
// beyond the edge's projection, and what is left is a rectangle, Lambert's.
TEST(Irradiance, BehindAStraightEdgeIsThatOfTheRectangleThatIsSeen) {
  Random random(829);
  const LitFloor any(random);
  const double half = 0.6, width = 0.4, top = 3, low = 1.2;
  constexpr int places = 7;
  double last = 10;
  for (int i = 0; i < (sanitized() ? 3 : places); ++i) {
    // Shares of the light that are seen: 0.95, ... 0.05.
    const double seen = 0.95 - 0.9 * i / (places - 1);
    // The edge lies over the floor's line 0, and is seen from x before x + (0 - x) top / low.
    const double cut = half * (2 * seen - 1), x = cut / (1 - top / low);
    LitFloor floor = any;
    floor.scene.lights = {quad_light(floor.point(-half - x, -width, top),
                                     floor.frame.u * (2 * half), floor.frame.v * (2 * width))};
    floor.scene.objects.push_back(
        object(mesh_of({floor.point(-x, -99, low), floor.point(99, -99, low),
                        floor.point(99, 99, low), floor.point(-x, 99, low)},
                       {0, 1, 2, 0, 2, 3}),
               dark()));
    const double left = -half - x, right = cut - x;
    const double expected =
        polygon_irradiance({floor.point(left, -width, top), floor.point(right, -width, top),
                            floor.point(right, width, top), floor.point(left, width, top)},
                           floor.frame.n);
    const Mean mean = floor.irradiance(1024);
    expect_mean(mean, expected, 1e-4);
    EXPECT_LT(mean.value, last);
    last = mean.value;
  }
}

// ---- many lights
// ---------------------------------------------------------------------------------

// However one of them is chosen: points give I cos / d^2, balls pi (r / d)^2 cos, quads Lambert's.
// They stand so far apart in the sky that none hides another.
TEST(Irradiance, OfManyLightsIsTheirSum) {
  Random random(832);
  for (const int count : {3, 12, 60}) {
    LitFloor floor(random);
    double expected = 0;
    for (int i = 0; i < count; ++i) {
      const double z = 0.2 + 0.8 * (i + 0.5) / count, turn = 2.399963 * i;  // the golden angle
      const double aside = std::sqrt(1 - z * z), d = random.in(1, 8), power = random.in(0.1, 9) * d;
      const Vec3d at = floor.point(aside * std::cos(turn), aside * std::sin(turn), z) * d;
      const double r = random.in(0.01, 0.1) * d;
      const Vec3d u = random.vector(0.02, 0.1) * d, v = random.vector(0.02, 0.1) * d;
      const Light lights[] = {point_light(at), sphere_light(at, r), quad_light(at, u, v)};
      const double given[] = {z / (d * d), pi * r * r / (d * d) * z,
                              polygon_irradiance({at, at + u, at + u + v, at + v}, floor.frame.n)};
      floor.scene.lights.push_back(lights[i % 3]);
      floor.scene.lights.back().intensity = power;
      expected += power * given[i % 3];
    }
    expect_mean(floor.irradiance(1024), expected, 1e-4);
  }
}

}  // namespace
}  // namespace tia
