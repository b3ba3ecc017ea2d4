#include "core/shapes/algebraic/algebraic.h"

#include <map>
#include <utility>

#include "core/shapes/algebraic/quadric.h"
#include "core/shapes/simple/torus.h"
#include "tests/core/shapes/lines.h"

namespace tia {
namespace {

using enum FaultKind;
using namespace test;

// Poly: a polynomial in x, y and z by its coefficients, to write surfaces as their authors do and
// to expand them; its value is each term's powers one by one, in long double.
struct Poly {
  std::map<std::array<int, 3>, double> c;
  Poly(double constant) : c{{{0, 0, 0}, constant}} {}
  Poly(std::array<int, 3> powers) : c{{powers, 1}} {}

  Long sum(const Vec3l& p, bool magnitudes) const {
    Long sum = 0;
    for (const auto& [powers, coefficient] : c) {
      Long term = static_cast<Long>(coefficient);
      for (int i = 0; i < powers[0]; ++i) term *= p.x;
      for (int i = 0; i < powers[1]; ++i) term *= p.y;
      for (int i = 0; i < powers[2]; ++i) term *= p.z;
      sum += magnitudes ? std::fabs(term) : term;
    }
    return sum;
  }
  Long operator()(const Vec3l& p) const { return sum(p, false); }
  std::vector<AlgebraicTerm> terms() const {
    std::vector<AlgebraicTerm> all;
    for (const auto& [powers, coefficient] : c) all.push_back({powers, coefficient});
    return all;
  }
};
Poly operator+(Poly a, const Poly& b) {
  for (const auto& [powers, coefficient] : b.c) a.c[powers] += coefficient;
  return a;
}
Poly operator*(const Poly& a, const Poly& b) {
  Poly product(0);
  for (const auto& [m, of_a] : a.c)
    for (const auto& [n, of_b] : b.c)
      product.c[{m[0] + n[0], m[1] + n[1], m[2] + n[2]}] += of_a * of_b;
  return product;
}
Poly operator-(const Poly& a, const Poly& b) { return a + b * -1.0; }
Poly power(const Poly& a, int n) { return n == 0 ? Poly(1) : a * power(a, n - 1); }
// f(p / s).
Poly grown(Poly f, double s) {
  for (auto& [powers, coefficient] : f.c)
    for (int i = powers[0] + powers[1] + powers[2]; i > 0; --i) coefficient /= s;
  return f;
}

const Poly X(std::array<int, 3>{1, 0, 0}), Y(std::array<int, 3>{0, 1, 0}),
    Z(std::array<int, 3>{0, 0, 1});
const Poly X2 = X * X, Y2 = Y * Y, Z2 = Z * Z, R2 = X2 + Y2 + Z2;

AlgebraicForm form_of(const Poly& f) { return prepare(Algebraic{f.terms(), {}}); }

// The sum as a distance near the surface: over its steepness.
struct PolyDistance {
  const Poly& f;
  Long size;
  Vec3l slope(const Vec3l& p) const {
    const Long h = size * 1e-6L;
    return Vec3l{f(p + Vec3l{h, 0, 0}) - f(p - Vec3l{h, 0, 0}),
                 f(p + Vec3l{0, h, 0}) - f(p - Vec3l{0, h, 0}),
                 f(p + Vec3l{0, 0, h}) - f(p - Vec3l{0, 0, h})} *
           (1 / (2 * h));
  }
  Long operator()(const Vec3l& p) const {
    const Vec3l g = slope(p);
    return f(p) / std::sqrt(dot(g, g));
  }
};

// At a crossing the sum is 0 but for the rounding of its terms, as large as they get within the
// bounds, and the normal is the gradient, where that is more than rounding too.
// Returns: whether the normal was compared.
bool expect_on(const AlgebraicForm& form, const Poly& f, const Vec3l& p, Long size) {
  const Long reach = std::sqrt(dot(p, p)) + size, magnitude = f.sum({reach, reach, reach}, true);
  EXPECT_LE(std::fabs(f(p)), 1e-15L * magnitude);
  const Vec3d n = normal(form, static_cast<Vec3d>(p), 0);
  EXPECT_NEAR(length(n), 1, 1e-14);
  const Vec3l slope = PolyDistance{f, size}.slope(p);
  const Long steepness = std::sqrt(dot(slope, slope));
  if (steepness * size < 1e-3L * f.sum(p, true)) return false;
  EXPECT_LT(length(n - static_cast<Vec3d>(slope * (1 / steepness))), 1e-6);
  return true;
}

// Random lines through the surface clipped to a ball: the solid's spans are the inside within the
// ball, and the surface's crossings obey the above. Returns: how many crossings there were.
int expect_clipped(const Poly& unit_sized, double radius, double scale, Random& random, int lines) {
  const Poly f = grown(unit_sized, scale);
  const double size = radius * scale;
  const Vec3d middle = Vec3d{0.1, 0.2, -0.1} * scale;
  const AlgebraicForm form = prepare(Algebraic{f.terms(), ball_of(size, middle)});
  const PolyDistance outside{f, size};
  const auto solid = [&](const Vec3l& p) {
    const Vec3l w = p - static_cast<Vec3l>(middle);
    return std::max(outside(p), std::sqrt(dot(w, w)) - static_cast<Long>(size));
  };
  int seen = 0, compared = 0;
  for (int i = 0; i < lines; ++i) {
    const SceneLine line = line_near(random, middle, size);
    expect_pairs_hold(spans_along(form, line), solid, line, middle, size);
    for (const Crossing& each : crossings_along(form, line)) {
      ++seen;
      EXPECT_EQ(each.element, 0);
      compared += expect_on(form, f, line.at(each.t), size);
    }
  }
  EXPECT_GE(2 * compared, seen) << "hardly any normal was compared";
  return seen;
}

// ---- the surfaces that have a shape of their own --------------------------------------------

TEST(Algebraic, BallIsMetLikeASphere) {
  Random random(100);
  for (const double s : scales) {
    const AlgebraicForm form = form_of(grown(R2 - 1, s));
    for (int i = 0; i < 300; ++i) {
      const SceneLine line = line_near(random, {0, 0, 0}, s);
      expect_distances(roots_along(form, line), roots_along(Sphere{{0, 0, 0}, s}, line),
                       1e-9 * s / length(line.direction));
    }
    expect_distances(roots_along(form, {{-3 * s, s, 0}, {1, 0, 0}}), {3 * s, 3 * s}, 1e-7 * s,
                     "graze");
  }
}

// (|p|^2 + R^2 - r^2)^2 = 4 R^2 (x^2 + z^2)
TEST(Algebraic, QuarticIsMetLikeTheTorus) {
  Random random(101);
  int seen = 0;
  for (const double s : scales) {
    const AlgebraicForm form = form_of(grown(power(R2 + (1 - 0.16), 2) - (X2 + Z2) * 4.0, s));
    const TorusForm torus = prepare(Torus{s, 0.4 * s});
    for (int i = 0; i < 300; ++i) {
      const SceneLine line = line_near(random, {0, 0, 0}, 1.4 * s);
      const std::vector<double> expected = roots_along(torus, line);
      expect_distances(roots_along(form, line), expected, 1e-7 * s / length(line.direction));
      seen += static_cast<int>(expected.size());
    }
  }
  EXPECT_GT(seen, 1000);
}

TEST(Algebraic, SecondDegreeIsMetLikeTheQuadricAloneAndClipped) {
  Random random(102);
  int seen = 0;
  for (int i = 0; i < 200; ++i) {
    std::array<double, 10> k{};
    for (double& each : k) each = random.in(-1, 1);
    const Poly parts[] = {X2, Y2, Z2, X * Y, X * Z, Y * Z, X, Y, Z, 1};
    Poly f(0);
    for (std::size_t n = 0; n < 10; ++n) f = f + parts[n] * k[n];
    for (const auto& bounds : {std::optional<Bounds>(), std::optional(ball_of(2, {1, 0, 0}))}) {
      const AlgebraicForm form = prepare(Algebraic{f.terms(), bounds});
      const QuadricForm quadric = prepare(Quadric{k, bounds});
      const SceneLine line = line_near(random, {0, 0, 0}, 2);
      const std::vector<Crossing> got = spans_along(form, line), all = spans_along(quadric, line);
      ASSERT_EQ(got.size(), all.size());
      for (std::size_t n = 0; n < all.size(); ++n) {
        EXPECT_EQ(got[n].element, all[n].element);
        if (std::isinf(all[n].t)) EXPECT_EQ(got[n].t, all[n].t);
        else EXPECT_NEAR(got[n].t, all[n].t, 1e-8 * (1 + std::fabs(all[n].t)));
      }
      expect_distances(roots_along(form, line), roots_along(quadric, line), 1e-5);
      seen += static_cast<int>(all.size());
    }
  }
  EXPECT_GT(seen, 500);
}

// ---- the surfaces of the books --------------------------------------------------------------

// Taubin's heart, 1993.
const Poly heart = power(X2 + Y2 * 2.25 + Z2 - 1, 3) - X2 * Z2 * Z - Y2 * Z2 * Z * 0.1125;
// Goursat's cubic symmetry: x^4 + y^4 + z^4 - 5 (x^2 + y^2 + z^2) + 11.8, the tangle cube.
const Poly tangle = X2 * X2 + Y2 * Y2 + Z2 * Z2 - R2 * 5.0 + 11.8;
// Barth's sextic, 65 nodes, in the plane w = 1, q the golden ratio.
Poly barth() {
  const double q = (1 + std::sqrt(5.0)) / 2;
  return (X2 * (q * q) - Y2) * (Y2 * (q * q) - Z2) * (Z2 * (q * q) - X2) * 4.0 -
         power(R2 - 1, 2) * (1 + 2 * q);
}
// Chmutov's: T(x) + T(y) + T(z) of a Chebyshev polynomial T.
Poly chebyshev(int n, const Poly& t) {
  Poly before(1), now = t;
  for (int i = 1; i < n; ++i) {
    const Poly next = t * now * 2.0 - before;
    before = now;
    now = next;
  }
  return now;
}
Poly chmutov(int n) { return chebyshev(n, X) + chebyshev(n, Y) + chebyshev(n, Z); }

TEST(Algebraic, FamousSurfacesAreMetWhereTheirSumChangesSign) {
  Random random(103);
  for (const double s : scales) {
    EXPECT_GT(expect_clipped(heart, 1.5, s, random, 20), 15) << "heart";
    EXPECT_GT(expect_clipped(tangle, 3, s, random, 20), 15) << "tangle cube";
    EXPECT_GT(expect_clipped(barth(), 2, s, random, 20), 15) << "Barth's sextic";
    EXPECT_GT(expect_clipped(chmutov(8), 1.2, s, random, 20), 15) << "Chmutov's octic";
    EXPECT_GT(expect_clipped(chmutov(14), 1.1, s, random, 20), 15) << "of degree 14";
  }
}

TEST(Algebraic, RandomSurfacesOfEveryDegreeAreMetWhereTheirSumChangesSign) {
  Random random(104);
  for (int degree = 1; degree <= 12; ++degree) {
    int seen = 0;
    for (const double s : scales) {
      for (int i = 0; i < 3; ++i) {
        Poly f(random.in(-0.5, 0.5));
        f.c[{degree, 0, 0}] = random.in(-1, 1);
        for (int n = 0; n < 12; ++n) {
          const int a = random.below(degree + 1), b = random.below(degree + 1 - a);
          f.c[{a, b, random.below(degree + 1 - a - b)}] += random.in(-1, 1);
        }
        seen += expect_clipped(f, 1.5, s, random, 10);
      }
    }
    EXPECT_GT(seen, 20) << "degree " << degree;
  }
}

// T_32 has the 32 roots cos((2 k - 1) pi / 64).
TEST(Algebraic, HighDegreeHasAllItsRoots) {
  const AlgebraicForm form = form_of(chebyshev(32, Y));
  std::vector<double> expected;
  for (int k = 32; k > 0; --k) expected.push_back(cos_of((2 * k - 1) * pi / 64));
  expect_distances(roots_along(form, {{0.3, 0, 7}, {0, 1, 0}}), expected, 1e-5);
}

// x^64 + y^64 + z^64 = 1, of the highest degree: along (1, 1, 1) 3 x^64 = 1.
TEST(Algebraic, HighestDegreeIsACubeWithRoundEdges) {
  const AlgebraicForm form = form_of(power(X, 64) + power(Y, 64) + power(Z, 64) - 1);
  expect_distances(roots_along(form, {{-2, 0, 0}, {1, 0, 0}}), {1, 3}, 1e-14);
  double corner = 1.0 / 3;
  for (int i = 0; i < 6; ++i) corner = std::sqrt(corner);
  expect_distances(roots_along(form, {{-2, -2, -2}, {1, 1, 1}}), {2 - corner, 2 + corner}, 1e-14);
  expect_distances(roots_along(form, {{-2, 1.01, 0}, {1, 0, 0}}), {}, 0);
}

// Written out around the middle of a chord, far from the origin, T_n(x) + T_n(y) + T_n(z) loses
// digits by the factor (|o| + |d|)^n or so; a root keeps those that the sum has at its own point.
TEST(Algebraic, RootsKeepTheDigitsOfTheSumAtTheirPoint) {
  Random random(110);
  int seen = 0;
  for (const int n : {8, 14, 20}) {
    const Vec3d middle{0.6, 0.6, -0.6};
    const AlgebraicForm form = prepare(Algebraic{chmutov(n).terms(), ball_of(1.5, middle)});
    const auto sum = [&](const Vec3l& p) {
      Long all = 0;
      for (const Long at : {p.x, p.y, p.z}) {
        Long before = 1, now = at;
        for (int i = 1; i < n; ++i) before = std::exchange(now, 2 * at * now - before);
        all += now;
      }
      return all;
    };
    for (int i = 0; i < 100; ++i) {
      SceneLine line = line_near(random, middle, 1);
      line.direction = normalize(line.direction);
      for (const double t : roots_along(form, line)) {
        const Long slope = (sum(line.at(t + 1e-7L)) - sum(line.at(t - 1e-7L))) / 2e-7L;
        EXPECT_LT(std::fabs(sum(line.at(t))), 1e-9L * std::max<Long>(std::fabs(slope), 1)) << n;
        ++seen;
      }
    }
  }
  EXPECT_GT(seen, 1000);
}

// ---- multiple roots, the ends of a line -----------------------------------------------------

// (y + 2)^a (y - 1)^b (y - 3)^c changes sides where the power is odd; where it is even it touches,
// from outside or from inside, and the root stands twice. A root of multiplicity m is known to the
// m-th root of rounding.
TEST(Algebraic, MultipleRootsKeepThePairs) {
  for (const double sign : {1.0, -1.0}) {
    for (int code = 0; code < 64; ++code) {
      const int m[] = {1 + code % 4, 1 + code / 4 % 4, 1 + code / 16};
      const double at[] = {-2, 1, 3};
      const Poly f = power(Y + 2, m[0]) * power(Y - 1, m[1]) * power(Y - 3, m[2]) * sign;
      const bool starts = ((m[0] + m[1] + m[2]) % 2 == 0 ? sign : -sign) < 0;
      std::vector<double> expected;
      if (starts) expected.push_back(-Aabb::far);
      for (int i = 0; i < 3; ++i) expected.insert(expected.end(), m[i] % 2 == 1 ? 1 : 2, at[i]);
      if (sign < 0) expected.push_back(Aabb::far);
      const SceneLine line{{5, 0.25, 5}, {0, 1, 0}};
      for (double& each : expected) each -= 0.25;
      expect_distances(roots_along(form_of(f), line), expected, 1e-3, std::to_string(code));
    }
  }
}

// Powers of a ball: odd ones are the ball, even ones have no inside but what rounding makes, and
// less an even one all is inside but for it.
TEST(Algebraic, PowersOfABallKeepThePairs) {
  Random random(105);
  const auto thickness = [](const std::vector<double>& t, std::size_t from, std::size_t to) {
    double sum = 0;
    for (std::size_t i = from; i + 1 < to; i += 2) sum += t[i + 1] - t[i];
    return sum;
  };
  for (int n = 2; n <= 7; ++n) {
    const AlgebraicForm form = form_of(power(R2 - 1, n)), less = form_of(power(R2 - 1, n) * -1.0);
    for (int i = 0; i < 100; ++i) {
      SceneLine line = line_near(random, {0, 0, 0}, 1);
      line.direction = normalize(line.direction);
      const std::vector<double> t = roots_along(form, line), rest = roots_along(less, line);
      const std::vector<double> ball = roots_along(Sphere{{0, 0, 0}, 1}, line);
      ASSERT_EQ(t.size() % 2, 0u);
      ASSERT_EQ(rest.size() % 2, 0u);
      EXPECT_EQ(rest.front(), -Aabb::far);
      EXPECT_EQ(rest.back(), Aabb::far);
      const double inside = n % 2 == 1 ? thickness(ball, 0, ball.size()) : 0;
      EXPECT_NEAR(thickness(t, 0, t.size()), inside, 0.1);
      EXPECT_NEAR(thickness(rest, 1, rest.size() - 1), inside, 0.1);
    }
  }
}

TEST(Algebraic, InsideMayReachTheEndsOfALine) {
  for (const double s : scales) {
    const SceneLine along{{0.5 * s, 0, 0}, {0, 1, 0}}, against{{0.5 * s, 0, 0}, {0, -1, 0}};
    const AlgebraicForm cubic = form_of(grown(Y2 * Y - X, s));  // y = the cube root of 1/2
    const double root = s * 0.79370052598409973737;
    expect_distances(roots_along(cubic, along), {-Aabb::far, root}, 1e-15 * s);
    expect_distances(roots_along(cubic, against), {-root, Aabb::far}, 1e-15 * s);
    const AlgebraicForm between = form_of(grown(X2 * X2 - Y2 * Y2, s));  // inside |x| < |y|
    expect_distances(roots_along(between, along), {-Aabb::far, -0.5 * s, 0.5 * s, Aabb::far},
                     1e-15 * s);
    expect_distances(roots_along(form_of(grown(X2 - 1, s)), along), {-Aabb::far, Aabb::far}, 0);
    expect_distances(roots_along(form_of(grown(X2 - 0.2, s)), along), {}, 0);
  }
}

// However a pipe of the fourth degree is turned, rounding makes no far root of a line along it.
TEST(Algebraic, LineAlongAPipeMeetsNothingFarAway) {
  Random random(106);
  for (int i = 0; i < 200; ++i) {
    const Vec3d n = random.direction();
    // Where 1 - n.x^2 has lost digits, the coefficients are another surface's.
    if (std::max({std::fabs(n.x), std::fabs(n.y), std::fabs(n.z)}) > 0.9) continue;
    const Poly aside2 = R2 - power(X * n.x + Y * n.y + Z * n.z, 2);
    const AlgebraicForm pipe = form_of(power(aside2, 2) - 1);
    const Vec3d aside = normalize(cross(n, random.direction()));
    expect_distances(roots_along(pipe, {aside * 0.5, n}), {-Aabb::far, Aabb::far}, 0);
    expect_distances(roots_along(pipe, {aside * 1.5, n}), {}, 0);
    expect_distances(roots_along(pipe, {aside * -3.0, aside}), {2, 4}, 1e-12);
  }
}

// x y = z along (s, 1 + s e, 0): roots 0 and -1/e, met from s = -3.
TEST(Algebraic, FarRootTakesNoDigitsFromTheNearOne) {
  for (double e = 0.1; e > 1e-8; e /= 10) {
    const auto got = roots_along(form_of(X * Y - Z), {{-3, 1 - 3 * e, 0}, {1, e, 0}});
    ASSERT_EQ(got.size(), 2u);
    EXPECT_NEAR(got[1], 3, 1e-14) << e;
    EXPECT_NEAR(got[0], 3 - 1 / e, 1e-6 / e);
  }
}

// ---- terms, bounds, descriptions ------------------------------------------------------------

TEST(Algebraic, TermsMayComeInAnyOrderAndInParts) {
  Random random(107);
  const Poly f = heart;
  Algebraic given{f.terms(), {}};
  const AlgebraicForm form = prepare(given);
  std::vector<AlgebraicTerm> parts;
  for (AlgebraicTerm term : given.terms) {
    term.coefficient /= 2;
    parts.insert(parts.begin(), 2, term);
  }
  parts.push_back({{9, 9, 9}, 5});
  parts.push_back({{9, 9, 9}, -5});
  const AlgebraicForm same = prepare(Algebraic{parts, {}});
  for (int i = 0; i < 50; ++i) {
    const SceneLine line = line_near(random, {0, 0, 0}, 1.3);
    EXPECT_EQ(roots_along(same, line), roots_along(form, line));
  }
}

// Doubling all lengths shifts exponents and nothing else.
TEST(Algebraic, PowersOfTwoScaleEveryRootExactly) {
  Random random(108);
  for (const bool clipped : {false, true}) {
    const auto grown_form = [&](double s) {
      Algebraic algebraic{grown(barth(), s).terms(), {}};
      if (clipped) algebraic.bounds = ball_of(2 * s, Vec3d{0.5, 0, 0} * s);
      return prepare(algebraic);
    };
    const AlgebraicForm small = grown_form(1), big = grown_form(1024);
    for (int i = 0; i < 100; ++i) {
      const SceneLine line = line_near(random, {0, 0, 0}, 2);
      std::vector<double> expected = roots_along(small, line);
      for (double& t : expected) t *= 1024;
      EXPECT_EQ(roots_along(big, {line.origin * 1024.0, line.direction}), expected);
    }
  }
}

// The ball within a box that it touches: the faces' middles are the surface's.
TEST(Algebraic, BoundsThatTouchTheSurfaceLeaveItWhole) {
  Bounds box;
  box.min = Vec3d{-1, -1, -1};
  box.max = Vec3d{1, 1, 1};
  const auto along_axis = [&](const Poly& f) {
    std::vector<double> all;
    const AlgebraicForm form = prepare(Algebraic{f.terms(), box});
    for (const Crossing& each : spans_along(form, {{-3, 0, 0}, {1, 0, 0}})) all.push_back(each.t);
    return all;
  };
  EXPECT_EQ(along_axis(R2 - 1), (std::vector<double>{2, 4}));
  // The whole face x = -1 is the surface, and behind it is the outside or the inside.
  EXPECT_EQ(along_axis(X * -1.0 - 1), (std::vector<double>{2, 4}));
  const std::vector<double> nothing = along_axis(X + 1);
  for (std::size_t i = 1; i < nothing.size(); i += 2) EXPECT_EQ(nothing[i - 1], nothing[i]);
}

// Roots and faces that differ by rounding alone still come in order.
TEST(Algebraic, SpansAscendWhereSurfaceAndBoundsCoincide) {
  Random random(109);
  Bounds box;
  box.min = Vec3d{-0.7, -0.7, -0.7};
  box.max = Vec3d{0.7, 0.7, 0.7};
  int seen = 0;
  for (const Poly& f : {X - 0.7, X * -1.0 - 0.7, X2 - 0.7 * 0.7, (X2 - 0.7 * 0.7) * -1.0}) {
    const AlgebraicForm form = prepare(Algebraic{f.terms(), box});
    for (int i = 0; i < 1000; ++i) {
      const std::vector<Crossing> all = spans_along(form, line_near(random, {0, 0, 0}, 0.7));
      ASSERT_EQ(all.size() % 2, 0u);
      for (std::size_t k = 1; k < all.size(); ++k) ASSERT_LE(all[k - 1].t, all[k].t);
      seen += static_cast<int>(all.size());
    }
  }
  EXPECT_GT(seen, 2000);
}

TEST(Algebraic, LineWithinTheSurfaceMeetsNothing) {
  expect_distances(roots_along(form_of(Y * (X2 + Z2 + 1)), {{0, 0, 0}, {1, 0, 0}}), {}, 0);
  EXPECT_TRUE(
      spans_along(prepare(Algebraic{Y.terms(), ball_of(1)}), {{0, 0, 0}, {1, 0, 0}}).empty());
}

// -1e30 x^32 at x = 1e9 is no double.
TEST(Algebraic, SumThatOverflowsIsMetNowhere) {
  const AlgebraicForm steep = form_of(power(X, 32) * -1e30);
  expect_distances(roots_along(steep, {{1e9, 0, 0}, {0, 1, 0}}), {}, 0);
  expect_distances(roots_along(steep, {{1e3, 0, 0}, {0, 1, 0}}), {-Aabb::far, Aabb::far}, 0);
  const AlgebraicForm slow = form_of(power(X, 32) * 1e-11 - power(X, 31));  // 0 at x = 1e11
  EXPECT_EQ(normal(slow, {1e11, 0, 0}, 0), (Vec3d{0, 1, 0}));
}

TEST(Algebraic, CrossesNothingOfNan) {
  expect_nothing_from_nan(form_of(heart * -1.0));
  expect_nothing_from_nan(prepare(Algebraic{heart.terms(), ball_of(2)}));
}

TEST(Algebraic, ElementsNormalsAndUvFollowTheBounds) {
  EXPECT_EQ(elements(form_of(heart)), 1);
  EXPECT_EQ(bounds(form_of(X2 * X2 - Y2 * Y2)), Aabb::everything());
  EXPECT_TRUE(bounds(form_of(heart)).bounded());
  Bounds box;
  box.min = Vec3d{-2, -3, -2};
  box.max = Vec3d{2, 5, 2};
  const AlgebraicForm form = prepare(Algebraic{(X2 * X2 - Y2 * Y2).terms(), box});
  EXPECT_EQ(elements(form), 7);
  EXPECT_EQ(bounds(form), (Aabb{{-2, -3, -2}, {2, 5, 2}}));
  EXPECT_EQ(normal(form, {0, 5, 0}, 1 + 3), (Vec3d{0, 1, 0}));
  EXPECT_EQ(normal(form, {0, 0, 0}, 0), (Vec3d{0, 1, 0})) << "where it is singular: some";
  EXPECT_EQ(uv(form, {1, 5, 0}, 1 + 3), (Vec2d{0.5, 0.75})) << "as the box has it: along z, x";
  EXPECT_EQ(uv(form, {1, 1, 0}, 0), (Vec2d{0.25, 0.5})) << "longitude, latitude from the middle";
}

TEST(Algebraic, FaultsAreNamedAtTheirTerm) {
  const auto faults = [](const std::string& terms) {
    return faults_in<Algebraic>(R"({"terms":)" + terms + "}");
  };
  expect_faults(faults("[[2,0,0,1],[0,1.5,0,1],[0,0,-1,1],[65,0,0,2e30]]"),
                {{FaultKind::wrong_type, "/terms/1/1", "1.5", "an integer from 0 to 64"},
                 {out_of_range, "/terms/2/2", "-1", "an integer from 0 to 64"},
                 {out_of_range, "/terms/3/0", "65", "an integer from 0 to 64"},
                 {out_of_range, "/terms/3/3", "2e+30", "1e+30"}});
  expect_faults(faults("[[2,0,1],5]"),
                {{FaultKind::wrong_type, "/terms/0", "[2,0,1]", "[i, j, k, c]"},
                 {FaultKind::wrong_type, "/terms/1", "5", "[i, j, k, c]"}});
  expect_faults(faults("[[1,0,0,1],[32,32,1,1]]"),
                {{out_of_range, "/terms/1", "[32,32,1,1]", "a total degree of at most 64"}});
  for (const char* constant : {"[[0,0,0,1]]", "[[1,2,0,0],[0,0,0,1]]", "[[1,0,0,2],[1,0,0,-2]]"})
    expect_faults(faults(constant), {{out_of_range, "/terms", constant, "more than a constant"}});
  EXPECT_EQ(faults("[]").size(), 1u);
  expect_faults(faults_in<Algebraic>("{}"), {{FaultKind::missing, "/terms", "", "array"}});
  expect_faults(faults_in<Algebraic>(R"({"terms":[[1,0,0,1]],"bounds":{"min":[0,0,0]}})"),
                {{FaultKind::missing, "/bounds/max", "", "min and max"}});
}

TEST(Algebraic, IsWrittenAsItWasRead) {
  const char* json =
      R"({"bounds":{"center":[0,0,0],"radius":2},"terms":[[2,0,0,1],[0,30,2,-0.5],[0,0,0,-1]]})";
  EXPECT_EQ(to_json(write_value(read_described<Algebraic>(parse_json(json)))), json);
}

}  // namespace
}  // namespace tia
