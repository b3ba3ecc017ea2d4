// Ambient occlusion, by closed forms of the share of the cosine-weighted hemisphere that is hidden.
#include <gtest/gtest.h>

#include "tests/core/tree.h"

namespace tia {
namespace {

using namespace test;

constexpr int sky_rays = 4096;
// Five standard errors of as many independent rays; Sobol's points stay far within.
double tolerance_of(double share) { return 5 * std::sqrt(share * (1 - share) / sky_rays) + 1e-6; }

// The picture's value where a ray from `eye` meets the scene: one pixel, so narrow that all of its
// rays meet one point.
double free_sky(Scene scene, const Vec3d& eye, const Vec3d& to, double radius = 0,
                Scalar scalar = Scalar::wide) {
  scene.camera = Camera{};
  scene.camera.location = eye;
  scene.camera.direction = to - eye;
  scene.camera.up = onb_around(normalize(to - eye)).u;
  scene.camera.fov_degrees = 1e-3;
  RenderOptions options;
  options.integrator = IntegratorName::ambient_occlusion;
  options.samples = sky_rays;
  options.scalar = scalar;
  if (radius > 0) options.ao_radius = radius;
  const Image image = picture(scene, 1, 1, options).image;
  EXPECT_EQ(image.rgb[0], image.rgb[1]);
  EXPECT_EQ(image.rgb[0], image.rgb[2]);
  return static_cast<double>(image.rgb[0]);
}

TEST(AmbientOcclusion, IsOneUnderTheOpenSkyAndWhereNothingIsHit) {
  Scene scene;
  scene.objects = {object(Plane{{0, 0, 0}, {0, 1, 0}}, Finish{})};
  EXPECT_EQ(free_sky(scene, {1, 2, 3}, {0, 0, 0}), 1);
  EXPECT_EQ(free_sky(scene, {1, 2, 3}, {1, 9, 3.5}), 1);
}

TEST(AmbientOcclusion, IsZeroInAClosedBall) {
  const Scene scene = [] {
    Scene closed;
    closed.objects = {ball({0, 0, 0}, 2)};
    return closed;
  }();
  EXPECT_EQ(free_sky(scene, {0.5, 0.2, 0.1}, {2, 1, 0}), 0);
}

// Over the point at the height h a disc of radius R hides R^2 / (R^2 + h^2).
// Source: the form factor from a small patch to a coaxial parallel disc (Howell, "A catalog of
// radiation heat transfer configuration factors", B-12).
TEST(AmbientOcclusion, BelowADiscIsItsFormFactorsComplement) {
  Random random(810);
  for (int i = 0; i < 12; ++i) {
    const Onb frame = onb_around(random.direction());
    const Vec3d p = random.point(5);
    const double h = random.in(0.3, 2), r = random.in(0.3, 3);
    Scene scene;
    scene.objects = {object(Plane{p, frame.n}, Finish{}),
                     object(Disc{p + frame.n * h, frame.n, r}, Finish{})};
    const double share = h * h / (h * h + r * r);
    // From aside, below the disc.
    const Vec3d eye = p + frame.u * (0.7 * h) + frame.n * (0.5 * h);
    for (const Scalar scalar : {Scalar::wide, Scalar::exact})
      EXPECT_NEAR(free_sky(scene, eye, p, 0, scalar), share, tolerance_of(share)) << h << " " << r;
  }
}

// A wall at the distance d hides half of the sky; within a radius it hides the directions of the
// unit disc beyond d / radius: (acos c - c sqrt(1 - c^2)) / pi of its area (Malley's projection).
TEST(AmbientOcclusion, BesideAWallIsTheSegmentOfTheDiscWithinTheRadius) {
  Random random(811);
  for (int i = 0; i < 12; ++i) {
    const Onb frame = onb_around(random.direction());
    const Vec3d p = random.point(5);
    const double d = random.in(0.2, 2);
    Scene scene;
    scene.objects = {object(Plane{p, frame.n}, Finish{}),
                     object(Plane{p + frame.u * d, frame.u}, Finish{})};
    const Vec3d eye = p - frame.u * 1.5 + frame.n * 1.0 + frame.v * 0.3;
    EXPECT_NEAR(free_sky(scene, eye, p), 0.5, tolerance_of(0.5));
    EXPECT_EQ(free_sky(scene, eye, p, 0.99 * d), 1);
    const double c = random.in(0.1, 0.9);
    const double hidden = (std::acos(c) - c * std::sqrt(1 - c * c)) / pi;
    EXPECT_NEAR(free_sky(scene, eye, p, d / c), 1 - hidden, tolerance_of(hidden)) << d << " " << c;
  }
}

// One ray a sample: two for what is hit, one for what is not.
TEST(AmbientOcclusion, CostsOneRayASample) {
  Scene scene;
  scene.objects = {object(Plane{{0, -1, 0}, {0, 1, 0}}, Finish{})};
  RenderOptions options;
  options.integrator = IntegratorName::ambient_occlusion;
  options.samples = 3;
  const RayCounts counts = picture(scene, 40, 30, options).rays;
  EXPECT_EQ(counts.primary, 3 * 40 * 30);
  EXPECT_GT(counts.shadow, 0);
  EXPECT_LT(counts.shadow, counts.primary);
}

}  // namespace
}  // namespace tia
