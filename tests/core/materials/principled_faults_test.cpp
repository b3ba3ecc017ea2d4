// Principled materials as JSON: every word read and written back, each mistake at its place.
#include "core/materials/material.h"
#include "core/scene/read_scene.h"
#include "tests/core/faults.h"

namespace tia {
namespace {

using enum FaultKind;

Material read_principled(const std::string& json) {
  return read_described<Material>(parse_json(json));
}
const auto expect_principled_refused =
    test::refusal_by([](const std::string& json) { read_principled(json); });

TEST(PrincipledFaults, EveryWordIsReadAndWrittenBack) {
  const char* json =
      R"({"anisotropy":0.5,"anisotropy_rotation":-1,"attenuation_color":[1,0.5,0.25],)"
      R"("attenuation_distance":2,"base_color":"gold","clearcoat":0.5,"clearcoat_roughness":0.25,)"
      R"("dispersion":0.5,)"
      R"("emissive":[1,0.5,0],"emissive_strength":100,"ior":1.25,"metallic":1,"roughness":0.25,)"
      R"("sheen_color":[0.5,0.5,1],"sheen_roughness":0.5,"specular":0.5,)"
      R"("specular_color":[1,0.5,0],"texture":{"type":"checker"},"thin":true,"transmission":0.5,)"
      R"("type":"principled"})";
  EXPECT_EQ(to_json(write_value(read_principled(json))), json);
}

TEST(PrincipledFaults, NumbersAndColoursHaveTheirRanges) {
  const auto refused = [](const std::string& word, const std::string& value, FaultKind kind,
                          const std::string& allowed) {
    expect_principled_refused(R"({"type":"principled",")" + word + "\":" + value + "}",
                              {{kind, "/" + word, value, allowed}});
  };
  for (const char* word : {"metallic", "roughness", "specular", "transmission", "clearcoat",
                           "clearcoat_roughness", "sheen_roughness", "anisotropy"})
    refused(word, "1.5", out_of_range, "from 0 to 1");
  for (const char* word : {"base_color", "attenuation_color", "sheen_color", "emissive"})
    refused(word, "1.5", out_of_range, "from 0 to 1");
  refused("ior", "0.5", out_of_range, "from 1 to 10");
  refused("attenuation_distance", "0", out_of_range, "above 0");
  expect_principled_refused(R"({"type":"principled","base_color":"silber"})",
                            {{unknown_name, "/base_color", "\"silber\"", "one of gold", "silver"}});
  refused("base_color", "{}", wrong_type, "one number for all 3, or one of gold");
}

}  // namespace
}  // namespace tia
