// The tree of a pixel: its terms add up, in their order, to the picture's own colour, bit for bit.
#include <gtest/gtest.h>

#include "tests/core/tree.h"

namespace tia {
namespace {

using namespace test;

// Everything at once: glass, mirrors, textures, areas, spots, fading.
Scene everything() {
  return read_scene(R"({
    "camera": {"location": [0, 2, 7], "look_at": [0, 0.8, 0], "fov_degrees": 45},
    "background": [0.3, 0.5, 0.9], "ambient_light": [0.9, 1, 1.1],
    "objects": [
      {"type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0],
       "material": {"texture": {"type": "checker"}, "ambient": 0.1, "reflection": 0.2}},
      {"type": "sphere", "center": [-1, 1.2, 1], "radius": 1,
       "material": {"diffuse": 0.1, "transmission": 0.9, "fresnel": true, "specular": 0.5,
                    "absorption": [0.1, 0.3, 0.5]}},
      {"type": "sphere", "center": [-1, 1.2, 1], "radius": 0.5,
       "material": {"diffuse": 0, "transmission": 1, "ior": 1}},
      {"type": "sphere", "center": [1.5, 1, -1], "radius": 1,
       "material": {"reflection": 0.7, "specular": 1, "roughness": 0.01, "brilliance": 2}},
      {"type": "sphere", "center": [0, 0.4, 2], "radius": 0.4, "material": {"emission": [1, 0.2, 0]}}],
    "lights": [
      {"type": "point", "position": [-4, 6, 4], "fade_distance": 5},
      {"type": "directional", "direction": [1, -2, -1], "intensity": 0.3},
      {"type": "spot", "position": [0, 6, 0], "point_at": [0, 0, 1], "color": [0.5, 0.5, 1]},
      {"type": "sphere", "position": [4, 5, 2], "radius": 0.5, "samples": 5},
      {"type": "quad", "corner": [-3, 4, -2], "u": [1, 0, 0], "v": [0, 0, 1], "samples": 3}]})");
}

bool adds_up(const RayNode& node) {
  Vec3f sum{0, 0, 0};
  for (const Term& each : node.terms) {
    sum = sum + each.value * each.weight;
    if (!each.node) continue;
    if (!adds_up(*each.node)) return false;
    if (!(each.value == each.node->color * each.node->transmittance)) return false;
  }
  return sum == node.color;
}

TEST(Tree, AddsUpToThePictureBitForBit) {
  const Scene scene = everything();
  constexpr int width = 64, height = 48;
  const View view = view_of(scene.camera, width, height);
  for (const IntegratorName integrator : {IntegratorName::whitted, IntegratorName::thesis}) {
    RenderOptions options = at_depth(4);
    options.integrator = integrator;
    const Image image = picture(scene, width, height, {0, 0, width, height}, options).image;
    Random random(430);
    for (int i = 0; i < 300; ++i) {
      const int x = random.below(width), y = random.below(height);
      const Explanation why = explain(scene, compile(scene), view, x, y, 0, options);
      EXPECT_TRUE(adds_up(*why.tree)) << x << " " << y;
      const float* pixel = image.at(x, y);
      EXPECT_EQ(why.tree->color, (Vec3f{pixel[0], pixel[1], pixel[2]})) << x << " " << y;
    }
  }
}

TEST(Tree, SamplesOfAPixelHaveItsMean) {
  const Scene scene = everything();
  const View view = view_of(scene.camera, 64, 48);
  RenderOptions options = at_depth(3);
  options.samples = 5;
  options.seed = 9;
  const Image image = picture(scene, 64, 48, {0, 0, 64, 48}, options).image;
  for (const auto& [x, y] : {std::pair{20, 20}, std::pair{40, 30}, std::pair{25, 40}}) {
    Vec3d sum{};
    for (int sample = 0; sample < 5; ++sample)
      sum = sum + static_cast<Vec3d>(
                      explain(scene, compile(scene), view, x, y, sample, options).tree->color);
    const float* pixel = image.at(x, y);
    expect_near({pixel[0], pixel[1], pixel[2]}, sum * 0.2, 1e-6);
  }
}

TEST(Tree, NeitherThreadsNorTilesNorWidthChangeAByte) {
  const Scene scene = everything();
  RenderOptions options = at_depth(4);
  options.samples = 2;
  const Image first = picture(scene, 75, 50, options).image;
  for (const int threads : {2, 7}) {
    for (const int tile : {32, 5}) {
      options.threads = threads;
      options.tile = tile;
      options.scalar = threads == 7 ? Scalar::narrow : Scalar::wide;
      EXPECT_TRUE(picture(scene, 75, 50, options).image.rgb == first.rgb) << threads << " " << tile;
    }
  }
}

// What takes light of a light in that place from the floor, through a clear pane at y = 2.
std::optional<int> blocker(const char* position, IntegratorName integrator) {
  const Scene scene = read_scene(std::string(R"({
    "objects": [{"type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0]},
                {"type": "disc", "center": [0, 2, 0], "normal": [0, 1, 0], "radius": 1,
                 "material": {"transmission": 1}}],
    "lights": [{"type": "sphere", "radius": 0.5, "samples": 16, "position": )") +
                                 position + R"(}], "options": {"transparent_shadows": true}})");
  RenderOptions options = at_depth(5);
  options.integrator = integrator;
  const std::unique_ptr<RayNode> floor = tree(scene, {0, 1, 0}, {0, -1, 0}, options);
  return term(*floor, TermName::diffuse)->light.blocker;
}

TEST(Tree, BlockersAreLookedForAsShadowsAre) {
  EXPECT_EQ(blocker("[0, 4, 0]", IntegratorName::whitted), std::nullopt);
  EXPECT_EQ(blocker("[0, 4, 0]", IntegratorName::thesis), 1) << "whose shadows are all black";
  EXPECT_EQ(blocker("[0, -4, 0]", IntegratorName::whitted), std::nullopt) << "below the horizon";
}

TEST(Tree, OneTooLargeForAnAnswerIsALimit) {
  // Two glass planes that split each ray at each surface.
  Scene scene;
  for (int i = 0; i < 40; ++i)
    scene.objects.push_back(object(Sphere{{0, 0, 0}, 1.0 + i}, glass(1.5 + 0.01 * i)));
  EXPECT_THROW(tree(scene, {100, 0.5, 0}, {-1, 0, 0}, at_depth(60)), InputError);
}

TEST(Tree, RaysThatGrowWithoutEndAreCountedAndStopped) {
  Scene scene;
  for (int i = 0; i < 40; ++i)
    scene.objects.push_back(object(Sphere{{0, 0, -50}, 1.0 + i}, glass(1.5 + 0.01 * i)));
  RenderOptions options = at_depth(60);
  options.max_rays = 1'000'000;
  EXPECT_THROW(picture(scene, 16, 16, options), InputError);
}

}  // namespace
}  // namespace tia
