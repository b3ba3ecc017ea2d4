// When the rays of a packet are better traced one by one.
#include "core/boxes/ray_interval.h"

#include <gtest/gtest.h>

#include "core/math/vec3.h"

namespace tia {
namespace {

// Rays whose directions differ by up to so much along x and y.
RayInterval interval_of(double width, const Vec3d& middle) {
  Vec3<Wide> direction;
  for (int i = 0; i < lanes<Wide>; ++i) {
    const double share = static_cast<double>(i) / (lanes<Wide> - 1) - 0.5;
    set_lane(direction.x, i, static_cast<float>(middle.x + width * share));
    set_lane(direction.y, i, static_cast<float>(middle.y - width * share));
    set_lane(direction.z, i, static_cast<float>(middle.z));
  }
  const Vec3<Wide> origin{Wide(0), Wide(0), Wide(0)};
  return {BoxRay<Wide>(origin, direction, Wide(0)), Wide(0) <= Wide(0)};
}

TEST(RayInterval, RaysPartWhereTheirAngleHoldsManyTriangles) {
  // The angle is 2 * 0.2^2 = 0.08: 16 000 triangles in it are 200 000 in all.
  const RayInterval wide = interval_of(0.2, {0.6, 0.6, 0.5});
  EXPECT_FALSE(wide.scattered());
  EXPECT_FALSE(wide.scattered_among(199'000));
  EXPECT_TRUE(wide.scattered_among(201'000));
  const RayInterval narrow = interval_of(0.002, {-0.6, 0.6, 0.5});
  EXPECT_FALSE(narrow.scattered_among(1'000'000));
}

TEST(RayInterval, RaysOfBothSignsAlongTwoAxesPartAnywhere) {
  const RayInterval interval = interval_of(0.2, {0.05, 0.05, 1});
  EXPECT_TRUE(interval.scattered());
  EXPECT_TRUE(interval.scattered_among(1));
}

}  // namespace
}  // namespace tia
