// Implicit surfaces where formulas are undefined, jump, bend, or are constant; and the solids that
// random formulas bound.
#include <gtest/gtest.h>

#include "tests/core/formulas/trees.h"
#include "tests/core/shapes/isosurfaces.h"

namespace tia {
namespace {

using namespace test;

const SceneLine line_along_x{{-5, 0.1, 0.2}, {1, 0, 0}};

std::vector<double> distances_to(std::vector<double> x) {
  for (double& each : x) each += 5;
  return x;
}
/// Along x through the cube from -2 to 2: the x of the roots, and of the solid's ends.
void expect_along_x(const std::string& f, const std::vector<double>& roots,
                    const std::vector<double>& ends) {
  const auto form = implicit(f, cube_of(2));
  expect_distances(roots_along(form, line_along_x), distances_to(roots), 1e-9, f + " roots: ");
  expect_distances(ends_of(spans_along(form, line_along_x)), distances_to(ends), 1e-9,
                   f + " ends: ");
}

TEST(ImplicitUndefined, OutsideOfItsDomainThereIsNothing) {
  expect_along_x("log(x)", {1}, {0, 1});
  expect_along_x("asin(x)-pi/6", {0.5}, {-1, 0.5});
  expect_along_x("acos(x)-pi/3", {0.5}, {0.5, 1});
  expect_along_x("sqrt(x)-1", {1}, {0, 1});
  expect_along_x("1-sqrt(x)", {1}, {1, 2});
  expect_along_x("-sqrt(x-0.5)-1", {}, {0.5, 2});
  expect_along_x("x^0.5-0.5", {0.25}, {0, 0.25});
  expect_along_x("log(x^2)-log(2)", {-std::sqrt(2), std::sqrt(2)}, {-std::sqrt(2), std::sqrt(2)});
}

TEST(ImplicitUndefined, HemisphereEndsAtItsRim) {
  Random random(1);
  const auto form = implicit("z-sqrt(1-x^2-y^2)", cube_of(2));
  for (int i = 0; i < 200; ++i) {
    const double r = random.in(0, 0.99), angle = random.in(0, 6);
    const double x = r * std::cos(angle), y = r * std::sin(angle), z = std::sqrt(1 - r * r);
    const SceneLine down{{x, y, 5}, {0, 0, -1}};
    expect_distances(roots_along(form, down), {5 - z}, 1e-9);
    expect_distances(ends_of(spans_along(form, down)), {5 - z, 7}, 1e-9);
    // At height h the ball is as wide as the rim is far.
    const double h = random.in(0.05, 0.95), aside = random.in(-0.9, 0.9) * std::sqrt(1 - h * h);
    const double half = std::sqrt(1 - h * h - aside * aside), rim = std::sqrt(1 - aside * aside);
    expect_distances(roots_along(form, {{-5, aside, h}, {1, 0, 0}}), {5 - half, 5 + half}, 1e-9);
    const SceneLine below{{-5, aside, -h}, {1, 0, 0}};
    EXPECT_TRUE(roots_along(form, below).empty());
    expect_distances(ends_of(spans_along(form, below)), {5 - rim, 5 + rim}, 1e-9);
  }
}

TEST(ImplicitUndefined, PolesAreNoSurface) {
  expect_along_x("1/x", {}, {-2, 0});
  expect_along_x("-1/(x-0.3)", {}, {0.3, 2});
  expect_along_x("1/x^2-4", {-0.5, 0.5}, {-2, -0.5, 0.5, 2});
  expect_along_x("4-1/x^2", {-0.5, 0.5}, {-0.5, 0.5});
  expect_along_x("tan(x)", {0}, {-pi / 2, 0, pi / 2, 2});
  // Poles at the odd multiples of pi/6, roots at those of pi/3.
  const double p = pi / 6;
  expect_along_x("tan(3*x)", {-2 * p, 0, 2 * p}, {-3 * p, -2 * p, -p, 0, p, 2 * p, 3 * p, 2});
}

TEST(ImplicitUndefined, JumpsBoundTheSolidAndAreNoSurface) {
  expect_along_x("floor(x)+0.5", {}, {-2, 0});
  expect_along_x("0.5-floor(x)", {}, {1, 2});
  expect_along_x("floor(2*x-0.2)-2*floor(x-0.1)-0.5", {},
                 {-1.9, -1.4, -0.9, -0.4, 0.1, 0.6, 1.1, 1.6});
  expect_along_x("(x-0.25)*(floor(x)+0.5)", {0.25}, {0, 0.25});
}

TEST(ImplicitUndefined, KinksAreSurfaces) {
  expect_along_x("abs(x)-0.5", {-0.5, 0.5}, {-0.5, 0.5});
  expect_along_x("0.5-abs(x)", {-0.5, 0.5}, {-2, -0.5, 0.5, 2});
  expect_along_x("min(x+1,1-x)", {-1, 1}, {-2, -1, 1, 2});
  expect_along_x("max(abs(x)-1,0.5-abs(x))", {-1, -0.5, 0.5, 1}, {-1, -0.5, 0.5, 1});
  expect_along_x("max(x,2*x)", {0}, {-2, 0});
  const auto touched = implicit("abs(x-0.3)", cube_of(2));
  expect_distances(roots_along(touched, line_along_x), {5.3, 5.3}, 1e-9);
}

TEST(ImplicitUndefined, ConstantsHaveNoSurface) {
  expect_along_x("1", {}, {});
  expect_along_x("-1", {}, {-2, 2});
  expect_along_x("x^2+1", {}, {});
  expect_along_x("-1-x^2-y^2", {}, {-2, 2});
  expect_along_x("sqrt(-1-x^2)", {}, {});
  expect_along_x("0/0*x", {}, {});
  expect_along_x("log(-1)", {}, {});
}

// ---- random formulas --------------------------------------------------------------------------

// The state of f at the samples of a line: where two runs of unlike states are each longer than
// three steps, an end of the solid lies between them.
struct March {
  static constexpr int samples = 10'000;
  const Program& f;
  SceneLine line;
  double from, to;

  double t(int i) const { return from + (to - from) * (i + 0.5) / samples; }
  double value(double at) const {
    const Vec3d p = line.origin + line.direction * at;
    const std::array<double, 3> xyz{p.x, p.y, p.z};
    return evaluate(f, xyz.data());
  }
};

// Returns: the ends that the march knows of.
int expect_march_agrees(const March& march, const std::vector<Crossing>& ends,
                        const std::string& text) {
  std::vector<bool> inside(March::samples);
  for (int i = 0; i < March::samples; ++i)
    inside[static_cast<std::size_t>(i)] = march.value(march.t(i)) < 0;
  int known = 0;
  const int run = 3;
  for (int i = run; i + run <= March::samples; ++i) {
    const auto at = static_cast<std::ptrdiff_t>(i);
    const bool before = inside[std::size_t(i - 1)], after = inside[std::size_t(i)];
    if (before == after) continue;
    const auto all = [&](std::ptrdiff_t first, bool what) {
      return std::all_of(inside.begin() + first, inside.begin() + first + run,
                         [&](bool each) { return each == what; });
    };
    if (!all(at - run, before) || !all(at, after)) continue;
    ++known;
    const double low = march.t(i - 1), high = march.t(i), slack = 1e-9;
    const auto between = std::count_if(ends.begin(), ends.end(), [&](const Crossing& each) {
      return each.t >= low - slack && each.t <= high + slack;
    });
    EXPECT_EQ(between % 2, 1) << text << " between " << low << " and " << high;
  }
  return known;
}

TEST(ImplicitRandom, SpansAreWhatADenseMarchFinds) {
  Random random(4);
  int known = 0, pairs = 0, given_up = 0;
  for (int i = 0; i < rounds(120); ++i) {
    const std::string text = print(*any_tree(random, 2 + random.below(4)), random).text;
    const IsosurfaceForm form = implicit(text, cube_of(2));
    for (int k = 0; k < 3; ++k) {
      const Vec3d target = random.point(1.5), way = random.direction();
      const SceneLine line{target - way * 8.0, way};
      std::int64_t work = 0;
      const std::vector<Crossing> ends =
          sent(bounds(form), line, [&](const Line& l, auto emit) { work = spans(form, l, emit); });
      ASSERT_EQ(ends.size() % 2, 0U) << text;
      const std::vector<double> box = roots_along(Box{{-2, -2, -2}, {2, 2, 2}}, line);
      const March march{form.function, line, box[0], box[1]};
      for (std::size_t n = 1; n < ends.size(); ++n) ASSERT_LE(ends[n - 1].t, ends[n].t) << text;
      // Beyond what a line may take its pieces are known by their ends alone.
      if (work > 3000 * (1 + form.function.cost / 4)) {
        ++given_up;
        continue;
      }
      for (std::size_t n = 0; n + 1 < ends.size(); n += 2) {
        const double in = ends[n].t, out = ends[n + 1].t;
        EXPECT_TRUE(in >= box[0] - 1e-9 && out <= box[1] + 1e-9) << text;
        if (out - in < 1e-6) continue;
        EXPECT_LT(march.value((in + out) / 2), 1e-12) << text << " at " << (in + out) / 2;
        ++pairs;
      }
      known += expect_march_agrees(march, ends, text);
    }
  }
  EXPECT_GT(known, sanitized() ? 0 : 60);
  EXPECT_GT(pairs, sanitized() ? 0 : 90);
  EXPECT_LT(given_up, 36) << "of 360";
}

// ---- bounded work -----------------------------------------------------------------------------

TEST(ImplicitWork, IsBoundedWhateverTheFormula) {
  Random random(5);
  std::string long_sum = "sin(x)";
  while (long_sum.size() < 3000) long_sum += "+sin(" + std::to_string(long_sum.size()) + "*x*y*z)";
  int formula = 0;
  for (const std::string& f : std::vector<std::string>{
           "sin(1e6*x*y)", "sin(1/x)", "floor(1000*x)+0.5", "x*sin(1000*z)", "tan(1e5*(x+y+z))",
           "0*x", "x-x", "sin(1e9*x)^2", "floor(x*1e4)", "abs(sin(1e4*x*y*z))", "1/sin(1e5*x*z)",
           "x^256-y^255", "exp(x*700)-y", "sqrt(sin(1e5*x))", "log(sin(1e5*x+y))", long_sum}) {
    if (sanitized() && formula++ % 4 != 0) continue;
    const IsosurfaceForm form = implicit(f, cube_of(1));
    std::int64_t most = 0;
    for (int i = 0; i < rounds(5); ++i) {
      const Vec3d origin = random.vector(0, 3), target = random.point(1);
      std::size_t count = 0;
      most = std::max(most, crossings(form, Line{origin, normalize(target - origin)},
                                      [&](double, int) { ++count; }));
      EXPECT_LT(count, 100'000u) << f;
    }
    const std::int64_t per_value = 1 + form.function.cost / 4;
    EXPECT_LT(most, 250'000 * per_value) << f;
  }
}

}  // namespace
}  // namespace tia
