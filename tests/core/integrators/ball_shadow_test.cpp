// The shadow of a ball on a plane, by closed forms: circles and ellipses.
//
// From a point light at L the ball of centre C and radius r hides all points P beyond it whose ray
// to L makes at most the angle alpha with the axis from L through C, sin(alpha) = r / |C - L|: the
// cone of its tangents. A plane at the distance H from L, whose normal makes the angle phi with the
// axis, cuts it in an ellipse while phi + alpha < 90 degrees. Its long axis lies in the plane of
// normal and axis and runs from H tan(phi - alpha) to H tan(phi + alpha) before the foot of L, so
//   a = H sin(alpha) cos(alpha) / (cos(phi + alpha) cos(phi - alpha)),
// and by Dandelin's eccentricity e = sin(phi) / cos(alpha) and the identity
// cos(alpha)^2 - sin(phi)^2 = cos(phi + alpha) cos(phi - alpha) the short one is
//   b = a sqrt(1 - e^2) = H sin(alpha) / sqrt(cos(phi + alpha) cos(phi - alpha)).
// Straight above phi = 0 and both are H tan(alpha) = H r / sqrt(d^2 - r^2).
// Source: Dandelin 1822, as in Hilbert, Cohn-Vossen, Geometry and the Imagination, par. 2.
//
// From infinitely far the cone is a cylinder of radius r, cut at the elevation of the light.
#include <gtest/gtest.h>

#include "tests/core/tree.h"

namespace tia {
namespace {

using namespace test;

// A flat ellipse: its middle and its half axes, each with its length.
struct Ellipse {
  Vec3d middle, along, across;
  Vec3d at(double angle, double share) const {
    return middle + (along * std::cos(angle) + across * std::sin(angle)) * share;
  }
};

// What sends the light: a light at a place, or infinitely far on the way there.
struct Sender {
  Vec3d place;
  bool far = false;
  Vec3d to(const Vec3d& p) const { return far ? place : place - p; }
};

// A plane through the origin, any way up, with a ball above it.
struct BallOnPlane {
  Scene scene;
  Onb frame;  ///< n is the plane's normal
  double height, radius;

  explicit BallOnPlane(Random& random)
      : frame(onb_around(random.direction())), height(random.in(2, 5)), radius(random.in(0.2, 1)) {
    scene.objects = {object(Plane{{0, 0, 0}, frame.n}, Finish{}), ball(center(), radius)};
  }
  Vec3d center() const { return frame.n * height; }

  // Light at the point p of the plane, seen from halfway below the ball.
  Vec3f light(const Vec3d& p) const {
    return tree(scene, p + frame.n * ((height - radius) / 2), -frame.n)->color;
  }
  // Dark just inside the ellipse, as bright as n.l just outside, all around.
  void expect_shadow(const Ellipse& edge, const Sender& sender) const {
    for (int i = 0; i < 24; ++i) {
      const double angle = 2 * pi * (i + 0.25) / 24;
      const double near =
          slack(edge.at(angle, 1), sender) / std::min(length(edge.along), length(edge.across));
      ASSERT_LT(near, 0.02);
      for (const double share : {0.0, 0.7, 1 - near})
        EXPECT_EQ(light(edge.at(angle, share)), (Vec3f{0, 0, 0})) << angle << " " << share;
      for (const double share : {1 + near, 1.3}) {
        const Vec3d p = edge.at(angle, share);
        const double cosine = dot(normalize(sender.to(p)), frame.n);
        expect_near(light(p), {cosine, cosine, cosine}, 2e-6);
      }
    }
  }

 private:
  // How far the edge may be off. A shadow ray starts 5e-6 of its place above the surface and passes
  // as far beside the light; the edge moves farther the more its rays slant and the nearer the ball
  // is to the light.
  double slack(const Vec3d& rim, const Sender& sender) const {
    const Vec3d to = sender.to(rim);
    const double cosine = dot(normalize(to), frame.n);
    const double lever = sender.far ? 1 : length(to) / length(sender.place - center());
    return (1e-5 + 1e-5 * length(rim) / cosine) * lever;
  }
};

Ellipse circle(const Vec3d& middle, double radius, const Onb& frame) {
  return {middle, frame.u * radius, frame.v * radius};
}

TEST(BallShadow, LampStraightAboveCastsTheCircleOfTheTangents) {
  Random random(440);
  for (int i = 0; i < 100; ++i) {
    BallOnPlane stage(random);
    const double gap = stage.radius * random.in(1.2, 8), top = stage.height + gap;
    const Vec3d light = stage.frame.n * top;
    stage.scene.lights = {point_light(light)};
    const double reach = top * stage.radius / std::sqrt(gap * gap - stage.radius * stage.radius);
    stage.expect_shadow(circle({}, reach, stage.frame), {light});
  }
}

// The circle of 3-4-5: r 3, 5 below the light, the tangents 4 long; the plane 8 below it.
TEST(BallShadow, PythagoreanTangentsGiveARoundNumber) {
  Scene scene;
  scene.objects = {object(Plane{{0, 0, 0}, {0, 1, 0}}, Finish{}), ball({0, 3.25, 0}, 3)};
  scene.lights = {point_light({0, 8.25, 0})};
  const double reach = 8.25 * 3 / 4;
  for (const double turn : {0.0, 1.0, 2.0, 4.0}) {
    const auto at = [&](double share) {
      const double x = share * reach * std::cos(turn), z = share * reach * std::sin(turn);
      return tree(scene, {x, 0.2, z}, {0, -1, 0})->color.x;
    };
    EXPECT_EQ(at(0.9999), 0.0F);
    EXPECT_NEAR(double(at(1.0001)), 0.8, 1e-4);
  }
}

TEST(BallShadow, LampAsideCastsTheEllipseThatCutsTheTangentCone) {
  Random random(441);
  for (int i = 0; i < 200; ++i) {
    BallOnPlane stage(random);
    const double distance = stage.radius * random.in(1.2, 8);
    const double alpha = std::asin(stage.radius / distance);
    const double phi = random.in(0, 0.9) * (pi / 2 - alpha);
    const double turn = random.in(0, 2 * pi);
    const Vec3d aside = stage.frame.u * std::cos(turn) + stage.frame.v * std::sin(turn);
    const Vec3d light =
        stage.center() + (stage.frame.n * std::cos(phi) + aside * std::sin(phi)) * distance;
    const double top = dot(light, stage.frame.n);
    const double most = top * std::tan(phi + alpha);
    if (most > 30) continue;
    stage.scene.lights = {point_light(light)};
    const double least = top * std::tan(phi - alpha);
    const double product = std::cos(phi + alpha) * std::cos(phi - alpha);
    const Vec3d foot = light - stage.frame.n * top;
    const double b = top * std::sin(alpha) / std::sqrt(product);
    EXPECT_NEAR((most - least) / 2, top * std::sin(alpha) * std::cos(alpha) / product, 1e-9 * most);
    stage.expect_shadow({foot - aside * ((most + least) / 2), aside * ((most - least) / 2),
                         cross(stage.frame.n, aside) * b},
                        {light});
  }
}

TEST(BallShadow, DirectionalLightCastsAnEllipseOfTheRadiusOverTheSineOfItsElevation) {
  Random random(442);
  for (int i = 0; i < 200; ++i) {
    BallOnPlane stage(random);
    const double elevation = random.in(0.1, 1) * pi / 2, turn = random.in(0, 2 * pi);
    const Vec3d aside = stage.frame.u * std::cos(turn) + stage.frame.v * std::sin(turn);
    const Vec3d to_light = stage.frame.n * std::sin(elevation) + aside * std::cos(elevation);
    Light sun;
    sun.kind = DirectionalLight{to_light * -random.in(0.1, 10)};
    stage.scene.lights = {sun};
    const Vec3d middle = stage.center() - to_light * (stage.height / std::sin(elevation));
    stage.expect_shadow({middle, aside * (stage.radius / std::sin(elevation)),
                         cross(stage.frame.n, aside) * stage.radius},
                        {to_light, true});
  }
}

// The same shadows as pictures: as many dark pixels as the ellipse has area, and their middle.
TEST(BallShadow, PicturesOfItHaveTheEllipsesAreaAndMiddle) {
  Random random(443);
  constexpr int side = 400;
  for (int i = 0; i < rounds(20); ++i) {
    const double height = random.in(2, 3), radius = random.in(0.5, 1);
    const double elevation = random.in(0.5, 1.5);
    Scene scene;
    scene.objects = {object(Plane{{0, 0, 0}, {0, 1, 0}}, Finish{}), ball({0, height, 0}, radius)};
    Light sun;
    sun.kind = DirectionalLight{Vec3d{std::cos(elevation), -std::sin(elevation), 0}};
    scene.lights = {sun};
    // Straight down from below the ball; the picture is 12 wide, its middle the shadow's.
    const double shift = height / std::tan(elevation);
    scene.camera.projection = Projection::orthographic;
    scene.camera.height = 12;
    scene.camera.location = {shift, 0.5, 0};
    scene.camera.direction = Vec3d{0, -1, 0};
    scene.camera.up = {0, 0, -1};
    const Image image = picture(scene, side, side, at_depth(5)).image;
    double dark = 0;
    Vec3d sum{};
    for (int y = 0; y < side; ++y) {
      for (int x = 0; x < side; ++x) {
        if (image.at(x, y)[0] > 0) continue;
        ++dark;
        sum = sum + Vec3d{x + 0.5, y + 0.5, 0};
      }
    }
    const double pixel = 12.0 / side;
    const double area = pi * radius * radius / std::sin(elevation);
    EXPECT_NEAR(dark * pixel * pixel, area, 0.01 * area);
    EXPECT_NEAR(sum.x / dark, side / 2.0, 0.5);
    EXPECT_NEAR(sum.y / dark, side / 2.0, 0.5);
  }
}

}  // namespace
}  // namespace tia
