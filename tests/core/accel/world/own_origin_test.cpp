// Where a world puts its origin.
#include "core/accel/world/own_origin.h"

#include <gtest/gtest.h>

#include "tests/core/accel/worlds.h"

namespace tia {
namespace {

using namespace test;

Vec3d origin_of(const std::vector<Object>& objects) { return world_of(objects).origin; }

Object ball_at(const Vec3d& center, double radius) { return object_of(Sphere{center, radius}); }

// Their pictures keep the bytes that they have had.
TEST(OwnOrigin, IsTheScenesOwnWhereThingsAreNear) {
  Random random(3900);
  for (int i = 0; i < 200; ++i)
    EXPECT_EQ(compile(mixed_scene(random, 20, std::pow(10, random.in(-3, 6)))).origin, Vec3d{});
  EXPECT_EQ(compile(thesis_scene('a')).origin, Vec3d{});
  EXPECT_EQ(compile(Scene{}).origin, Vec3d{});
}

TEST(OwnOrigin, IsAmidWhatIsFarHoweverLargeItsFloor) {
  Random random(3901);
  for (int i = 0; i < 200; ++i) {
    const Vec3d middle = random.direction() * std::pow(10, random.in(3.5, 7));
    std::vector<Object> objects{ball_at(middle - Vec3d{0, 10010, 0}, 10000)};
    for (int k = 0; k < 10; ++k) objects.push_back(ball_at(middle + random.point(9), 1));
    EXPECT_LT(length(origin_of(objects) - middle), 20);
  }
}

// What is taken off all numbers may cost them no digits.
TEST(OwnOrigin, IsARoundNumber) {
  Random random(3902);
  for (int i = 0; i < 200; ++i) {
    const Vec3d middle = random.direction() * 1e6;
    const Vec3d origin = origin_of({ball_at(middle, 1), ball_at(middle + Vec3d{4, 0, 0}, 1)});
    EXPECT_NE(origin, Vec3d{});
    for (const double x : {origin.x, origin.y, origin.z}) EXPECT_EQ(x, std::round(x));
  }
}

TEST(OwnOrigin, OfEndlessThingsIsAmidTheirPoints) {
  const auto plane = [](const Vec3d& p, const Vec3d& n) { return object_of(Plane{p, n}); };
  EXPECT_EQ(origin_of({plane({1e6, 0.3, 7}, {0, 1, 0})}), (Vec3d{1e6, 0.3, 7}));
  const Vec3d corner{1e6, -3e5, 2e4};
  EXPECT_LT(length(origin_of({plane(corner + Vec3d{3, 0, 0}, {1, 0, 0}),
                              plane(corner - Vec3d{3, 0, 0}, {-1, 0, 0}),
                              plane(corner + Vec3d{0, 2, 0}, {0, 1, 0})}) -
                   corner),
            6);
  // Beside what has bounds they have no say.
  EXPECT_EQ(origin_of({plane({1e6, 0, 0}, {0, 1, 0}), ball_at({1, 2, 3}, 1)}), Vec3d{});
}

TEST(OwnOrigin, ScalesByPowersOfTwo) {
  Random random(3903);
  for (int i = 0; i < 100; ++i) {
    Random once = random, again = random;
    const auto scene = [](Random& from, double scale) {
      Scene all = mixed_scene(from, 10, scale);
      for (Object& each : all.objects.edit())
        each.transform.steps.push_back(Translate{Vec3d{3e5, -1e6, 7e4} * scale});
      return all;
    };
    const Vec3d small = compile(scene(once, 1)).origin;
    EXPECT_NE(small, Vec3d{});
    EXPECT_EQ(compile(scene(again, 1024)).origin, small * 1024.0);
    random = once;
  }
}

}  // namespace
}  // namespace tia
