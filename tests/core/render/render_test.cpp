#include "core/render/render.h"

#include <gtest/gtest.h>

#include <array>
#include <set>

#include "core/math/deterministic.h"
#include "tests/core/random_scene.h"

namespace tia {
namespace {

using test::bits_of;
using test::picture;
using test::Random;

RenderOptions options_of(Scalar scalar, int threads = 1, int tile = FilmTile::size) {
  RenderOptions options;
  options.scalar = scalar;
  options.threads = threads;
  options.tile = tile;
  return options;
}

// ---- a pixel depends on the scene and itself alone --------------------------------------------

TEST(Render, WideEqualsNarrowBitForBit) {
  Random random(60);
  for (std::uint64_t seed = 0; seed < 60; ++seed) {
    const Scene scene = test::random_scene(seed, 20);
    const int width = 1 + random.below(120), height = 1 + random.below(90);
    const auto wide = picture(scene, width, height, options_of(Scalar::wide));
    const auto narrow = picture(scene, width, height, options_of(Scalar::narrow));
    ASSERT_EQ(bits_of(wide.image), bits_of(narrow.image)) << "seed " << seed;
    EXPECT_EQ(wide.rays, narrow.rays) << "seed " << seed;
  }
}

TEST(Render, WideEqualsNarrowBitForBitForEveryKey) {
  for (const char key : {'\0', 'a', 'd', 's', 'w'}) {
    const Scene scene = test::thesis_scene(key);
    const auto wide = picture(scene, 640, 480, options_of(Scalar::wide));
    const auto narrow = picture(scene, 640, 480, options_of(Scalar::narrow));
    ASSERT_EQ(bits_of(wide.image), bits_of(narrow.image)) << key;
    EXPECT_EQ(wide.rays, narrow.rays) << key;
  }
}

// No multiple of any tile. A quarter where the sanitizers would take minutes.
const int odd_width = test::sanitized() ? 101 : 203, odd_height = test::sanitized() ? 75 : 151;

void expect_same_bytes_on_any_tile(const Scene& scene, const std::vector<int>& thread_counts) {
  const auto alone = picture(scene, odd_width, odd_height);
  const std::string pfm = encode_pfm(alone.image);
  for (const int threads : thread_counts) {
    for (const int tile : {32, 16, 7, 1}) {
      const auto other =
          picture(scene, odd_width, odd_height, options_of(Scalar::wide, threads, tile));
      EXPECT_TRUE(encode_pfm(other.image) == pfm) << threads << " threads, tile " << tile;
      EXPECT_EQ(other.rays, alone.rays) << threads << " threads, tile " << tile;
    }
  }
}

TEST(Render, ThreadsAndTilesNeverChangeAByte) {
  for (const char key : {'\0', 'a', 'd', 's', 'w'}) {
    if (test::sanitized() && key != 'a') continue;
    expect_same_bytes_on_any_tile(test::thesis_scene(key), {1, 2, 7});
  }
  for (std::uint64_t seed = 0; seed < (test::sanitized() ? 1U : 6U); ++seed)
    expect_same_bytes_on_any_tile(test::random_scene(seed, 30), {1, 7});
}

// What a tile leaves out depends on which it is; a pixel must not, though the float rays stray from
// the exact ones: far from the origin, where the eye itself is rounded ...
TEST(Render, TilesNeverChangeAByteHoweverFarOutTheEye) {
  for (const double far : {1e5, 1e7, 1e8}) {
    const Vec3d out{far, -0.3 * far + 0.07, 2 * far - 0.011};
    for (std::uint64_t seed = 60; seed < 63; ++seed) {
      SCOPED_TRACE(far);
      Scene scene = test::random_scene(seed, 30);
      scene.camera.location = scene.camera.location + out;
      if (scene.camera.look_at) *scene.camera.look_at = *scene.camera.look_at + out;
      for (Object& object : scene.objects.edit()) {
        auto& sphere = std::get<Sphere>(object.shape);
        sphere.center = sphere.center + out;
      }
      expect_same_bytes_on_any_tile(scene, {1});
    }
  }
}

// ... and in a view so narrow that a pixel is smaller than a float's step of direction.
TEST(Render, TilesNeverChangeAByteHoweverNarrowTheView) {
  for (const double fov : {1e-2, 1e-4, 1e-5}) {
    SCOPED_TRACE(fov);
    Random random(63);
    Scene scene;
    scene.camera.direction = Vec3d{1, 0.7, -0.9};
    scene.camera.fov_degrees = fov;
    scene.background = {0.5, 0.25, 1};
    const Vec3d axis = normalize(*scene.camera.direction);
    for (int i = 0; i < 3; ++i) {  // balls whose outlines pass through the view
      const Vec3d aside = normalize(cross(axis, random.direction()));
      const double radius = random.in(5, 20), pixels = random.in(0, 0.3) * fov * (pi / 180);
      scene.objects.push_back(test::ball(axis * 20.0 + aside * (radius * (1 + pixels)), radius));
    }
    scene.lights.push_back(test::point_light({0, 0, 0}));
    expect_same_bytes_on_any_tile(scene, {1});
  }
}

TEST(Render, WindowEqualsTheFullPicturesWindow) {
  Random random(64);
  const int width = odd_width, height = odd_height;
  for (std::uint64_t seed = 61; seed < 65; ++seed) {
    const Scene scene = seed == 61 ? test::thesis_scene('a') : test::random_scene(seed, 30);
    const Image full = picture(scene, width, height).image;
    for (int i = 0; i < 20; ++i) {
      Window window{random.below(width), random.below(height), 0, 0};
      window.x1 = window.x0 + 1 + random.below(width - window.x0);
      window.y1 = window.y0 + 1 + random.below(height - window.y0);
      const Image part = picture(scene, width, height, window).image;
      Image cut(window.width(), window.height());
      for (int y = 0; y < cut.height; ++y)
        std::copy_n(full.at(window.x0, window.y0 + y), 3 * cut.width, cut.at(0, y));
      EXPECT_TRUE(bits_of(part) == bits_of(cut)) << window.x0 << ", " << window.y0;
    }
  }
}

TEST(Render, RaysOfWindowsAddUpToThePicturesRays) {
  const Scene scene = test::thesis_scene('s');
  RayCounts sum;
  for (const Window& window : {Window{0, 0, 77, 60}, {77, 0, 200, 60}, {0, 60, 200, 150}}) {
    const RayCounts rays = picture(scene, 200, 150, window).rays;
    sum.primary += rays.primary;
    sum.shadow += rays.shadow;
  }
  EXPECT_EQ(sum, picture(scene, 200, 150).rays);
}

TEST(Render, BlocksCoverTheWindowOnceAndStandInItsCoordinates) {
  const Scene scene = test::thesis_scene();
  const Window window{5, 9, 106, 80};
  std::set<std::pair<int, int>> seen;
  Pool pool(1);
  render(compile(scene), view_of(scene.camera, 300, 200), window, options_of(Scalar::wide, 1, 16),
         pool, {}, [&](const FilmTile& tile) {
           for (int y = tile.y; y < tile.y + tile.height; ++y)
             for (int x = tile.x; x < tile.x + tile.width; ++x)
               EXPECT_TRUE(seen.emplace(x, y).second) << x << ", " << y;
         });
  EXPECT_EQ(seen.size(), static_cast<std::size_t>(window.width() * window.height()));
  EXPECT_EQ(*seen.begin(), std::pair(0, 0));
  EXPECT_EQ(*seen.rbegin(), std::pair(window.width() - 1, window.height() - 1));
}

// ---- symmetry and scale -----------------------------------------------------------------------

std::vector<std::uint32_t> mirrored_bits(const Image& image) {
  Image mirror(image.width, image.height);
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      std::copy_n(image.at(image.width - 1 - x, y), 3, mirror.at(x, y));
  return bits_of(mirror);
}

Image8 thesis_codes(char key, int width, int height) {
  const Scene scene = test::thesis_scene(key);
  DisplayFilm film(width, height, Transfer::srgb);
  Pool pool(1);
  render(compile(scene), view_of(scene.camera, width, height), {0, 0, width, height}, {}, pool, {},
         [&](const FilmTile& tile) { film.put(tile); });
  return film.image();
}
using Pixel = std::array<std::uint8_t, 3>;
Pixel pixel_of(const Image8& image, int x, int y) {
  const auto i = static_cast<std::size_t>(3 * (y * image.width + x));
  return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

TEST(Render, PictureDIsTheMirrorOfA) {
  for (const auto& [width, height] : {std::pair{640, 480}, {333, 217}, {64, 100}}) {
    const Image a = picture(test::thesis_scene('a'), width, height).image;
    const Image d = picture(test::thesis_scene('d'), width, height).image;
    EXPECT_TRUE(bits_of(d) == mirrored_bits(a)) << width << " x " << height;
    EXPECT_FALSE(bits_of(d) == bits_of(a)) << "a light from the side shows";
    const Image8 codes_a = thesis_codes('a', width, height),
                 codes_d = thesis_codes('d', width, height);
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x)
        ASSERT_EQ(pixel_of(codes_a, x, y), pixel_of(codes_d, width - 1 - x, y)) << x << ", " << y;
  }
}

TEST(Render, PicturesSAndWAreTheirOwnMirrors) {
  for (const char key : {'\0', 's', 'w'}) {
    const Image image = picture(test::thesis_scene(key), 640, 480).image;
    EXPECT_TRUE(bits_of(image) == mirrored_bits(image)) << key;
  }
}

Scene scaled(Scene scene, double factor) {
  scene.camera.location = scene.camera.location * factor;
  if (scene.camera.look_at) *scene.camera.look_at = *scene.camera.look_at * factor;
  for (Object& object : scene.objects.edit()) {
    auto& sphere = std::get<Sphere>(object.shape);
    sphere = {sphere.center * factor, sphere.radius * factor};
  }
  const auto scale_light = [&](Light& light) {
    if (light.place()) light.move_to(*light.place() * factor, {});
    if (auto* ball = std::get_if<SphereLight>(&light.kind)) ball->radius *= factor;
  };
  for (Light& light : scene.lights) scale_light(light);
  if (scene.key_light) scale_light(*scene.key_light);
  return scene;
}

TEST(Render, ScalingTheWorldByAPowerOfTwoChangesNoBit) {
  // Every length shifts its exponent; no sum, root or comparison notices.
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Scene scene = seed == 0 ? test::thesis_scene('a') : test::random_scene(seed);
    const auto bits = bits_of(picture(scene, 120, 90).image);
    for (const double factor : {0x1p-10, 0x1p10})
      EXPECT_TRUE(bits_of(picture(scaled(scene, factor), 120, 90).image) == bits) << seed;
  }
}

TEST(Render, ScalingTheWorldBetweenAThousandthAndAThousandLeavesThePicture) {
  // Other factors round differently: a few edge pixels may fall to the other side.
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Scene scene = seed == 0 ? test::thesis_scene('a') : test::random_scene(seed);
    const Image image = picture(scene, 160, 120).image;
    for (const double factor : {1e-3, 1e3}) {
      const Image other = picture(scaled(scene, factor), 160, 120).image;
      int moved = 0;
      for (std::size_t i = 0; i < image.rgb.size(); ++i)
        moved += !(std::fabs(image.rgb[i] - other.rgb[i]) < 1e-4F);
      EXPECT_LE(moved, 3 * 4) << "seed " << seed << ", factor " << factor;
    }
  }
}

}  // namespace
}  // namespace tia
