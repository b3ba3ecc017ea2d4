// Finishes as JSON: every word read and written back, each mistake at its place, the schema against
// the reader.
#include "core/materials/material.h"
#include "core/scene/read_scene.h"
#include "tests/core/film/files.h"
#include "tests/core/materials/textures.h"
#include "tests/core/schema/corpus.h"

namespace tia {
namespace {

using enum FaultKind;
using test::expect_faults;
using test::to_text;

Material read_material(const std::string& json) {
  return read_described<Material>(parse_json(json));
}
const auto expect_material_refused =
    test::refusal_by([](const std::string& json) { read_material(json); });

TEST(FinishFaults, EveryWordIsReadAndWrittenBack) {
  const char* json =
      R"({"absorption":[0.1,0.2,0.3],"ambient":0.1,"brilliance":2,"color":[1,0.5,0],)"
      R"("diffuse":0.5,"emission":[1,2,3],"fresnel":true,"ior":1.33,"reflection":0.25,)"
      R"("roughness":0.01,"specular":0.75,"texture":{"type":"checker"},"transmission":1})";
  EXPECT_EQ(to_json(write_value(read_material(json))), json);
  // What is at its default is left out.
  EXPECT_EQ(to_json(write_value(read_material(
                R"({"type":"finish","color":[1,1,1],"ambient":0,"diffuse":1,"brilliance":1,)"
                R"("specular":0,"roughness":0.05,"reflection":0,"transmission":0,"ior":1.5,)"
                R"("absorption":0,"emission":0,"fresnel":false})"))),
            "{}");
}

TEST(FinishFaults, SharesAreFromNothingToAll) {
  for (const char* word : {"ambient", "diffuse", "specular", "reflection", "transmission"}) {
    const std::string start = std::string("{\"") + word + "\":", at = std::string("/") + word;
    for (const char* share : {"-0.1", "1.1", "1e+300"})
      expect_material_refused(start + share + "}",
                              {{out_of_range, at, share, "a number from 0 to 1"}});
    for (const char* other : {"\"0.5\"", "null", "true", "[0.5,0.5,0.5]", "{}"})
      expect_material_refused(start + other + "}",
                              {{wrong_type, at, other, "a number from 0 to 1"}});
    for (const char* bound : {"0", "1", "-0.0"})
      EXPECT_NO_THROW(read_material(start + bound + "}"));
  }
}

TEST(FinishFaults, OtherNumbersHaveTheirRanges) {
  const auto refused = [](const std::string& word, const std::vector<const char*>& values,
                          const std::string& allowed) {
    for (const char* value : values)
      expect_material_refused("{\"" + word + "\":" + value + "}",
                              {{out_of_range, "/" + word, value, allowed}});
  };
  refused("brilliance", {"-1", "1000.5"}, "from 0 to 1000");
  refused("roughness", {"0", "-1", "0.000001", "1.5"}, "from 0.00001 to 1");
  refused("ior", {"0", "-1.5", "0.05", "10.5", "1000000000", "1e-9"}, "from 0.1 to 10");
  refused("color", {"-1", "1000001"}, "from 0 to 1000000");
  refused("emission", {"-1", "1000001"}, "from 0 to 1000000");
  refused("absorption", {"-1", "1000001"}, "from 0 to 1000000");
  for (const char* word : {"color", "emission", "absorption"}) {
    const std::string start = std::string("{\"") + word + "\":", at = std::string("/") + word;
    expect_material_refused(start + "[0,1,-2]}",
                            {{out_of_range, at + "/2", "-2", "from 0 to 1000000"}});
    expect_material_refused(start + "[0,1]}", {{wrong_type, at, "[0,1]", "3 numbers"}});
    expect_material_refused(start + "\"red\"}", {{wrong_type, at, "\"red\"", "3 numbers"}});
  }
}

TEST(FinishFaults, FresnelIsTrueOrFalse) {
  for (const char* other : {"1", "\"yes\"", "null", "[]"})
    expect_material_refused(std::string(R"({"fresnel":)") + other + "}",
                            {{wrong_type, "/fresnel", other, "true or false"}});
}

TEST(FinishFaults, UnknownWordsNameTheNearest) {
  const std::pair<const char*, const char*> words[] = {{"shine", ""},
                                                       {"reflectivity", "reflection"},
                                                       {"reflections", "reflection"},
                                                       {"specullar", "specular"},
                                                       {"rougness", "roughness"},
                                                       {"absorbtion", "absorption"},
                                                       {"emision", "emission"},
                                                       {"fresnell", "fresnel"},
                                                       {"textures", "texture"},
                                                       {"iro", "ior"}};
  for (const auto& [word, nearest] : words)
    expect_material_refused(
        std::string("{\"") + word + "\":1}",
        {{unknown_name, std::string("/") + word, std::string("\"") + word + "\"",
          "color, ambient, diffuse, brilliance, specular, roughness, reflection", nearest}});
  expect_material_refused(R"({"type":"principle"})", {{unknown_name, "/type", "\"principle\"",
                                                       "one of finish, principled", "principled"}});
}

// ---- textures -----------------------------------------------------------------------------------

TEST(FinishFaults, TexturesOfEveryKindHaveTheirFaultsBelowTheFinish) {
  const char* const kinds = "one of checker, stripes, gradient, noise, marble, wood, image";
  expect_material_refused(R"({"texture":"checker"})",
                          {{wrong_type, "/texture", "\"checker\"", "an object"}});
  expect_material_refused(R"({"texture":{}})", {{missing, "/texture/type", "", kinds}});
  expect_material_refused(R"({"texture":{"type":"bricks"}})",
                          {{unknown_name, "/texture/type", "\"bricks\"", kinds, ""}});
  expect_material_refused(R"({"texture":{"type":"mable"}})",
                          {{unknown_name, "/texture/type", "\"mable\"", kinds, "marble"}});
  for (const char* type : {"checker", "stripes", "gradient", "noise", "marble", "wood"}) {
    const std::string start = std::string(R"({"texture":{"type":")") + type + "\",";
    const bool two = std::string(type) == "checker" || std::string(type) == "stripes";
    for (const char* colors : {"[]", "[1]"})
      expect_material_refused(start + R"("colors":)" + colors + "}}",
                              {{wrong_type, "/texture/colors", colors, two ? "2" : "at least 2"}});
    expect_material_refused(start + R"("colors":5}})",
                            {{wrong_type, "/texture/colors", "5", two ? "2" : "at least 2"}});
    expect_material_refused(start + R"("colors":[0,[0,-1,0]]}})",
                            {{out_of_range, "/texture/colors/1/1", "-1", "from 0 to 1000000"}});
    for (const char* scale : {"0", "-1", "2000000000"})
      expect_material_refused(
          start + R"("scale":)" + scale + "}}",
          {{out_of_range, "/texture/scale", scale, "above 0, at most 1000000000"}});
    expect_material_refused(start + R"("colour":1}})", {{unknown_name, "/texture/colour",
                                                         "\"colour\"", "colors, ", "colors"}});
    expect_material_refused(
        start + R"("transform":[{"turn":1}]}})",
        {{unknown_name, "/texture/transform/0/turn", "\"turn\"", "translate", ""}});
  }
  for (const char* type : {"marble", "wood"})
    for (const char* turbulence : {"-1", "100.5"})
      expect_material_refused(
          std::string(R"({"texture":{"type":")") + type + R"(","turbulence":)" + turbulence + "}}",
          {{out_of_range, "/texture/turbulence", turbulence, "from 0 to 100"}});
}

std::string with_picture(std::string_view file) {
  return R"({"texture":{"type":"image","data":")" + test::base64(file) + "\"}}";
}

// A header that promises other pixels than the file has: none are made up, none are read beyond.
TEST(FinishFaults, PicturesThatLieAboutTheirSizeAreRefused) {
  const auto refused = [](const std::string& file, FaultKind kind, const char* got,
                          const char* allowed) {
    expect_material_refused(with_picture(file), {{kind, "/texture/data", got, allowed}});
  };
  const char* const broken = "\"bytes that cannot be decoded\"";
  // Four rows, each a filter's byte and four pixels.
  const std::string stream = test::zlib(std::string(4 * 5, '\0'));
  const auto png = [&](std::uint32_t width, std::uint32_t height) {
    return test::png_file({width, height, 8, test::grey}, stream, "");
  };
  EXPECT_NO_THROW(read_material(with_picture(png(4, 4))));
  for (const std::uint32_t height : {5U, 400U})
    refused(png(4, height), wrong_type, broken, "a whole PNG or JPEG picture");
  refused(png(0, 4), wrong_type, broken, "a whole PNG");
  refused(png(2049, 2048), limit, "\"2049 x 2048 pixels\"", "at most 4194304 pixels");
  refused(png(0x7FFFFFFF, 0x7FFFFFFF), wrong_type, broken, "a whole PNG");
  // The height and width of a JPEG stand in its frame header, after FF C0, two bytes and one.
  std::string jpeg = to_text(test::flat_jpeg({51}));
  const std::size_t frame = jpeg.find("\xFF\xC0");
  ASSERT_NE(frame, std::string::npos);
  const auto sized = [&](int height, int width) {
    std::string lying = jpeg;
    for (const auto& [at, size] : {std::pair{frame + 5, height}, std::pair{frame + 7, width}}) {
      lying[at] = static_cast<char>(size >> 8);
      lying[at + 1] = static_cast<char>(size & 255);
    }
    return lying;
  };
  refused(sized(0, 8), wrong_type, broken, "a whole PNG");
  refused(sized(8, 0), wrong_type, broken, "a whole PNG");
  refused(sized(65535, 65535), limit, "\"65535 x 65535 pixels\"", "at most 4194304 pixels");
  for (std::size_t cut = 3; cut < frame + 9; ++cut)
    refused(jpeg.substr(0, cut), wrong_type, broken, "a whole PNG");
}

TEST(FinishFaults, TextThatIsNoBase64IsRefusedAtItsCharacter) {
  const auto refused = [](const std::string& data, const char* got, const char* allowed) {
    expect_material_refused(R"({"texture":{"type":"image","data":")" + data + "\"}}",
                            {{wrong_type, "/texture/data", got, allowed}});
  };
  refused("data:image/png;base64,AAAA", "\":image/png;base6\"", "from its character 4 on");
  refused("AAA", "\"\"", "base64");
  refused("AA==AAAA", "\"==AAAA\"", "base64");
  refused("AB==", "\"B==\"", "from its character 1 on");
}

TEST(FinishFaults, SeveralComeAtOnceInTheOrderOfTheFields) {
  expect_material_refused(
      R"({"ior":0,"reflection":2,"texture":{"type":"wood","colors":[]},"fresnel":1,"shiny":1})",
      {{out_of_range, "/reflection", "2", "from 0 to 1"},
       {out_of_range, "/ior", "0", "from 0.1 to 10"},
       {wrong_type, "/fresnel", "1", "true or false"},
       {wrong_type, "/texture/colors", "[]", "at least 2"},
       {unknown_name, "/shiny", "\"shiny\"", "color, ambient", ""}});
}

// ---- options of light ---------------------------------------------------------------------------

TEST(FinishFaults, OptionsOfLightHaveTheirRanges) {
  const auto refused = [](const std::string& option, const test::Expected& fault) {
    expect_faults(test::faults_of([&] { read_scene(R"({"options":{)" + option + "}}"); }), {fault});
  };
  for (const char* depth : {"-1", "65", "1000000"})
    refused(std::string(R"("max_depth":)") + depth,
            {out_of_range, "/options/max_depth", depth, "an integer from 0 to 64"});
  refused(R"("max_depth":2.5)", {wrong_type, "/options/max_depth", "2.5", "an integer"});
  refused(R"("max_dept":2)",
          {unknown_name, "/options/max_dept", "\"max_dept\"", "max_depth", "max_depth"});
  for (const char* other : {"0", "1", "\"true\"", "null"})
    refused(std::string(R"("transparent_shadows":)") + other,
            {wrong_type, "/options/transparent_shadows", other, "true or false"});
  for (const char* seed : {"-1", "9007199254740992", "1e+300"})
    refused(std::string(R"("seed":)") + seed,
            {out_of_range, "/options/seed", seed, "from 0 to 9007199254740991"});
  expect_faults(test::faults_of([] { read_scene(R"({"ambient_light":[1,-1,1]})"); }),
                {{out_of_range, "/ambient_light/1", "-1", "from 0 to 1000000"}});
}

TEST(FinishFaults, TheSchemaAgreesWithTheReader) {
  const std::vector<std::string> beyond = {"can be undone", "PNG or JPEG picture",
                                           "a picture of at most"};
  test::expect_agreement<Material>(whole_schema<Material>(), 4000, beyond);
}

}  // namespace
}  // namespace tia
