// The cone of a block's rays, by which objects are left out of it.
#include <gtest/gtest.h>

#include "core/accel/world/world.h"
#include "tests/core/random_scene.h"

namespace tia {
namespace {

using test::Random;

// A ray through any point of a pixel.
Ray<double> anywhere_in(const View& view, int x, int y, Random& random) {
  const double dx = random.in(-0.5, 0.5), dy = random.in(-0.5, 0.5);
  return Eye<double>(view).ray(view.column<double>(x) + view.row<double>(y), {dx, dy, 0, 0});
}

TEST(Beam, NeverLeavesOutABallThatOneOfItsRaysMeets) {
  Random random(40);
  int met = 0;
  for (int i = 0; i < 3000; ++i) {
    const int width = 1 + random.below(700), height = 1 + random.below(500);
    const View view = view_of(test::random_camera(random), width, height);
    const int x0 = random.below(width), y0 = random.below(height);
    const int x1 = x0 + 1 + random.below(std::min(32, width - x0));
    const int y1 = y0 + 1 + random.below(std::min(32, height - y0));
    const Beam beam(view, x0, y0, x1, y1);
    const Sphere ball{random.point(8) + Vec3d{0, 0, -15}, random.in(0.01, 4)};
    if (beam.may_meet(ball.center, ball.radius)) continue;
    for (int y = y0; y < y1; ++y)
      for (int x = x0; x < x1; ++x)
        met += intersect(ball, RootRay<double>(anywhere_in(view, x, y, random))) < 1e30;
  }
  EXPECT_EQ(met, 0);
}

TEST(Beam, MeetsABallOfOnePixelsRayHoweverSmall) {
  Random random(41);
  for (int i = 0; i < 3000; ++i) {
    const View view = view_of(test::random_camera(random), 640, 480);
    const int x = random.below(640), y = random.below(480);
    const Vec3d center = anywhere_in(view, x, y, random).at(random.in(0.1, 1000));
    const int x0 = x / 32 * 32, y0 = y / 32 * 32;
    EXPECT_TRUE(Beam(view, x0, y0, x0 + 32, y0 + 32).may_meet(center, 1e-6));
    EXPECT_TRUE(Beam(view, x, y, x + 1, y + 1).may_meet(center, 1e-6));
  }
}

TEST(Beam, MeetsTheBallAroundItsEye) {
  Random random(42);
  for (int i = 0; i < 1000; ++i) {
    const View view = view_of(test::random_camera(random), 640, 480);
    const double radius = random.in(0.1, 10);
    const Vec3d center = view.origin + random.vector(0, 0.999 * radius);
    EXPECT_TRUE(Beam(view, 0, 0, 8, 8).may_meet(center, radius));
  }
}

TEST(Beam, MeetsEverythingWhereRaysLeaveMoreThanOnePoint) {
  Camera lens, parallel;
  lens.aperture = lens.focus_distance.emplace(1);
  parallel.projection = Projection::orthographic;
  parallel.height = 1;
  for (const Camera& camera : {lens, parallel})
    EXPECT_TRUE(Beam(view_of(camera, 640, 480), 0, 0, 8, 8).may_meet({0, 0, 20}, 1e-3));
}

TEST(Beam, OfAViewTooNarrowForDoubleLeavesNothingOut) {
  Camera camera;
  camera.fov_degrees = 1e-200;
  EXPECT_TRUE(Beam(view_of(camera, 640, 480), 0, 0, 8, 8).may_meet({0, 0, -20}, 1));
}

TEST(Beam, LeavesOutWhatLiesBehindOrFarAside) {
  const Beam beam(view_of({}, 640, 480), 304, 224, 336, 256);  // the middle of the picture
  EXPECT_TRUE(beam.may_meet({0, 0, -20}, 1));
  EXPECT_FALSE(beam.may_meet({0, 0, 20}, 1));
  EXPECT_FALSE(beam.may_meet({15, 0, -20}, 1));
  EXPECT_FALSE(beam.may_meet({0, -10004, -20}, 10000));
}

}  // namespace
}  // namespace tia
