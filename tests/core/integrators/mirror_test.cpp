// Mirrors by closed forms.
#include <gtest/gtest.h>

#include "tests/core/tree.h"

namespace tia {
namespace {

using namespace test;

TEST(Mirror, FacingMirrorsAreATruncatedGeometricSeries) {
  // Between two planes that glow and mirror: e (1 + r + r^2 + ... + r^depth).
  Random random(400);
  for (int i = 0; i < 50; ++i) {
    const double r = random.in(0.05, 1), e = random.in(0.1, 2);
    const double a = random.in(-3, -0.5), b = random.in(0.5, 3);
    Scene scene;
    scene.background = {7, 7, 7};
    scene.objects = {object(Plane{{0, 0, a}, {0, 0, 1}}, mirror(r, {e, 2 * e, 0})),
                     object(Plane{{0, 0, b}, {0, 0, -1}}, mirror(r, {e, 2 * e, 0}))};
    for (const int depth : {0, 1, 2, 5}) {
      double series = 0;
      for (int k = 0; k <= depth; ++k) series += std::pow(r, k);
      const auto node = tree(scene, {0, 0, 0}, {0, 0, 1}, at_depth(depth));
      expect_near(node->color, {e * series, 2 * e * series, 0}, 2e-6 * e * series * 2);
    }
  }
}

TEST(Mirror, DirectionFollowsTheLawOfReflection) {
  Random random(401);
  for (int i = 0; i < 500; ++i) {
    const Vec3d n = random.direction();
    const Vec3d d = random.direction();
    if (std::fabs(dot(n, d)) < 0.05) continue;
    Scene scene;
    scene.objects = {object(Plane{{0, 0, 0}, n}, mirror(1))};
    const auto node = tree(scene, d * -3.0, d);
    const RayNode* seen = child(*node, TermName::reflection);
    ASSERT_NE(seen, nullptr);
    expect_near(seen->ray.direction, d - n * (2 * dot(d, n)), 5e-7);
  }
}

TEST(Mirror, CornerOfThreeSendsTheRayBack) {
  Random random(402);
  Scene scene;
  scene.background = {0.25, 0.5, 0.75};
  scene.objects = {object(Plane{{0, 0, 0}, {1, 0, 0}}, mirror(1)),
                   object(Plane{{0, 0, 0}, {0, 1, 0}}, mirror(1)),
                   object(Plane{{0, 0, 0}, {0, 0, 1}}, mirror(1))};
  for (int i = 0; i < 200; ++i) {
    const double x = random.in(0.2, 1), y = random.in(0.2, 1);
    const Vec3d d = normalize(Vec3d{-x, -y, -random.in(0.2, 1)});
    const double ox = random.in(1, 4), oy = random.in(1, 4);
    const auto node = tree(scene, {ox, oy, random.in(1, 4)}, d);
    const RayNode* at = node.get();
    int mirrors = 0;
    while (const RayNode* next = child(*at, TermName::reflection)) {
      at = next;
      ++mirrors;
    }
    EXPECT_EQ(mirrors, 3);
    expect_near(at->ray.direction, -d, 1e-6);
    expect_near(node->color, {0.25, 0.5, 0.75}, 1e-6);
  }
}

// Two mirrors that meet at an angle of 180/k degrees show 2k - 1 images of what is between them:
// as many directions from the eye, besides the straight one, end at the thing.
TEST(Mirror, TwoAtAnAngleShowThreeFiveOrSevenImages) {
  for (const int k : {2, 3, 4}) {
    const double angle = pi / k;
    Scene scene;
    scene.background = {0, 0, 0};
    const Vec3d thing{2 * std::cos(0.4 * angle), 0, 2 * std::sin(0.4 * angle)};
    scene.objects = {object(Plane{{0, 0, 0}, {0, 0, 1}}, mirror(1)),
                     object(Plane{{0, 0, 0}, {std::sin(angle), 0, -std::cos(angle)}}, mirror(1)),
                     object(Sphere{thing, 0.02}, [] {
                       Finish glow = dark();
                       glow.emission = {1, 1, 1};
                       return glow;
                     }())};
    const Vec3d eye{3 * std::cos(0.7 * angle), 0, 3 * std::sin(0.7 * angle)};
    int images = 0;
    bool inside = false;
    constexpr int steps = 4000;  // an image is five of them wide, and more
    for (int i = 0; i < steps; ++i) {
      const double turn = 2 * pi * i / steps;
      const auto node = tree(scene, eye, {std::cos(turn), 0, std::sin(turn)}, at_depth(10));
      const bool seen = node->color.x > 0.5F;
      images += seen && !inside;
      inside = seen;
    }
    EXPECT_EQ(images, 2 * k) << "the thing itself and its images, at " << 180 / k << " degrees";
  }
}

TEST(Mirror, WeightScalesWhatItShows) {
  Scene scene;
  scene.background = {0.5, 1, 2};
  scene.objects = {object(Plane{{0, 0, -1}, {0, 0, 1}}, mirror(0.25, {0.1, 0.1, 0.1}))};
  const auto node = tree(scene, {0, 0, 0}, {0.3, 0.1, -1});
  expect_near(node->color, {0.225, 0.35, 0.6}, 1e-6);
}

TEST(Mirror, RaysAreCountedByKindExactly) {
  // A floor that mirrors under an open sky: one reflection for each pixel that sees it.
  Scene scene;
  scene.camera.fov_degrees = 60;
  scene.objects = {object(Plane{{0, -1, 0}, {0, 1, 0}}, mirror(0.5))};
  const Picture whole = picture(scene, 64, 48, {0, 0, 64, 48}, at_depth(5));
  EXPECT_EQ(whole.rays, (RayCounts{.primary = 64 * 48, .reflection = 64 * 24}));
  EXPECT_EQ(picture(scene, 64, 48, {0, 0, 64, 48}, at_depth(0)).rays,
            (RayCounts{.primary = 64 * 48}));
}

}  // namespace
}  // namespace tia
