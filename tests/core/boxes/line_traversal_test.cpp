// Lines through trees of boxes: a line visits exactly the leaves that it meets, and in order.
#include "core/boxes/line_traversal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;

struct Boxes {
  OffsetBvh tree;
  std::vector<Aabb> leaves;  // around the middle
};

// Random boxes parted in eight by their middles, some of them left out.
Boxes octree(Random& random, int levels, double missing) {
  Boxes all;
  all.tree.middle = random.point(10);
  struct Pending {
    Aabb box;
    std::size_t node;
    int level;
  };
  std::deque<Pending> pending{{{{-1, -2, -4}, {1, 2, 4}}, 0, 1}};
  all.tree.nodes.emplace_back();
  while (!pending.empty()) {
    const Pending next = pending.front();
    pending.pop_front();
    const Vec3d c = next.box.center();
    for (std::size_t i = 0; i < 8; ++i) {
      if (random.chance(missing)) continue;
      Aabb box = next.box;
      ((i & 1) != 0 ? box.min : box.max).x = c.x;
      ((i & 2) != 0 ? box.min : box.max).y = c.y;
      ((i & 4) != 0 ? box.min : box.max).z = c.z;
      if (next.level == levels || random.chance(0.2)) {
        all.tree.add_leaf(next.node, box, all.leaves.size());
        all.leaves.push_back(box);
      } else {
        pending.push_back({box, all.tree.nodes.size(), next.level + 1});
        all.tree.nodes.emplace_back();
        all.tree.add_node(next.node, box, pending.back().node);
      }
    }
  }
  return all;
}

struct Visit {
  std::uint32_t leaf;
  double in, out;
};
std::vector<Visit> visits(const OffsetBvh& tree, const Line& line, double from, double to) {
  std::vector<Visit> all;
  traverse(tree, line, from, to, [&](std::uint32_t leaf, double in, double out, double end) {
    all.push_back({leaf, in, out});
    return end;
  });
  return all;
}

// The stretch of a line within a box, by clipping at its six planes; empty where in > out.
Visit stretch(const Aabb& box, const Vec3d& o, const Vec3d& d, double from, double to) {
  Visit s{0, from, to};
  const double low[] = {box.min.x, box.min.y, box.min.z},
               high[] = {box.max.x, box.max.y, box.max.z};
  const double at[] = {o.x, o.y, o.z}, way[] = {d.x, d.y, d.z};
  for (int axis = 0; axis < 3; ++axis) {
    if (way[axis] == 0) {
      if (at[axis] < low[axis] || at[axis] > high[axis]) s.out = -Aabb::far;
      continue;
    }
    const double a = (low[axis] - at[axis]) / way[axis], b = (high[axis] - at[axis]) / way[axis];
    s.in = std::max(s.in, std::min(a, b));
    s.out = std::min(s.out, std::max(a, b));
  }
  return s;
}

Line any_line(Random& random, const Vec3d& middle) {
  Vec3d d = random.direction();
  if (random.chance(0.3)) d.x = 0;
  if (random.chance(0.3)) d.y = 0;
  if (dot(d, d) == 0) d.z = 1;
  const Vec3d target = middle + random.point(2);
  return {target - normalize(d) * random.in(-9, 9), normalize(d)};
}

TEST(LineTraversal, VisitsTheLeavesThatTheLineMeets) {
  Random random(1);
  std::size_t met = 0;
  for (int i = 0; i < 100; ++i) {
    const Boxes boxes = octree(random, 1 + random.below(4), 0.4);
    for (int k = 0; k < 30; ++k) {
      const Line line = any_line(random, boxes.tree.middle);
      const double from = random.chance(0.5) ? -20 : random.in(-5, 5), to = from + random.in(1, 40);
      std::vector<Visit> seen(boxes.leaves.size(), {0, 1, 0});
      for (const Visit& each : visits(boxes.tree, line, from, to)) {
        EXPECT_GT(seen[std::size_t(each.leaf)].in, seen[std::size_t(each.leaf)].out) << "once";
        seen[std::size_t(each.leaf)] = each;
      }
      for (std::size_t n = 0; n < boxes.leaves.size(); ++n) {
        const Visit expected =
            stretch(boxes.leaves[n], line.origin - boxes.tree.middle, line.direction, from, to);
        // Those only touched at a corner may go either way.
        if (std::fabs(expected.out - expected.in) < 1e-4) continue;  // lines are tried in float
        const bool is_met = expected.in < expected.out;
        ASSERT_EQ(seen[n].in <= seen[n].out, is_met);
        if (!is_met) continue;
        ASSERT_NEAR(seen[n].in, expected.in, 2e-5);
        ASSERT_NEAR(seen[n].out, expected.out, 2e-5);
        ++met;
      }
    }
  }
  EXPECT_GT(met, 1500U);
}

TEST(LineTraversal, BoxesThatOnlyTouchComeInTheOrderOfTheLine) {
  Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Boxes boxes = octree(random, 3, 0.2);
    for (int k = 0; k < 30; ++k) {
      const auto all = visits(boxes.tree, any_line(random, boxes.tree.middle), -30, 30);
      for (std::size_t n = 1; n < all.size(); ++n) ASSERT_LE(all[n - 1].in, all[n].in + 1e-12) << n;
    }
  }
}

TEST(LineTraversal, NothingBeyondWhatAVisitReturnsIsVisited) {
  Random random(3);
  for (int i = 0; i < 300; ++i) {
    const Boxes boxes = octree(random, 3, 0.1);
    const Line line = any_line(random, boxes.tree.middle);
    const auto all = visits(boxes.tree, line, -30, 30);
    std::size_t count = 0;
    const double enough = random.in(-4, 4);
    traverse(boxes.tree, line, -30, 30, [&](std::uint32_t leaf, double in, double, double) {
      EXPECT_EQ(leaf, all[count].leaf);
      EXPECT_TRUE(count == 0 || in <= enough);
      ++count;
      return enough;
    });
    const auto within =
        std::count_if(all.begin(), all.end(), [&](const Visit& v) { return v.in <= enough; });
    EXPECT_GE(count, std::size_t(within));
  }
}

TEST(LineTraversal, LinesWithinFacesVisitTheBoxesOfThoseFaces) {
  Boxes boxes;
  boxes.tree.nodes.emplace_back();
  boxes.tree.add_leaf(0, {{0, 0, 0}, {1, 1, 1}}, 0);
  boxes.tree.add_leaf(0, {{1, 0, 0}, {2, 1, 1}}, 1);
  for (const double side : {0.0, 1.0}) {
    // In one face, in two at once, that is, along an edge; both ways.
    for (const double z : {side, 0.5})
      for (const double way : {-1.0, 1.0}) {
        const auto all = visits(boxes.tree, {{0.5, side, z}, {way, 0, 0}}, -10, 10);
        ASSERT_EQ(all.size(), 2U);
        EXPECT_EQ(all[0].leaf, way > 0 ? 0U : 1U);
      }
  }
  EXPECT_EQ(visits(boxes.tree, {{1, 0.5, -3}, {0, 0, 1}}, -10, 10).size(), 2U);
}

TEST(LineTraversal, FloatsHoldWhatDoublesSay) {
  Random random(4);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d low = random.point(1e6), high = low + Vec3d{1, 1, 1} * random.unit();
    const Box32 box = enclosing({low, high});
    EXPECT_LE(double(box.min.x), low.x);
    EXPECT_GE(double(box.max.z), high.z);
  }
}

TEST(LineTraversal, EmptyOnesAndLinesOfNaNVisitNothing) {
  EXPECT_TRUE(visits({}, {{0, 0, 0}, {1, 0, 0}}, -1, 1).empty());
  OffsetBvh tree;
  tree.nodes.emplace_back();
  EXPECT_TRUE(visits(tree, {{0, 0, 0}, {1, 0, 0}}, -1, 1).empty());
}

}  // namespace
}  // namespace tia
