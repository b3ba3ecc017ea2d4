#include "core/accel/bvh_builder.h"

#include <gtest/gtest.h>

#include "core/render/pool.h"

#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;

Aabb random_box(Random& random, double extent, double size) {
  const Vec3d at = random.point(extent);
  const double x = random.in(0, size), y = random.in(0, size);
  return {at, at + Vec3d{x, y, random.in(0, size)}};
}

int depth_of(const Bvh& bvh, std::uint32_t at = 0) {
  const Bvh::Node& node = bvh.nodes[at];
  int below = 0;
  for (std::size_t i = 0; i < node.boxes.count; ++i)
    if (node.count[i] == 0) below = std::max(below, depth_of(bvh, node.first[i]));
  return 1 + below;
}

Bvh built(const std::vector<Aabb>& boxes) {
  std::vector<Box32> rounded;
  for (const Aabb& box : boxes) rounded.push_back(rounded_outwards(box));
  return build_bvh(rounded);
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
    things += node.count[i];
    for (std::uint32_t k = 0; k < node.count[i]; ++k)
      for (const Box32& each : above) EXPECT_TRUE(holds(each, boxes[bvh.order[node.first[i] + k]]));
    if (node.count[i] == 0) things += check_below(bvh, node.first[i], boxes, above);
    above.pop_back();
  }
  return things;
}

void expect_sound(const std::vector<Aabb>& boxes) {
  const Bvh bvh = built(boxes);
  std::vector<Box32> above;
  EXPECT_EQ(check_below(bvh, 0, boxes, above), boxes.size());
  EXPECT_LE(depth_of(bvh), Bvh::deepest);
  std::vector<std::uint32_t> all = bvh.order;
  std::sort(all.begin(), all.end());
  for (std::size_t i = 0; i < boxes.size(); ++i) EXPECT_EQ(all[i], i);
}

// ---- the tree ---------------------------------------------------------------------------------

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
  for (int i = 0; i < 200'000; ++i)
    boxes.push_back(rounded_outwards(random_box(random, 10, i % 100 == 0 ? 3 : 0.1)));
  const Bvh alone = build_bvh(boxes);
  Pool pool(4);
  const Workers backwards([](int count, const Workers::Task& task) {
    for (int i = count; i-- > 0;) task(i);
  });
  const Workers many(
      [&](int count, const Workers::Task& task) { pool.for_each(count, 4, {}, task); });
  for (const Workers* workers : {&backwards, &many}) {
    const Bvh shared = build_bvh(boxes, *workers);
    EXPECT_EQ(shared.order, alone.order);
    ASSERT_EQ(shared.nodes.size(), alone.nodes.size());
    for (std::size_t i = 0; i < alone.nodes.size(); ++i) {
      const Bvh::Node &a = shared.nodes[i], &b = alone.nodes[i];
      ASSERT_EQ(a.boxes.faces, b.boxes.faces) << i;
      ASSERT_EQ(a.first, b.first) << i;
      ASSERT_EQ(a.count, b.count) << i;
    }
  }
}

TEST(Bvh, OfNothingIsEmptyAndVisitsNothing) {
  const Bvh bvh = build_bvh({});
  EXPECT_TRUE(bvh.nodes.empty());
  Effort effort;
  traverse<float>(bvh, {{0, 0, 0}, {0, 0, -1}, 0}, true, infinity, effort,
                  [](std::uint32_t, std::uint32_t, bool) { FAIL(); });
  EXPECT_EQ(effort.tests(), 0);
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

// ---- the rays ---------------------------------------------------------------------------------

// What a box test must never miss: the ray, exact in long double, within the box for some t in
// [0, t_max].
bool meets(const Aabb& box, const Ray<float>& ray, double t_max) {
  using Long = long double;
  Long near = 0, far = t_max;
  const auto slab = [&](Long low, Long high, Long o, Long d) {
    if (d == 0) {
      if (o < low || o > high) far = -1;
      return;
    }
    const Long a = (low - o) / d, b = (high - o) / d;
    near = std::max(near, std::min(a, b));
    far = std::min(far, std::max(a, b));
  };
  slab(box.min.x, box.max.x, ray.origin.x, ray.direction.x);
  slab(box.min.y, box.max.y, ray.origin.y, ray.direction.y);
  slab(box.min.z, box.max.z, ray.origin.z, ray.direction.z);
  return near <= far;
}

// Boxes and rays at few places, so that faces, edges and corners are met exactly.
Ray<float> grid_ray(Random& random) {
  const auto at = [&] { return static_cast<float>(random.below(5)); };
  const float x = at(), y = at(), z = at(), to_x = at(), to_y = at(), to_z = at();
  return {{x, y, z}, normalize(Vec3f{to_x - x, to_y - y, to_z - z + 0x1p-30F})};
}

TEST(BoxRay, NeverMissesABoxThatTheRayMeets) {
  Random random(102);
  int met = 0, entered = 0;
  constexpr int all = 50'000;
  for (int i = 0; i < all; ++i) {
    const bool grid = i % 2 == 0;
    const Vec3d corner{double(random.below(5)), double(random.below(5)), double(random.below(5))};
    const Vec3d size{double(random.below(2)), double(random.below(2)), double(random.below(2))};
    const Aabb box = grid ? Aabb{corner, corner + size} : random_box(random, 3, 3);
    const Ray<float> ray =
        grid ? grid_ray(random)
             : Ray<float>{lift<float>(random.point(4)), normalize(lift<float>(random.direction()))};
    const double t_max = random.in(0, 12);
    const BoxRay<float> test(ray.origin, ray.direction, 0);
    const bool enters = test.enters(rounded_outwards(box), static_cast<float>(t_max));
    const bool expected = meets(box, ray, t_max);
    EXPECT_TRUE(enters || !expected);
    met += expected;
    entered += enters;
  }
  EXPECT_GT(met, all / 50);
  EXPECT_LT(entered - met, all / 50) << "and hardly ever finds one that it does not meet";
}

// All rays of a packet together: the bundle never misses what one of them meets, and one ray alone
// is told apart as finely as by its own test.
TEST(Bundle, NeverMissesABoxThatOneOfItsRaysMeets) {
  constexpr std::size_t n = Wide::size;
  Random random(105);
  int met = 0, told = 0, told_lone = 0;
  for (int round = 0; round < 10'000; ++round) {
    std::array<std::array<float, n>, 6> parts;
    std::array<Ray<float>, n> rays;
    const Vec3d eye = random.point(4), way = random.direction();
    const double spread = std::pow(10, random.in(-4, 0.5));
    for (std::size_t i = 0; i < n; ++i) {
      const Vec3d aside = random.point(spread), turn = random.point(spread);
      rays[i] = round % 4 == 0
                    ? grid_ray(random)
                    : Ray<float>{lift<float>(eye + aside), normalize(lift<float>(way + turn))};
      const auto& [o, d] = rays[i];
      const float all[] = {o.x, o.y, o.z, d.x, d.y, d.z};
      for (std::size_t k = 0; k < 6; ++k) parts[k][i] = all[k];
    }
    const auto vector = [&](std::size_t k) -> Vec3<Wide> {
      return {load<Wide>(parts[k].data()), load<Wide>(parts[k + 1].data()),
              load<Wide>(parts[k + 2].data())};
    };
    const Wide lane_index = iota<Wide>();
    const float first_out = static_cast<float>(1 + random.below(static_cast<int>(n)));
    const WideMask active = lane_index < Wide(first_out);
    const Bundle bundle(BoxRay<Wide>(vector(0), vector(3), Wide(0)), active);
    const float t_max = static_cast<float>(random.in(0, 12));

    BoxSet boxes;
    std::vector<Aabb> exact;
    const int count = 1 + random.below(8);
    for (int i = 0; i < count; ++i) {
      exact.push_back(random_box(random, 3, 3));
      boxes.add(rounded_outwards(exact.back()));
    }
    BoxSet::Floats near, alone_near;
    const unsigned entered = bundle.enters(boxes, t_max, near);
    EXPECT_EQ(entered >> count, 0U);
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(first_out); ++lane) {
      const BoxRay<float> one(rays[lane].origin, rays[lane].direction, 0);
      const unsigned alone = Bundle(one, true).enters(boxes, t_max, alone_near);
      BoxSet::Floats lone_near;
      const unsigned lone = LoneRay(one).enters(boxes, t_max, lone_near);
      EXPECT_EQ(lone >> count, 0U);
      EXPECT_EQ(alone & ~entered, 0U);
      for (std::size_t i = 0; i < boxes.count; ++i) {
        const bool meets_it = meets(exact[i], rays[lane], double(t_max));
        EXPECT_TRUE(!meets_it || (alone >> i & 1U) != 0);
        EXPECT_EQ((alone >> i & 1U) != 0, one.enters(boxes.box(i), t_max));
        EXPECT_TRUE(!meets_it || (lone >> i & 1U) != 0);
        told_lone += lone >> i & 1U;
        if ((alone >> i & 1U) != 0) {
          EXPECT_LE(near[i], alone_near[i]);
        }
        met += meets_it;
        told += alone >> i & 1U;
      }
    }
  }
  EXPECT_GT(met, 10'000);
  EXPECT_LT(told - met, met / 50);
  EXPECT_LT(told_lone - met, met / 50);
}

TEST(BoxRay, OriginWithinTheBlurNeverMissesEither) {
  Random random(103);
  for (int i = 0; i < 20'000; ++i) {
    const double far = std::pow(10, random.in(0, 7));
    const Vec3d origin = random.point(far);
    const Vec3d target = random.point(1);
    const Vec3d direction = normalize(target - origin);
    const Vec3d half{1e-3, 1e-3, 1e-3};
    const Aabb box{target - half, target + half};
    const float blur = static_cast<float>(far) * 0x1p-22F;
    const BoxRay<float> ray(lift<float>(origin), lift<float>(direction), blur);
    EXPECT_TRUE(ray.enters(rounded_outwards(box), infinity)) << far;
  }
}

TEST(Bvh, RayVisitsEveryThingWhoseBoxItMeets) {
  Random random(104);
  std::vector<Aabb> boxes;
  for (int i = 0; i < 500; ++i) boxes.push_back(random_box(random, 10, 2));
  const Bvh bvh = built(boxes);
  Effort effort;
  for (int i = 0; i < 500; ++i) {
    const Ray<float> ray{lift<float>(random.point(12)), normalize(lift<float>(random.direction()))};
    const float t_max = static_cast<float>(random.in(0, 30));
    std::vector<int> visits(boxes.size());
    traverse<float>(bvh, {ray.origin, ray.direction, 0}, true, t_max, effort,
                    [&](std::uint32_t first, std::uint32_t count, bool) {
                      for (std::uint32_t k = first; k < first + count; ++k) ++visits[bvh.order[k]];
                    });
    std::vector<int> lone_visits(boxes.size());
    traverse(bvh, 0, LoneRay({ray.origin, ray.direction, 0}), t_max, effort,
             [&](std::uint32_t first, std::uint32_t count, bool) {
               for (std::uint32_t k = first; k < first + count; ++k) ++lone_visits[bvh.order[k]];
             });
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      EXPECT_LE(visits[k], 1);
      EXPECT_LE(lone_visits[k], 1);
      EXPECT_GE(std::min(visits[k], lone_visits[k]), meets(boxes[k], ray, double(t_max)));
    }
  }
  EXPECT_LT(effort.tests(), 500 * 200) << "of 500 boxes and more";
}

}  // namespace
}  // namespace tia
