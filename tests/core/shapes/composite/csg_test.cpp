// Merging of spans: against membership point by point, and the half-open rule case by case.
#include "core/shapes/composite/csg.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;

constexpr Operation operations[] = {Operation::union_, Operation::intersection,
                                    Operation::difference};

// Spans at some of the integers 0 .. 11, perhaps from or to infinity; parts numbered from `first`.
Spans random_spans(Random& random, int first) {
  Spans spans;
  if (random.chance(0.2)) spans.push_back({-Aabb::far, first++, 0});
  for (int t = 0; t < 12; ++t)
    if (random.chance(0.35)) spans.push_back({double(t), first++, t});
  if (spans.size() % 2 != 0) spans.push_back({Aabb::far, first++, 0});
  return spans;
}

bool inside_spans(const Spans& spans, double t) {
  bool in = false;
  for (const Boundary& each : spans) in = in != (each.t <= t);
  return in;
}

bool expected(Operation operation, bool a, bool b) {
  if (operation == Operation::union_) return a || b;
  return operation == Operation::intersection ? a && b : a && !b;
}

Spans merged(Operation operation, const Spans& a, const Spans& b, double same = 0) {
  Spans result;
  merge(operation, a, b, same, result);
  return result;
}

std::vector<std::pair<double, int>> ends(const Spans& spans) {
  std::vector<std::pair<double, int>> list;
  for (const Boundary& each : spans) list.emplace_back(each.t, each.primitive);
  return list;
}
using Ends = std::vector<std::pair<double, int>>;

// ---- the laws ---------------------------------------------------------------------------------

TEST(Csg, MergedSpansHoldJustThePointsThatTheOperationKeeps) {
  Random random(300);
  for (int i = 0; i < 5000; ++i) {
    const Spans a = random_spans(random, 0), b = random_spans(random, 100);
    for (const Operation operation : operations) {
      const Spans result = merged(operation, a, b);
      for (double t = -1.5; t < 14; t += 0.5)  // on the boundaries, too: the half-open rule
        ASSERT_EQ(inside_spans(result, t),
                  expected(operation, inside_spans(a, t), inside_spans(b, t)))
            << t;
    }
  }
}

TEST(Csg, MergedSpansAscendInPairsAndTakeTheirSurfacesFromTheOperands) {
  Random random(301);
  for (int i = 0; i < 5000; ++i) {
    const Spans a = random_spans(random, 0), b = random_spans(random, 100);
    for (const Operation operation : operations) {
      const Spans result = merged(operation, a, b);
      ASSERT_EQ(result.size() % 2, 0U);
      for (std::size_t k = 0; k < result.size(); ++k) {
        if (k > 0) {
          ASSERT_LT(result[k - 1].t, result[k].t);
        }
        const Spans& own = result[k].primitive < 100 ? a : b;
        const auto same = [&](const Boundary& each) {
          return each.t == result[k].t && each.primitive == result[k].primitive &&
                 each.element == result[k].element;
        };
        ASSERT_TRUE(std::any_of(own.begin(), own.end(), same));
      }
    }
  }
}

TEST(Csg, AlgebraOfSetsHoldsForSpans) {
  Random random(302);
  const Spans all{{-Aabb::far, 7, 0}, {Aabb::far, 7, 0}};
  const auto places = [](const Spans& spans) {
    std::vector<double> t;
    for (const Boundary& each : spans) t.push_back(each.t);
    return t;
  };
  for (int i = 0; i < 2000; ++i) {
    const Spans a = random_spans(random, 0), b = random_spans(random, 100),
                c = random_spans(random, 200);
    const auto u = [](const Spans& x, const Spans& y) { return merged(Operation::union_, x, y); };
    const auto n = [](const Spans& x, const Spans& y) {
      return merged(Operation::intersection, x, y);
    };
    const auto d = [](const Spans& x, const Spans& y) {
      return merged(Operation::difference, x, y);
    };
    EXPECT_EQ(places(u(a, b)), places(u(b, a)));
    EXPECT_EQ(places(n(a, b)), places(n(b, a)));
    EXPECT_EQ(places(u(u(a, b), c)), places(u(a, u(b, c))));
    EXPECT_EQ(places(n(a, u(b, c))), places(u(n(a, b), n(a, c))));
    EXPECT_EQ(places(d(all, u(a, b))), places(n(d(all, a), d(all, b)))) << "De Morgan";
    EXPECT_EQ(places(d(all, n(a, b))), places(u(d(all, a), d(all, b)))) << "De Morgan";
    EXPECT_EQ(ends(u(a, {})), ends(a));
    EXPECT_EQ(ends(d(a, {})), ends(a));
    EXPECT_TRUE(n(a, {}).empty());
    EXPECT_TRUE(d({}, a).empty());
    EXPECT_TRUE(d(a, a).empty());
    EXPECT_EQ(ends(u(a, a)), ends(a));
    EXPECT_EQ(ends(n(a, a)), ends(a));
  }
}

// ---- the half-open rule -----------------------------------------------------------------------

const Spans from_1_to_2{{1, 10, 0}, {2, 11, 0}}, from_2_to_3{{2, 20, 0}, {3, 21, 0}};

TEST(Csg, TouchingSolidsHaveNoFaceBetweenThemInTheirUnion) {
  EXPECT_EQ(ends(merged(Operation::union_, from_1_to_2, from_2_to_3)), (Ends{{1, 10}, {3, 21}}));
  EXPECT_EQ(ends(merged(Operation::union_, from_2_to_3, from_1_to_2)), (Ends{{1, 10}, {3, 21}}));
}

TEST(Csg, TouchingSolidsHaveNothingInCommonAndLoseNothing) {
  EXPECT_TRUE(merged(Operation::intersection, from_1_to_2, from_2_to_3).empty());
  EXPECT_EQ(ends(merged(Operation::difference, from_1_to_2, from_2_to_3)), ends(from_1_to_2));
  EXPECT_EQ(ends(merged(Operation::difference, from_2_to_3, from_1_to_2)), ends(from_2_to_3));
}

TEST(Csg, CoincidentFacesShowTheFirstOperand) {
  const Spans longer{{1, 30, 0}, {4, 31, 0}};
  EXPECT_EQ(ends(merged(Operation::union_, from_1_to_2, longer)), (Ends{{1, 10}, {4, 31}}));
  EXPECT_EQ(ends(merged(Operation::union_, longer, from_1_to_2)), (Ends{{1, 30}, {4, 31}}));
  EXPECT_EQ(ends(merged(Operation::intersection, longer, from_1_to_2)), (Ends{{1, 30}, {2, 11}}));
  EXPECT_EQ(ends(merged(Operation::difference, longer, from_1_to_2)), (Ends{{2, 11}, {4, 31}}))
      << "a cut face is the cutter's";
}

TEST(Csg, BoundariesWithinRoundingAreOne) {
  const double e = 1e-9;
  const Spans near{{1 + e, 40, 0}, {2 - e, 41, 0}}, far_off{{1 + 3 * e, 50, 0}, {2 + 3 * e, 51, 0}};
  EXPECT_TRUE(merged(Operation::difference, from_1_to_2, near, 2 * e).empty());
  EXPECT_EQ(merged(Operation::difference, from_1_to_2, near, e / 2).size(), 4U);
  EXPECT_EQ(merged(Operation::difference, from_1_to_2, far_off, 2 * e).size(), 2U)
      << "a sliver stays";
  // 1000 and its next double are one for the rounding of t alone.
  const Spans a{{1000, 0, 0}, {2000, 1, 0}}, b{{std::nextafter(1000, 2000), 2, 0}, {2000, 3, 0}};
  EXPECT_TRUE(merged(Operation::difference, a, b).empty());
}

TEST(Csg, GrazedSpanOfNoLengthIsNothing) {
  const Spans graze{{5, 0, 0}, {5, 1, 0}};
  EXPECT_TRUE(merged(Operation::union_, graze, {}).empty());
  EXPECT_EQ(ends(merged(Operation::union_, from_1_to_2, graze)), ends(from_1_to_2));
  const Spans within{{1.5, 0, 0}, {1.5, 1, 0}};
  EXPECT_EQ(ends(merged(Operation::difference, from_1_to_2, within)), ends(from_1_to_2));
}

}  // namespace
}  // namespace tia
