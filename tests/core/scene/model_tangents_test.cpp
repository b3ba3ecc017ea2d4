// Tangents that a model's file does not have: made once, and kept with the model.
#include <gtest/gtest.h>

#include "core/scene/model_maps.h"
#include "tests/core/scene/textured_models.h"

namespace tia {
namespace {

using namespace test;

// Two squares with a seam between mirrored uvs, which is parted.
Model seamed_squares() {
  Model model = square_model(1);
  ModelPart& part = part_of(model);
  part.positions = {0, 0, 0, 1, 0, 0, 1, 1, 0, 0, 1, 0, 2, 0, 0, 2, 1, 0};
  part.uvs[0] = {0, 1, 1, 1, 1, 0, 0, 0, 0, 1, 0, 0};
  part.indices = {0, 1, 2, 0, 2, 3, 1, 4, 5, 1, 5, 2};
  paint_of(model).normal_texture = TextureUse{};
  return model;
}
const std::vector<ImageRgba8> any_picture{even_rgba(2, 2, {128, 128, 255, 255})};
Mesh mesh_shown(const ModelSource& source, const std::string& members = "") {
  const Scene scene = square_scene(source, members);
  return mesh_in((*children_of(scene.objects[0]))[0]);
}

TEST(ModelTangents, AreMadeOnceForAllRequests) {
  const ModelSource source = source_of(seamed_squares(), any_picture);
  const Mesh once = mesh_shown(source), again = mesh_shown(source);
  ASSERT_EQ(once.tangents.values.size(), 4 * once.vertices());
  EXPECT_EQ(once.vertices(), 8U) << "those of the seam are parted";
  EXPECT_EQ(once.tangents.values.get().data(), again.tangents.values.get().data());
  EXPECT_EQ(once.indices.values.get().data(), again.indices.values.get().data());
  EXPECT_EQ(once, again);
  EXPECT_EQ(once, mesh_shown(source_of(seamed_squares(), any_picture))) << "as of a new model";
  EXPECT_EQ(mesh_shown(source, R"("smooth":30)").tangents.values.size(), 32U);
  EXPECT_EQ(mesh_shown(source), once) << "whatever else was shown";
}

// Of two materials whose uvs are turned otherwise, each its own, in any order.
TEST(ModelTangents, FollowTheRowsOfTheMaterialThatIsWorn) {
  Model model = seamed_squares();
  ModelMaterial other = paint_of(model);
  other.name = "other";
  other.normal_texture->rotation = pi / 2;
  model.materials.push_back(other);
  model.variants = {"turned"};
  part_of(model).variants = {{0, 1}};
  const ModelSource source = source_of(model, any_picture);
  const std::string turned = R"("variant":"turned")";
  const Mesh plain = mesh_shown(source), across = mesh_shown(source, turned);
  for (std::size_t i = 0; i < 4; ++i) {
    const auto at = [&](const Mesh& mesh) {
      const auto& t = mesh.tangents.values.get();
      return Vec3d{t[4 * i], t[4 * i + 1], t[4 * i + 2]};
    };
    EXPECT_NEAR(length(at(plain)), 1, 1e-12);
    EXPECT_NEAR(dot(at(plain), at(across)), 0, 1e-12);
  }
  EXPECT_EQ(mesh_shown(source), plain);
  EXPECT_EQ(mesh_shown(source, turned), across);
}

TEST(ModelTangents, TakeNoMoreThanIsCounted) {
  const Model model = seamed_squares();
  const Mesh mesh = mesh_shown(source_of(model, any_picture));
  const std::size_t added = mesh.vertices() - model.meshes[0].parts[0].vertices();
  EXPECT_GE(tangent_bytes(model),
            8 * mesh.tangents.values.size() + 4 * (mesh.indices.values.size() + added));
  Model plain = model, given = model, unlit = model, worn = model;
  paint_of(plain).normal_texture.reset();
  part_of(given).tangents.assign(24, 1);
  paint_of(unlit).unlit = true;
  for (const Model& each : {plain, given, unlit}) EXPECT_EQ(tangent_bytes(each), 0U);
  worn.materials.push_back(paint_of(worn));
  paint_of(worn).normal_texture.reset();
  worn.variants = {"bumpy"};
  part_of(worn).variants = {{0, 1}};
  EXPECT_EQ(tangent_bytes(worn), tangent_bytes(model));
}

// Whatever makes tangents matter asks for them.
TEST(ModelTangents, AreAskedForByNormalsOfSurfaceOrCoatAndByGrain) {
  const auto asks = [](auto set) {
    ModelMaterial material;
    set(material);
    return tangent_texture(material) != nullptr;
  };
  EXPECT_FALSE(asks([](ModelMaterial&) {}));
  EXPECT_TRUE(asks([](ModelMaterial& m) { m.normal_texture = TextureUse{}; }));
  EXPECT_FALSE(asks([](ModelMaterial& m) { m.clearcoat_normal_texture = TextureUse{}; }));
  EXPECT_TRUE(
      asks([](ModelMaterial& m) { m.clearcoat = 0.5, m.clearcoat_normal_texture = TextureUse{}; }));
  EXPECT_FALSE(asks([](ModelMaterial& m) { m.anisotropy_texture = TextureUse{}; }));
  EXPECT_TRUE(asks([](ModelMaterial& m) { m.anisotropy = 0.5; }));
  EXPECT_FALSE(asks([](ModelMaterial& m) { m.anisotropy = 0.5, m.unlit = true; }));
}

}  // namespace
}  // namespace tia
