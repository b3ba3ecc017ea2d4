#include "core/formulas/program.h"

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

double value_at(const Program& program, const Point& at) { return evaluate(program, at.data()); }
double value_at(const std::string& text, const Point& at = {}) {
  return value_at(program_of_xyz(text), at);
}

Point any_point(Random& random, double extent = 3) {
  Point at{};
  for (double& each : at)
    each = random.chance(0.1) ? random.below(5) - 2 : random.in(-extent, extent);
  return at;
}
bool same(double a, double b) { return a == b || (std::isnan(a) && std::isnan(b)); }

// ---- values ---------------------------------------------------------------------------------

TEST(Program, ComputesWhatItsTextSays) {
  Random random(1);
  int defined = 0;
  for (int i = 0; i < 5'000; ++i) {
    const TreePtr tree = any_tree(random, 1 + random.below(5));
    const std::string text = print(*tree, random).text;
    const Program program = program_of_xyz(text);
    for (int k = 0; k < 5; ++k) {
      const Point at = any_point(random);
      const double expected = Evaluation<double>(at).value(*tree), got = value_at(program, at);
      ASSERT_TRUE(same(got, expected)) << text << ": " << got << ", not " << expected;
      defined += std::isfinite(got) ? 1 : 0;
    }
  }
  EXPECT_GT(defined, 10'000);
}

TEST(Program, OfEightIsThatOfEach) {
  Random random(2);
  for (int i = 0; i < 3'000; ++i) {
    const Program program = program_of_xyz(print(*any_tree(random, 4), random).text);
    std::array<Point, 8> at{};
    for (Point& each : at) each = any_point(random, 1000);
    std::array<Octet, 3> all{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::array<double, 8> lanes{};
      for (std::size_t k = 0; k < 8; ++k) lanes[k] = at[k][axis];
      all[axis] = Octet::load_unaligned(lanes.data());
    }
    const Octet got = evaluate(program, all.data());
    for (std::size_t k = 0; k < 8; ++k)
      ASSERT_TRUE(same(lane(got, static_cast<int>(k)), value_at(program, at[k])));
  }
}

TEST(Program, PowersOfZero) {
  EXPECT_EQ(value_at("0^0"), 1);
  EXPECT_EQ(value_at("x^0"), 1);
  EXPECT_EQ(value_at("x^y"), 1);
  EXPECT_TRUE(std::isinf(value_at("0^-1")));
  EXPECT_TRUE(std::isinf(value_at("x^-2")));
  EXPECT_EQ(value_at("x^0.5"), 0);
}

TEST(Program, PowersBelowZeroAreThoseToWholeNumbers) {
  EXPECT_EQ(value_at("x^3", {-2, 0, 0}), -8);
  EXPECT_EQ(value_at("x^-2", {-2, 0, 0}), 0.25);
  EXPECT_EQ(value_at("x^256", {-1, 0, 0}), 1);
  for (const char* text : {"x^y", "x^0.5", "x^2.5", "x^(1/3)"})
    EXPECT_TRUE(std::isnan(value_at(text, {-2, 3, 0}))) << text;
}

TEST(Program, UndefinedPartsMakeTheWholeUndefined) {
  for (const char* text : {"min(sqrt(x), 1)", "min(1, sqrt(x))", "max(log(x), 1)", "max(1, log(x))",
                           "abs(asin(x))", "floor(acos(x))", "sqrt(x)^2", "sqrt(x)^y", "y^sqrt(x)",
                           "atan2(sqrt(x), 1)", "0*sqrt(x)", "tanh(sqrt(x))", "cosh(sqrt(x))"})
    for (const double y : {0.0, 1.0}) EXPECT_TRUE(std::isnan(value_at(text, {-2, y, 0}))) << text;
}

// ---- intervals ------------------------------------------------------------------------------

struct Box3 {
  std::array<Interval<double>, 3> side{};
  Point point(Random& random) const {
    Point at{};
    for (std::size_t i = 0; i < 3; ++i) {
      const double t = random.chance(0.4) ? random.below(2) : random.unit();
      at[i] = std::clamp(side[i].lo * (1 - t) + side[i].hi * t, side[i].lo, side[i].hi);
    }
    return at;
  }
};
Box3 any_box(Random& random) {
  Box3 box;
  const Point from = any_point(random);
  const double width = std::pow(10, random.in(-9, 1));
  for (std::size_t i = 0; i < 3; ++i)
    box.side[i] = {from[i], random.chance(0.1) ? from[i] : from[i] + width * random.unit()};
  return box;
}

TEST(Program, OverBoxesHoldsItsValues) {
  Random random(3);
  int whole = 0, broken = 0, nowhere = 0;
  for (int i = 0; i < 30'000; ++i) {
    const TreePtr tree = any_tree(random, 1 + random.below(4));
    const std::string text = print(*tree, random).text;
    const Program program = program_of_xyz(text);
    const Box3 box = any_box(random);
    Definedness<double> where;
    const Interval<double> all = evaluate(program, box.side.data(), where);
    (where.whole ? whole : where.some ? broken : nowhere) += 1;
    for (int k = 0; k < 4; ++k) {
      const Point at = box.point(random);
      const double own = value_at(program, at);
      Evaluation<Long> exactly(at);
      const Long exact = exactly.value(*tree);
      if (exactly.overflowed() || std::isinf(own)) continue;
      // Constants are doubles, computed once: the formula's own is a few of their digits off.
      const auto holds = [&](Long x, Long slack = 0) {
        return all.lo <= x + slack && x - slack <= all.hi && where.some;
      };
      ASSERT_TRUE(std::isnan(own) || holds(own)) << text << " at " << at[0] << ", " << at[1];
      ASSERT_TRUE(std::isnan(exact) ||
                  holds(exact, std::isfinite(exact) ? 1e-12L * std::fabs(exact) : 0))
          << text << " at " << at[0] << ", " << at[1];
      ASSERT_FALSE(std::isnan(exact) && where.whole) << text;
    }
  }
  EXPECT_GT(whole, 4'000);
  EXPECT_GT(broken, 500);
  EXPECT_GT(nowhere, 500);
}

TEST(Program, OverEightBoxesIsThatOverEach) {
  Random random(4);
  for (int i = 0; i < 2'000; ++i) {
    const Program program = program_of_xyz(print(*any_tree(random, 4), random).text);
    std::array<Box3, 8> boxes{};
    for (Box3& each : boxes) each = any_box(random);
    std::array<Interval<Octet>, 3> all{};
    for (std::size_t axis = 0; axis < 3; ++axis) {
      std::array<double, 8> lo{}, hi{};
      for (std::size_t k = 0; k < 8; ++k)
        lo[k] = boxes[k].side[axis].lo, hi[k] = boxes[k].side[axis].hi;
      all[axis] = {Octet::load_unaligned(lo.data()), Octet::load_unaligned(hi.data())};
    }
    Definedness<Octet> where;
    const Interval<Octet> got = evaluate(program, all.data(), where);
    for (int k = 0; k < 8; ++k) {
      Definedness<double> lone;
      const auto one = evaluate(program, boxes[static_cast<std::size_t>(k)].side.data(), lone);
      ASSERT_EQ(lane(got.lo, k), one.lo);
      ASSERT_EQ(lane(got.hi, k), one.hi);
      ASSERT_EQ((bits(where.whole) >> k & 1U) != 0, lone.whole);
      ASSERT_EQ((bits(where.some) >> k & 1U) != 0, lone.some);
    }
  }
}

}  // namespace
}  // namespace tia
