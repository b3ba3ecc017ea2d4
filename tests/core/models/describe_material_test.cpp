// Materials in the words of scenes.
#include "core/models/describe_material.h"

#include <gmock/gmock.h>

#include "core/input/json.h"
#include "core/scene/read_scene.h"
#include "tests/core/support.h"

namespace tia {
namespace {

std::string described(const ModelMaterial& material) {
  return to_json(material_value(Model(), material));
}

ModelMaterial plain_material() {
  ModelMaterial plain;
  plain.base_color = {1, 1, 1};
  return plain;
}

TEST(Describe, WhatAPrincipledHasAnywayIsLeftOut) {
  EXPECT_EQ(described(plain_material()), R"({"type":"principled"})");
  EXPECT_EQ(described({}), R"({"base_color":[0.8,0.8,0.8],"type":"principled"})");
  ModelMaterial one_sided = plain_material();
  one_sided.double_sided = false;
  EXPECT_EQ(described(one_sided), R"({"double_sided":false,"type":"principled"})");
}

TEST(Describe, EachMemberHasItsWord) {
  ModelMaterial material = plain_material();
  material.name = "Glass";
  material.alpha = 0.5;
  material.alpha_mode = AlphaMode::mask;
  material.transmission = 1;
  material.attenuation_distance = 2;
  material.unlit = true;
  EXPECT_EQ(described(material),
            R"({"alpha":0.5,"alpha_mode":"mask","attenuation_distance":2,"name":"Glass",)"
            R"("thin":true,"transmission":1,"type":"principled","unlit":true})");
  material = plain_material();
  material.base_color_texture = TextureUse{3, 0, {0, 0}, {1, 1}, 0, 1};
  material.normal_texture = TextureUse{4, 1, {0.5, 0}, {2, -2}, 1.5, 0.25};
  EXPECT_EQ(described(material),
            R"({"base_color_texture":{"texture":3},"normal_texture":{"offset":[0.5,0],)"
            R"("rotation":1.5,"scale":[2,-2],"strength":0.25,"texture":4,"uv_set":1},)"
            R"("type":"principled"})");
}

// Each number, set alone, is one member more, and no two share one.
TEST(Describe, NoMemberOfAMaterialIsForgotten) {
  std::set<std::string> texts;
  std::size_t members = 0;
  std::apply(
      [&](auto... member) {
        const auto change = [&](auto each) {
          ModelMaterial material = plain_material();
          auto& is = material.*each;
          using Is = std::remove_reference_t<decltype(is)>;
          if constexpr (std::is_same_v<Is, std::string>) is = "a";
          else if constexpr (std::is_same_v<Is, Color>) is = {0.1, 0.2, 0.3};
          else if constexpr (std::is_same_v<Is, double>) is = 0.125;
          else if constexpr (std::is_same_v<Is, std::optional<double>>) is = 0.125;
          else if constexpr (std::is_same_v<Is, bool>) is = !is;
          else if constexpr (std::is_same_v<Is, AlphaMode>) is = AlphaMode::blend;
          else is = TextureUse{};
          if constexpr (std::is_same_v<Is, bool>) material.transmission = 0.25;
          texts.insert(described(material));
          ++members;
        };
        (change(member), ...);
      },
      ModelMaterial::members);
  EXPECT_EQ(texts.size(), members);
  EXPECT_FALSE(texts.contains(R"({"type":"principled"})"));
}

// What scenes know already reads back as the same principled.
TEST(Describe, WhatScenesKnowAreNumbersThatTheyRead) {
  ModelMaterial material = plain_material();
  material.base_color = {0.25, 0.5, 0.75};
  material.metallic = 0.5;
  material.roughness = 0.25;
  material.transmission = 0.5;
  material.sheen_color = {0.5, 0.5, 0.5};
  material.anisotropy_rotation = 1;
  material.attenuation_distance = 3;
  const Scene scene = read_scene(
      R"({"materials": {"m": )" + described(material) +
      R"(}, "objects": [{"type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "m"}]})");
  EXPECT_EQ(scene.objects.size(), 1U);
}

}  // namespace
}  // namespace tia
