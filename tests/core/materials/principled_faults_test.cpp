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
      R"({"alpha":0.5,"alpha_cutoff":0.25,"alpha_mode":"mask","anisotropy":0.5,)"
      R"("anisotropy_rotation":-1,"attenuation_color":[1,0.5,0.25],)"
      R"("attenuation_distance":2,"base_color":"gold","clearcoat":0.5,"clearcoat_roughness":0.25,)"
      R"("dispersion":0.5,"double_sided":false,)"
      R"("emissive":[1,0.5,0],"emissive_strength":100,"ior":1.25,"metallic":1,"roughness":0.25,)"
      R"("sheen_color":[0.5,0.5,1],"sheen_roughness":0.5,"specular":0.5,)"
      R"("specular_color":[1,0.5,0],"texture":{"type":"checker"},"thin":true,"transmission":0.5,)"
      R"("type":"principled"})";
  EXPECT_EQ(to_json(write_value(read_principled(json))), json);
}

TEST(PrincipledFaults, TexturesOfNumbersAreReadAndWrittenBack) {
  const char* json =
      R"({"anisotropy":{"range":[0,1],"type":"wood"},"clearcoat":{"range":[0,1],"type":"noise"},)"
      R"("clearcoat_roughness":{"range":[0.5,0.5],"scale":2,"type":"stripes"},)"
      R"("metallic":{"channel":"b","data":"iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR42mP4)"
      R"(DwABAQEAHLCMmQAAAABJRU5ErkJggg==","range":[0,1],"transfer":"srgb","type":"image"},)"
      R"("roughness":{"colors":[[0,0,0],[1,0.5,0.25]],"range":[0.75,0.25],"type":"checker"},)"
      R"("sheen_roughness":{"range":[1,0],"type":"marble"},)"
      R"("specular":{"channel":"g","range":[0,1],"type":"gradient"},)"
      R"("transmission":{"range":[0,1],"turbulence":3,"type":"marble"},"type":"principled"})";
  EXPECT_EQ(to_json(write_value(read_principled(json))), json);
}

TEST(PrincipledFaults, TexturesOfNumbersSayWhatTheyMean) {
  const auto refused = [](const std::string& texture, const std::vector<test::Expected>& faults) {
    expect_principled_refused(R"({"type":"principled","roughness":)" + texture + "}", faults);
  };
  const char* two = "2 numbers, each a number from 0 to 1";
  refused(R"({"type":"checker"})", {{missing, "/roughness/range", "", two}});
  refused(R"({"range":[0,1]})", {{missing, "/roughness/type", "", "one of checker, stripes"}});
  refused(R"({"type":"noise","range":0.5})", {{wrong_type, "/roughness/range", "0.5", two}});
  refused(R"({"type":"noise","range":[0,1,1]})",
          {{wrong_type, "/roughness/range", "[0,1,1]", two}});
  refused(R"({"type":"noise","range":[-0.5,1.5]})",
          {{out_of_range, "/roughness/range/0", "-0.5", "a number from 0 to 1"},
           {out_of_range, "/roughness/range/1", "1.5", "a number from 0 to 1"}});
  refused(R"({"type":"checker","range":[0,1],"colors":[0,[1,2,0]]})",
          {{out_of_range, "/roughness/colors/1/1", "2", "a number from 0 to 1"}});
  refused(R"({"type":"gradient","range":[0,1],"colors":[0,2]})",
          {{out_of_range, "/roughness/colors/1", "2", "a number from 0 to 1"}});
  refused(R"({"type":"noise","range":[0,1],"channel":"red"})",
          {{unknown_name, "/roughness/channel", R"("red")", "one of r, g, b", "r"}});
  refused(R"({"type":"noise","rang":[0,1]})",
          {{missing, "/roughness/range", "", two},
           {unknown_name, "/roughness/rang", R"("rang")", "range", "range"}});
  refused(R"({"type":"image","range":[0,1]})", {{missing, "/roughness/data", "", "PNG or JPEG"}});
  for (const char* wrong : {R"("rough")", "[0.5]", "true", "null"})
    refused(wrong,
            {{wrong_type, "/roughness", wrong, "a number from 0 to 1, or a texture with a range"}});
}

// Those that are no shares, and those of finishes.
TEST(PrincipledFaults, OtherNumbersAreNotTextured) {
  const std::string texture = R"({"range":[0,1],"type":"checker"})";
  for (const std::string word :
       {"ior", "attenuation_distance", "anisotropy_rotation", "dispersion"}) {
    std::string json = R"({"type":"principled",")";
    json.append(word).append("\":").append(texture).append("}");
    expect_principled_refused(json, {{wrong_type, "/" + word, texture, "a number"}});
  }
  expect_principled_refused(R"({"roughness":)" + texture + "}",
                            {{wrong_type, "/roughness", texture, "a number from 0.00001 to 1"}});
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
