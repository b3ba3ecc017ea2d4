// Layers: the parts of a path's light in closed form, and that nothing but the scene decides.
#include "core/render/layers.h"

#include <gtest/gtest.h>

#include <numbers>

#include "core/render/layer_film.h"
#include "tests/core/film/exr_reader.h"
#include "tests/core/tree.h"

namespace tia::test {
namespace {

constexpr LayerSet of_samples{Layer::rgba,     Layer::direct,   Layer::indirect,
                              Layer::emission, Layer::variance, Layer::samples};

std::string layers_of(const Scene& scene, const RenderOptions& options, int width, int height) {
  const World world = compile(scene);
  Pool pool(options.threads);
  LayerFilm film(width, height, options.layers, scene.backdrop.has_value());
  render(world, view_of(scene.camera, width, height), {0, 0, width, height}, options, pool, {},
         [&](const FilmTile& tile) { film.put(tile); });
  return film.encode({.width = width, .height = height, .channels = {}, .texts = {}}, ExrType::real,
                     {});
}
RenderOptions with_layers(int samples) {
  RenderOptions options;
  options.integrator = IntegratorName::path;
  options.max_depth = 16;
  options.samples = samples;
  options.layers = of_samples;
  return options;
}

// Matt and mirroring, clear glass, a lamp, a sky and fog.
Scene foggy_room() {
  Scene scene;
  scene.background = {0.2, 0.3, 0.4};
  scene.objects.push_back(ball({0, 0, -7}, 1.5, {mirror(0.5)}));
  scene.objects.push_back(ball({2, 0, -6}, 1, matte({1, 0.5, 0.2})));
  scene.objects.push_back(ball({-2, 0, -6}, 0.8, {clear_glass(1.5)}));
  scene.objects.push_back(ball({0, -1001, -7}, 1000, matte({0.5, 0.5, 0.5})));
  scene.lights.push_back(sphere_light({0, 4, -5}, 1, {5, 5, 5}));
  scene.fog = Fog{};
  scene.fog->density = 0.05;
  return scene;
}

TEST(LayersOfRender, AreTheSameBytesForAllThreadsTilesAndLanes) {
  const Scene scene = foggy_room();
  RenderOptions options = with_layers(3);
  const std::string expected = layers_of(scene, options, 37, 34);
  options.threads = 3;
  options.tile = 16;
  EXPECT_EQ(layers_of(scene, options, 37, 34), expected);
  options.scalar = Scalar::narrow;
  EXPECT_EQ(layers_of(scene, options, 37, 34), expected);
  const ExrFile file = read_exr(expected);
  for (std::size_t i = 0; i < 37 * 34; ++i) {
    const auto at = [&](const char* name) { return file.numbers.at(name)[i]; };
    ASSERT_NEAR(at("direct.G") + at("indirect.G") + at("emission.G"), at("G"), 1e-6 * at("G"));
  }
}

// Each round is the file of as many samples.
TEST(LayersOfRender, AreTheSameWhoeverWatches) {
  const Scene scene = foggy_room();
  RenderOptions options = with_layers(16);
  std::vector<std::string> seen;
  options.watch = [&](const Glimpse& glimpse) {
    LayerFilm film(37, 34, of_samples, false);
    glimpse.show([&](const FilmTile& tile) { film.put(tile); });
    seen.push_back(
        film.encode({.width = 37, .height = 34, .channels = {}, .texts = {}}, ExrType::real, {}));
  };
  EXPECT_EQ(layers_of(scene, options, 37, 34), layers_of(scene, with_layers(16), 37, 34));
  ASSERT_EQ(seen.size(), 4U);  // of 1, 2, 4, 8
  EXPECT_EQ(seen[2], layers_of(scene, with_layers(4), 37, 34));
}

TEST(LayersOfRender, ThoseOfOneRayThroughTheCentreAreItsOwn) {
  const ExrFile file = read_exr(layers_of(foggy_room(), with_layers(1), 16, 12));
  RenderOptions plain = with_layers(1);
  plain.layers = {};
  const Image image = picture(foggy_room(), 16, 12, plain).image;
  for (std::size_t i = 0; i < 16 * 12; ++i) {
    ASSERT_EQ(file.numbers.at("R")[i], static_cast<double>(image.rgb[3 * i]));
    ASSERT_EQ(file.numbers.at("samples")[i], 1);
  }
}

/// What a pixel's light consists of, all along one ray.
struct Parts {
  double direct, indirect, emission, all;
};
Parts parts_of(const Scene& scene, int max_depth = 16) {
  RenderOptions options = with_layers(16);
  options.max_depth = max_depth;
  const ExrFile file = read_exr(layers_of(scene, options, 1, 1));
  const auto at = [&](const char* name) { return file.numbers.at(name)[0]; };
  return {at("direct.G"), at("indirect.G"), at("emission.G"), at("G")};
}
Scene looking_down_at(const Material& material, const Light& light) {
  Scene scene;
  scene.camera.location = {0, 2, 0};
  scene.camera.direction = {0, -1, 0};
  scene.camera.up = Vec3d{1, 0, 0};
  scene.camera.fov_degrees = 1e-3;
  scene.objects.push_back({"", Plane{{0, 0, 0}, {0, 1, 0}}, {}, MaterialRef(material)});
  scene.lights.push_back(light);
  return scene;
}

// A point of intensity 10 at a distance of 3 over a matt floor: 10 rho / (pi 9), all of it direct.
TEST(PartsOfLight, ALampOverAFloorIsDirect) {
  const Parts parts =
      parts_of(looking_down_at(matte({1, 0.5, 1}), point_light({0, 3, 0}, {10, 10, 10})));
  const double albedo = 0.5 * Finish{}.diffuse;
  EXPECT_NEAR(parts.direct, 10 * albedo / (std::numbers::pi * 9), 1e-6);
  EXPECT_EQ(parts.direct, parts.all);
  EXPECT_EQ(parts.indirect, 0);
  EXPECT_EQ(parts.emission, 0);
}

// What shines in a mirror is seen to shine, however often it is mirrored; what a mirror shows of a
// floor that a lamp lights has come to that floor straight.
TEST(PartsOfLight, MirrorsShowWhatTheyShowAsItIs) {
  Scene shining = looking_down_at({mirror(1)}, point_light({0, 1, 0}));
  shining.objects.push_back(ball({0, 9, 0}, 1, matte({0, 0, 0}, {3, 2, 1})));
  const Parts seen = parts_of(shining);
  EXPECT_GT(seen.emission, 1);
  EXPECT_EQ(seen.emission, seen.all);
  EXPECT_EQ(seen.direct + seen.indirect, 0);

  Scene ceiling = looking_down_at({mirror(1)}, point_light({0, 5, 0}, {10, 10, 10}));
  ceiling.objects.push_back(
      {"", Plane{{0, 9, 0}, {0, -1, 0}}, {}, MaterialRef(matte({0, 0.5, 0}))});
  const Parts mirrored = parts_of(ceiling, 2);  // what the mirror gives back to it comes later
  EXPECT_GT(mirrored.direct, 0.01);
  EXPECT_EQ(mirrored.direct, mirrored.all);
}

// In a furnace, walls of albedo rho and emission 1, each bounce is rho of the one before: 1 is
// seen, rho comes straight, rho^2 + rho^3 ... = rho^2 / (1 - rho) by way of others. A sphere around
// the eye is one: every ray meets it.
TEST(PartsOfLight, AFurnacesSharesAreItsGeometricSeries) {
  Scene furnace;
  furnace.objects.push_back(ball({0, 0, 0}, 5, matte({0.5, 0.5, 0.5}, {1, 1, 1})));
  RenderOptions options = with_layers(256);
  options.max_depth = 40;
  const ExrFile file = read_exr(layers_of(furnace, options, 8, 8));
  const auto mean = [&](const char* name) {
    double sum = 0;
    for (const double number : file.numbers.at(name)) sum += number;
    return sum / 64;
  };
  const double albedo = mean("direct.G");  // 0.5 times the share that a finish scatters
  EXPECT_NEAR(mean("emission.G"), 1, 1e-6);
  EXPECT_GT(albedo, 0.2);
  EXPECT_NEAR(mean("indirect.G"), albedo * albedo / (1 - albedo), 0.02 * albedo);
}

}  // namespace
}  // namespace tia::test
