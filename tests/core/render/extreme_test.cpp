// Scenes at the ends of what the reader lets in: the picture stays a picture.
#include <gtest/gtest.h>

#include "tests/core/random_scene.h"

namespace tia {
namespace {

using test::picture;
using test::Random;

// A length of any magnitude up to the format's 1e9.
double any_length(Random& random) { return std::pow(10.0, random.in(-12, 9)); }
Vec3d vector_of_any_length(Random& random) {
  const double size = any_length(random);
  return random.vector(size, size);
}

// Random values of all magnitudes, read like any other scene.
Scene extreme_scene(std::uint64_t seed) {
  Random random(seed);
  Scene scene;
  scene.camera.location = vector_of_any_length(random);
  scene.camera.direction = vector_of_any_length(random);
  scene.camera.up = vector_of_any_length(random);
  scene.camera.fov_degrees =
      random.chance(0.5) ? random.in(1, 179) : std::pow(10, random.in(-9, 0));
  scene.background = {1e6 * random.unit(), random.unit(), 0};
  for (int i = random.below(6); i >= 0; --i) {
    const Vec3d ahead =
        random.chance(0.5)
            ? scene.camera.location + normalize(*scene.camera.direction) * any_length(random)
            : vector_of_any_length(random);
    const double bound = 1e9;
    const Vec3d center{std::clamp(ahead.x, -bound, bound), std::clamp(ahead.y, -bound, bound),
                       std::clamp(ahead.z, -bound, bound)};
    const double radius = any_length(random), green = random.unit(), glow = random.unit();
    scene.objects.push_back(test::ball(center, radius, test::matte({1e6, green, 0}, {0, 0, glow})));
  }
  for (int i = random.below(3); i >= 0; --i) {
    const Vec3d place = vector_of_any_length(random);
    scene.lights.push_back(test::point_light(place, {1e6, 1, random.unit()}));
    scene.lights.back().intensity = std::pow(10, random.in(-6, 6));
  }
  if (random.chance(0.3)) {  // a light exactly where something else is
    scene.lights.push_back(test::point_light(scene.camera.location));
    scene.lights.push_back(test::point_light(std::get<Sphere>(scene.objects[0].shape).center));
  }
  return read_scene(canonical_text(scene));
}

TEST(Extreme, NoSceneThatCanBeReadGivesNaNOrInfiniteOrNegativeLight) {
  RenderOptions narrow;
  narrow.scalar = Scalar::narrow;
  int hits = 0;
  for (std::uint64_t seed = 0; seed < 1000; ++seed) {
    const Scene scene = extreme_scene(seed);
    const auto wide = picture(scene, 21, 17);
    for (const float value : wide.image.rgb) {
      ASSERT_TRUE(std::isfinite(value) && value >= 0) << "seed " << seed << ": " << value;
      hits += value != static_cast<float>(scene.background.r);
    }
    ASSERT_EQ(test::bits_of(wide.image), test::bits_of(picture(scene, 21, 17, narrow).image));
  }
  EXPECT_GT(hits, 10'000);
}

TEST(Extreme, ALampNearerThanFloatCanTellGivesNoInfiniteLight) {
  Scene scene;
  scene.objects = {test::ball({0, 0, -1e-25}, 2e-26, test::matte({1, 1, 1}))};
  scene.lights = {test::point_light({1e-25, 1e-25, 0})};
  for (const float value : picture(scene, 64, 48).image.rgb) ASSERT_TRUE(std::isfinite(value));
}

TEST(Extreme, ViewPlanesSizeChangesNoBit) {
  // A power of two shifts exponents only; the ray has unit length after all.
  Scene scene = test::random_scene(160);
  scene.camera = Camera{};
  scene.camera.direction = Vec3d{0, 0, -1};
  scene.camera.right = Vec3d{0.5, 0, 0};
  scene.camera.up = {0, 0.375, 0};
  const auto bits = test::bits_of(picture(scene, 80, 60).image);
  for (const double factor : {0x1p20, 0x1p-20, 0x1p-60, 0x1p-80, 0x1p-200}) {
    Scene other = scene;
    other.camera.direction = Vec3d{0, 0, -factor};
    other.camera.right = Vec3d{0.5 * factor, 0, 0};
    other.camera.up = {0, 0.375 * factor, 0};
    EXPECT_TRUE(test::bits_of(picture(other, 80, 60).image) == bits) << factor;
  }
}

}  // namespace
}  // namespace tia
