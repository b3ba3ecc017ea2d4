// Rays of basis, orthographic and lens cameras against their formulas.
#include "core/scene/view.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "core/math/deterministic.h"
#include "core/render/sampler.h"
#include "tests/core/random_scene.h"

namespace tia {
namespace {

using test::Random;

// A right-handed orthonormal frame: u right, v up, w towards the viewer.
Basis random_basis(Random& random) {
  Basis basis;
  basis.w = random.direction();
  basis.u = normalize(cross(random.direction(), basis.w));
  basis.v = cross(basis.w, basis.u);
  return basis;
}

template <class Real>
Ray<Real> ray_of(const View& view, int x, int y, const Aim<double>& aim) {
  const auto real = [](double value) { return static_cast<Real>(value); };
  return Eye<Real>(view).ray(view.column(real(x)) + view.row(real(y)),
                             {real(aim.dx), real(aim.dy), real(aim.lens_x), real(aim.lens_y)});
}

// ---- basis --------------------------------------------------------------------------------------

TEST(View, BasisFollowsAlgoWikisGrid) {
  // Pixel (i, j), i from the bottom: (s (j - w/2 + 1/2), s (i - h/2 + 1/2), -d) in the basis.
  Random random(90);
  for (int k = 0; k < 500; ++k) {
    Camera camera;
    camera.location = random.point(5);
    camera.basis = random_basis(random);
    camera.distance = random.in(0.1, 10);
    camera.pixel_size = *camera.distance * random.in(1e-4, 1e-2);
    const int w = 1 + random.below(900), h = 1 + random.below(900);
    const int j = random.below(w), i = random.below(h);
    const Vec3d way = camera.basis->u * (*camera.pixel_size * (j - w / 2.0 + 0.5)) +
                      camera.basis->v * (*camera.pixel_size * (i - h / 2.0 + 0.5)) -
                      camera.basis->w * *camera.distance;
    const View view = view_of(camera, w, h);
    const int row = h - 1 - i;
    EXPECT_LT(length(view.ray<double>(j, row).direction - normalize(way)), 1e-12);
    EXPECT_EQ(view.ray<double>(j, row).origin, camera.location);
    const auto single = view.ray<float>(static_cast<float>(j), static_cast<float>(row));
    EXPECT_LT(length(widen(single.direction) - normalize(way)), 1e-6);
  }
}

TEST(View, AllSpellingsOfOneViewGiveTheSameRaysAlsoThroughALens) {
  Random random(91);
  for (int k = 0; k < 300; ++k) {
    const int width = 1 + random.below(900), height = 1 + random.below(900);
    const Basis frame = random_basis(random);
    const double half = std::tan(random.in(3, 60) * (pi / 180)), far = random.in(0.1, 10);
    Camera look_at, direction, plane, basis;
    look_at.location = random.point(5);
    look_at.aperture = random.in(0.01, 1);
    look_at.focus_distance = random.in(0.5, 20);
    direction = plane = basis = look_at;
    look_at.look_at = look_at.location - frame.w * random.in(0.1, 100);
    look_at.up = frame.v + frame.w * random.in(-2, 2);
    direction.direction = -frame.w;
    direction.up = frame.v;
    direction.fov_degrees = look_at.fov_degrees = 2 * std::atan(half) * (180 / pi);
    plane.direction = -frame.w * far;
    plane.up = frame.v * (half * far);
    plane.right = frame.u * (half * far * width / height);
    basis.basis = frame;
    basis.distance = far;
    basis.pixel_size = 2 * half * far / height;
    const int x = random.below(width), y = random.below(height);
    const double turn = random.in(0, 2 * pi), radius = random.unit();
    const double dx = random.in(-0.5, 0.5), dy = random.in(-0.5, 0.5);
    const Aim<double> aim{dx, dy, radius * std::cos(turn), radius * std::sin(turn)};
    const Ray<double> ray = ray_of<double>(view_of(look_at, width, height), x, y, aim);
    for (const Camera& other : {direction, plane, basis}) {
      const View view = view_of(other, width, height);
      const Ray<double> same = ray_of<double>(view, x, y, aim);
      EXPECT_LT(length(same.direction - ray.direction), 1e-12);
      EXPECT_LT(length(same.origin - ray.origin), 1e-12);
      const Ray<float> single = ray_of<float>(view, x, y, aim);
      EXPECT_LT(length(widen(single.direction) - ray.direction), 2e-6);
      EXPECT_LT(length(widen(single.origin) - ray.origin), 2e-6);
    }
  }
}

// ---- orthographic -------------------------------------------------------------------------------

TEST(View, OrthographicRaysAreParallelAndStartInThePlaneOfLocation) {
  Random random(92);
  for (int k = 0; k < 500; ++k) {
    const Basis frame = random_basis(random);
    const int width = 1 + random.below(900), height = 1 + random.below(900);
    Camera by_height;
    by_height.projection = Projection::orthographic;
    by_height.location = random.point(5);
    Camera by_plane = by_height, by_basis = by_height;
    const double tall = random.in(0.1, 50), wide = tall * width / height;
    by_height.direction = -frame.w * random.in(0.1, 10);
    by_height.up = frame.v + frame.w;
    by_height.height = tall;
    by_plane.direction = by_height.direction;
    by_plane.right = frame.u * (wide / 2);
    by_plane.up = frame.v * (tall / 2);
    by_basis.basis = frame;
    by_basis.pixel_size = tall / height;
    const int x = random.below(width), y = random.below(height);
    const double dx = random.in(-0.5, 0.5), dy = random.in(-0.5, 0.5);
    const Vec3d start = by_height.location + frame.u * (wide * ((x + 0.5 + dx) / width - 0.5)) +
                        frame.v * (tall * (0.5 - (y + 0.5 + dy) / height));
    for (const Camera& each : {by_height, by_plane, by_basis}) {
      const Ray<double> ray = ray_of<double>(view_of(each, width, height), x, y, {dx, dy, 0, 0});
      EXPECT_LT(length(ray.origin - start), 1e-12 * (1 + wide + tall));
      EXPECT_LT(length(ray.direction + frame.w), 1e-12);
    }
  }
}

TEST(View, OrthographicPlaneMayBeSkewToItsRays) {
  Camera camera;
  camera.projection = Projection::orthographic;
  camera.direction = Vec3d{0, -3, -4};
  camera.right = Vec3d{2, 0, 0};
  const View view = view_of(camera, 2, 2);  // pixel centres half way to the edges
  EXPECT_EQ(view.ray<double>(0, 0).origin, (Vec3d{-1, 0.5, 0}));
  EXPECT_LT(length(view.ray<double>(0, 0).direction - Vec3d{0, -0.6, -0.8}), 1e-15);
}

// ---- the thin lens ------------------------------------------------------------------------------

TEST(View, AllRaysOfOnePointOfThePictureMeetInThePlaneOfFocus) {
  Random random(93);
  for (int k = 0; k < 300; ++k) {
    Camera camera = test::random_camera(random);
    camera.aperture = random.in(0.01, 2);
    camera.focus_distance = random.in(1, 30);
    const View view = view_of(camera, 640, 480);
    const int x = random.below(640), y = random.below(480);
    const double dx = random.in(-0.5, 0.5), dy = random.in(-0.5, 0.5);
    const Ray<double> middle = ray_of<double>(view, x, y, {dx, dy, 0, 0});
    const Vec3d normal = normalize(cross(view.right, view.up));
    // The plane of focus stands parallel to the lens, at focus_distance along the view.
    const double depth = *camera.focus_distance * dot(view.forward, normal);
    const Vec3d sharp = middle.at(depth / dot(middle.direction, normal));
    for (int i = 0; i < 8; ++i) {
      const double turn = random.in(0, 2 * pi), radius = random.unit();
      const Ray<double> ray =
          ray_of<double>(view, x, y, {dx, dy, radius * std::cos(turn), radius * std::sin(turn)});
      EXPECT_NEAR(length(ray.origin - camera.location), radius * camera.aperture / 2, 1e-12);
      EXPECT_NEAR(dot(ray.origin - camera.location, normal), 0, 1e-12) << "in the lens";
      const Vec3d met = ray.at(depth / dot(ray.direction, normal));
      EXPECT_LT(length(met - sharp), 1e-11 * *camera.focus_distance);
    }
  }
}

// Where the rays of a pixel meet the plane z = -depth, for the default camera with a lens.
struct Spots {
  Camera camera;
  Sampler sampler{4096, 0, 3};

  Spots(double aperture, double focus) {
    camera.aperture = aperture;
    camera.focus_distance = focus;
  }
  template <class F>
  void each(double depth, F visit) const {
    const View view = view_of(camera, 641, 481);  // so that a pixel's centre is on the axis
    for (int i = 0; i < 4096; ++i) {
      const Aim<float> aim = sampler.aim(320, 240, i);
      const Ray<double> ray = ray_of<double>(view, 320, 240, {0, 0, aim.lens_x, aim.lens_y});
      const double t = (-depth - ray.origin.z) / ray.direction.z;
      visit(ray.at(t));
    }
  }
};

TEST(View, CircleOfConfusionHasTheRadiusOfSimilarTriangles) {
  // The cone from the lens, radius A/2, to its tip at f cuts the plane z in A/2 |z - f| / f; seen
  // from the lens' centre in the plane of focus that is f/z of it, A/2 |z - f| / z.
  for (const auto& [aperture, focus, depth] :
       {std::tuple{1.0, 10.0, 5.0}, {1.0, 10.0, 20.0}, {0.2, 3.0, 300.0}}) {
    const double radius = aperture / 2 * std::fabs(depth - focus) / focus;
    double farthest = 0, second_moment = 0;
    Spots(aperture, focus).each(depth, [&](const Vec3d& p) {
      const double square = p.x * p.x + p.y * p.y;
      farthest = std::max(farthest, std::sqrt(square));
      second_moment += square / 4096;
    });
    EXPECT_LE(farthest, radius * (1 + 1e-6));
    EXPECT_GE(farthest, radius * 0.99);
    EXPECT_NEAR(second_moment, radius * radius / 2, 0.002 * radius * radius) << "uniform disc";
  }
}

TEST(View, PlaneOfFocusIsSharp) {
  Spots(2, 7).each(7, [](const Vec3d& p) { EXPECT_LT(std::hypot(p.x, p.y), 1e-12); });
}

TEST(View, BlurredStraightEdgeHasTheProfileOfADiscCutByAChord) {
  // The share of a disc of radius R that lies to the left of the chord at u R:
  // 1/2 + (asin u + u sqrt(1 - u^2)) / pi. 4096 strata: the chord cuts at most 4 * 64 of them, each
  // an independent error of deviation at most 1/2 / 4096: below sqrt(256) / 8192 = 0.002.
  const double radius = 0.5 * (20 - 8) / 8;
  const Spots spots(1, 8);
  for (double u = -0.95; u < 1; u += 0.19) {
    int left = 0;
    spots.each(20, [&](const Vec3d& p) { left += p.x < u * radius; });
    const double exact = 0.5 + (std::asin(u) + u * std::sqrt(1 - u * u)) / pi;
    EXPECT_NEAR(left / 4096.0, exact, 4 * 0.002) << u;
  }
}

}  // namespace
}  // namespace tia
