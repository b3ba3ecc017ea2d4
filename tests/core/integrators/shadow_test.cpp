// What casts a shadow, and what never does.
#include <gtest/gtest.h>

#include "tests/core/random_scene.h"

namespace tia {
namespace {

using test::ball;
using test::light_along;
using test::matte;
using test::point_light;
using test::Random;
using test::sphere_light;

// A lit ball whose point p = (0,0,0), normal +z, is seen from the side; the light straight above at
// a height of 10; blockers are put in between or beyond.
struct Stage {
  Scene scene;
  explicit Stage(const Light& light) {
    scene.background = {9, 9, 9};
    scene.objects.push_back(ball({0, 0, -2}, 2));
    scene.lights = {light};
  }
  Stage& with(const Object& object) {
    scene.objects.push_back(object);
    return *this;
  }
  Vec3f light() const { return light_along(scene, {0, 3, 3}, {0, -1, -1}); }
};
const Vec3f fully_lit{1, 1, 1}, unlit{0, 0, 0};
const Light overhead_light = point_light({0, 0, 10});

TEST(Shadow, OpenPointIsFullyLit) { EXPECT_EQ(Stage(overhead_light).light(), fully_lit); }

TEST(Shadow, BallBetweenPointAndLightLeavesExactlyNothing) {
  for (const double height : {0.5, 1.0, 5.0, 9.0, 9.94})
    EXPECT_EQ(Stage(overhead_light).with(ball({0, 0, height}, 0.05)).light(), unlit) << height;
}

TEST(Shadow, BallBeyondTheLightCastsNone) {
  for (const double height : {10.06, 11.0, 100.0})
    EXPECT_EQ(Stage(overhead_light).with(ball({0, 0, height}, 0.05)).light(), fully_lit) << height;
}

TEST(Shadow, BallBelowOrBesideCastsNone) {
  EXPECT_EQ(Stage(overhead_light).with(ball({0, 0, -30}, 5)).light(), fully_lit);
  EXPECT_EQ(Stage(overhead_light).with(ball({1.01, 0, 5}, 1)).light(), fully_lit);
  EXPECT_EQ(Stage(overhead_light).with(ball({0.99, 0, 5}, 1)).light(), unlit);
}

TEST(Shadow, WhiteBlockerBlocksAsABlackOneDoes) {
  EXPECT_EQ(Stage(overhead_light).with(ball({0, 0, 5}, 1, matte({1, 1, 1}))).light(), unlit);
  EXPECT_EQ(Stage(overhead_light).with(ball({0, 0, 5}, 1, matte({0, 0, 0}))).light(), unlit);
}

TEST(Shadow, LightInsideABallIsHiddenByIt) {
  EXPECT_EQ(Stage(overhead_light).with(ball({0, 0, 10}, 1)).light(), unlit);
}

TEST(Shadow, LightsOwnSphereNeverShadowsItself) {
  for (const double radius : {0.1, 3.0, 9.9})
    EXPECT_EQ(Stage(sphere_light({0, 0, 10}, radius)).light(), fully_lit) << radius;
}

TEST(Shadow, LuminousObjectNeverShadowsItsOwnLight) {
  Stage stage(overhead_light);
  stage.scene.lights.clear();
  EXPECT_EQ(stage.with(ball({0, 0, 10}, 3, matte({0, 0, 0}, {1, 1, 1}))).light(), fully_lit);
}

TEST(Shadow, LuminousSphereBlocksOtherLights) {
  Stage stage(sphere_light({0, 0, 10}, 1, {0.25, 0.25, 0.25}));
  stage.scene.lights.push_back(sphere_light({0, 0, 20}, 1, {1, 1, 1}));
  EXPECT_EQ(stage.light(), (Vec3f{0.25F, 0.25F, 0.25F})) << "the farther light is hidden";
}

TEST(Shadow, KeyLightsSphereBlocksAndNeverItself) {
  Stage stage(point_light({0, 0, 20}, {0.5, 0.5, 0.5}));
  stage.scene.key_light = sphere_light({0, 0, 10}, 1, {0.25, 0.25, 0.25});
  EXPECT_EQ(stage.light(), (Vec3f{0.25F, 0.25F, 0.25F}));
}

TEST(Shadow, TwoBlockersOfOneLightCountAsOne) {
  EXPECT_EQ(Stage(overhead_light).with(ball({0, 0, 3}, 1)).with(ball({0, 0, 6}, 1)).light(), unlit);
}

TEST(Shadow, OneLightsShadowLeavesTheOthersLight) {
  Stage stage(overhead_light);
  stage.scene.lights.push_back(point_light({0, -6, 8}));  // n.l = 4/5, clear of the blocker
  stage.with(ball({0, 0, 5}, 0.5));
  EXPECT_NEAR(stage.light().x, 0.8, 3e-7);
}

// No acne: a convex ball alone never shades its own lit side, at any scale.
TEST(Shadow, BallAloneNeverShadesItself) {
  for (const double scale : {1e-3, 1e-2, 1.0, 1e2, 1e3}) {
    Random random(80);
    Scene scene;
    scene.objects.push_back(ball(Vec3d{0.3, -0.2, -20} * scale, 4 * scale));
    for (int i = 0; i < 5; ++i) {
      const Vec3d place = random.direction() * 30.0 + Vec3d{0, 0, -20};
      scene.lights = {point_light(place * scale)};
      const Image image = test::picture(scene, 200, 150).image;
      const View view = view_of(scene.camera, 200, 150);
      const auto& sphere = std::get<Sphere>(scene.objects[0].shape);
      for (int y = 0; y < 150; ++y) {
        for (int x = 0; x < 200; ++x) {
          const Ray<double> ray = view.ray<double>(x, y);
          const double t = intersect(sphere, RootRay<double>(ray));
          if (!(t < infinity)) continue;
          const Vec3d p = ray.at(t), n = normalize(p - sphere.center);
          const double cosine = dot(n, normalize(place * scale - p));
          // The outline's own pixels aside, where float and double may differ on the hit.
          if (dot(n, ray.direction) > -1e-2) continue;
          ASSERT_NEAR(image.at(x, y)[0], std::max(0.0, cosine), 2e-5) << scale;
        }
      }
    }
  }
}

// No leaks: the far side of a thin gap between two balls stays dark.
TEST(Shadow, LightDoesNotLeakThroughATouchingBall) {
  for (const double scale : {1e-3, 1.0, 1e3}) {
    Scene scene;
    scene.background = {9, 9, 9};
    scene.objects.push_back(ball(Vec3d{0, 0, -2} * scale, 2 * scale));
    scene.objects.push_back(ball(Vec3d{0, 0, 3.001} * scale, 3 * scale));  // 1e-3 above the point
    scene.lights = {point_light(Vec3d{0, 0, 10} * scale)};
    // Seen through the gap, from 1 aside along the first ball's surface.
    const Vec3d eye{0, 1, 0.1};
    const Vec3d p{0, 0.02, -2 + std::sqrt(4 - 0.02 * 0.02)};
    EXPECT_EQ(light_along(scene, eye * scale, p - eye), (Vec3f{0, 0, 0})) << scale;
  }
}

}  // namespace
}  // namespace tia
