// What of a model an object shows, and what it wears.
#include <gtest/gtest.h>

#include "core/accel/world/world.h"
#include "core/scene/labels.h"
#include "tests/core/models/random_model.h"
#include "tests/core/scene/models.h"

namespace tia::test {
namespace {

Model model_of_three() {
  Model model = triangle_model();
  model.materials.push_back(model.materials[0]);
  model.materials[1].name = "gloss";
  model.meshes.push_back(model.meshes[0]);
  model.meshes[1].name = "pane";
  model.meshes[1].parts[0].material = 1;
  model.nodes[0].children = {1};
  for (const char* name : {"lid", "handle"}) {
    ModelNode node;
    node.name = name;
    node.mesh = node.name == "lid" ? 1 : 0;
    model.nodes.push_back(node);
  }
  model.scenes = {{"all", {0, 2}}, {"handle alone", {2}}};
  return model;
}
std::vector<std::string> shown_names(const Model& model, const std::string& members = "") {
  std::vector<std::string> names;
  for (const Object& each : shown_by(model, members)) names.push_back(each.name);
  return names;
}
using NamesShown = std::vector<std::string>;

TEST(ModelChoice, ShowsANodeOnceForEachOfItsParts) {
  EXPECT_EQ(shown_names(model_of_three()), (NamesShown{"root", "lid", "handle"}));
  Model model = model_of_three();
  model.nodes[1].name.clear();  // then its mesh's
  model.meshes[0].parts.push_back(model.meshes[0].parts[0]);
  EXPECT_EQ(shown_names(model), (NamesShown{"root", "root", "pane", "handle", "handle"}));
}

TEST(ModelChoice, HidesNodesWithAllBelowMeshesAndMaterials) {
  const Model model = model_of_three();
  EXPECT_EQ(shown_names(model, R"("hide":["lid"])"), (NamesShown{"root", "handle"}));
  EXPECT_EQ(shown_names(model, R"("hide":["root"])"), (NamesShown{"handle"}));
  EXPECT_EQ(shown_names(model, R"("hide":["sheet"])"), (NamesShown{"lid"}));
  EXPECT_EQ(shown_names(model, R"("hide":["gloss"])"), (NamesShown{"root", "handle"}));
  EXPECT_EQ(shown_names(model, R"("hide":["paint","gloss"])"), NamesShown{});
}

TEST(ModelChoice, ShowsTheSceneThatIsAskedFor) {
  EXPECT_EQ(shown_names(model_of_three(), R"("scene":1)"), (NamesShown{"handle"}));
  Model model = model_of_three();
  model.scene = 1;
  EXPECT_EQ(shown_names(model), (NamesShown{"handle"}));
}

// ---- materials ----------------------------------------------------------------------------------

const Principled& principled_of(const Object& object) {
  const Material& material = *std::get<Boxed<Material>>(*object.material);
  return *std::get<Boxed<Principled>>(material.kind);
}

TEST(ModelMaterials, AreTheModelsFactors) {
  Model model = triangle_model();
  ModelMaterial& m = model.materials[0];
  m.metallic = 0.1, m.roughness = 0.2, m.ior = 1.3, m.specular = 0.4;
  m.specular_color = {0.5, 0.6, 0.7};
  m.transmission = 0.8, m.thin = false, m.attenuation_color = {0.1, 0.2, 0.3};
  m.attenuation_distance = 4, m.clearcoat = 0.5, m.clearcoat_roughness = 0.6;
  m.sheen_color = {0.2, 0.3, 0.4}, m.sheen_roughness = 0.7, m.anisotropy = 0.8;
  m.anisotropy_rotation = 0.9, m.dispersion = 1.1, m.emissive = {0, 0, 1};
  m.emissive_strength = 12, m.alpha = 0.25, m.alpha_mode = AlphaMode::mask;
  m.alpha_cutoff = 0.75, m.double_sided = false;
  const Scene written = read_scene(R"({"materials":{"it":{"type":"principled",
      "base_color":[0.1,0.5,0.9],"metallic":0.1,"roughness":0.2,"ior":1.3,"specular":0.4,
      "specular_color":[0.5,0.6,0.7],"transmission":0.8,"attenuation_color":[0.1,0.2,0.3],
      "attenuation_distance":4,"clearcoat":0.5,"clearcoat_roughness":0.6,
      "sheen_color":[0.2,0.3,0.4],"sheen_roughness":0.7,"anisotropy":0.8,
      "anisotropy_rotation":0.9,"dispersion":1.1,"emissive":[0,0,1],"emissive_strength":12,
      "alpha":0.25,"alpha_mode":"mask","alpha_cutoff":0.75,"double_sided":false}}})");
  EXPECT_EQ(*std::get<Boxed<Material>>(*shown_by(model)[0].material), written.materials.at("it"));
}

TEST(ModelMaterials, AreThoseOfAFileWithoutAnyWhereAPartHasNone) {
  Model model = triangle_model();
  model.meshes[0].parts[0].material.reset();
  const Object shown = shown_by(model)[0];
  EXPECT_EQ(std::get<Color>(principled_of(shown).base_color), (Color{0.8, 0.8, 0.8}));
}

TEST(ModelMaterials, ThatAreUnlitShineWithTheirBaseColour) {
  Model model = triangle_model();
  model.materials[0].unlit = true;
  const Scene scene = resolved(read_scene(model_scene()), model);  // without a light
  const Vec3f seen = light_along(scene, {0.5, 0.5, 5}, {0, 0, -1});
  EXPECT_EQ(seen, (Vec3f{0.1F, 0.5F, 0.9F}));
}

TEST(ModelMaterials, AreReplacedAllOrByName) {
  const Model model = model_of_three();
  const auto by_name = shown_by(model, R"("materials":{"gloss":{"color":[1,0,0]}})");
  EXPECT_EQ(by_name[1].material, MaterialRef(matte({1, 0, 0})));
  EXPECT_EQ(std::get<Color>(principled_of(by_name[0]).base_color), (Color{0.1, 0.5, 0.9}));
  for (const Object& each : shown_by(model, R"("material":{"color":[0,1,0]})"))
    EXPECT_FALSE(each.material);  // it inherits the model's
  const Scene named = resolved(read_scene(R"({"materials":{"red":{"color":[1,0,0]}},"objects":[
      {"type":"model","id":"it","materials":{"gloss":"red"}}]})"),
                               model);
  EXPECT_EQ((*children_of(named.objects[0]))[1].material, MaterialRef("red"));
}

TEST(ModelMaterials, AreAnothersInAVariant) {
  Model model = model_of_three();
  model.variants = {"dull", "bright"};
  model.meshes[0].parts[0].variants = {{1, 1}};
  model.materials[1].base_color = {1, 1, 1};
  const auto base = [&](const std::string& members) {
    return std::get<Color>(principled_of(shown_by(model, members)[0]).base_color);
  };
  EXPECT_EQ(base(R"("variant":"bright")"), (Color{1, 1, 1}));
  for (const char* members : {"", R"("variant":"dull")"})
    EXPECT_EQ(base(members), (Color{0.1, 0.5, 0.9})) << members;
  EXPECT_EQ(shown_names(model, R"("variant":"bright","hide":["gloss"])"), NamesShown{});
}

TEST(ModelMeshes, HaveTheFilesNormalsAndUvsThatGoUpwards) {
  Model model = triangle_model();
  ModelPart& part = model.meshes[0].parts[0];
  part.normals = {0, 0, 1, 0, 1, 0, 1, 0, 0};
  part.uvs[0] = {0, 0, 0.25, 0.75, 1, 1};
  const Object shown = shown_by(model)[0];
  EXPECT_EQ(mesh_in(shown).normals.values.get(), (std::vector<double>{0, 0, 1, 0, 1, 0, 1, 0, 0}));
  EXPECT_EQ(mesh_in(shown).uvs.values.get(), (std::vector<double>{0, 1, 0.25, 0.25, 1, 0}));
}

// ---- motion -------------------------------------------------------------------------------------

TEST(ModelMotion, MovesNodesToWhereTheyAreAtThatTime) {
  Model model = triangle_model();
  model.animations = {
      {"up", {{0, AnimatedPath::translation, Interpolation::linear, {0, 2}, {1, 0, 0, 1, 4, 0}}}},
      {"off", {{0, AnimatedPath::translation, Interpolation::linear, {0, 2}, {0, 0, 0, 0, 0, 8}}}}};
  const auto first = [&](const std::string& members) {
    return placed_vertices(shown_by(model, members)[0])[0];
  };
  EXPECT_EQ(first(""), (Vec3d{0, 0, 0}));
  EXPECT_EQ(first(R"("animation":0)"), (Vec3d{1, 0, 0}));
  EXPECT_EQ(first(R"("time":1)"), (Vec3d{1, 2, 0}));
  EXPECT_EQ(first(R"("time":1.5,"animation":1)"), (Vec3d{0, 0, 6}));
}

TEST(ModelMotion, OfARigidSkinIsThatOfItsJoint) {
  Model model = triangle_model();
  ModelNode joint;
  joint.placement.translation = {1, 2, 3};
  joint.placement.rotation = {0, 0, 1, 1};  // a quarter turn: x to y
  model.nodes.push_back(joint);
  model.scenes[0].nodes.push_back(1);
  model.skins = {{"", {1}, {{1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1}}}};
  ModelPart& part = model.meshes[0].parts[0];
  part.joints.assign(12, 0);
  part.weights = {1, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0};
  model.nodes[0].placement.translation = {50, 50, 50};  // of a node with a skin it does not count
  const std::vector<Object> skinned = shown_by([&] {
    model.nodes[0].skin = 0;
    return model;
  }());
  expect_near_points(placed_vertices(skinned[0]), {{1, 2, 3}, {1, 6, 3}, {-1, 2, 3}}, 1e-12);
}

}  // namespace
}  // namespace tia::test
