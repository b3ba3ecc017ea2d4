// Where the eye of a still stands.
#include "core/scene/still_framing.h"

#include "tests/core/scene/stills.h"

namespace tia {
namespace {

using namespace test;

constexpr double framed_share = 0.9;

// ---- the axes -----------------------------------------------------------------------------------

TEST(StillOrbit, AzimuthsGoFromTheFrontToTheRight) {
  EXPECT_EQ(orbit_direction(0, 0), (Vec3d{0, 0, 1}));
  EXPECT_EQ(orbit_direction(90, 0), (Vec3d{1, 0, 0}));
  EXPECT_EQ(orbit_direction(180, 0), (Vec3d{0, 0, -1}));
  EXPECT_EQ(orbit_direction(-90, 0), (Vec3d{-1, 0, 0}));
  EXPECT_EQ(orbit_direction(123, 90), (Vec3d{0, 1, 0}));
  EXPECT_EQ(orbit_direction(123, -90), (Vec3d{0, -1, 0}));
}

TEST(StillOrbit, AxesAreACamerasThatLooksFromThere) {
  Random random(2201);
  for (int i = 0; i < 300; ++i) {
    const double azimuth = random.in(-360, 360);
    const double elevation = i % 10 == 0 ? (i % 20 == 0 ? 90 : -90) : random.in(-90, 90);
    const Basis axes = orbit_basis(azimuth, elevation);
    EXPECT_LT(length(axes.w - orbit_direction(azimuth, elevation)), 1e-15);
    EXPECT_LT(length(cross(axes.u, axes.v) - axes.w), 1e-15);
    EXPECT_NEAR(dot(axes.u, axes.v), 0, 1e-15);
    EXPECT_EQ(axes.u.y, 0) << "the horizon is level";
    EXPECT_GE(axes.v.y, 0) << "what is above is up in the picture";
  }
}

// ---- the frame ----------------------------------------------------------------------------------

// Whether a tip is so near that the eye has gone back from where it would touch.
bool goes_back(const StillPoints& points, const Camera& camera) {
  double nearest = 1e300;
  for (const Vec3d& p : points.corners)
    nearest = std::min(nearest, dot(p - camera.location, *camera.direction));
  return nearest < 1.001e-3 * ball_around(points).radius;
}

// On one axis both sides are touched, on the other none is passed.
TEST(StillFraming, PointsTouchAFrameFivePercentInside) {
  Random random(2202);
  int across = 0, back = 0;
  for (int i = 0; i < 400; ++i) {
    const StillPoints points = cloud(random, random.whole(4, 60));
    const StillFrame frame = random_frame(random, i % 4 == 0 ? 0 : random.in(1, 120));
    const Camera camera = framed(points, frame);
    const SeenBox box = seen_box(points, camera, frame.aspect);
    const bool wide = box.across() > box.along();
    across += wide;
    if (goes_back(points, camera)) {
      ++back;
      continue;
    }
    EXPECT_NEAR(wide ? box.right : box.up, framed_share, 1e-9);
    EXPECT_NEAR(wide ? box.left : box.down, -framed_share, 1e-9);
    EXPECT_LE(wide ? box.along() : box.across(), framed_share + 1e-9);
  }
  EXPECT_GT(across, 100);
  EXPECT_LT(across, 300);
  EXPECT_LT(back, 40);
}

TEST(StillFraming, ParallelViewsAreCentredOnTheOtherAxisToo) {
  Random random(2203);
  for (int i = 0; i < 200; ++i) {
    const StillPoints points = cloud(random, random.whole(2, 40));
    const StillFrame frame = random_frame(random, 0);
    const SeenBox box = seen_box(points, framed(points, frame), frame.aspect);
    EXPECT_NEAR(box.left, -box.right, 1e-9);
    EXPECT_NEAR(box.down, -box.up, 1e-9);
  }
}

// In perspective what has the same distances from both sides of the frame need not be seen in its
// middle: it is where it could go as far to the one side as to the other.
TEST(StillFraming, PointsAreAsFarFromBothSidesOfTheFrame) {
  Random random(2204);
  for (int i = 0; i < 200; ++i) {
    const StillPoints points = cloud(random, random.whole(4, 60));
    const double fov = random.in(5, 100);
    const StillFrame frame = random_frame(random, fov);
    const Camera camera = framed(points, frame);
    const double along = framed_share * std::tan(fov * pi / 360), across = along * frame.aspect;
    double right = 1e300, left = 1e300, up = 1e300, down = 1e300;
    for (const Vec3d& p : points.corners) {
      const Vec3d way = p - camera.location;
      const double z = -dot(way, frame.axes.w), x = dot(way, frame.axes.u),
                   y = dot(way, frame.axes.v);
      right = std::min(right, across * z - x), left = std::min(left, across * z + x);
      up = std::min(up, along * z - y), down = std::min(down, along * z + y);
    }
    EXPECT_NEAR(right, left, 1e-9);
    EXPECT_NEAR(up, down, 1e-9);
    if (!goes_back(points, camera)) {
      EXPECT_NEAR(std::min(right / across, up / along), 0, 1e-9) << "and touch one of both";
    }
  }
}

// A rectangle that faces the eye has one depth.
TEST(StillFraming, WhatIsFlatBeforeTheEyeIsSeenInTheMiddle) {
  Random random(2205);
  for (int i = 0; i < 100; ++i) {
    const StillFrame frame = random_frame(random, random.in(5, 100));
    const Vec3d middle = random.point(5);
    const Vec3d x = frame.axes.u * random.in(0.1, 2), y = frame.axes.v * random.in(0.1, 2);
    const StillPoints points{{middle - x - y, middle + x - y, middle - x + y, middle + x + y}, {}};
    const SeenBox box = seen_box(points, framed(points, frame), frame.aspect);
    EXPECT_NEAR(box.left, -box.right, 1e-9);
    EXPECT_NEAR(box.down, -box.up, 1e-9);
    EXPECT_NEAR(std::max(box.right, box.up), framed_share, 1e-9);
  }
}

TEST(StillFraming, ZoomEnlargesThePictureAboutItsCentre) {
  Random random(2206);
  for (int i = 0; i < 100; ++i) {
    const StillPoints points = cloud(random, 12);
    StillFrame frame = random_frame(random, i % 2 == 0 ? 0 : random.in(5, 100));
    const SeenBox one = seen_box(points, framed(points, frame), frame.aspect);
    frame.zoom = random.in(0.2, 20);
    const SeenBox zoomed = seen_box(points, framed(points, frame), frame.aspect);
    EXPECT_NEAR(zoomed.left, one.left * frame.zoom, 1e-8);
    EXPECT_NEAR(zoomed.right, one.right * frame.zoom, 1e-8);
    EXPECT_NEAR(zoomed.down, one.down * frame.zoom, 1e-8);
    EXPECT_NEAR(zoomed.up, one.up * frame.zoom, 1e-8);
  }
}

// A ball before the eye is framed as the cloud of its surface's points.
TEST(StillFraming, BallsCountWithTheirRadius) {
  Random random(2207);
  for (int i = 0; i < 6; ++i) {
    StillPoints two{{}, {random.point(3), random.point(3)}, random.in(0.2, 1)};
    StillPoints surface;
    for (const Vec3d& center : two.balls)
      for (int k = 0; k < 10000; ++k)
        surface.corners.push_back(center + random.direction() * two.ball_radius);
    const StillFrame frame = random_frame(random, i % 2 == 0 ? 0 : 60);
    const SeenBox box = seen_box(surface, framed(two, frame), frame.aspect);
    EXPECT_LE(std::max(box.across(), box.along()), framed_share + 1e-9);
    EXPECT_GT(std::max(box.across(), box.along()), framed_share - 6e-3);
  }
}

// ---- what has no size, or stands on its tip -----------------------------------------------------

TEST(StillFraming, ASinglePlaceHasACameraThatSeesIt) {
  for (const double fov : {0.0, 30.0}) {
    const StillPoints points{{{3, 4, 5}, {3, 4, 5}}, {}};
    EXPECT_EQ(ball_around(points).radius, 1);
    const Camera camera = framed(points, {orbit_basis(30, 20), fov, 1, 1.5});
    const SeenBox box = seen_box(points, camera, 1.5);
    EXPECT_NEAR(box.across(), 0, 1e-9);
    EXPECT_NEAR(box.along(), 0, 1e-9);
    Faults faults;
    camera.check({}, faults);
    EXPECT_EQ(faults.count(), 0U);
  }
}

TEST(StillFraming, TheEyeKeepsAwayFromATipThatPointsAtIt) {
  const StillPoints needle{{{0, 0, 1}, {0, 0, -1}}, {}};
  const Camera camera = framed(needle, {orbit_basis(0, 0), 40, 1, 1});
  EXPECT_NEAR(camera.location.z, 1 + 1e-3, 1e-12);
}

TEST(StillFraming, CamerasAreSoundAtTheEndsOfTheirRanges) {
  Random random(2208);
  const StillPoints points = cloud(random, 9);
  for (const double elevation : {-90.0, 0.0, 90.0})
    for (const double fov : {0.0, 1.0, 170.0})
      for (const double zoom : {0.1, 1.0, 1000.0}) {
        Faults faults;
        framed(points, {orbit_basis(77, elevation), fov, zoom, 3}).check({}, faults);
        EXPECT_EQ(faults.count(), 0U) << elevation << " " << fov << " " << zoom;
      }
}

// ---- the ball, the ground -----------------------------------------------------------------------

TEST(StillBallAround, IsThatOfTheBoxesCentreAndTheFarthestPoint) {
  const StillPoints points{{{0, 0, 0}, {4, 0, 0}, {0, 2, 0}}, {{2, 1, 6}}, 1};
  // The box is 0..4, 0..2, 0..7.
  const StillBall ball = ball_around(points);
  EXPECT_EQ(ball.center, (Vec3d{2, 1, 3.5}));
  EXPECT_DOUBLE_EQ(ball.radius, std::sqrt(4 + 1 + 3.5 * 3.5));
  EXPECT_EQ(lowest_of(points), 0);
  EXPECT_EQ(lowest_of({{{0, 5, 0}}, {{0, 2, 0}}, 0.5}), 1.5);
}

}  // namespace
}  // namespace tia
