// Pictures of models from afar: their mip pyramids.
#include <gtest/gtest.h>

#include "core/scene/model_maps.h"
#include "tests/core/scene/textured_models.h"

namespace tia {
namespace {

using namespace test;

ImageRgba8 checker_picture(int side) {
  ImageRgba8 image{side, side, {}};
  for (int i = 0; i < side * side; ++i)
    for (int k = 0; k < 4; ++k) image.rgba.push_back((i % side + i / side) % 2 == 0 ? 255 : 0);
  return image;
}

// Half of it is white and half is black; a tenth of its pixels a side is all that is drawn.
TEST(ModelMips, AFarCheckerIsItsMean) {
  for (const Projection projection : {Projection::orthographic, Projection::perspective}) {
    Model model = square_model(1);
    model.textures[0].nearest = false;
    paint_of(model).base_color_texture = TextureUse{};
    Scene scene = square_scene(source_of(model, {checker_picture(160)}));
    scene.camera.projection = projection;
    scene.camera.fov_degrees = 10;
    const Image seen = drawn(scene, IntegratorName::albedo, 16, 16);
    for (int y = 1; y < 15; ++y)
      for (int x = 1; x < 15; ++x) expect_pixel(seen.at(x, y), {0.5, 0.5, 0.5}, 0.005);
    model.textures[0].nearest = true;
    const Scene raw = square_scene(source_of(model, {checker_picture(160)}));
    const float one = drawn(raw, IntegratorName::albedo, 16, 16).at(3, 4)[0];
    EXPECT_TRUE(one == 0 || one == 1) << "nearest stays so";
  }
}

// Seen in a mirror it is as far as both ways together: each pixel covers 6 tan(1 degree) = 0.105,
// which is 6.7 texels.
TEST(ModelMips, ReflectionsAreSeenFromAsFarAsTheyAre) {
  Model model = square_model(1);
  model.textures[0].nearest = false;
  paint_of(model).base_color_texture = TextureUse{};
  paint_of(model).unlit = true;
  Scene scene = square_scene(source_of(model, {checker_picture(64)}));
  Finish mirror;
  mirror.reflection = 1, mirror.diffuse = 0;
  Object pane;
  pane.shape = Plane{{0, 0, 3}, {0, 0, -1}};
  pane.material = MaterialRef(Material{mirror});
  scene.objects.push_back(pane);
  scene.camera.projection = Projection::perspective;
  // Next to the square, with it behind its back.
  scene.camera.location = {0.5, 0.5, 0.001};
  scene.camera.direction = Vec3d{0, 0, 1};
  scene.camera.fov_degrees = 2;
  const Image seen = drawn(scene, IntegratorName::whitted, 2, 2);
  const Image path = drawn(scene, IntegratorName::path, 2, 2);
  for (const Image& each : {seen, path}) expect_pixel(each.at(0, 0), {0.5, 0.5, 0.5}, 0.02);
}

TEST(ModelMips, PyramidsAreMadeOnceAndKnownBefore) {
  Model model = square_model(2);
  for (ModelTexture& texture : model.textures) texture.nearest = false;
  TextureUse second;
  second.texture = 1;
  paint_of(model).base_color_texture = TextureUse{};
  paint_of(model).emissive_texture = TextureUse{};
  paint_of(model).roughness_texture = second;
  paint_of(model).metallic_texture = second;
  paint_of(model).normal_texture = second;
  const auto kept = source_of(model, {checker_picture(32), checker_picture(16)})("it");
  const auto maps = maps_of(*kept, kept->model->materials[0], Mesh{}),
             again = maps_of(*kept, kept->model->materials[0], Mesh{});
  ASSERT_EQ(maps->uses.size(), 3U) << "metallic and roughness are looked up together";
  EXPECT_EQ(*maps, *again);
  EXPECT_EQ(maps->uses[0].map.pyramid, maps->uses[2].map.pyramid);
  EXPECT_EQ(maps->uses[1].map.pyramid, maps->normal->pyramid);
  EXPECT_EQ(pyramid_bytes(*kept), bytes_of_halves(32, 32) + bytes_of_halves(16, 16));
  const auto compiled =
      compile(square_scene(source_of(model, {checker_picture(32), checker_picture(16)})));
  const std::size_t pictures = 4 * (32 * 32 + 16 * 16);
  EXPECT_GE(bytes_of(*compiled.of_objects), pictures);
  EXPECT_LE(bytes_of(*compiled.of_objects), 2 * pictures + sizeof(Geometry) + 20000);
}

}  // namespace
}  // namespace tia
