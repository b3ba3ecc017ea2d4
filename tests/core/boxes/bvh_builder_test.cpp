#include "core/boxes/bvh_builder.h"

#include <gtest/gtest.h>

#include "core/parallel/pool.h"

#include "tests/core/boxes/boxes.h"

namespace tia {
namespace {

using test::built;
using test::Random;
using test::random_box;

int depth_of(const Bvh& bvh, std::uint32_t at = 0) {
  const Bvh::Node& node = bvh.nodes[at];
  int below = 0;
  for (std::size_t i = 0; i < node.boxes.count; ++i)
    if (!node.children[i].is_leaf())
      below = std::max(below, depth_of(bvh, node.children[i].first()));
  return 1 + below;
}

bool holds(const Box32& box, const Aabb& inner) {
  const auto low = static_cast<Vec3d>(box.min), high = static_cast<Vec3d>(box.max);
  return lower(low, inner.min) == low && upper(high, inner.max) == high;
}

// Every thing below a child is within the child's box. Returns: how many there are.
std::size_t check_below(const Bvh& bvh, std::uint32_t at, const std::vector<Aabb>& boxes,
                        std::vector<Box32>& above) {
  const Bvh::Node& node = bvh.nodes[at];
  std::size_t things = 0;
  for (std::size_t i = 0; i < node.boxes.count; ++i) {
    above.push_back(node.boxes.box(i));
    const BvhChild child = node.children[i];
    things += child.count();
    for (std::uint32_t k = 0; k < child.count(); ++k)
      for (const Box32& each : above) EXPECT_TRUE(holds(each, boxes[bvh.order[child.first() + k]]));
    if (!child.is_leaf()) things += check_below(bvh, child.first(), boxes, above);
    above.pop_back();
  }
  return things;
}

void expect_sound(const std::vector<Aabb>& boxes) {
  const Bvh bvh = built(boxes);
  std::vector<Box32> above;
  EXPECT_EQ(check_below(bvh, 0, boxes, above), boxes.size());
  EXPECT_LE(depth_of(bvh), Bvh::deepest);
  HugeVector<std::uint32_t> all = bvh.order;
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i < boxes.size(); ++i) EXPECT_EQ(all[i], i);
}

TEST(Bvh, HoldsEveryThingOnceInBoxesThatHoldIt) {
  Random random(100);
  for (const int n : {1, 2, 3, 8, 9, 17, 100, 1000}) {
    for (const double scale : {1e-6, 1.0, 1e6}) {
      std::vector<Aabb> boxes;
      for (int i = 0; i < n; ++i) boxes.push_back(random_box(random, 10 * scale, scale));
      expect_sound(boxes);
    }
  }
}

TEST(Bvh, IsTheSameWhoeverBuildsIt) {
  Random random(105);
  std::vector<Box32> boxes;
  for (int i = 0; i < test::rounds(200'000, 2); ++i)
    boxes.push_back(rounded_outwards(random_box(random, 10, i % 100 == 0 ? 3 : 0.1)));
  const Bvh alone = build_bvh(boxes);
  Pool pool(4);
  const Workers backwards([](int count, const Workers::Task& task) {
    for (int i = count; i-- > 0;) task(i);
  });
  const Workers many = pool.workers(4);
  for (const Workers* workers : {&backwards, &many}) {
    const Bvh shared = build_bvh(boxes, *workers);
    EXPECT_EQ(shared.order, alone.order);
    ASSERT_EQ(shared.nodes.size(), alone.nodes.size());
    for (std::size_t i = 0; i < alone.nodes.size(); ++i) {
      const Bvh::Node &a = shared.nodes[i], &b = alone.nodes[i];
      ASSERT_EQ(a.boxes.faces, b.boxes.faces) << i;
      ASSERT_EQ(a.children, b.children) << i;
    }
  }
}

TEST(Bvh, OfNothingIsEmptyAndVisitsNothing) {
  const Bvh bvh = build_bvh({});
  EXPECT_TRUE(bvh.nodes.empty());
  WorkCounter work;
  traverse<float>(bvh, {{0, 0, 0}, {0, 0, -1}, 0}, true, infinity, work,
                  [](std::uint32_t, std::uint32_t, bool) { FAIL(); });
  EXPECT_EQ(work.tests(), 0);
}

TEST(Bvh, OfBoxesInOnePlaceIsAsShallowAsHalvingIs) {
  // No split separates them: 10 000 things in leaves of at most 8 are 11 halvings, three a node.
  const std::vector<Aabb> same(10'000, Aabb{{1, 2, 3}, {4, 5, 6}});
  expect_sound(same);
  EXPECT_EQ(depth_of(built(same)), 4);
  const std::vector<Aabb> points(10'000, Aabb{{1, 2, 3}, {1, 2, 3}});
  expect_sound(points);
}

TEST(Bvh, OfBoxesAtExponentialDistancesIsNoDeeperThanTheStack) {
  // Bins of equal width part off one or two at a time.
  for (const double ratio : {2.0, 17.0, 1e3}) {
    std::vector<Aabb> boxes;
    double at = 1e-100;
    while (at < 1e30) {
      boxes.push_back({{at, 0, 0}, {at * 1.0001, at, at}});
      at *= ratio;
    }
    expect_sound(boxes);
  }
}

TEST(Bvh, OfCentresCloserThanDoublesCanBeBinnedIsSound) {
  std::vector<Aabb> boxes;
  for (int i = 0; i < 100; ++i) {
    const double at = 1 + i * 0x1p-52, tiny = i * 5e-324;
    boxes.push_back({{at, tiny, 0}, {at, tiny, 0}});
  }
  expect_sound(boxes);
}

TEST(Bvh, OfHugeBoxesIsSound) {
  std::vector<Aabb> boxes;
  for (int i = 1; i < 50; ++i) {
    const double far = i * 1e200;  // areas overflow
    boxes.push_back({{-far, -far, -far}, {far, far, 2 * far}});
  }
  expect_sound(boxes);
}

TEST(Bvh, RoundedBoxHoldsTheExactOne) {
  Random random(101);
  for (int i = 0; i < 10'000; ++i) {
    const double scale = std::pow(10, random.in(-50, 45));
    const Aabb box = random_box(random, scale, scale * 1e-7);
    EXPECT_TRUE(holds(rounded_outwards(box), box));
  }
}

}  // namespace
}  // namespace tia
