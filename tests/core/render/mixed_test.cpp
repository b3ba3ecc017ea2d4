// A pixel of a world of all kinds of things depends on the scene and itself alone, for every
// integrator, lens and number of samples.
#include <gtest/gtest.h>

#include "tests/core/accel/worlds.h"

namespace tia {
namespace {

using test::bits_of;
using test::picture;
using test::Random;

const int mixed_width = test::sanitized() ? 43 : 67, mixed_height = test::sanitized() ? 31 : 45;

Scene mixed(std::uint64_t seed) {
  Random random(seed);
  Scene scene = test::mixed_scene(random, 150, 1);
  for (Object& object : scene.objects.edit())
    if (random.chance(0.8))
      object.material = random.chance(0.3) ? Material{test::random_principled(random)}
                                           : test::matte(test::random_color(random));
  scene.background = {0.1, 0.2, 0.3};
  scene.camera.location = {3, 4, 25};
  scene.camera.look_at = Vec3d{0, -1, 0};
  scene.camera.fov_degrees = 50;
  scene.lights = {test::point_light({9, 20, 20}), test::sphere_light({-14, 9, 9}, 1)};
  return scene;
}

std::vector<IntegratorName> integrators() {
  std::vector<IntegratorName> all;
  for (std::size_t i = 0; i < Names<IntegratorName>::names.size(); ++i)
    all.push_back(static_cast<IntegratorName>(i));
  return all;
}

RenderOptions options_for(IntegratorName integrator) {
  RenderOptions options;
  options.integrator = integrator;
  return options;
}

TEST(MixedPicture, WideEqualsNarrowBitForBitForEveryIntegrator) {
  for (const IntegratorName integrator : integrators()) {
    const Scene scene = mixed(600);
    RenderOptions options = options_for(integrator);
    const auto wide = picture(scene, mixed_width, mixed_height, options);
    options.scalar = Scalar::narrow;
    const auto narrow = picture(scene, mixed_width, mixed_height, options);
    EXPECT_TRUE(bits_of(wide.image) == bits_of(narrow.image)) << int(integrator);
    EXPECT_EQ(wide.rays, narrow.rays);
  }
}

TEST(MixedPicture, WideEqualsNarrowWithALensManySamplesAndParallelRays) {
  Scene lens = mixed(601), parallel = mixed(601);
  lens.camera.aperture = 0.5;
  lens.camera.focus_distance = 25;
  parallel.camera.projection = Projection::orthographic;
  parallel.camera.height = 20;
  for (const Scene& scene : {lens, parallel}) {
    RenderOptions options;
    options.samples = 5;
    const auto wide = picture(scene, mixed_width, mixed_height, options);
    options.scalar = Scalar::narrow;
    EXPECT_TRUE(bits_of(wide.image) ==
                bits_of(picture(scene, mixed_width, mixed_height, options).image));
  }
}

TEST(MixedPicture, ThreadsAndTilesNeverChangeAByteOfAnyIntegrator) {
  const Scene scene = mixed(602);
  for (const IntegratorName integrator : integrators()) {
    RenderOptions options = options_for(integrator);
    const auto alone = picture(scene, mixed_width, mixed_height, options);
    for (const auto& [threads, tile] : {std::pair{2, 32}, {7, 32}, {1, 7}, {7, 7}}) {
      if (test::sanitized() && threads != 7) continue;
      options.threads = threads;
      options.tile = tile;
      const auto other = picture(scene, mixed_width, mixed_height, options);
      EXPECT_TRUE(bits_of(other.image) == bits_of(alone.image)) << threads << " " << tile;
      EXPECT_EQ(other.rays, alone.rays);
    }
  }
}

TEST(MixedPicture, WindowIsTheFullPicturesWindowWithAThreshold) {
  const Scene scene = mixed(603);
  RenderOptions options;
  options.samples = 4;
  options.threshold = 0.05;
  for (const IntegratorName integrator : {IntegratorName::thesis, IntegratorName::shadow}) {
    options.integrator = integrator;
    const Image full = picture(scene, mixed_width, mixed_height, options).image;
    const Window window{13, 9, 38, 26};
    const Image part = picture(scene, mixed_width, mixed_height, window, options).image;
    Image cut(window.width(), window.height());
    for (int y = 0; y < cut.height; ++y)
      std::copy_n(full.at(window.x0, window.y0 + y), 3 * cut.width, cut.at(0, y));
    EXPECT_TRUE(bits_of(part) == bits_of(cut));
  }
}

TEST(MixedPicture, IsTheOneWithoutAnIndex) {
  const Scene scene = mixed(604);
  const World world = compile(scene), brute = test::without_index(world);
  const int width = test::sanitized() ? 20 : 40, height = 3 * width / 4;
  const View view = view_of(scene.camera, width, height);
  Pool pool(1);
  const auto image_of = [&](const World& each, IntegratorName integrator) {
    LinearFilm film(width, height);
    render(each, view, {0, 0, width, height}, options_for(integrator), pool, {},
           [&](const FilmTile& tile) { film.put(tile); });
    return film.image();
  };
  for (const IntegratorName integrator : integrators()) {
    if (integrator == IntegratorName::cost) continue;
    const Image image = image_of(world, integrator);
    EXPECT_TRUE(bits_of(image) == bits_of(image_of(brute, integrator))) << int(integrator);
  }
}

// Where parts differ in order alone, a pixel changes only where two surfaces are met at one t.
TEST(MixedPicture, OrderOfTheObjectsIsOfNoAccount) {
  Random random(605);
  Scene scene = mixed(605);
  const Image image = picture(scene, mixed_width, mixed_height).image;
  for (std::size_t i = scene.objects.size(); i > 1; --i)
    std::swap(scene.objects[i - 1],
              scene.objects[static_cast<std::size_t>(random.below(static_cast<int>(i)))]);
  const Image shuffled = picture(scene, mixed_width, mixed_height).image;
  int differences = 0;
  for (std::size_t i = 0; i < image.rgb.size(); i += 3)
    differences += !std::equal(&image.rgb[i], &image.rgb[i] + 3, &shuffled.rgb[i]);
  EXPECT_LE(differences, 3);
}

}  // namespace
}  // namespace tia
