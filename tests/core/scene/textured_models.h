// Models with pictures: a square that a camera looks at straight on.
#pragma once

#include <memory>
#include <utility>
#include <vector>

#include "tests/core/materials/texture_maps.h"
#include "tests/core/scene/models.h"

namespace tia::test {

/// Of images as they are decoded.
inline ModelSource source_of(Model model, const std::vector<ImageRgba8>& images) {
  KeptModel kept{std::make_shared<const Model>(std::move(model)), {}};
  for (const ImageRgba8& image : images)
    kept.images.push_back(std::make_shared<const ImageRgba8>(image));
  const auto shared = std::make_shared<const KeptModel>(std::move(kept));
  return [shared](const std::string&) { return shared; };
}

/// The square from 0 to 1 along x and y, seen from +z. Its picture lies upright on it: the first
/// row is on top. Texture i is image i; material "paint" is white, matt and plain.
inline Model square_model(std::size_t images) {
  Model model = triangle_model();
  ModelPart& part = model.meshes[0].parts[0];
  part.positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0};
  part.uvs[0] = {0, 1, 1, 1, 1, 0, 0, 0};
  part.indices = {0, 1, 2, 0, 2, 3};
  ModelMaterial& paint = model.materials[0];
  paint.base_color = {1, 1, 1};
  paint.metallic = 0;
  for (ModelIndex i = 0; i < images; ++i) {
    model.images.push_back({"", {1}});
    model.textures.push_back({i, Wrap::repeat, Wrap::repeat, true});
  }
  return model;
}
inline ModelMaterial& paint_of(Model& model) { return model.materials[0]; }
inline ModelPart& part_of(Model& model) { return model.meshes[0].parts[0]; }

/// What a camera sees of the model that looks down -z at the square from 0 to `side`.
inline Scene square_scene(const ModelSource& source, const std::string& members = "",
                          double side = 1) {
  Scene scene = read_scene(model_scene(members));
  scene.camera.projection = Projection::orthographic;
  scene.camera.height = side;
  scene.camera.location = {side / 2, side / 2, 5};
  scene.camera.direction = Vec3d{0, 0, -1};
  Faults faults;
  resolve_models(scene, source, faults);
  for (const Fault& fault : faults.list()) ADD_FAILURE() << describe(fault);
  return scene;
}
inline Image drawn(const Scene& scene, IntegratorName integrator, int width, int height,
                   Scalar scalar = Scalar::wide) {
  RenderOptions options;
  options.integrator = integrator;
  options.max_depth = 3;
  options.scalar = scalar;
  return picture(scene, width, height, options).image;
}
inline void expect_pixel(const float* pixel, const Vec3d& expected, double most = 1e-6) {
  const Vec3d got{pixel[0], pixel[1], pixel[2]};
  EXPECT_LE(length(got - expected), most)
      << testing::PrintToString(got) << " expected " << testing::PrintToString(expected);
}
/// The light of a pixel of an sRGB picture.
inline Vec3d light_at(const ImageRgba8& image, int x, int y) {
  const auto code = codes_at(image, x, y);
  return {srgb_light(code[0]), srgb_light(code[1]), srgb_light(code[2])};
}

}  // namespace tia::test
