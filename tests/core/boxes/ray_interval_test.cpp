// When the rays of a packet are better traced one by one.
#include "core/boxes/ray_interval.h"

#include <gtest/gtest.h>

#include "core/math/vec3.h"

namespace tia {
namespace {

// Rays whose directions differ by up to so much along x and y.
BoxRay<Wide> rays(double width, const Vec3d& middle) {
  Vec3<Wide> direction;
  for (int i = 0; i < lanes<Wide>; ++i) {
    const double share = static_cast<double>(i) / (lanes<Wide> - 1) - 0.5;
    set_lane(direction.x, i, static_cast<float>(middle.x + width * share));
    set_lane(direction.y, i, static_cast<float>(middle.y - width * share));
    set_lane(direction.z, i, static_cast<float>(middle.z));
  }
  const Vec3<Wide> origin{Wide(0), Wide(0), Wide(0)};
  return {origin, direction, Wide(0)};
}
const WideMask all = Wide(0) <= Wide(0);

TEST(RayInterval, RaysPartAmongManyTriangles) {
  // The squares of the widths are 2 * 0.2^2 = 0.08: 16 000 triangles in it are 200 000 in all.
  const BoxRay<Wide> wide = rays(0.2, {0.6, 0.6, 0.5});
  EXPECT_FALSE(scattered(wide, all));
  EXPECT_FALSE(RayInterval(wide, all).parts_among(199'000));
  EXPECT_TRUE(RayInterval(wide, all).parts_among(201'000));
  // An axis of both signs does not count.
  const BoxRay<Wide> across = rays(0.2, {0.05, 0.6, 0.5});
  EXPECT_FALSE(RayInterval(across, all).parts_among(399'000));
  EXPECT_TRUE(RayInterval(across, all).parts_among(401'000));
  EXPECT_FALSE(RayInterval(rays(0.002, {-0.6, 0.6, 0.5}), all).parts_among(1'000'000));
}

TEST(RayInterval, RaysOfBothSignsAlongTwoAxesPartAnywhere) {
  EXPECT_TRUE(scattered(rays(0.2, {0.05, 0.05, 1}), all));
  EXPECT_FALSE(scattered(rays(0.2, {0.05, 0.5, 1}), all));
  // The first half of them alone goes one way.
  EXPECT_FALSE(scattered(rays(0.2, {0, 0, 1}), iota<Wide>() < Wide(lanes<Wide> / 2)));
}

}  // namespace
}  // namespace tia
