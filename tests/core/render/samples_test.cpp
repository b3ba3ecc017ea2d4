// Pictures of many rays a pixel, through lenses and in parallel: their bytes, counts and areas.
#include <gtest/gtest.h>

#include "core/math/deterministic.h"
#include "tests/core/faults.h"
#include "tests/core/random_scene.h"

namespace tia {
namespace {

using test::bits_of;
using test::black_ball;
using test::picture;
using test::Random;

RenderOptions sampling(int samples, double threshold = 0) {
  RenderOptions options;
  options.samples = samples;
  options.threshold = threshold;
  options.seed = 42;
  return options;
}

// A random scene, seen by a camera of any kind.
Scene any_scene(std::uint64_t seed) {
  Scene scene = test::random_scene(seed, 12);
  Camera& camera = scene.camera;
  if (seed % 3 == 1) {
    camera.aperture = 0.3;
    camera.focus_distance = 18;
  } else if (seed % 3 == 2) {
    camera = {};
    camera.projection = Projection::orthographic;
    camera.height = 15;
  }
  return scene;
}

// ---- a pixel depends on the scene, the seed and itself alone
// --------------------------------------

TEST(Samples, WideEqualsNarrowBitForBit) {
  for (std::uint64_t seed = 0; seed < 12; ++seed) {
    for (RenderOptions options : {sampling(1), sampling(5), sampling(2, 0.05)}) {
      const Scene scene = any_scene(seed);
      const auto wide = picture(scene, 37, 29, options);
      options.scalar = Scalar::narrow;
      const auto narrow = picture(scene, 37, 29, options);
      ASSERT_EQ(bits_of(wide.image), bits_of(narrow.image)) << seed;
      EXPECT_EQ(wide.rays, narrow.rays) << seed;
    }
  }
}

TEST(Samples, DoubleTakesTheSamePointsButForEdges) {
  for (std::uint64_t seed = 0; seed < 9; ++seed) {
    const Scene scene = any_scene(seed);
    RenderOptions options = sampling(8);
    const Image image = picture(scene, 40, 30, options).image;
    options.scalar = Scalar::exact;
    const Image exact = picture(scene, 40, 30, options).image;
    int apart = 0;
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
      apart += !(std::fabs(image.rgb[i] - exact.rgb[i]) < 1e-3F);
    EXPECT_LE(apart, 3 * 3) << seed;
  }
}

TEST(Samples, ThreadsTilesAndWindowsNeverChangeAByte) {
  const int width = test::sanitized() ? 31 : 61, height = test::sanitized() ? 23 : 43;
  Random random(100);
  for (std::uint64_t seed = 0; seed < 3; ++seed) {
    for (RenderOptions options : {sampling(3), sampling(1, 0.1)}) {
      const Scene scene = any_scene(seed);
      const auto whole = picture(scene, width, height, options);
      for (const int tile : {32, 7, 1}) {
        options.tile = tile;
        options.threads = tile == 7 ? 3 : 1;
        const auto other = picture(scene, width, height, options);
        EXPECT_EQ(bits_of(other.image), bits_of(whole.image)) << seed << ", tile " << tile;
        EXPECT_EQ(other.rays, whole.rays) << seed << ", tile " << tile;
      }
      Window window{random.below(width), random.below(height), 0, 0};
      window.x1 = window.x0 + 1 + random.below(width - window.x0);
      window.y1 = window.y0 + 1 + random.below(height - window.y0);
      const Image part = picture(scene, width, height, window, options).image;
      Image cut(window.width(), window.height());
      for (int y = 0; y < cut.height; ++y)
        std::copy_n(whole.image.at(window.x0, window.y0 + y), 3 * cut.width, cut.at(0, y));
      EXPECT_EQ(bits_of(part), bits_of(cut)) << seed;
    }
  }
}

TEST(Samples, SeedChangesThePictureOfManyRaysAndNotOfOne) {
  const Scene scene = test::thesis_scene('a');
  const auto seeded = [&](int samples, std::int64_t seed) {
    RenderOptions options = sampling(samples);
    options.seed = seed;
    return bits_of(picture(scene, 64, 48, options).image);
  };
  EXPECT_EQ(seeded(1, 0), seeded(1, 1));
  EXPECT_NE(seeded(4, 0), seeded(4, 1));
  EXPECT_NE(seeded(4, 0), seeded(4, 1LL << 52));
}

TEST(Samples, OneRayIsThePinholesAlsoThroughALens) {
  Scene scene = test::thesis_scene('d');
  const auto pinhole = bits_of(picture(scene, 80, 60).image);
  scene.camera.aperture = 2;
  scene.camera.focus_distance = 5;
  EXPECT_EQ(bits_of(picture(scene, 80, 60, sampling(1)).image), pinhole);
  EXPECT_NE(bits_of(picture(scene, 80, 60, sampling(4)).image), pinhole);
}

// ---- counts -------------------------------------------------------------------------------------

TEST(Samples, PrimaryRaysAreExactlyPixelsTimesSamples) {
  for (const int samples : {1, 2, 7, 16})
    for (std::uint64_t seed = 0; seed < 3; ++seed)
      EXPECT_EQ(picture(any_scene(seed), 33, 21, sampling(samples)).rays.primary,
                33 * 21 * samples);
}

TEST(Samples, ThresholdLeavesEvenPixelsAtTheFirstRound) {
  Scene scene;
  scene.background = {0.3, 0.6, 7};  // beyond 1 as well: what is shown is even
  EXPECT_EQ(picture(scene, 33, 21, sampling(1, 1e-6)).rays.primary, 33 * 21 * 4);
  EXPECT_EQ(picture(scene, 33, 21, sampling(9, 1e-6)).rays.primary, 33 * 21 * 9);
}

// Whether a pixel's rays see a black ball on the axis is found by its angle.
TEST(Samples, ThresholdTakesRoundsUntilThePixelsOwnErrorIsBelowIt) {
  constexpr int width = 40, height = 30;
  const Scene scene = black_ball({0, 0, -20}, 3);
  for (const auto& [samples, threshold] : {std::pair{4, 0.03}, {6, 0.1}, {1, 0.2}}) {
    // The rule, applied to the same rays by hand: light is 0 or 1, of m ones in n the standard
    // error is sqrt(m (n - m) / n^2 / (n - 1)).
    const Sampler sampler(samples, threshold, 42);
    const View view = view_of(scene.camera, width, height);
    std::int64_t rays = 0;
    const Image image = picture(scene, width, height, sampling(samples, threshold)).image;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        int n = 0, ones = 0;
        const int first = std::max(samples, 4);
        for (int until = first; until <= 16 * first; until *= 2) {
          for (; n < until; ++n) {
            const Aim<float> aim = sampler.aim(x, y, n);
            const Ray<float> ray = Eye<float>(view).ray(
                view.column(static_cast<float>(x)) + view.row(static_cast<float>(y)), aim);
            const double cosine = -ray.direction.z, sine = 3.0 / 20;
            ones += cosine * cosine < 1 - sine * sine;
          }
          const double p = static_cast<double>(ones) / n;
          if (std::sqrt(p * (1 - p) / (n - 1)) <= threshold) break;
        }
        rays += n;
        EXPECT_EQ(image.at(x, y)[0], static_cast<float>(static_cast<double>(ones) / n));
      }
    }
    EXPECT_EQ(picture(scene, width, height, sampling(samples, threshold)).rays.primary, rays);
    EXPECT_GT(rays, width * height * std::max(samples, 4));
  }
}

TEST(Samples, RaysBeyondTheLimitEndThePicture) {
  using enum FaultKind;
  const Scene scene = test::thesis_scene('a');
  for (RenderOptions options : {sampling(1), sampling(4), sampling(2, 0.01)}) {
    const RayCounts rays = picture(scene, 64, 48, options).rays;
    options.max_rays = rays.primary + rays.shadow;
    options.threads = 3;
    EXPECT_EQ(picture(scene, 64, 48, options).rays, rays) << "the limit itself is allowed";
    --options.max_rays;
    test::expect_faults(
        test::faults_of([&] { picture(scene, 64, 48, options); }),
        {{limit, "/samples", "\"a picture of more\"",
          "at most " + std::to_string(options.max_rays) + " rays (option TIA_MAX_RAYS)"}});
  }
}

TEST(Samples, LimitAndStopAreSeenWithinOneTile) {
  // 65536 samples of 1024 pixels: 67 million rays, all in one tile.
  const World world = compile(test::thesis_scene('a'));
  const View view = view_of(Camera{}, 32, 32);
  Pool pool(1);
  RenderOptions options = sampling(65536);
  options.max_rays = 1000;
  const auto nothing = [](const FilmTile&) {};
  EXPECT_THROW(render(world, view, {0, 0, 32, 32}, options, pool, {}, nothing), InputError);

  RayCounts many;
  many.primary = RayMeter::often;
  std::stop_source source;
  RayMeter meter(1LL << 60, 1LL << 60, source.get_token());
  EXPECT_NO_THROW(meter.add_if_many(many));
  EXPECT_EQ(many.primary, 0);
  EXPECT_EQ(meter.counts().primary, RayMeter::often);
  many.shadow = RayMeter::often;
  source.request_stop();
  EXPECT_THROW(meter.add_if_many(many), Stopped);
}

// ---- areas --------------------------------------------------------------------------------------

double covered_pixels(const Image& image) {
  double sum = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3) sum += 1 - image.rgb[i];
  return sum;
}

// Strata leave each pixel of an outline an independent error of variance below n^-1.5 / 4 (sqrt(n)
// cells cut, each of variance at most 1/4 / n^2, twice that for a slanting edge): five deviations
// of an outline of that many pixels.
double coverage_bound(double outline_pixels, int n) {
  return 5 * std::sqrt(outline_pixels * 2 * std::pow(n, -1.5) / 4);
}

TEST(Samples, BallsOffTheAxisCoverTheirEllipse) {
  // The cone of half angle a (sin a = r/d) about an axis at angle b from the view cuts the plane
  // z = -1 in the ellipse k (x - x0)^2 + cos^2 a y^2 = cos^2 a sin^2 a / k, k = cos^2 a - sin^2 b:
  // its area is pi cos a sin^2 a / k^(3/2).
  Random random(101);
  constexpr int width = 160, height = 120, n = 16;
  const double pixel = 2 * std::tan(12.5 * (pi / 180)) / height;
  for (int i = 0; i < 10; ++i) {
    const double depth = random.in(5, 30), sideways = random.in(-0.12, 0.12) * depth;
    const Vec3d center{sideways, random.in(-0.06, 0.06) * depth, -depth};
    const double d = length(center), radius = random.in(0.02, 0.1) * depth;
    const double sine = radius / d, cosine = std::sqrt(1 - sine * sine);
    const double k = cosine * cosine - 1 + depth * depth / (d * d);
    const double area = pi * cosine * sine * sine / std::pow(k, 1.5) / (pixel * pixel);
    const Image image = picture(black_ball(center, radius), width, height, sampling(n)).image;
    EXPECT_NEAR(covered_pixels(image), area, coverage_bound(4 * std::sqrt(area * pi), n)) << i;
  }
}

TEST(Samples, OrthographicBallsCoverTheirDiscWhereverTheyStand) {
  // Of a circle of R pixels' radius the pixel centres inside differ from pi R^2 by less than the
  // pixels that its outline crosses, at most 8 R + 4 (Gauss' circle problem).
  Random random(102);
  constexpr int width = 160, height = 120, n = 16;
  for (int i = 0; i < 10; ++i) {
    const double radius = random.in(0.3, 3);
    Scene scene = black_ball({random.in(-4, 4), random.in(-1.5, 1.5), random.in(-500, -4)}, radius);
    scene.camera.projection = Projection::orthographic;
    scene.camera.height = 10;
    const double in_pixels = radius * height / 10, area = pi * in_pixels * in_pixels;
    EXPECT_NEAR(covered_pixels(picture(scene, width, height, sampling(1)).image), area,
                8 * in_pixels + 4);
    EXPECT_NEAR(covered_pixels(picture(scene, width, height, sampling(n)).image), area,
                coverage_bound(8 * in_pixels + 4, n));
  }
}

// ---- the lens -----------------------------------------------------------------------------------

TEST(Samples, BallOutOfFocusCoversTheDiscOfConfusionAndKeepsItsLight) {
  // A small ball at z, the lens focused at f: its points meet the plane of focus in discs of
  // A/2 |z - f| / z, a pixel's side there being f times that at distance 1. The light of the ball
  // seen sharp, as many rays as its area times n, is spread: at most chance's error, 1/sqrt(rays),
  // and (A/2z)^2 = 0.2 % for the lens' edge seeing it from aside.
  constexpr int side = 101, n = 400, cut = 30;
  constexpr double z = 10, aperture = 0.8, ball = 0.1;
  Scene scene = black_ball({0, 0, -z}, ball);
  const double pixel = 2 * std::tan(12.5 * (pi / 180)) / side, own = ball / z / pixel;
  const double area = pi * own * own;
  scene.camera.aperture = aperture;
  for (const double focus : {6.0, 16.0}) {
    scene.camera.focus_distance = focus;
    const Window middle{cut, cut, side - cut, side - cut};
    const Image image = picture(scene, side, side, middle, sampling(n)).image;
    const double confusion = aperture / 2 * std::fabs(z - focus) / z / (pixel * focus);
    double farthest = 0;
    for (int y = 0; y < image.height; ++y)
      for (int x = 0; x < image.width; ++x)
        if (image.at(x, y)[0] < 1)
          farthest = std::max(farthest, std::hypot(x - image.width / 2, y - image.height / 2));
    EXPECT_LE(farthest, confusion + own + 1) << "1 for the pixel's own corner";
    EXPECT_GE(farthest, confusion + own - 1);
    EXPECT_NEAR(covered_pixels(image), area, area * (5 / std::sqrt(area * n) + 0.002)) << focus;
  }
}

TEST(Samples, BallInFocusIsAsSharpAsThroughAPinhole) {
  // Its outline lies in the plane of focus but for r^2 / z: 0.25 / 20, blurred by 0.02 pixels.
  Scene scene = black_ball({0, 0, -20}, 0.5);
  const Image pinhole = picture(scene, 120, 90, sampling(64)).image;
  scene.camera.aperture = 0.5;
  scene.camera.focus_distance = 20;
  const Image lens = picture(scene, 120, 90, sampling(64)).image;
  for (std::size_t i = 0; i < lens.rgb.size(); ++i) EXPECT_NEAR(lens.rgb[i], pinhole.rgb[i], 0.08);
}

}  // namespace
}  // namespace tia
