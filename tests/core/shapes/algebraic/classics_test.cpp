// The named algebraic surfaces, and two that have a shape of their own, against closed forms.
#include "core/shapes/algebraic/classics.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "core/shapes/algebraic/quadric.h"
#include "core/shapes/simple/torus.h"
#include "tests/core/shapes/lines.h"

namespace tia {
namespace {

using namespace test;

const double golden = (1 + std::sqrt(5.0)) / 2;

SceneLine unit_line(Random& random, double size) {
  const SceneLine line = line_near(random, {0, 0, 0}, size);
  return {line.origin, normalize(line.direction)};
}
// Whether roots are clear of each other, so that each keeps nearly all digits.
bool apart(const std::vector<double>& t) {
  for (std::size_t i = 1; i < t.size(); ++i)
    if (t[i] - t[i - 1] < 1e-3) return false;
  return true;
}
Vec3d turned(const Vec3d& v, int places) {
  return places == 0 ? v : turned({v.z, v.x, v.y}, places - 1);
}
Vec3d with_random_signs(Random& random, const Vec3d& v) {
  const double a = random.chance(0.5) ? -1 : 1, b = random.chance(0.5) ? -1 : 1;
  return {a * v.x, b * v.y, random.chance(0.5) ? -v.z : v.z};
}

// ---- surfaces with a shape of their own -----------------------------------------------------

// (|p|^2 + R^2 - r^2)^2 - 4 R^2 (x^2 + z^2), each square written out.
TEST(Classics, TorusAsAQuarticIsTheTorus) {
  Random random(120);
  int seen = 0;
  for (int i = 0; i < 300; ++i) {
    const double R = random.in(0.5, 2), r = R * random.in(0.1, 0.9), k = R * R - r * r;
    Algebraic quartic;
    quartic.terms = {{{4, 0, 0}, 1}, {{0, 4, 0}, 1}, {{0, 0, 4}, 1},    {{2, 2, 0}, 2},
                     {{2, 0, 2}, 2}, {{0, 2, 2}, 2}, {{0, 0, 0}, k * k}};
    quartic.terms.push_back({{2, 0, 0}, 2 * k - 4 * R * R});
    quartic.terms.push_back({{0, 2, 0}, 2 * k});
    quartic.terms.push_back({{0, 0, 2}, 2 * k - 4 * R * R});
    const SceneLine line = unit_line(random, R + r);
    const std::vector<double> expected = roots_along(prepare(Torus{R, r}), line);
    if (!apart(expected)) continue;
    const std::vector<double> got = roots_along(prepare(quartic), line);
    expect_distances(got, expected, 1e-8);
    for (const double t : got) {
      const Vec3l p = line.at(t);
      const Long ring = std::sqrt(p.x * p.x + p.z * p.z) - static_cast<Long>(R);
      EXPECT_NEAR(static_cast<double>(std::sqrt(ring * ring + p.y * p.y)), r, 1e-8);
      ++seen;
    }
  }
  EXPECT_GT(seen, 300);
}

// y = x^2 / a + z^2 / b, along o + t d: A t^2 + 2 B t + C = 0.
TEST(Classics, ParaboloidAsAQuadricAndAsTermsIsTheSame) {
  Random random(121);
  int seen = 0;
  for (int i = 0; i < 300; ++i) {
    const double a = random.in(0.2, 3), b = random.in(-3, -0.2) * (random.chance(0.5) ? 1 : -1);
    Quadric quadric;
    quadric.coefficients = {1 / a, 0, 1 / b, 0, 0, 0, 0, -1, 0, 0};
    const Algebraic terms{{{{2, 0, 0}, 1 / a}, {{0, 0, 2}, 1 / b}, {{0, 1, 0}, -1}}, {}};
    const SceneLine line = unit_line(random, 2);
    const Vec3d &o = line.origin, &d = line.direction;
    const double A = d.x * d.x / a + d.z * d.z / b;
    const double B = o.x * d.x / a + o.z * d.z / b - d.y / 2;
    const double root = B * B - A * (o.x * o.x / a + o.z * o.z / b - o.y);
    if (std::fabs(A) < 0.01 || std::fabs(root) < 0.01) continue;
    std::vector<double> expected;
    if (A < 0) expected.push_back(-Aabb::far);
    if (root > 0)
      for (const double sign : {-1.0, 1.0})
        expected.push_back((-B + std::copysign(sign, sign * A) * std::sqrt(root)) / A);
    if (A < 0) expected.push_back(Aabb::far);
    expect_distances(roots_along(prepare(quadric), line), expected, 1e-9);
    expect_distances(roots_along(prepare(terms), line), expected, 1e-9);
    seen += root > 0;
  }
  EXPECT_GT(seen, 100);
}

// ---- Steiner ----------------------------------------------------------------------------------

// Where s is a coordinate of (s, s, s): 3 s^4 - s^3 = s^3 (3 s - 1). A change of two signs changes
// nothing, a change of three turns the axis around.
TEST(Steiner, OnEachThreefoldAxisALobeReachesToAThird) {
  Random random(122);
  for (int i = 0; i < 50; ++i) {
    const Vec3d way = with_random_signs(random, {1, 1, 1});
    const double tip = way.x * way.y * way.z / 3, start = random.in(1, 3);
    const auto got = roots_along(prepare(Steiner{}), {way * -start, way});
    // 0 is a root of third order, known to the third root of rounding.
    expect_distances(got, {start + std::min(0.0, tip), start + std::max(0.0, tip)}, 1e-5);
    EXPECT_NEAR(got[tip > 0 ? 1 : 0], start + tip, 1e-13);
  }
}

// Across the z axis at height z, where y = m x: z^2 (1 + m^2) - m z + m^2 x^2 = 0 besides x = 0.
TEST(Steiner, SheetsCrossOnTheAxesBelowAHalf) {
  Random random(123);
  for (int i = 0; i < 100; ++i) {
    const double z = random.in(0.05, 0.45), m = random.in(0.2, 5);
    const double square = (m * z - z * z * (1 + m * m)) / (m * m);
    if (std::fabs(square) < 1e-3) continue;
    const auto got = roots_along(prepare(Steiner{}), {{-2, -2 * m, z}, {1, m, 0}});
    std::vector<double> simple = got;
    std::erase_if(simple, [](double t) { return std::fabs(t - 2) < 1e-6; });
    if (square < 0) expect_distances(simple, {}, 0);
    else expect_distances(simple, {2 - std::sqrt(square), 2 + std::sqrt(square)}, 1e-9);
    EXPECT_EQ(got.size() % 2, 0U);
  }
}

// ---- Barth ------------------------------------------------------------------------------------

// Where s is a coordinate of (s, s, s), and since p^2 - 1 = p, 1 + 2 p = p^3:
// p^3 (4 s^6 - (3 s^2 - 1)^2) = p^3 (s - 1)^2 (2 s + 1) (s + 1)^2 (2 s - 1).
TEST(Barth, OnThreefoldAxesItIsCrossedAtAHalfAndTouchedAtItsNodes) {
  Random random(124);
  for (int i = 0; i < 50; ++i) {
    const Vec3d way = with_random_signs(random, {1, 1, 1});
    const double start = random.in(1.5, 3);
    std::vector<double> got = roots_along(prepare(BarthSextic{}), {way * -start, way});
    EXPECT_EQ(got.size() % 2, 0U);
    std::erase_if(got, [&](double t) { return std::fabs(std::fabs(t - start) - 1) < 1e-6; });
    expect_distances(got, {start - 0.5, start + 0.5}, 1e-13);
  }
}

// Where s is a coordinate of (s, s, 0): -4 p^3 s^6 - p^3 (2 s^2 - 1)^2 < 0.
TEST(Barth, DiagonalsOfTheCoordinatePlanesAreInsideThroughout) {
  for (const Vec3d& way : {Vec3d{1, 1, 0}, Vec3d{0, -1, 1}, Vec3d{1, 0, -1}})
    expect_distances(roots_along(prepare(BarthSextic{}), {way * -2.0, way}),
                     {-Aabb::far, Aabb::far}, 0);
}

// Rodrigues' rotation.
Vec3d rotated(const Vec3d& v, const Vec3d& axis, double cosine) {
  return v * cosine + cross(axis, v) * std::sqrt(1 - cosine * cosine) +
         axis * (dot(axis, v) * (1 - cosine));
}
// The largest difference between the roots of random lines and of the same lines turned; infinite
// where their numbers differ.
double change_by_turning(Random& random, const Vec3d& axis, double cosine) {
  const AlgebraicForm form = prepare(BarthSextic{ball_of(1.9)});
  double most = 0;
  for (int i = 0; i < 20; ++i) {
    const SceneLine line = unit_line(random, 1.5);
    const SceneLine other{rotated(line.origin, axis, cosine),
                          rotated(line.direction, axis, cosine)};
    const auto before = roots_along(form, line), after = roots_along(form, other);
    if (!apart(before)) continue;
    if (before.size() != after.size()) return Aabb::far;
    for (std::size_t k = 0; k < before.size(); ++k)
      most = std::max(most, std::fabs(before[k] - after[k]));
  }
  return most;
}

// The icosahedron's vertices are (p, 1, 0), its like, and what a cyclic change of coordinates makes
// of them; three that are next to each other add up to (p^3, 0, p), to its like and to (1, 1, 1).
TEST(Barth, HasTheTurnsOfTheIcosahedronThroughItsVerticesAndItsFaces) {
  Random random(125);
  const double fifth = (golden - 1) / 2, third = -0.5;  // cosines of 72 and of 120 degrees
  for (int i = 0; i < 2; ++i) {
    const int places = random.below(3);
    const auto axis = [&](const Vec3d& v) {
      return normalize(turned(with_random_signs(random, v), places));
    };
    EXPECT_LT(change_by_turning(random, axis({golden, 1, 0}), fifth), 1e-9);
    EXPECT_LT(change_by_turning(random, axis({golden * golden, 0, 1}), third), 1e-9);
    EXPECT_LT(change_by_turning(random, axis({1, 1, 1}), third), 1e-9);
    EXPECT_GT(change_by_turning(random, axis({1, golden, 0}), fifth), 1e-3)
        << "the other way round";
  }
}

// ---- Chmutov ----------------------------------------------------------------------------------

double chebyshev_at(int n, double x) {
  double before = 1, now = x;
  for (int i = 1; i < n; ++i) before = std::exchange(now, 2 * x * now - before);
  return now;
}

// T_n(x) = c where x is a cosine of (acos c + 2 pi k) / n.
TEST(Chmutov, RaysAlongAnAxisMeetAllCosines) {
  Random random(126);
  const double turn = 2 * std::acos(-1.0);
  int seen = 0;
  for (int n = 2; n <= 20; n += n < 8 ? 1 : 4) {
    const AlgebraicForm whole = prepare(Chmutov{n, {}}), clipped = prepare(Chmutov{n, ball_of(2)});
    for (int i = 0; i < 30; ++i) {
      const double u = random.in(-1, 1), v = random.in(-1, 1);
      const double c = -chebyshev_at(n, u) - chebyshev_at(n, v);
      if (std::fabs(c) > 0.98) continue;
      std::vector<double> expected;
      for (int k = 0; k < n; ++k) expected.push_back(std::cos((std::acos(c) + turn * k) / n));
      std::sort(expected.begin(), expected.end());
      const int places = random.below(3);
      const SceneLine line{turned({0, u, v}, places), turned({1, 0, 0}, places)};
      expect_distances(roots_along(clipped, line), expected, 1e-7, std::to_string(n));
      std::vector<double> all = roots_along(whole, line);
      std::erase_if(all, [](double t) { return std::isinf(t); });
      expect_distances(all, expected, 1e-7, std::to_string(n));
      ++seen;
    }
  }
  EXPECT_GT(seen, 150);
}

// ---- the heart --------------------------------------------------------------------------------

// Where y = 0 it is the plane curve (x^2 + z^2 - 1)^3 = x^2 z^3, here in polar coordinates:
// (r^2 - 1)^3 = r^5 cos^2 sin^3, of which there is one r at each angle.
TEST(Heart, SectionAcrossIsTheCurveOfTheHeart) {
  for (int i = 0; i < 200; ++i) {
    Random random(static_cast<std::uint64_t>(i));
    const double angle = random.in(0, 2 * std::acos(-1.0));
    const double cosine = std::cos(angle), sine = std::sin(angle);
    const double k = cosine * cosine * sine * sine * sine;
    if (std::fabs(k) < 1e-3) continue;  // a root of third order
    double low = 0, high = 2;
    for (int step = 0; step < 200; ++step) {
      const double r = (low + high) / 2, square = r * r - 1;
      (square * square * square < r * r * r * r * r * k ? low : high) = r;
    }
    const std::vector<double> got =
        roots_along(prepare(Heart{}), {Vec3d{cosine, 0, sine} * 3.0, {-cosine, 0, -sine}});
    ASSERT_EQ(got.size(), 2U) << angle;
    EXPECT_NEAR(got[0], 3 - low, 1e-8) << angle;
  }
}

// On the axes it is (x^2 - 1)^3, (9/4 y^2 - 1)^3 and (z^2 - 1)^3.
TEST(Heart, ReachesOneAndTwoThirdsOnItsAxes) {
  const AlgebraicForm form = prepare(Heart{});
  expect_distances(roots_along(form, {{-2, 0, 0}, {1, 0, 0}}), {1, 3}, 1e-4);
  expect_distances(roots_along(form, {{0, -2, 0}, {0, 1, 0}}), {2 - 2.0 / 3, 2 + 2.0 / 3}, 1e-4);
  expect_distances(roots_along(form, {{0, 0, -2}, {0, 0, 1}}), {1, 3}, 1e-4);
}

// ---- the cubics -------------------------------------------------------------------------------

// Six times the left side is a sum of five cubes of numbers whose sum is 0; these at p.
std::array<Long, 5> cubed_at(const Vec3l& p) {
  const Long sum = 3 * (p.x + p.y + p.z);
  return {12 * p.x - sum - 1, 12 * p.y - sum - 1, 12 * p.z - sum - 1, 2 - 2 * sum, sum + 1};
}
// Of each of these the gradient.
constexpr Vec3d gradients[] = {{9, -3, -3}, {-3, 9, -3}, {-3, -3, 9}, {-6, -6, -6}, {3, 3, 3}};

// Where one of the five is 0, and of the others two and two are each other's negative: on 15 lines,
// for five times three choices.
std::vector<SceneLine> rational_lines() {
  std::vector<SceneLine> lines;
  const auto base = cubed_at({0, 0, 0});
  const auto number = [&](std::size_t i) { return static_cast<double>(base[i]); };
  for (std::size_t zero = 0; zero < 5; ++zero) {
    std::vector<std::size_t> rest;
    for (std::size_t i = 0; i < 5; ++i)
      if (i != zero) rest.push_back(i);
    for (std::size_t partner = 1; partner < 4; ++partner) {
      // The planes a . p = h and b . p = k; their line's point nearest to the origin.
      const Vec3d a = gradients[zero], b = gradients[rest[0]] + gradients[rest[partner]];
      const double h = -number(zero), k = -number(rest[0]) - number(rest[partner]);
      const Vec3d way = cross(a, b);
      if (!(dot(way, way) > 0)) continue;  // at infinity
      const Vec3d p = (cross(b, way) * h + cross(way, a) * k) * (1 / dot(way, way));
      lines.push_back({p, normalize(way)});
    }
  }
  return lines;
}

TEST(Clebsch, HoldsTheLinesOfTheSumOfFiveCubes) {
  Random random(127);
  const AlgebraicForm form = prepare(Clebsch{ball_of(4)});
  const auto lines = rational_lines();
  EXPECT_GT(lines.size(), 10U);
  for (const SceneLine& on : lines) {
    expect_distances(roots_along(form, on), {}, 0, "along it");
    int seen = 0;
    for (int i = 0; i < 20; ++i) {
      const Vec3d p = on.origin + on.direction * random.in(-1, 1);
      const SceneLine across{p - random.direction() * 1.0, {0, 0, 0}};
      const SceneLine ray{across.origin, p - across.origin};
      std::vector<double> t = roots_along(form, ray);
      if (!apart(t)) continue;  // tangent
      std::erase_if(t, [](double each) { return std::fabs(each - 1) > 1e-9; });
      EXPECT_EQ(t.size(), 1U) << "crossed where the ray meets the line";
      ++seen;
    }
    EXPECT_GT(seen, 10);
  }
}

TEST(Clebsch, InsideIsWhereTheSumOfFiveCubesIsBelowZero) {
  Random random(128);
  const AlgebraicForm form = prepare(Clebsch{});
  const auto sum = [](const Vec3l& p) {
    Long all = 0;
    for (const Long each : cubed_at(p)) all += each * each * each;
    return all / 6;
  };
  std::size_t seen = 0;
  for (int i = 0; i < 200; ++i) {
    const SceneLine line = unit_line(random, 1.5);
    const auto pairs = crossings_along(form, line);
    expect_pairs_hold(pairs, sum, line, {0, 0, 0}, 1.5);
    seen += pairs.size();
  }
  EXPECT_GT(seen, 400U);
}

// Its node n has each coordinate 1/2 in magnitude and a product below 0. Along n + t d the sum is
// (4 d.d + 16 (n.x d.y d.z + d.x n.y d.z + d.x d.y n.z)) t^2 + 16 d.x d.y d.z t^3.
TEST(Cayley, LineThroughANodeHasOneRootBesidesIt) {
  Random random(129);
  const AlgebraicForm form = prepare(Cayley{});
  int seen = 0;
  for (int i = 0; i < 200; ++i) {
    Vec3d n = with_random_signs(random, {0.5, 0.5, 0.5});
    if (n.x * n.y * n.z > 0) n = -n;
    const Vec3d d = random.direction();
    const double square =
        4 * dot(d, d) + 16 * (n.x * d.y * d.z + d.x * n.y * d.z + d.x * d.y * n.z);
    const double expected = -square / (16 * d.x * d.y * d.z);
    if (std::fabs(expected) < 0.01 || std::fabs(expected) > 10) continue;
    std::vector<double> t = roots_along(form, {n - d * 2.0, d});
    std::erase_if(t, [](double each) { return std::isinf(each) || std::fabs(each - 2) < 1e-5; });
    ASSERT_EQ(t.size(), 1U);
    EXPECT_NEAR(t[0], 2 + expected, 1e-9 * (1 + std::fabs(expected)));
    ++seen;
  }
  EXPECT_GT(seen, 100);
}

// Through the middle and the node, s a coordinate over the node's sign: 12 s^2 - 16 s^3 - 1
// = -(2 s - 1)^2 (4 s + 1).
TEST(Cayley, AxisThroughANodeLeavesTheMiddleAtAQuarter) {
  for (const Vec3d& way : {Vec3d{-1, -1, -1}, Vec3d{1, 1, -1}, Vec3d{1, -1, 1}, Vec3d{-1, 1, 1}}) {
    std::vector<double> t = roots_along(prepare(Cayley{}), {way * -2.0, way});
    EXPECT_EQ(t.back(), Aabb::far) << "beyond the node is inside";
    std::erase_if(t, [](double each) { return std::fabs(each - 2.5) < 1e-6; });
    expect_distances(t, {1.75, Aabb::far}, 1e-13);
  }
}

// ---- descriptions -----------------------------------------------------------------------------

TEST(Classics, AreNamedAndClippedInAScene) {
  for (const char* type : {"steiner", "barth_sextic", "heart", "clebsch", "cayley"}) {
    const Scene scene = read_scene(R"({"objects":[{"type":")" + std::string(type) +
                                   R"(","bounds":{"center":[0,0,0],"radius":2}}]})");
    const Aabb box = std::visit(
        [](const auto& shape) {
          if constexpr (IsClassic<std::decay_t<decltype(shape)>>) return bounds(prepare(shape));
          else return Aabb::everything();
        },
        scene.objects.front().shape);
    EXPECT_EQ(box, (Aabb{{-2, -2, -2}, {2, 2, 2}})) << type;
  }
  EXPECT_TRUE(faults_in<Chmutov>(R"({"order":20})").empty());
  expect_faults(faults_in<Chmutov>("{}"),
                {{FaultKind::missing, "/order", "", "an integer from 2"}});
  for (const char* order : {"1", "21"})
    expect_faults(faults_in<Chmutov>(std::string(R"({"order":)") + order + "}"),
                  {{FaultKind::out_of_range, "/order", order, "an integer from 2 to 20"}});
}

}  // namespace
}  // namespace tia
