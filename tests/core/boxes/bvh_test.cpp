// Rays and boxes: what a test of boxes must never miss.
#include "core/boxes/bvh.h"

#include <gtest/gtest.h>

#include "core/boxes/lone_ray.h"
#include "tests/core/boxes/boxes.h"

namespace tia {
namespace {

using test::built;
using test::Random;
using test::random_box;
using test::ray_meets;

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
    const bool expected = ray_meets(box, ray, t_max);
    EXPECT_TRUE(enters || !expected);
    met += expected;
    entered += enters;
  }
  EXPECT_GT(met, all / 50);
  EXPECT_LT(entered - met, all / 50) << "and hardly ever finds one that it does not meet";
}

// All rays of a packet together: the interval never misses what one of them meets, and one ray
// alone is told apart as finely as by its own test.
TEST(RayInterval, NeverMissesABoxThatOneOfItsRaysMeets) {
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
    const RayInterval interval(BoxRay<Wide>(vector(0), vector(3), Wide(0)), active);
    const float t_max = static_cast<float>(random.in(0, 12));

    BoxSet boxes;
    std::vector<Aabb> exact;
    const int count = 1 + random.below(8);
    for (int i = 0; i < count; ++i) {
      exact.push_back(random_box(random, 3, 3));
      boxes.add(rounded_outwards(exact.back()));
    }
    BoxSet::Floats near, alone_near;
    const unsigned entered = interval.enters(boxes, t_max, near);
    EXPECT_EQ(entered >> count, 0U);
    for (std::size_t lane = 0; lane < static_cast<std::size_t>(first_out); ++lane) {
      const BoxRay<float> one(rays[lane].origin, rays[lane].direction, 0);
      const unsigned alone = RayInterval(one, true).enters(boxes, t_max, alone_near);
      BoxSet::Floats lone_near;
      const unsigned lone =
          LoneRay<true>(one, 0).enters(boxes, LoneRay<true>::limit(t_max), lone_near);
      EXPECT_EQ(lone >> count, 0U);
      EXPECT_EQ(alone & ~entered, 0U);
      for (std::size_t i = 0; i < boxes.count; ++i) {
        const bool meets_it = ray_meets(exact[i], rays[lane], double(t_max));
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
  EXPECT_GT(met, 600 * Wide::size);
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
    BoxSet boxes;
    boxes.add(rounded_outwards(box));
    BoxSet::Floats near;
    EXPECT_EQ(LoneRay<false>(ray, 0).enters(boxes, infinity, near), 1U) << far;
  }
}

TEST(Bvh, RayVisitsEveryThingWhoseBoxItMeets) {
  Random random(104);
  std::vector<Aabb> boxes;
  for (int i = 0; i < 500; ++i) boxes.push_back(random_box(random, 10, 2));
  const Bvh bvh = built(boxes);
  WorkCounter work;
  for (int i = 0; i < 500; ++i) {
    const Ray<float> ray{lift<float>(random.point(12)), normalize(lift<float>(random.direction()))};
    const float t_max = static_cast<float>(random.in(0, 30));
    std::vector<int> visits(boxes.size());
    traverse<float>(bvh, {ray.origin, ray.direction, 0}, true, t_max, work,
                    [&](std::uint32_t first, std::uint32_t count, bool) {
                      for (std::uint32_t k = first; k < first + count; ++k) ++visits[bvh.order[k]];
                    });
    for (std::size_t k = 0; k < boxes.size(); ++k) {
      EXPECT_LE(visits[k], 1);
      EXPECT_GE(visits[k], ray_meets(boxes[k], ray, double(t_max)));
    }
  }
  EXPECT_LT(work.tests(), 500 * 200) << "of 500 boxes and more";
}

}  // namespace
}  // namespace tia
