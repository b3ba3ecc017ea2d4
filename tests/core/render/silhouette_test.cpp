// Outlines and shadow edges against closed forms, counted or found independently per pixel.
#include <gtest/gtest.h>

#include "tests/core/random_scene.h"
#include "tests/core/reference.h"

namespace tia {
namespace {

using test::ball;
using test::black_ball;
using test::Long;
using test::picture;

const Long half_height_of_view =
    std::tan(12.5L * std::acos(-1.0L) / 180);  // of the default field of view

bool is_black(const Image& image, int x, int y) { return image.at(x, y)[0] == 0; }

TEST(Silhouette, PixelCountOnTheAxisIsTheClosedForm) {
  // A pixel's ray (xx, yy, -1) meets the ball at depth d where xx^2 + yy^2 <= r^2 / (d^2 - r^2).
  const std::pair<int, int> sizes[] = {{640, 480}, {333, 217}, {64, 480}, {101, 101}};
  const std::pair<double, double> balls[] = {{4, 20}, {1, 20}, {0.01, 1}, {100, 1000}, {3, 3.5}};
  for (const auto& [width, height] : sizes) {
    for (const auto& [r, d] : balls) {
      const Long limit =
          static_cast<Long>(r) * r / (static_cast<Long>(d) * d - static_cast<Long>(r) * r);
      int inside = 0, close = 0, black = 0;
      const Image image = picture(black_ball({0, 0, -d}, r), width, height).image;
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          const Long xx = static_cast<Long>(2 * x + 1 - width) / height * half_height_of_view;
          const Long yy = static_cast<Long>(height - 2 * y - 1) / height * half_height_of_view;
          const Long square = xx * xx + yy * yy;
          inside += square <= limit;
          close += std::fabs(square / limit - 1) < 1e-6L;
          black += is_black(image, x, y);
        }
      }
      ASSERT_EQ(close, 0) << "a pixel too close to call: choose another size";
      EXPECT_EQ(black, inside) << "r " << r << ", d " << d << ", " << width << " x " << height;
    }
  }
}

TEST(Silhouette, OffTheAxisEveryPixelFollowsTheQuadratic) {
  constexpr int width = 160, height = 120;
  test::Random random(50);
  int blacks = 0, close = 0;
  for (int i = 0; i < 100; ++i) {
    const Sphere sphere{random.point(4) + Vec3d{0, 0, -15}, random.in(0.1, 4)};
    const Image image = picture(black_ball(sphere.center, sphere.radius), width, height).image;
    const auto c = static_cast<Vec3<Long>>(sphere.center);
    const Long k = dot(c, c) - static_cast<Long>(sphere.radius) * sphere.radius;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const Vec3<Long> d{static_cast<Long>(2 * x + 1 - width) / height * half_height_of_view,
                           static_cast<Long>(height - 2 * y - 1) / height * half_height_of_view,
                           -1};
        // |t d - c|^2 = r^2 has a root: (c.d)^2 >= |d|^2 (|c|^2 - r^2), before the eye.
        const Long along = dot(c, d), left = along * along / (dot(d, d) * k);
        if (std::fabs(left - 1) < 1e-6L) {
          ++close;
          continue;
        }
        const bool hit = along > 0 && left > 1;
        ASSERT_EQ(is_black(image, x, y), hit) << i << ": " << x << ", " << y;
        blacks += hit;
      }
    }
  }
  EXPECT_GT(blacks, 50'000);
  EXPECT_LT(close, 50);
}

// Where the eye's ray through a point of the thesis' raster meets the floor, in long double.
struct FloorPoint {
  bool met = false;
  Vec3<Long> p{};
};
FloorPoint floor_point(Long x, Long y, int width, int height) {
  const Vec3<Long> floor{0, -10004, -20}, ball{0, 0, -20};
  Vec3<Long> d{
      (2 * x + 1 - static_cast<Long>(width)) / static_cast<Long>(height) * half_height_of_view,
      (static_cast<Long>(height) - 2 * y - 1) / static_cast<Long>(height) * half_height_of_view,
      -1};
  d = d * (1 / std::sqrt(dot(d, d)));
  const Long to_ball = dot(ball, d), b = dot(floor, d);
  const bool ball_before = to_ball * to_ball > dot(ball, ball) - 16;
  const Long discriminant = b * b - dot(floor, floor) + 1e8L;
  if (ball_before || b < 0 || discriminant < 0) return {};
  return {true, d * (b - std::sqrt(discriminant))};
}

TEST(Silhouette, ShadowEdgeOnTheFloorIsTheConesEdge) {
  // Lit and dark floor part where the line to the light passes the ball's centre at its radius.
  const Vec3<Long> light{-20, 20, -10}, center{0, 0, -20};
  const auto in_shadow = [&](const Vec3<Long>& p) {
    const auto beside = cross(center - p, light - p);
    return dot(beside, beside) < 16 * dot(light - p, light - p);
  };
  constexpr int width = 640, height = 480;
  const Image image = picture(test::thesis_scene('a'), width, height).image;
  int dark = 0, lit = 0, close = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      bool sure = true;
      const FloorPoint here = floor_point(x, y, width, height);
      for (const auto& [dx, dy] :
           {std::pair{-0.02L, 0.0L}, {0.02L, 0.0L}, {0.0L, -0.02L}, {0.0L, 0.02L}}) {
        const FloorPoint near = floor_point(x + dx, y + dy, width, height);
        sure = sure && near.met == here.met && in_shadow(near.p) == in_shadow(here.p);
      }
      if (!here.met) continue;
      close += !sure;
      if (!sure) continue;
      ASSERT_EQ(is_black(image, x, y), in_shadow(here.p)) << x << ", " << y;
      ++(in_shadow(here.p) ? dark : lit);
    }
  }
  EXPECT_GT(dark, 2000);
  EXPECT_GT(lit, 20'000);
  EXPECT_LT(close, 100);
}

TEST(Silhouette, UnlitFirstPictureIsBlackOnBothBallsAndBackgroundElsewhere) {
  const Scene scene = test::thesis_scene();
  constexpr int width = 640, height = 480;
  const test::Reference reference(scene, width, height);
  const Image image = picture(scene, width, height).image;
  int count[] = {0, 0, 0};
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      if (reference.on_edge(x, y)) continue;
      const int met = reference.trace(x, y).story.ball;
      const float expected = met < 0 ? 0.8F : 0.0F;
      for (int c = 0; c < 3; ++c) ASSERT_EQ(image.at(x, y)[c], expected) << x << ", " << y;
      ++count[met + 1];
    }
  }
  for (const int pixels : count) EXPECT_GT(pixels, 20'000);
}

}  // namespace
}  // namespace tia
