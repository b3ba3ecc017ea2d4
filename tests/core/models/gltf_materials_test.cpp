// materials of glTF: every expectation is from the specification's tables.
#include <gmock/gmock.h>

#include "core/models/gltf/gltf_parts.h"
#include "tests/core/models/gltf_part.h"

namespace tia {
namespace {

using testing::ElementsAre;
using testing::IsEmpty;

test::PartRead materials_of(const std::string& json) {
  return test::read_part(gltf::read_materials, json);
}
// The document's texture 0 is a white pixel, as its texture 1.
std::string with_textures(const std::string& material) {
  return R"({"textures": [{"source": 0}, {"source": 0}], "images": [{"uri": ")" +
         test::data_uri("image/png", test::png({1, 1, 8, test::grey}, "\xFF")) +
         R"("}], "materials": [)" + material + "]}";
}
ModelMaterial material_of(const std::string& material) {
  const test::PartRead read = materials_of(with_textures(material));
  EXPECT_THAT(read.fault_lines(), IsEmpty());
  EXPECT_THAT(read.warning_lines(), IsEmpty());
  return read.model.materials.size() == 1 ? read.model.materials[0] : ModelMaterial{};
}
std::string extension(const std::string& name, const std::string& members) {
  return R"({"extensions": {"KHR_materials_)" + name + "\": {" + members + "}}}";
}
// What glTF says of an empty object.
ModelMaterial gltf_plain() {
  ModelMaterial plain;
  plain.base_color = {1, 1, 1};
  plain.metallic = plain.roughness = 1;
  plain.double_sided = false;
  return plain;
}
TextureUse use_of(ModelIndex texture, double strength = 1) {
  TextureUse use;
  use.texture = texture;
  use.strength = strength;
  return use;
}

// ---- the core -----------------------------------------------------------------------------------

TEST(GltfMaterials, AnEmptyMaterialHasTheDefaultsOfGltf) {
  const ModelMaterial material = material_of("{}");
  EXPECT_EQ(material, gltf_plain());
  EXPECT_EQ(material_of(R"({"pbrMetallicRoughness": {}, "extensions": {}})"), gltf_plain());
  EXPECT_EQ(material.alpha_cutoff, 0.5);
  EXPECT_EQ(material.alpha_mode, AlphaMode::opaque);
}

TEST(GltfMaterials, ADocumentWithoutMaterialsHasNone) {
  EXPECT_THAT(materials_of("{}").model.materials, IsEmpty());
  EXPECT_THAT(materials_of("{}").fault_lines(), IsEmpty());
}

TEST(GltfMaterials, EveryMemberOfTheCoreIsRead) {
  ModelMaterial expected;
  expected.name = "Body";
  expected.base_color = {0.1, 0.2, 0.3};
  expected.alpha = 0.4;
  expected.metallic = 0.5;
  expected.roughness = 0.6;
  expected.base_color_texture = use_of(0);
  expected.metallic_roughness_texture = use_of(1);
  expected.normal_texture = use_of(0, -2);
  expected.normal_texture->uv_set = 1;
  expected.occlusion_texture = use_of(1, 0.7);
  expected.emissive_texture = use_of(0);
  expected.emissive = {1, 0.5, 0};
  expected.alpha_mode = AlphaMode::mask;
  expected.alpha_cutoff = 1.5;
  EXPECT_EQ(material_of(R"({"name": "Body", "pbrMetallicRoughness": {
      "baseColorFactor": [0.1, 0.2, 0.3, 0.4], "metallicFactor": 0.5, "roughnessFactor": 0.6,
      "baseColorTexture": {"index": 0}, "metallicRoughnessTexture": {"index": 1}},
      "normalTexture": {"index": 0, "scale": -2, "texCoord": 1},
      "occlusionTexture": {"index": 1, "strength": 0.7}, "emissiveTexture": {"index": 0},
      "emissiveFactor": [1, 0.5, 0], "alphaMode": "MASK", "alphaCutoff": 1.5,
      "doubleSided": true})"),
            expected);
  EXPECT_EQ(material_of(R"({"alphaMode": "BLEND"})").alpha_mode, AlphaMode::blend);
}

TEST(GltfMaterials, WhatIsWrongIsAFaultAtItsPlace) {
  const auto faults = materials_of(R"({"materials": [
      {"alphaMode": "mask", "doubleSided": 1, "emissiveFactor": [1, 1], "name": 3},
      {"pbrMetallicRoughness": {"metallicFactor": 1.5, "baseColorFactor": [1, 1, -1, 2]}},
      {"alphaCutoff": -1, "pbrMetallicRoughness": []}, 7,
      {"extensions": {"KHR_materials_sheen": 1, "KHR_materials_ior": {"ior": "1"},
                      "KHR_materials_volume": {"attenuationDistance": 0}}}]})")
                          .fault_lines();
  EXPECT_THAT(
      faults,
      testing::UnorderedElementsAre(
          "unknown_name /materials/0/alphaMode", "wrong_type /materials/0/doubleSided",
          "wrong_type /materials/0/emissiveFactor", "wrong_type /materials/0/name",
          "out_of_range /materials/1/pbrMetallicRoughness/metallicFactor",
          "out_of_range /materials/1/pbrMetallicRoughness/baseColorFactor/2",
          "out_of_range /materials/1/pbrMetallicRoughness/baseColorFactor/3",
          "out_of_range /materials/2/alphaCutoff", "wrong_type /materials/2/pbrMetallicRoughness",
          "wrong_type /materials/3", "wrong_type /materials/4/extensions/KHR_materials_sheen",
          "wrong_type /materials/4/extensions/KHR_materials_ior/ior",
          "out_of_range /materials/4/extensions/KHR_materials_volume/attenuationDistance"));
}

// ---- extensions ---------------------------------------------------------------------------------

TEST(GltfMaterials, EmptyExtensionsChangeNothingButUnlit) {
  for (const char* name : {"emissive_strength", "ior", "specular", "transmission", "volume",
                           "clearcoat", "sheen", "anisotropy", "dispersion"})
    EXPECT_EQ(material_of(extension(name, "")), gltf_plain()) << name;
  ModelMaterial unlit = gltf_plain();
  unlit.unlit = true;
  EXPECT_EQ(material_of(extension("unlit", "")), unlit);
}

TEST(GltfMaterials, ExtensionsOfTheBaseAreRead) {
  ModelMaterial expected = gltf_plain();
  expected.specular = 0.25;
  expected.specular_color = {0.5, 1, 2};
  expected.specular_texture = use_of(0);
  expected.specular_color_texture = use_of(1);
  EXPECT_EQ(material_of(extension("specular", R"("specularFactor": 0.25,
      "specularColorFactor": [0.5, 1, 2], "specularTexture": {"index": 0},
      "specularColorTexture": {"index": 1})")),
            expected);
  EXPECT_EQ(
      material_of(extension("emissive_strength", R"("emissiveStrength": 12)")).emissive_strength,
      12);
  EXPECT_EQ(material_of(extension("ior", R"("ior": 2.42)")).ior, 2.42);
  EXPECT_EQ(material_of(extension("dispersion", R"("dispersion": 0.36)")).dispersion, 0.36);
}

TEST(GltfMaterials, ExtensionsOfLayersAreRead) {
  ModelMaterial expected = gltf_plain();
  expected.clearcoat = 0.1;
  expected.clearcoat_roughness = 0.2;
  expected.clearcoat_texture = use_of(0);
  expected.clearcoat_roughness_texture = use_of(1);
  expected.clearcoat_normal_texture = use_of(0, 3);
  EXPECT_EQ(material_of(extension("clearcoat", R"("clearcoatFactor": 0.1,
      "clearcoatRoughnessFactor": 0.2, "clearcoatTexture": {"index": 0},
      "clearcoatRoughnessTexture": {"index": 1},
      "clearcoatNormalTexture": {"index": 0, "scale": 3})")),
            expected);
  expected = gltf_plain();
  expected.sheen_color = {0.1, 0.2, 0.3};
  expected.sheen_roughness = 0.4;
  expected.sheen_color_texture = use_of(0);
  expected.sheen_roughness_texture = use_of(1);
  EXPECT_EQ(material_of(extension("sheen", R"("sheenColorFactor": [0.1, 0.2, 0.3],
      "sheenRoughnessFactor": 0.4, "sheenColorTexture": {"index": 0},
      "sheenRoughnessTexture": {"index": 1})")),
            expected);
  expected = gltf_plain();
  expected.anisotropy = 0.5;
  expected.anisotropy_rotation = -1.5;
  expected.anisotropy_texture = use_of(1);
  EXPECT_EQ(material_of(extension("anisotropy", R"("anisotropyStrength": 0.5,
      "anisotropyRotation": -1.5, "anisotropyTexture": {"index": 1})")),
            expected);
}

// Source: KHR_materials_volume: thickness 0 is thin-walled, no distance is an infinite one.
TEST(GltfMaterials, OnlyAThickVolumeIsNotThin) {
  ModelMaterial expected = gltf_plain();
  expected.transmission = 0.75;
  expected.transmission_texture = use_of(1);
  EXPECT_EQ(material_of(extension("transmission", R"("transmissionFactor": 0.75,
      "transmissionTexture": {"index": 1})")),
            expected);
  expected = gltf_plain();
  expected.thin = false;
  expected.attenuation_color = {0.5, 0.25, 1};
  expected.attenuation_distance = 2;
  EXPECT_EQ(material_of(extension("volume", R"("thicknessFactor": 0.001,
      "attenuationColor": [0.5, 0.25, 1], "attenuationDistance": 2)")),
            expected);
  EXPECT_TRUE(material_of(extension("volume", R"("thicknessFactor": 0)")).thin);
  for (const char* infinite : {"3.4e38", "null"})
    EXPECT_EQ(material_of(extension("volume", R"("attenuationDistance": )" + std::string(infinite)))
                  .attenuation_distance,
              std::nullopt);
}

// Source: KHR_materials_ior: F0 = ((ior - 1) / (ior + 1))^2, and 1 where ior is 0.
TEST(GltfMaterials, AnIorOfZeroReflectsAllInTheSpecularColor) {
  for (const char* order : {R"("KHR_materials_ior": {"ior": 0},
      "KHR_materials_specular": {"specularColorFactor": [0.1, 0.5, 1]})",
                            R"("KHR_materials_specular": {"specularColorFactor": [0.1, 0.5, 1]},
      "KHR_materials_ior": {"ior": 0})"}) {
    const auto read =
        materials_of(R"({"materials": [{"extensions": {)" + std::string(order) + "}}]}");
    ASSERT_THAT(read.fault_lines(), IsEmpty());
    const ModelMaterial& material = read.model.materials.at(0);
    const double f0 =
        (material.ior - 1) * (material.ior - 1) / (material.ior + 1) / (material.ior + 1);
    EXPECT_NEAR(f0 * material.specular_color.r, 0.1, 1e-15);
    EXPECT_NEAR(f0 * material.specular_color.g, 0.5, 1e-15);
    EXPECT_NEAR(f0 * material.specular_color.b, 1, 1e-15);
    ASSERT_EQ(read.model.warnings.size(), 1U);
    EXPECT_EQ(read.model.warnings[0].pointer, "/materials/0/extensions/KHR_materials_ior/ior");
  }
  EXPECT_THAT(
      materials_of(R"({"materials": [)" + extension("ior", R"("ior": 0.5)") + "]}").fault_lines(),
      ElementsAre("out_of_range /materials/0/extensions/KHR_materials_ior/ior"));
}

TEST(GltfMaterials, WhatIsLargerThanRenderersTakeIsTheLargestThatTheyTake) {
  const auto read = materials_of(R"({"materials": [)" + extension("ior", R"("ior": 11)") + "," +
                                 extension("emissive_strength", R"("emissiveStrength": 1e9)") +
                                 "," + extension("dispersion", R"("dispersion": 11)") + "]}");
  ASSERT_EQ(read.model.materials.size(), 3U);
  EXPECT_EQ(read.model.materials[0].ior, 10);
  EXPECT_EQ(read.model.materials[1].emissive_strength, 1e6);
  EXPECT_EQ(read.model.materials[2].dispersion, 10);
  EXPECT_THAT(
      read.warning_lines(),
      ElementsAre("/materials/0/extensions/KHR_materials_ior/ior: more than 10 is taken as 10",
                  "/materials/1/extensions/KHR_materials_emissive_strength/emissiveStrength: more "
                  "than 1000000 is taken as 1000000",
                  "/materials/2/extensions/KHR_materials_dispersion/dispersion: more than 10 is "
                  "taken as 10"));
}

TEST(GltfMaterials, EachExtensionThatIsNotTakenIsNamedOnce) {
  const auto read = materials_of(R"({"materials": [
      {"extensions": {"KHR_materials_iridescence": {}, "EXT_of_somebody": {}}},
      {"extensions": {"KHR_materials_iridescence": {}, "KHR_materials_a~b/c": 5,
                      "KHR_materials_pbrSpecularGlossiness": {"diffuseFactor": [1, 1, 1, 1]}}}]})");
  EXPECT_THAT(read.fault_lines(), IsEmpty());
  EXPECT_THAT(read.warning_lines(),
              ElementsAre("/materials/0/extensions/KHR_materials_iridescence: "
                          "KHR_materials_iridescence is not taken",
                          "/materials/1/extensions/KHR_materials_a~0b~1c: KHR_materials_a~b/c is "
                          "not taken",
                          "/materials/1/extensions/KHR_materials_pbrSpecularGlossiness: "
                          "KHR_materials_pbrSpecularGlossiness is not taken"));
}

}  // namespace
}  // namespace tia
