#include "core/formulas/dual.h"

#include <gtest/gtest.h>

#include "tests/core/formulas/values.h"

namespace tia {
namespace {

using test::any_tree;
using test::Evaluation;
using test::Long;
using test::Point;
using test::program_of_xyz;
using test::Random;
using test::TreePtr;

using Sides = std::array<Interval<double>, 3>;
using Slopes = Dual<double, 3>;
using SlopeBounds = Dual<Interval<double>, 3>;

template <class T>
std::array<Dual<T, 3>, 3> variables(const std::array<T, 3>& at) {
  std::array<Dual<T, 3>, 3> all;
  for (std::size_t i = 0; i < 3; ++i) all[i] = Dual<T, 3>::variable(at[i], i);
  return all;
}
Slopes slopes(const Program& program, const Point& at) {
  return evaluate(program, variables(at).data());
}
SlopeBounds slopes(const Program& program, const Sides& sides, Definedness<double>& where) {
  return evaluate(program, variables(sides).data(), where);
}
// Constants are doubles, computed once: the formula's own is a few of their digits off.
bool nearly_holds(const Interval<double>& bounds, Long x) {
  const Long slack = std::isfinite(x) ? 1e-12L * std::fabs(x) : 0;
  return bounds.lo <= x + slack && x - slack <= bounds.hi;
}

Point uniform_point(Random& random) {
  Point at{};
  for (double& each : at) each = random.in(-3, 3);
  return at;
}

// Its enclosure over the point alone tells how far rounding may have led it.
TEST(Dual, SlopesOfFormulasAreTheirDerivatives) {
  Random random(2);
  int checked = 0, precise = 0;
  for (int i = 0; i < 20'000; ++i) {
    const TreePtr tree = any_tree(random, 1 + random.below(4));
    const std::string text = print(*tree, random).text;
    const Program program = program_of_xyz(text);
    const Point at = uniform_point(random);
    Definedness<double> where;
    const SlopeBounds bounds = slopes(program, Sides{at[0], at[1], at[2]}, where);
    const Slopes got = slopes(program, at);
    Evaluation<Long> exactly(at);
    if (!where.whole) continue;
    for (int by = 0; by < 3; ++by) {
      const auto axis = static_cast<std::size_t>(by);
      const Long exact = exactly.slope(*tree, by);
      if (exactly.overflowed() || !std::isfinite(exact)) continue;
      ++checked;
      const double own = got.slope[axis];
      const Interval<double>& bound = bounds.slope[axis];
      ASSERT_TRUE(nearly_holds(bound, exact)) << text << " by " << by << ": " << exact;
      ASSERT_TRUE(std::isnan(own) || nearly_holds(bound, own))
          << text << " by " << by << ": " << own;
      if (!(bound.hi - bound.lo <= 1e-11 * std::fabs(exact))) continue;
      ++precise;
      ASSERT_NEAR(own, static_cast<double>(exact), 1e-10 * std::fabs(own)) << text << " by " << by;
    }
  }
  EXPECT_GT(precise, 10'000);
  EXPECT_GT(precise, checked / 3);
}

TEST(Dual, ValuesAreThoseWithoutSlopes) {
  Random random(3);
  for (int i = 0; i < 3'000; ++i) {
    const Program program = program_of_xyz(print(*any_tree(random, 4), random).text);
    const Point at = uniform_point(random);
    const double with = slopes(program, at).value, alone = evaluate(program, at.data());
    ASSERT_TRUE(with == alone || (std::isnan(with) && std::isnan(alone)));
    const Sides sides{Interval<double>(at[0], at[0] + 1), at[1], at[2]};
    Definedness<double> first, second;
    const Interval<double> bounds = slopes(program, sides, first).value;
    const Interval<double> own = evaluate(program, sides.data(), second);
    ASSERT_EQ(bounds.lo, own.lo);
    ASSERT_EQ(bounds.hi, own.hi);
    ASSERT_EQ(first.whole, second.whole);
    ASSERT_EQ(first.some, second.some);
  }
}

Sides any_sides(Random& random) {
  Sides sides{};
  const double width = std::pow(10, random.in(-4, 1));
  for (auto& each : sides) {
    const double from = random.chance(0.2) ? random.below(5) - 2 : random.in(-3, 3);
    each = {from, from + width * random.in(0.01, 1)};
  }
  return sides;
}
Point point_in(const Sides& sides, Random& random) {
  Point at{};
  for (std::size_t i = 0; i < 3; ++i) {
    const double t = random.chance(0.4) ? random.below(2) : random.unit();
    at[i] = std::clamp(sides[i].lo * (1 - t) + sides[i].hi * t, sides[i].lo, sides[i].hi);
  }
  return at;
}

TEST(Dual, OverBoxesHoldsTheSlopesThere) {
  Random random(4);
  int checked = 0, finite = 0;
  for (int i = 0; i < 10'000; ++i) {
    const TreePtr tree = any_tree(random, 1 + random.below(4));
    const std::string text = print(*tree, random).text;
    const Program program = program_of_xyz(text);
    const Sides sides = any_sides(random);
    Definedness<double> where;
    const SlopeBounds bounds = slopes(program, sides, where);
    for (int k = 0; k < 6; ++k) {
      const Point at = point_in(sides, random);
      Evaluation<Long> exactly(at);
      const Long value = exactly.value(*tree), exact = exactly.slope(*tree, k % 3);
      if (std::isnan(value) || exactly.overflowed() || !std::isfinite(exact)) continue;
      const Interval<double>& bound = bounds.slope[static_cast<std::size_t>(k % 3)];
      ASSERT_TRUE(nearly_holds(bound, exact)) << text << " by " << k % 3 << ": " << exact;
      ++checked;
      finite += bound.hi - bound.lo < 1e6 ? 1 : 0;
    }
  }
  EXPECT_GT(checked, 30'000);
  EXPECT_GT(finite, checked / 2);
}

// The mean value theorem: (f(b) - f(a)) / (b - a) is a slope between the two.
TEST(Dual, OverBoxesHoldsSecants) {
  Random random(5);
  int checked = 0;
  for (int i = 0; i < 20'000; ++i) {
    const TreePtr tree = any_tree(random, 1 + random.below(4));
    const std::string text = print(*tree, random).text;
    const Program program = program_of_xyz(text);
    const Sides sides = any_sides(random);
    Definedness<double> where;
    const SlopeBounds bounds = slopes(program, sides, where);
    if (!where.whole) continue;
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const Point from = point_in(sides, random);
      Point to = from;
      to[axis] = point_in(sides, random)[axis];
      Evaluation<Long> before(from), after(to);
      const Long f = before.value(*tree), g = after.value(*tree);
      const Long step = static_cast<Long>(to[axis]) - from[axis], secant = (g - f) / step;
      if (std::fabs(step) < 1e-3L || before.overflowed() || after.overflowed()) continue;
      // What rounding in long double, and of the formula's terms, may do to it.
      const Long slack = 1e-9L * (1 + std::fabs(f) + std::fabs(g) + std::fabs(secant));
      ++checked;
      ASSERT_TRUE(bounds.slope[axis].lo <= secant + slack &&
                  secant - slack <= bounds.slope[axis].hi)
          << text << " by " << axis << ": " << secant;
    }
  }
  EXPECT_GT(checked, 10'000);
}

TEST(Dual, OverEightBoxesIsThatOverEach) {
  using Bounds = Dual<Interval<Octet>, 3>;
  Random random(6);
  for (int i = 0; i < 2'000; ++i) {
    const Program program = program_of_xyz(print(*any_tree(random, 4), random).text);
    std::array<Sides, 8> boxes{};
    for (Sides& each : boxes) each = any_sides(random);
    std::array<Interval<Octet>, 3> all{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::array<double, 8> lo{}, hi{};
      for (std::size_t k = 0; k < 8; ++k) lo[k] = boxes[k][axis].lo, hi[k] = boxes[k][axis].hi;
      all[axis] = {Octet::load_unaligned(lo.data()), Octet::load_unaligned(hi.data())};
    }
    Definedness<Octet> where;
    const Bounds got = evaluate(program, variables(all).data(), where);
    for (int k = 0; k < 8; ++k) {
      Definedness<double> lone;
      const SlopeBounds one = slopes(program, boxes[static_cast<std::size_t>(k)], lone);
      for (std::size_t axis = 0; axis < 3; ++axis) {
        ASSERT_EQ(lane(got.slope[axis].lo, k), one.slope[axis].lo);
        ASSERT_EQ(lane(got.slope[axis].hi, k), one.slope[axis].hi);
      }
    }
  }
}

}  // namespace
}  // namespace tia
