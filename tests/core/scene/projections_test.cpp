// Fisheye, equirectangular and cylindrical pictures: directions by hand, solid angles, what a ball
// covers, and lanes.
#include <gtest/gtest.h>

#include <cmath>

#include "core/scene/views.h"
#include "tests/core/accel/worlds.h"
#include "tests/core/random_scene.h"

namespace tia {
namespace {

using test::Random;

Camera panorama(Projection projection, std::optional<double> angle = {}) {
  Camera camera;
  camera.projection = projection;
  camera.angle_degrees = angle;
  return camera;
}
constexpr Projection curved[] = {Projection::fisheye, Projection::equirectangular,
                                 Projection::cylindrical};

// Of the default camera, whose frame is the world's own; (dx, dy) in pixels from the centre.
SeenRay<double> ray_at(const View& view, int x, int y, double dx = 0, double dy = 0) {
  return seen_ray<double>(view, x, y, {dx, dy, 0, 0});
}
void expect_direction(const SeenRay<double>& ray, const Vec3d& way) {
  EXPECT_TRUE(ray.seen);
  EXPECT_LT(length(ray.ray.direction - way), 1e-15) << way.x << ' ' << way.y << ' ' << way.z;
  EXPECT_EQ(ray.ray.origin, (Vec3d{0, 0, 0}));
}

// The angle of the triangle on the unit sphere. Source: van Oosterom and Strackee, 1983.
double solid_angle(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  return 2 * std::atan2(std::fabs(dot(a, cross(b, c))), 1 + dot(a, b) + dot(b, c) + dot(c, a));
}
double solid_angle(const View& view, int x, int y) {
  const auto corner = [&](double dx, double dy) {
    return ray_at(view, x, y, dx, dy).ray.direction;
  };
  const Vec3d a = corner(-0.5, -0.5), b = corner(0.5, -0.5), c = corner(0.5, 0.5),
              d = corner(-0.5, 0.5);
  return solid_angle(a, b, c) + solid_angle(a, c, d);
}
// Of the pixels whose centre passes.
template <class Passes>
double solid_angle_of(const View& view, const Passes& passes) {
  double sum = 0;
  for (int y = 0; y < view.height; ++y)
    for (int x = 0; x < view.width; ++x)
      if (const auto ray = ray_at(view, x, y); ray.seen && passes(ray.ray))
        sum += solid_angle(view, x, y);
  return sum;
}
constexpr auto all_pass = [](const Ray<double>&) { return true; };

TEST(Projections, LookWhereTheirFormulasSayInTheMiddleAndAtTheEdges) {
  const double h = std::sqrt(0.5);
  // 181 x 91 pixels: the pixel in the middle is on the axis, and edges are half a pixel off.
  const View fish = view_of(panorama(Projection::fisheye), 181, 91);
  expect_direction(ray_at(fish, 90, 45), {0, 0, -1});
  expect_direction(ray_at(fish, 90, 0, 0, -0.5), {0, 1, 0});   // up is up, 90 degrees off the axis
  expect_direction(ray_at(fish, 113, 45, -0.25), {h, 0, -h});  // 22.75 of 45.5 pixels: 45 degrees
  EXPECT_FALSE(ray_at(fish, 0, 0).seen);
  EXPECT_FALSE(ray_at(fish, 90 + 46, 45).seen);
  const View around = view_of(panorama(Projection::equirectangular), 180, 90);
  expect_direction(ray_at(around, 90, 45, -0.5, -0.5), {0, 0, -1});
  expect_direction(ray_at(around, 135, 45, -0.5, -0.5), {1, 0, 0});  // azimuth 90: to the right
  expect_direction(ray_at(around, 0, 45, -0.5, -0.5), {0, 0, 1});    // behind
  expect_direction(ray_at(around, 90, 22, -0.5, 0), {0, h, -h});
  expect_direction(ray_at(around, 17, 0, 0, -0.5), {0, 1, 0});
  expect_direction(ray_at(around, 179, 89, 0.5, 0.5), {0, -1, 0});  // a corner, all of it a pole
  expect_direction(ray_at(around, 0, 67, -0.5, 0), {0, -h, h});
  Camera tube = panorama(Projection::cylindrical, 180);
  tube.height = 2;
  const View cylinder = view_of(tube, 100, 50);
  expect_direction(ray_at(cylinder, 50, 25, -0.5, -0.5), {0, 0, -1});
  expect_direction(ray_at(cylinder, 50, 0, -0.5, -0.5), {0, h, -h});
  expect_direction(ray_at(cylinder, 99, 25, 0.5, -0.5), {1, 0, 0});
  expect_direction(ray_at(cylinder, 99, 0, 0.5, -0.5), {h, h, 0});  // the corners
  expect_direction(ray_at(cylinder, 0, 49, -0.5, 0.5), {-h, -h, 0});
}

TEST(Projections, SolidAnglesOfPixelsSumToTheWhole) {
  const View around = view_of(panorama(Projection::equirectangular), 60, 40);
  EXPECT_NEAR(solid_angle_of(around, all_pass), 4 * pi, 1e-6);
  // The cap within theta has 2 pi (1 - cos theta); the disc's edge cuts pixels, of which the
  // centre decides: an error below a share of the edge's pixels of (circumference)^(-1/2) each.
  for (const double degrees : {60.0, 180.0, 300.0}) {
    const View fish = view_of(panorama(Projection::fisheye, degrees), 200, 200);
    const double cap = 2 * pi * (1 - std::cos(degrees / 2 * pi / 180));
    EXPECT_NEAR(solid_angle_of(fish, all_pass), cap, 4e-3 * cap) << degrees;
  }
  // Of the sphere a cylinder of half height h covers 2 h / sqrt(1 + h^2) * angle / 2 ... : the zone
  // between the elevations +-atan h has angle * 2 sin(atan h).
  Camera tube = panorama(Projection::cylindrical, 200);
  tube.height = 3;
  EXPECT_NEAR(solid_angle_of(view_of(tube, 100, 100), all_pass),
              200 * pi / 180 * 2 * std::sin(std::atan(1.5)), 2e-3);
}

// Of the pixels that a picture shows it in, too.
TEST(Projections, ABallCoversTheConeOfItsTangents) {
  Random random(261);
  for (const Projection projection : curved) {
    Scene scene;
    scene.camera = panorama(projection);
    const View view = view_of(scene.camera, 240, 160);
    const Vec3d way = normalize(Vec3d{random.in(-0.5, 0.5), random.in(-0.3, 0.3), -1});
    const double radius = random.in(0.2, 0.5);  // at distance 1: sin of half its angle
    const double cosine = std::sqrt(1 - radius * radius);
    scene.objects = {test::object_of(Sphere{way, radius})};
    RenderOptions numbers;
    numbers.integrator = IntegratorName::object;
    const Image image = test::picture(scene, view.width, view.height, numbers).image;
    double covered = 0, shown = 0;
    for (int y = 0; y < view.height; ++y)
      for (int x = 0; x < view.width; ++x) {
        const SeenRay<double> ray = ray_at(view, x, y);
        if (!ray.seen) continue;
        const double along = dot(ray.ray.direction, way), angle = solid_angle(view, x, y);
        covered += along > cosine ? angle : 0;
        shown += image.at(x, y)[0] == 1 ? angle : 0;
        if (std::fabs(along - cosine) > 1e-6) ASSERT_EQ(image.at(x, y)[0] == 1, along > cosine);
      }
    EXPECT_NEAR(covered, 2 * pi * (1 - cosine), 0.02 * covered) << name_of(projection);
    EXPECT_NEAR(shown, covered, 1e-3 * covered) << name_of(projection);
  }
}

TEST(Projections, FollowTheCamerasFrame) {
  Random random(262);
  for (int k = 0; k < 100; ++k) {
    const Projection projection = curved[k % 3];
    Camera turned = panorama(projection);
    turned.location = random.point(5);
    turned.direction = random.direction();
    turned.up = random.direction();
    const View view = view_of(turned, 64, 32), plain = view_of(panorama(projection), 64, 32);
    const int x = random.below(64), y = random.below(32);
    const Vec3d local = ray_at(plain, x, y).ray.direction;
    const Vec3d w = normalize(*turned.direction), u = normalize(cross(w, turned.up));
    const Vec3d way = u * local.x + cross(u, w) * local.y - w * local.z;
    EXPECT_LT(length(ray_at(view, x, y).ray.direction - way), 1e-14);
    EXPECT_EQ(ray_at(view, x, y).ray.origin, turned.location);
  }
}

TEST(Projections, LanesAreTheSameBitsAsOneByOne) {
  Random random(263);
  for (int k = 0; k < 60; ++k) {
    Camera camera = panorama(curved[k % 3], curved[k % 3] == Projection::equirectangular
                                                ? std::nullopt
                                                : std::optional(random.in(10, 360)));
    camera.location = random.point(5);
    camera.direction = random.direction();
    const View view = view_of(camera, random.whole(1, 500), random.whole(1, 500));
    float x[Wide::size], y[Wide::size], dx[Wide::size], dy[Wide::size];
    for (std::size_t i = 0; i < Wide::size; ++i) {
      x[i] = static_cast<float>(random.below(view.width));
      y[i] = static_cast<float>(random.below(view.height));
      dx[i] = static_cast<float>(random.in(-0.5, 0.5));
      dy[i] = static_cast<float>(random.in(-0.5, 0.5));
    }
    const auto wide =
        curved_ray<Wide>(view, load<Wide>(x), load<Wide>(y), load<Wide>(dx), load<Wide>(dy));
    for (std::size_t i = 0; i < Wide::size; ++i) {
      const auto one = curved_ray<float>(view, x[i], y[i], dx[i], dy[i]);
      const int lane_of_it = static_cast<int>(i);
      EXPECT_EQ(lane(wide.ray.direction.x, lane_of_it), one.ray.direction.x);
      EXPECT_EQ(lane(wide.ray.direction.y, lane_of_it), one.ray.direction.y);
      EXPECT_EQ(lane(wide.ray.direction.z, lane_of_it), one.ray.direction.z);
      EXPECT_EQ((bits(wide.seen) >> i & 1U) != 0, one.seen);
      const auto exact = curved_ray<double>(view, x[i], y[i], dx[i], dy[i]);
      EXPECT_EQ(one.ray.direction, lift<float>(exact.ray.direction));
    }
  }
}

TEST(Projections, PicturesAreTheSameBytesByPacketsAndRayByRay) {
  Scene scene = test::random_scene(264);
  for (const Projection projection : curved)
    for (const int samples : {1, 4}) {
      scene.camera = panorama(projection);
      RenderOptions options;
      options.integrator = IntegratorName::whitted;
      options.samples = samples;
      const auto wide = test::picture(scene, 45, 33, options);
      options.scalar = Scalar::narrow;
      const auto narrow = test::picture(scene, 45, 33, options);
      EXPECT_EQ(wide.image.rgb, narrow.image.rgb) << name_of(projection) << ' ' << samples;
      EXPECT_EQ(wide.rays, narrow.rays);
    }
}

TEST(Projections, OutsideOfTheDiscThereIsNoRayAndNoLight) {
  Scene scene;
  scene.camera = panorama(Projection::fisheye);
  scene.background = {1, 2, 3};
  const auto drawn = test::picture(scene, 60, 40, RenderOptions{});
  const View view = view_of(scene.camera, 60, 40);
  int inside = 0;
  for (int y = 0; y < 40; ++y)
    for (int x = 0; x < 60; ++x) {
      const bool seen = std::hypot(x - 29.5, y - 19.5) <= 20;
      inside += seen;
      EXPECT_EQ(ray_at(view, x, y).seen, seen);
      EXPECT_EQ(drawn.image.at(x, y)[2], seen ? 3 : 0);
    }
  EXPECT_EQ(drawn.rays.primary, inside);
  RenderOptions depths;
  depths.integrator = IntegratorName::planar_depth;
  EXPECT_EQ(test::picture(scene, 60, 40, depths).image.at(0, 0)[0],
            std::numeric_limits<float>::infinity());
}

}  // namespace
}  // namespace tia
