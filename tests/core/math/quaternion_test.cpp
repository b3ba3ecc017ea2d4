#include "core/math/quaternion.h"

#include <gtest/gtest.h>

#include "core/math/deterministic.h"
#include "tests/core/support.h"

namespace tia {
namespace {

// A turn about an axis of length 1, by the definition.
Quaternion turn(const Vec3d& axis, double angle) {
  const double s = sin_of(angle / 2);
  return {axis.x * s, axis.y * s, axis.z * s, cos_of(angle / 2)};
}
Quaternion negative(const Quaternion& q) { return {-q[0], -q[1], -q[2], -q[3]}; }
double distance(const Quaternion& a, const Quaternion& b) {
  double most = 0;
  for (std::size_t i = 0; i < 4; ++i) most = std::max(most, std::fabs(a[i] - b[i]));
  return most;
}

// Rodrigues (1840): p cos + (k x p) sin + k (k.p)(1 - cos).
TEST(Quaternion, TurnsAboutItsAxisByItsAngle) {
  test::Random random(1);
  for (int i = 0; i < 100; ++i) {
    const Vec3d k = random.direction(), p = random.point(3);
    const double angle = random.in(-6, 6), c = cos_of(angle), s = sin_of(angle);
    Quaternion q = turn(k, angle);
    for (double& each : q) each *= 7;  // its length means nothing
    const Vec3d expected = p * c + cross(k, p) * s + k * (dot(k, p) * (1 - c));
    EXPECT_LT(length(rotation_of(q).point(p) - expected), 1e-14);
  }
}

// Between two turns about one axis lies the turn by the angle between them, in proportion; of the
// two ways the short one, whichever of q and -q is written.
TEST(Quaternion, SlerpTurnsAtConstantSpeedTheShortWay) {
  test::Random random(2);
  for (int i = 0; i < 100; ++i) {
    const Vec3d axis = random.direction();
    const double from = random.in(-1, 1), by = random.in(-3, 3), share = random.unit();
    const Quaternion a = turn(axis, from), b = turn(axis, from + by);
    const Quaternion between = turn(axis, from + by * share);
    EXPECT_LT(distance(slerp(a, b, share), between), 1e-12);
    EXPECT_LT(distance(slerp(a, negative(b), share), between), 1e-12);
    EXPECT_LT(distance(slerp(a, b, 0), a), 1e-15);
    EXPECT_LT(distance(slerp(a, b, 1), b), 1e-15);
  }
}

TEST(Quaternion, OfNoLengthTurnsNothing) {
  EXPECT_EQ(normalized({0, 0, 0, 0}), (Quaternion{0, 0, 0, 1}));
  EXPECT_EQ(normalized({0, 3, 0, 4}), (Quaternion{0, 0.6, 0, 0.8}));
}

}  // namespace
}  // namespace tia
