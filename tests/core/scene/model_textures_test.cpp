// Models in pictures: their textures and the colours of their vertices.
#include <gtest/gtest.h>

#include "core/input/json.h"
#include "core/models/formats.h"
#include "core/models/images.h"
#include "tests/core/models/gltf_builder.h"
#include "tests/core/scene/textured_models.h"

namespace tia {
namespace {

using namespace test;
constexpr int grid_side = 8;

TEST(ModelTextures, EachTexelIsAtItsPixel) {
  Random random(2211);
  const ImageRgba8 image = random_rgba(random, grid_side, grid_side);
  Model model = square_model(1);
  paint_of(model).base_color_texture = TextureUse{};
  const Scene scene = square_scene(source_of(model, {image}));
  for (const Scalar scalar : {Scalar::wide, Scalar::narrow, Scalar::exact}) {
    const Image seen = drawn(scene, IntegratorName::albedo, grid_side, grid_side, scalar);
    for (int y = 0; y < grid_side; ++y)
      for (int x = 0; x < grid_side; ++x) expect_pixel(seen.at(x, y), light_at(image, x, y));
  }
}

TEST(ModelTextures, ColourIsFactorTimesTextureTimesVertexColour) {
  Random random(2212);
  const ImageRgba8 image = random_rgba(random, grid_side, grid_side);
  Model model = square_model(1);
  paint_of(model).base_color = {0.5, 0.25, 1};
  paint_of(model).base_color_texture = TextureUse{};
  // Red grows with x and green with y; blue is beyond 1, where glTF bounds it.
  part_of(model).colors = {0, 0, 3, 1, 1, 0, 3, 1, 1, 1, 3, 1, 0, 1, 3, 1};
  const Scene scene = square_scene(source_of(model, {image}));
  const Image seen = drawn(scene, IntegratorName::albedo, grid_side, grid_side);
  for (int y = 0; y < grid_side; ++y)
    for (int x = 0; x < grid_side; ++x) {
      const Vec3d vertex{(x + 0.5) / grid_side, 1 - (y + 0.5) / grid_side, 1};
      expect_pixel(seen.at(x, y), Vec3d{0.5, 0.25, 1} * light_at(image, x, y) * vertex);
    }
}

// In whitted light that falls straight on a matt surface gives it its albedo, in path with 1/pi.
TEST(ModelTextures, LightIsScatteredByIt) {
  Random random(2213);
  const ImageRgba8 image = random_rgba(random, grid_side, grid_side);
  Model model = square_model(1);
  paint_of(model).base_color_texture = TextureUse{};
  paint_of(model).specular = 0;
  part_of(model).colors = {0.5, 1, 1, 1, 0.5, 1, 1, 1, 0.5, 1, 1, 1, 0.5, 1, 1, 1};
  Scene scene = square_scene(source_of(model, {image}));
  scene.lights.resize(1);
  DirectionalLight sun;
  sun.direction = Vec3d{0, 0, -1};
  scene.lights[0].kind = sun;
  for (const auto& [integrator, share] : {std::pair(IntegratorName::whitted, 1.0),
                                          std::pair(IntegratorName::path, 1 / std::acos(-1.0))}) {
    const Image seen = drawn(scene, integrator, grid_side, grid_side);
    for (int y = 0; y < grid_side; ++y)
      for (int x = 0; x < grid_side; ++x)
        expect_pixel(seen.at(x, y), Vec3d{0.5, 1, 1} * light_at(image, x, y) * share, 1e-5);
  }
}

// As whitted has it, what is no metal is matt, and a metal as far as it is rough.
TEST(ModelTextures, RoughnessIsGreenAndMetallicBlueInLinearNumbers) {
  Random random(2214);
  const ImageRgba8 image = random_rgba(random, grid_side, grid_side);
  Model model = square_model(1);
  paint_of(model).metallic = 0.8, paint_of(model).roughness = 0.9;
  paint_of(model).metallic_roughness_texture = TextureUse{};
  const Image seen =
      drawn(square_scene(source_of(model, {image})), IntegratorName::albedo, grid_side, grid_side);
  for (int y = 0; y < grid_side; ++y)
    for (int x = 0; x < grid_side; ++x) {
      const auto code = codes_at(image, x, y);
      const double rough = 0.9 * code[1], metal = 0.8 * code[2], matt = 1 - metal + metal * rough;
      expect_pixel(seen.at(x, y), Vec3d{matt, matt, matt});
    }
}

TEST(ModelTextures, EmissionIsItsTextureInEveryIntegratorOfLight) {
  Random random(2215);
  const ImageRgba8 image = random_rgba(random, grid_side, grid_side);
  for (const bool unlit : {false, true}) {
    Model model = square_model(1);
    (unlit ? paint_of(model).base_color_texture : paint_of(model).emissive_texture) = TextureUse{};
    paint_of(model).emissive = {1, 0.5, 0.25};
    paint_of(model).emissive_strength = 2;
    paint_of(model).unlit = unlit;
    if (unlit) part_of(model).colors.assign(16, 0.5F);
    const Vec3d factor = unlit ? Vec3d{0.5, 0.5, 0.5} : Vec3d{2, 1, 0.5};
    const Scene scene = square_scene(source_of(model, {image}));
    for (const IntegratorName integrator : {IntegratorName::whitted, IntegratorName::path}) {
      const Image seen = drawn(scene, integrator, grid_side, grid_side);
      for (int y = 0; y < grid_side; ++y)
        for (int x = 0; x < grid_side; ++x)
          expect_pixel(seen.at(x, y), factor * light_at(image, x, y));
    }
    EXPECT_EQ(compile(scene).of_objects->unasked.count, 1U) << "found by chance alone";
  }
}

TEST(ModelTextures, AnotherMaterialHasNeitherTexturesNorVertexColours) {
  Model model = square_model(1);
  paint_of(model).base_color_texture = TextureUse{};
  part_of(model).colors.assign(16, 0.5F);
  const ModelSource source = source_of(model, {even_rgba(1, 1, {99, 99, 99, 99})});
  for (const std::string members :
       {R"("material":{"type":"principled","base_color":[0.2,0.4,0.6]})",
        R"("materials":{"paint":{"type":"principled","base_color":[0.2,0.4,0.6]}})"}) {
    const Image seen = drawn(square_scene(source, members), IntegratorName::albedo, 2, 2);
    expect_pixel(seen.at(1, 1), {0.2, 0.4, 0.6});
  }
}

TEST(ModelTextures, TheSecondSetAndTransformsOfCoordinates) {
  Random random(2216);
  const ImageRgba8 image = random_rgba(random, grid_side, grid_side);
  Model model = square_model(1);
  part_of(model).uvs[1] = {1, 1, 1, 0, 0, 0, 0, 1};  // a quarter turned: u is 1 - y, v is 1 - x
  TextureUse use;
  use.uv_set = 1;
  use.offset = {0.125, 0};
  paint_of(model).base_color_texture = use;
  const Image seen =
      drawn(square_scene(source_of(model, {image})), IntegratorName::albedo, grid_side, grid_side);
  for (int y = 0; y < grid_side; ++y)
    for (int x = 0; x < grid_side; ++x)
      expect_pixel(seen.at(x, y), light_at(image, (y + 1) % grid_side, grid_side - 1 - x));
}

TEST(ModelTextures, WithoutAPictureTheFactorIsLeft) {
  Model model = square_model(1);
  paint_of(model).base_color = {0.2, 0.4, 0.6};
  paint_of(model).base_color_texture = TextureUse{};
  const Scene scene = resolved(read_scene(model_scene()), model);
  const auto& object = (*children_of(scene.objects[0]))[0];
  const auto& material = *std::get<Boxed<Material>>(*object.material);
  EXPECT_EQ(std::get<Boxed<Principled>>(material.kind)->maps, nullptr);
}

// ---- meshes of scenes ---------------------------------------------------------------------------

// Of a finish as of a principled, and times a texture's colour.
TEST(MeshColors, MultiplyTheColourOfAnyMaterial) {
  for (const std::string material :
       {R"({"color":[0.5,1,0.25],"diffuse":1})",
        R"({"type":"principled","base_color":[0.5,1,0.25]})",
        R"({"diffuse":1,"texture":{"type":"checker","colors":[[0.5,1,0.25],[0.5,1,0.25]]}})"}) {
    Scene scene = read_scene(R"({"camera":{"projection":"orthographic","height":1,
      "location":[0.5,0.5,5],"direction":[0,0,-1]},"objects":[{"type":"mesh",
      "positions":[0,0,0,1,0,0,1,1,0,0,1,0],"indices":[0,1,2,0,2,3],
      "colors":[0,0,1,1,1,0,1,1,1,1,1,1,0,1,1,1],"material":)" +
                             material + "}]}");
    const Image seen = drawn(scene, IntegratorName::albedo, 4, 4);
    for (int y = 0; y < 4; ++y)
      for (int x = 0; x < 4; ++x)
        expect_pixel(seen.at(x, y),
                     Vec3d{0.5, 1, 0.25} * Vec3d{(x + 0.5) / 4, 1 - (y + 0.5) / 4, 1});
    EXPECT_EQ(write_value(scene), write_value(read_scene(to_json(write_value(scene)))));
  }
}

// ---- files --------------------------------------------------------------------------------------

// The square as a GLB with a PNG inside.
Bytes square_glb(const ImageRgba8& image) {
  using namespace gltf_files;
  GltfBuilder file;
  const int positions = file.vec3({0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0});
  const int uvs = file.floats("VEC2", 2, {0, 1, 1, 1, 1, 0, 0, 0});
  const int colors = file.numbers<std::uint8_t>(
      gltf_ubyte, "VEC4", 4,
      {255, 0, 255, 255, 255, 0, 255, 255, 255, 0, 255, 255, 255, 0, 255, 255},
      ",\"normalized\":true");
  const int indices = file.numbers<std::uint16_t>(gltf_ushort, "SCALAR", 1, {0, 1, 2, 0, 2, 3});
  const int png = file.view(to_bytes(encode_png(image)));
  file.set("meshes", one_primitive(named("POSITION", positions) + "," + named("TEXCOORD_0", uvs) +
                                       "," + named("COLOR_0", colors),
                                   ",\"material\":0,\"indices\":" + std::to_string(indices)));
  file.set("nodes", R"([{"mesh":0}])");
  file.set("scenes", R"([{"nodes":[0]}])");
  file.set("images", R"([{"mimeType":"image/png","bufferView":)" + std::to_string(png) + "}]");
  file.set("samplers", R"([{"magFilter":9728,"minFilter":9728}])");
  file.set("textures", R"([{"source":0,"sampler":0}])");
  file.set("materials",
           R"([{"pbrMetallicRoughness":{"metallicFactor":0,"baseColorTexture":{"index":0}}}])");
  return file.glb();
}

TEST(ModelTextures, AGlbIsSeenAsItsPicture) {
  Random random(2217);
  const ImageRgba8 image = random_rgba(random, grid_side, grid_side);
  const auto glb = square_glb(image);
  ModelFiles files;
  files.all.push_back({"square.glb", gltf_files::span_of(glb)});
  Faults faults;
  const Model model = read_model(files);
  KeptModel kept{std::make_shared<const Model>(model), {}};
  kept.images = decode_images(model, {}, faults);
  EXPECT_EQ(faults.count(), 0U);
  const auto shared = std::make_shared<const KeptModel>(std::move(kept));
  const Scene scene = square_scene([&](const std::string&) { return shared; });
  const Image seen = drawn(scene, IntegratorName::albedo, grid_side, grid_side);
  for (int y = 0; y < grid_side; ++y)
    for (int x = 0; x < grid_side; ++x)
      expect_pixel(seen.at(x, y), light_at(image, x, y) * Vec3d{1, 0, 1});
}

}  // namespace
}  // namespace tia
