// How textures stand in JSON: round trips, faults, the schema against the reader.
#include "core/materials/material.h"
#include "tests/core/materials/textures.h"
#include "tests/core/schema/corpus.h"

namespace tia {
namespace {

using enum FaultKind;
using test::expect_faults;
using test::texture;
using test::texture_faults;

TEST(TextureDescription, WritesWhatIsNotByDefaultAndReadsItBack) {
  for (const char* json :
       {R"({"type":"checker"})", R"({"colors":[[1,0,0],[0,0.5,0]],"scale":2.5,"type":"checker"})",
        R"({"transform":[{"translate":[1,2,3]},{"scale":2}],"type":"stripes"})",
        R"({"colors":[[1,0,0],[0,0.5,0],[0,0,1]],"type":"gradient"})",
        R"({"scale":0.125,"type":"noise"})",
        R"({"colors":[[1,1,1],[0,0,0],[2,2,2],[3,3,3]],"turbulence":0,"type":"marble"})",
        R"({"turbulence":3,"type":"wood"})"}) {
    EXPECT_EQ(to_json(write_value(texture(json))), json);
  }
  EXPECT_EQ(to_json(write_value(texture(
                R"({"type":"marble","turbulence":1,"scale":1,"colors":[1,0],"transform":[]})"))),
            R"({"type":"marble"})");
}

TEST(TextureDescription, AnImageKeepsItsText) {
  const std::string file = R"("iVBORw0KGgoAAAANSUhEUgAAAAEAAAABCAAAAAA6fptVAAAACklEQVR42mP4DwAB)"
                           R"(AQEAHLCMmQAAAABJRU5ErkJggg==")";
  const std::string json = R"({"data":)" + file + R"(,"filter":"nearest","repeat":[2,1],)" +
                           R"("transfer":"linear","type":"image"})";
  EXPECT_EQ(to_json(write_value(texture(json))), json);
  const auto pixels = std::get<ImageTexture>(texture(json).kind).data.pixels;
  EXPECT_EQ(pixels->rgb, (std::vector<std::uint8_t>{255, 255, 255}));
}

TEST(TextureDescription, FaultsComeWhereTheyStand) {
  expect_faults(texture_faults("{}"), {{missing, "/type", "", "one of checker, stripes"}});
  expect_faults(texture_faults(R"({"type":"chequer"})"),
                {{unknown_name, "/type", "\"chequer\"", "checker", "checker"}});
  expect_faults(texture_faults(R"({"type":"checker","colors":[1,0,1],"scale":0})"),
                {{wrong_type, "/colors", "[1,0,1]", "2 colours"},
                 {out_of_range, "/scale", "0", "above 0, at most 1000000000"}});
  expect_faults(texture_faults(R"({"type":"stripes","colors":[[1,0,-1],0],"turbulence":1})"),
                {{out_of_range, "/colors/0/2", "-1", "from 0 to 1000000"},
                 {unknown_name, "/turbulence", "\"turbulence\"", "colors, scale", ""}});
  expect_faults(texture_faults(R"({"type":"noise","colors":[1]})"),
                {{wrong_type, "/colors", "[1]", "at least 2"}});
  expect_faults(texture_faults(R"({"type":"wood","turbulence":-1,"transform":[{"scale":0}]})"),
                {{out_of_range, "/turbulence", "-1", "from 0 to 100"},
                 {out_of_range, "/transform/0/scale", "0", "not 0"}});
}

TEST(TextureDescription, AFinishHasOne) {
  const char* json = R"({"diffuse":0.5,"texture":{"scale":2,"type":"checker"}})";
  const auto material = read_described<Material>(parse_json(json));
  const auto& finish = std::get<Finish>(material.kind);
  ASSERT_TRUE(finish.texture.has_value());
  EXPECT_EQ(std::get<Checker>(finish.texture->kind).scale, 2);
  EXPECT_EQ(to_json(write_value(material)), json);
  expect_faults(test::faults_of([] {
                  read_described<Material>(parse_json(R"({"texture":{"type":"wood","scale":-1}})"));
                }),
                {{out_of_range, "/texture/scale", "-1", "above 0"}});
}

TEST(TextureDescription, TheSchemaAgreesWithTheReader) {
  const std::vector<std::string> beyond = {"can be undone", "PNG or JPEG picture",
                                           "a picture of at most"};
  test::expect_agreement<Texture>(whole_schema<Texture>(), 3000, beyond);
}

}  // namespace
}  // namespace tia
