// Implicit surfaces that other kinds of shapes give too, or whose roots are known.
#include "core/shapes/formula/implicit.h"

#include <algorithm>

#include "core/shapes/algebraic/quadric.h"
#include "core/shapes/simple/sphere.h"
#include "core/shapes/simple/torus.h"
#include "tests/core/shapes/isosurfaces.h"

namespace tia {
namespace {

using namespace test;

// Both forms along random lines, but for those that nearly touch. Returns: how many roots.
template <class A, class B>
int expect_same_roots(const A& a, const B& b, const Vec3d& center, double size, Random& random) {
  int roots = 0;
  for (int i = 0; i < rounds(100); ++i) {
    const SceneLine line = line_near(random, center, size);
    std::vector<double> expected = roots_along(b, line);
    const double pace = length(line.direction);
    bool touches = false;
    for (std::size_t k = 1; k < expected.size(); ++k)
      touches = touches || (expected[k] - expected[k - 1]) * pace < 1e-4 * size;
    if (touches) continue;
    expect_distances(roots_along(a, line), expected, 1e-9 * size / pace);
    roots += static_cast<int>(expected.size());
  }
  return roots;
}

TEST(Implicit, SphereIsTheSphere) {
  Random random(1);
  int roots = 0;
  for (int i = 0; i < rounds(60); ++i) {
    const double scale = std::ldexp(1.0, random.below(41) - 20);
    const Vec3d c = random.point(3) * scale;
    const double r = random.in(0.2, 2) * scale;
    const Bounds bounds = random.chance(0.5) ? cube_of(r * 1.2, c) : ball_of(r * 1.2, c);
    const auto form = implicit("(x-a)^2+(y-b)^2+(z-c)^2-r^2", bounds,
                               {{"a", c.x}, {"b", c.y}, {"c", c.z}, {"r", r}});
    roots += expect_same_roots(form, Sphere{c, r}, c, r, random);
  }
  EXPECT_GT(roots, rounds(6000, 500));
}

TEST(Implicit, EllipsoidIsTheQuadric) {
  Random random(2);
  int roots = 0;
  for (int i = 0; i < rounds(20); ++i) {
    const double a = random.in(0.3, 2), b = random.in(0.3, 2), c = random.in(0.3, 2);
    const Parameters halves{{"a", a}, {"b", b}, {"c", c}};
    const auto form = implicit("(x/a)^2 + (y/b)^2 + (z/c)^2 - 1", cube_of(2.1), halves);
    const Quadric quadric{{1 / (a * a), 1 / (b * b), 1 / (c * c), 0, 0, 0, 0, 0, 0, -1}, {}};
    roots += expect_same_roots(form, prepare(quadric), {}, 2, random);
  }
  EXPECT_GT(roots, rounds(1000, 500));
}

TEST(Implicit, TorusIsTheTorus) {
  Random random(3);
  int roots = 0;
  for (int i = 0; i < rounds(20); ++i) {
    const double major = random.in(0.5, 2), minor = major * random.in(0.1, 0.9);
    const std::string text = random.chance(0.5) ? "(sqrt(x^2+z^2)-a)^2 + y^2 - b^2"
                                                : "(x^2+y^2+z^2+a^2-b^2)^2 - 4*a^2*(x^2+z^2)";
    const auto form = implicit(text, cube_of(major + 1.1 * minor), {{"a", major}, {"b", minor}});
    roots += expect_same_roots(form, prepare(Torus{major, minor}), {}, major + minor, random);
  }
  EXPECT_GT(roots, rounds(1500, 500));
}

TEST(Implicit, FactorsMoveNoRoot) {
  Random random(4);
  int roots = 0;
  for (const char* factor : {"1e12", "1e-12", "-1", "1e60", "1e-60", "1e170", "1e-170"}) {
    const std::string torus = "((sqrt(x^2+z^2)-1)^2 + y^2 - 0.16)";
    const auto form = implicit(std::string(factor) + "*" + torus, cube_of(1.6));
    roots += expect_same_roots(form, prepare(Torus{1, 0.4}), {}, 1.4, random);
  }
  EXPECT_GT(roots, rounds(500));
}

TEST(Implicit, FarFromTheOriginKeepsItsShape) {
  Random random(5);
  for (const double far : {1e3, 1e6, -1e6}) {
    const Vec3d c{far, -far, far / 2};
    const auto form = implicit("sqrt((x-a)^2+(y-b)^2+(z-c)^2)-1", cube_of(1.3, c),
                               {{"a", c.x}, {"b", c.y}, {"c", c.z}});
    for (int i = 0; i < 100; ++i) {
      const SceneLine line = line_near(random, c, 1);
      const std::vector<double> expected = roots_along(Sphere{c, 1}, line);
      const double pace = length(line.direction);
      if (expected.size() == 2 && (expected[1] - expected[0]) * pace < 0.01) continue;
      expect_distances(roots_along(form, line), expected, 1e-7 / pace);
    }
  }
}

TEST(Implicit, FlatBoundsAreSearchedAsWell) {
  // Long and thin: cells are no cubes, and far from the middle floats are coarse.
  Random random(6);
  for (const double length : {1e2, 1e4, 1e6}) {
    const auto form = implicit("y - 0.5*sin(x)*cos(z)", box_of({-length, -1, -1}, {length, 1, 1}));
    for (int i = 0; i < 200; ++i) {
      const double x = random.in(-length, length), z = random.in(-1, 1);
      expect_distances(roots_along(form, {{x, 7, z}, {0, -1, 0}}),
                       {7 - 0.5 * std::sin(x) * std::cos(z)}, 1e-9);
    }
  }
}

TEST(Implicit, SmallBallInALongBoxKeepsItsShape) {
  Random random(11);
  int roots = 0;
  for (int i = 0; i < rounds(5); ++i) {
    const Vec3d c{random.in(0.6e6, 1e6), 0, 0};
    const double r = random.in(0.05, 0.5);
    const auto form = implicit("sqrt((x-a)^2+y^2+z^2)-r", box_of({-1e6, -1, -1}, {1e6, 1, 1}),
                               {{"a", c.x}, {"r", r}});
    for (int k = 0; k < rounds(40, 5); ++k) {
      const Vec3d target = c + random.vector(0, 0.9 * r), d = random.direction();
      const SceneLine line{target - d * 3.0, d};
      expect_distances(roots_along(form, line), roots_along(Sphere{c, r}, line), 1e-7);
      roots += 2;
    }
  }
  EXPECT_GT(roots, rounds(300, 30));
}

// ---- double roots, thin sheets ---------------------------------------------------------------

TEST(Implicit, TouchedSurfaceStandsTwice) {
  Random random(7);
  const auto form = implicit("(x^2+y^2+z^2-1)^2", cube_of(1.5));
  int roots = 0;
  for (int i = 0; i < 200; ++i) {
    const SceneLine line = line_near(random, {}, 1);
    const double pace = length(line.direction);
    std::vector<double> twice;
    for (const double t : roots_along(Sphere{{}, 1}, line)) twice.insert(twice.end(), 2, t);
    if (twice.size() == 4 && (twice[2] - twice[1]) * pace < 0.05) continue;
    expect_distances(roots_along(form, line), twice, 1e-7 / pace);
    const std::vector<Crossing> solid = spans_along(form, line);
    for (std::size_t k = 0; k + 1 < solid.size(); k += 2)
      EXPECT_EQ(solid[k].t, solid[k + 1].t) << "it has no inside";
    roots += static_cast<int>(twice.size());
  }
  EXPECT_GT(roots, 200);
}

TEST(Implicit, ThinSheetsKeepBothSides) {
  Random random(8);
  for (const double half : {1e-2, 1e-4, 1e-6}) {
    const auto form = implicit("x^2-h^2", cube_of(1), {{"h", half}});
    for (int i = 0; i < 200; ++i) {
      const Vec3d p{0, random.in(-0.5, 0.5), random.in(-0.5, 0.5)};
      const Vec3d d = normalize(Vec3d{1, random.in(-0.4, 0.4), random.in(-0.4, 0.4)});
      const SceneLine line{p - d * 3.0, d};
      const std::vector<double> expected{3 - half / d.x, 3 + half / d.x};
      expect_distances(roots_along(form, line), expected, 1e-11);
      expect_distances(ends_of(spans_along(form, line)), expected, 1e-11);
    }
  }
}

TEST(Implicit, NearlyTangentLinesFindBothRoots) {
  // At height 1 - e the chord is 2 sqrt(2e - e^2) long.
  const auto form = implicit("x^2+y^2+z^2-1", cube_of(1.25));
  for (const double e : {1e-3, 1e-5, 1e-7, 1e-9, 1e-11}) {
    const double half = std::sqrt(2 * e - e * e);
    expect_distances(roots_along(form, {{-5, 1 - e, 0}, {1, 0, 0}}), {5 - half, 5 + half},
                     1e-14 / half);
    EXPECT_TRUE(roots_along(form, {{-5, 1 + e, 0}, {1, 0, 0}}).empty()) << e;
  }
}

TEST(Implicit, BoundsCutTheSurfaceOpenAndTheSolidClosed) {
  Random random(9);
  const auto form = implicit("x^2+y^2+z^2-1", cube_of(0.8));
  for (int i = 0; i < 300; ++i) {
    const SceneLine line = line_near(random, {}, 1);
    const std::vector<double> box = roots_along(Box{{-0.8, -0.8, -0.8}, {0.8, 0.8, 0.8}}, line);
    const std::vector<double> ball = roots_along(Sphere{{}, 1}, line);
    if (box.empty() || ball.empty()) {
      EXPECT_TRUE(roots_along(form, line).empty() && spans_along(form, line).empty());
      continue;
    }
    const double tolerance = 1e-7 / length(line.direction);
    expect_distances(roots_along(form, line), clipped(ball, box[0], box[1]), tolerance);
    const double in = std::max(box[0], ball[0]), out = std::min(box[1], ball[1]);
    expect_distances(ends_of(spans_along(form, line)),
                     in < out ? std::vector{in, out} : std::vector<double>{}, tolerance);
  }
}

TEST(Implicit, TwoOfOneTextAreTheSameToTheBit) {
  Random random(10);
  const std::string text = "sin(3*x)*cos(2*y)+z*exp(-x^2)-0.1";
  const auto a = implicit(text, cube_of(2)), b = implicit(text, cube_of(2));
  for (int i = 0; i < 100; ++i) {
    const SceneLine line = line_near(random, {}, 2);
    EXPECT_EQ(roots_along(a, line), roots_along(b, line));
  }
}

TEST(Implicit, LinesThatHaveNaNCrossNothing) {
  expect_nothing_from_nan(implicit("x^2+y^2+z^2-1", cube_of(2)));
}

}  // namespace
}  // namespace tia
