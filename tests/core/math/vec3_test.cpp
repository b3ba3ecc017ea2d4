#include "core/math/vec3.h"

#include <gtest/gtest.h>

#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;

TEST(Vec3, DotSumsInTheOrderXYZ) {
  // (2^24 + 1) + 1 = 2^24 in float, 2^24 + (1 + 1) = 2^24 + 2: the order shows.
  const Vec3f big_first{0x1p24F, 1, 1}, big_last{1, 1, 0x1p24F}, ones{1, 1, 1};
  EXPECT_EQ(dot(big_first, ones), 0x1p24F);
  EXPECT_EQ(dot(big_last, ones), 0x1p24F + 2);
}

TEST(Vec3, ComponentsAreTreatedOneByOne) {
  const Vec3d a{1, -2, 3}, b{5, 7, -11};
  EXPECT_EQ(a + b, (Vec3d{6, 5, -8}));
  EXPECT_EQ(a - b, (Vec3d{-4, -9, 14}));
  EXPECT_EQ(-a, (Vec3d{-1, 2, -3}));
  EXPECT_EQ(a * b, (Vec3d{5, -14, -33}));
  EXPECT_EQ(a * 2.0, (Vec3d{2, -4, 6}));
  EXPECT_EQ(2.0 * a, a * 2.0);
  EXPECT_EQ(static_cast<Vec3f>(a), (Vec3f{1, -2, 3}));
}

TEST(Vec3, CrossIsRightHanded) {
  const Vec3d x{1, 0, 0}, y{0, 1, 0}, z{0, 0, 1};
  EXPECT_EQ(cross(x, y), z);
  EXPECT_EQ(cross(y, z), x);
  EXPECT_EQ(cross(z, x), y);
}

TEST(Vec3, CrossIsPerpendicularWithTheLengthOfLagrangesIdentity) {
  Random random(1);
  for (int i = 0; i < 1000; ++i) {
    const Vec3d a = random.point(10), b = random.point(10), c = cross(a, b);
    EXPECT_NEAR(dot(a, c), 0, 1e-11);
    EXPECT_NEAR(dot(b, c), 0, 1e-11);
    EXPECT_NEAR(dot(c, c), dot(a, a) * dot(b, b) - dot(a, b) * dot(a, b), 1e-9);
  }
}

TEST(Vec3, NormalizeGivesUnitLengthAlongTheVector) {
  Random random(2);
  for (int i = 0; i < 1000; ++i) {
    const double size = std::exp(random.in(-20, 20));
    const Vec3d v = random.vector(size, size);
    const Vec3d n = normalize(v);
    // Eight roundings of half a unit at most: the dot's, the root's, the quotient's, the product's.
    EXPECT_NEAR(dot(n, n), 1, 8 * 0x1p-53);
    EXPECT_NEAR(dot(n, v) / length(v), 1, 8 * 0x1p-53);
    const Vec3f f = normalize(static_cast<Vec3f>(v));
    EXPECT_NEAR(dot(widen(f), widen(f)), 1, 8 * 0x1p-24);
  }
}

}  // namespace
}  // namespace tia
