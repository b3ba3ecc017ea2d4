// Single rays through a tree: what they must visit, alone and by turns.
#include "core/boxes/lone_traversal.h"

#include <gtest/gtest.h>

#include "tests/core/boxes/boxes.h"

namespace tia {
namespace {

using test::built;
using test::Random;
using test::random_box;
using test::ray_meets;

Ray<float> chance_ray(Random& random) {
  return {lift<float>(random.point(12)), normalize(lift<float>(random.direction()))};
}

TEST(LoneTraversal, OneRayVisitsEveryThingWhoseBoxItMeets) {
  Random random(105);
  std::vector<Aabb> boxes;
  for (int i = 0; i < 500; ++i) boxes.push_back(random_box(random, 10, 2));
  const Bvh bvh = built(boxes);
  WorkCounter work;
  for (int i = 0; i < 500; ++i) {
    const Ray<float> ray = chance_ray(random);
    const float t_max = static_cast<float>(random.in(0, 30));
    std::vector<int> visits(boxes.size());
    with_lone_ray(BoxRay<float>(ray.origin, ray.direction, 0), 0, [&](const auto& lone) {
      traverse(bvh, 0, lone, t_max, work, [&](std::uint32_t first, std::uint32_t count, bool) {
        for (std::uint32_t k = first; k < first + count; ++k) ++visits[bvh.order[k]];
      });
    });
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      EXPECT_LE(visits[k], 1);
      EXPECT_GE(visits[k], ray_meets(boxes[k], ray, double(t_max)));
    }
  }
  EXPECT_LT(work.tests(), 500 * 100) << "of 500 boxes and more";
}

// Leaves whose things end a ray where its box begins: the nearest is what all of them agree on.
struct Beginnings {
  const Bvh& bvh;
  const std::vector<Aabb>& boxes;
  std::vector<Ray<float>> rays;
  std::vector<float> nearest;
  std::vector<int> taken;

  // Where the ray enters the box; infinite where it does not.
  float beginning(const Ray<float>& ray, const Aabb& box) const {
    BoxSet one;
    one.add(rounded_outwards(box));
    BoxSet::Floats near;
    const BoxRay<float> as_box_ray(ray.origin, ray.direction, 0);
    return LoneRay<true>(as_box_ray, 0).enters(one, infinity, near) != 0 ? near[0] : infinity;
  }
  unsigned test(const LoneTraversal<true>& ray, std::uint32_t first, std::uint32_t count) const {
    unsigned met = 0;
    for (std::uint32_t k = 0; k < count; ++k) {
      const float at = beginning(rays[ray.number], boxes[bvh.order[first + k]]);
      met |= static_cast<unsigned>(at < nearest[ray.number]) << k;
    }
    return met;
  }
  float take(const LoneTraversal<true>& ray, std::uint32_t first, std::uint32_t count,
             unsigned met) {
    EXPECT_NE(met, 0U);
    float& own = nearest[ray.number];
    for (std::uint32_t k = 0; k < count; ++k)
      if ((met >> k & 1U) != 0)
        own = std::min(own, beginning(rays[ray.number], boxes[bvh.order[first + k]]));
    ++taken[ray.number];
    return own;
  }
};

// However many go by turns, each finds what there is for it, and is stopped by nobody else's limit.
TEST(LoneTraversal, RaysByTurnsEachFindTheirNearest) {
  Random random(106);
  std::vector<Aabb> boxes;
  for (int i = 0; i < 2000; ++i) boxes.push_back(random_box(random, 10, 0.6));
  const Bvh bvh = built(boxes);
  int found = 0, takes = 0;
  for (int round = 0; round < 60; ++round) {
    const std::size_t n = 1 + static_cast<std::size_t>(random.below(most_lone_rays));
    Beginnings leaves{bvh, boxes, {}, std::vector<float>(n, infinity), std::vector<int>(n)};
    LoneTraversals<true> rays;
    for (std::size_t i = 0; i < n; ++i) {
      leaves.rays.push_back(chance_ray(random));
      leaves.nearest[i] = i % 3 == 0 ? static_cast<float>(random.in(0, 5)) : infinity;
      const Ray<float>& ray = leaves.rays.back();
      rays.add(BoxRay<float>(ray.origin, ray.direction, 0), 0, leaves.nearest[i], 0U, i);
    }
    std::vector<float> expected = leaves.nearest;
    for (std::size_t i = 0; i < n; ++i)
      for (const Aabb& box : boxes)
        expected[i] = std::min(expected[i], leaves.beginning(leaves.rays[i], box));
    WorkCounter work;
    traverse<true, Beginnings&>(bvh, rays.all(), work, leaves);
    EXPECT_EQ(leaves.nearest, expected);
    for (std::size_t i = 0; i < n; ++i) found += expected[i] < infinity, takes += leaves.taken[i];
  }
  EXPECT_GT(found, 200);
  EXPECT_LT(takes, 4 * found) << "the nearest leaves first";
}

}  // namespace
}  // namespace tia
