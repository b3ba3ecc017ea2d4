// The scene's JSON Schema, against the reader it describes.
#include <gtest/gtest.h>

#include "core/scene/read_scene.h"
#include "tests/core/schema/corpus.h"

namespace tia {
namespace {

using test::JsonSchema;

const JsonSchema& schema() {
  static const JsonSchema parsed(parse_json(scene_schema()));
  return parsed;
}
bool valid(const char* json) { return schema().valid(parse_json(json)); }

// The schema found along names, through "properties" and "items".
const Value& schema_at(std::initializer_list<const char*> path) {
  const Value* here = &schema().document();
  for (const char* step : path) here = find(*schema().resolved(*here).as<Value::Object>(), step);
  return *here;
}

// The schema of a field of that kind of a tagged union.
const Value& kind_of(const Value& list, std::string_view type, std::string_view field) {
  for (const Value& each :
       *find(*schema().resolved(list).as<Value::Object>(), "oneOf")->as<Value::Array>()) {
    const auto& properties = *find(*each.as<Value::Object>(), "properties")->as<Value::Object>();
    if (*find(*find(properties, "type")->as<Value::Object>(), "const") == Value(type))
      return *find(properties, field);
  }
  throw std::out_of_range("no such kind");
}

TEST(SceneSchema, NamesHaveAtMost256Characters) {
  for (const std::size_t length : {256U, 257U}) {
    const std::string name(length, 'n');
    const bool fits = length == 256;
    for (const std::string& scene :
         {R"({"materials":{")" + name + "\":{}}}", R"({"keys":{")" + name + R"(":{"title":"x"}}})",
          R"({"objects":[{"type":"sphere","center":[0,0,0],"radius":1,"name":")" + name + "\"}]}"})
      EXPECT_EQ(valid(scene.c_str()), fits) << scene;
  }
}

TEST(SceneSchema, IsAnObjectSchemaOf2020) {
  EXPECT_EQ(schema_at({"$schema"}), Value("https://json-schema.org/draft/2020-12/schema"));
  EXPECT_EQ(schema_at({"type"}), Value("object"));
  EXPECT_EQ(schema_at({"additionalProperties"}), Value(false));
}

TEST(SceneSchema, HoldsTheFieldsRangesDefaultsAndWords) {
  const Value& fov = schema_at({"properties", "camera", "properties", "fov_degrees"});
  EXPECT_EQ(*find(*fov.as<Value::Object>(), "exclusiveMinimum"), Value(0));
  EXPECT_EQ(*find(*fov.as<Value::Object>(), "maximum"), Value(179));
  EXPECT_EQ(*find(*fov.as<Value::Object>(), "default"), Value(25));
  EXPECT_EQ(*find(*fov.as<Value::Object>(), "description"),
            Value("vertical field of view, in degrees"));
  const Value& radius = kind_of(schema_at({"properties", "objects", "items"}), "sphere", "radius");
  EXPECT_EQ(*find(*radius.as<Value::Object>(), "exclusiveMinimum"), Value(0));
  EXPECT_EQ(*find(*radius.as<Value::Object>(), "maximum"), Value(1e9));
  EXPECT_EQ(find(*radius.as<Value::Object>(), "default"), nullptr) << "it is required";
  const Value& seed = schema_at({"properties", "options", "properties", "seed"});
  EXPECT_EQ(*find(*seed.as<Value::Object>(), "type"), Value("integer"));
  EXPECT_EQ(*find(*seed.as<Value::Object>(), "maximum"), Value(9007199254740991.0));
  const Value& transfer = schema_at({"properties", "options", "properties", "transfer", "enum"});
  EXPECT_EQ(transfer, Value(Value::Array{"srgb", "linear", "aces", "agx"}));
}

TEST(SceneSchema, AcceptsWhatTheReaderAccepts) {
  const std::string thesis = test::file_text("web/scenes/thesis.json");
  const char* scenes[] = {
      thesis.c_str(),
      "{}",
      R"({"background":0.5})",
      R"({"key_light":{"type":"point"}})",
      R"({"camera":{"direction":[0,0,-1],"right":[1,0,0],"up":[0,1,0]}})",
      R"({"camera":{"projection":"orthographic","height":3}})",
      R"({"camera":{"aperture":1,"focus_distance":3}})",
      R"({"camera":{"distance":1,"pixel_size":1,
          "basis":{"u":[1,0,0],"v":[0,1,0],"w":[0,0,1]}}})",
      R"({"fog":{"density":1,"bounds":{"min":[0,0,0],"max":[1,1,1]}}})",
      R"({"fog":{"density":1,"bounds":{"center":[0,0,0],"radius":1}}})",
      R"({"options":{"samples":65536,"threshold":0}})",
      R"({"objects":[{"type":"sphere","center":[0,0,0],"radius":1e9,"material":{"color":2}}]})",
      R"({"lights":[{"type":"sphere","position":[0,0,0],"radius":1,"color":[1,1,1]}]})",
      R"({"materials":{"any name":{"type":"finish","emission":3}}})",
      R"({"materials":{"m":{"texture":{"type":"wood","colors":[1,[1,0,0],0],"scale":2}}}})",
      R"({"materials":{"m":{"type":"principled","metallic":1,
          "roughness":{"type":"noise","colors":[0,1,0.5],"range":[0.9,0.1],"channel":"g"}}}})",
      R"({"keys":{"a":{"light":[1,2,3]},"b":{"title":"x"},"c":{"light":1,"title":"x"},"d":{}}})",
      R"({"options":{"integrator":"thesis","transfer":"srgb","seed":9007199254740991}})",
      R"({"options":{"integrator":"path","noise":0.01,"samples":256}})",
      R"({"animation":{"duration":2,"tracks":[
          {"target":"/a","keys":[[0,1,"in"],[1,{}]],"interpolation":"step","repeat":"loop"},
          {"target":"/b","keys":[[0,1,2,3]],"interpolation":"bezier"},
          {"target":"/c","formula":["t","a"],"parameters":{"a":1}},
          {"target":"/d","visible":[[0,1]]}]}})",
      R"({"physics":{"gravity":[0,0,0],"solver":"rigid","bodies":[
          {"object":"a","mass":1,"spin":[0,1,0]},{"object":"/objects/1","density":2}],
          "fixed":[{"object":"c"}],"pairs":[{"objects":["a","c"],"friction":0}]}})",
      R"({"options":{"transfer":"agx","exposure":-32,"white_balance_kelvin":1000}})"};
  for (const char* json : scenes) {
    EXPECT_NO_THROW(read_scene(json)) << json;
    EXPECT_TRUE(valid(json)) << json;
  }
}

TEST(SceneSchema, RefusesWhatTheReaderRefuses) {
  for (const char* json :
       {"[]",
        "1",
        R"({"titel":"x"})",
        R"({"title":1})",
        R"({"camera":{"fov_degrees":0}})",
        R"({"camera":{"fov_degrees":180}})",
        R"({"camera":{"up":[0,1]}})",
        R"({"camera":{"location":[0,2e9,0]}})",
        R"({"camera":{"projection":"mercator"}})",
        R"({"camera":{"projection":"orthographic","height":0}})",
        R"({"camera":{"aperture":-1}})",
        R"({"camera":{"basis":{"u":[1,0,0]}}})",
        R"({"options":{"samples":0}})",
        R"({"options":{"samples":65537}})",
        R"({"options":{"samples":1.5}})",
        R"({"options":{"threshold":1.1}})",
        R"({"background":-1})",
        R"({"background":[0,0]})",
        R"({"objects":[{"type":"sphere","center":[0,0,0]}]})",
        R"({"objects":[{"center":[0,0,0],"radius":1}]})",
        R"({"objects":[{"type":"cube","center":[0,0,0],"radius":1}]})",
        R"({"objects":[{"type":"sphere","center":[0,0,0],"radius":0}]})",
        R"({"objects":[{"type":"sphere","center":[0,0,0],"radius":1,"material":5}]})",
        R"({"lights":[{"type":"point","position":[0,0,0],"radius":1}]})",
        R"({"lights":[{"type":"sphere","position":[0,0,0]}]})",
        R"({"lights":[{}]})",
        R"({"materials":{"m":{"diffuse":2}}})",
        R"({"materials":{"m":{"colour":1}}})",
        R"({"materials":{"m":{"texture":{}}}})",
        R"({"materials":{"m":{"texture":{"type":"checker","colors":[1]}}}})",
        R"({"materials":{"m":{"texture":{"type":"image","data":"AAA"}}}})",
        R"({"materials":{"m":{"texture":{"type":"checker","range":[0,1]}}}})",
        R"({"materials":{"m":{"type":"principled","roughness":{"type":"checker"}}}})",
        R"({"materials":{"m":{"type":"principled","roughness":{"range":[0,1]}}}})",
        R"({"materials":{"m":{"type":"principled","roughness":{"type":"noise","range":[0,2]}}}})",
        R"({"materials":{"m":{"type":"principled","ior":{"type":"noise","range":[0,1]}}}})",
        R"({"materials":{"m":{"roughness":{"type":"noise","range":[0,1]}}}})",
        R"({"fog":{"density":1,"bounds":{}}})",
        R"({"fog":{"density":1,"bounds":{"min":[0,0,0]}}})",
        R"({"fog":{"density":1,"bounds":{"center":[0,0,0],"max":[1,1,1]}}})",
        R"({"fog":{"density":1,"bounds":{"min":[0,0,0],"max":[1,1,1],"radius":1}}})",
        R"({"keys":{"a":{"light":[1,2]}}})",
        R"({"keys":{"a":5}})",
        R"({"options":{"seed":-1}})",
        R"({"options":{"seed":1.5}})",
        R"({"options":{"transfer":"gamma"}})",
        R"({"options":{"integrator":"paths"}})",
        R"({"objects":[{"type":"group","children":[]}]})",
        R"({"objects":[{"type":"csg","operation":"minus","children":[{"type":"group"}]}]})",
        R"({"objects":[{"type":"mesh","positions":[0,0,0],"indices":[0,0,0]}]})",
        R"({"objects":[{"type":"torus","major_radius":1,"minor_radius":-1}]})"}) {
    EXPECT_THROW(read_scene(json), InputError) << json;
    EXPECT_FALSE(valid(json)) << json;
  }
}

// What the reader checks beyond the schema, all of it across fields: by the words of the faults.
const std::vector<std::string> beyond_scene_schema = {
    // the options
    "whose rays are chance", "noise or threshold",
    // the camera
    "look_at or direction", "right goes with", "basis goes without", "goes with basis", "for basis",
    "basis goes without distance", "goes with projection orthographic", "projection orthographic",
    "only projection perspective", "for aperture", "of aperture", "of pixel_size",
    "a point other than location", "a direction of some length", "not zero, not parallel",
    "a view plane of some size", "of the view plane's size", "a vector of length 1",
    "perpendicular to u", "u x v", "more than near", "goes with projection", "go with projection",
    "goes without pixel_size", "fov_degrees goes with",
    // of displays
    "of which such a display", "has no lens", "such a display says itself",
    "the middle of the display's window", "where the camera has no look_at", "interlace goes with",
    "from left to right", "between neighbours", "pitch goes with", "one for all, or one for each",
    "as many points as", "at least 2 views", "matrix goes with",
    // animations: what a track is made of, keys that belong together
    "one of keys, formula and visible", "keys, formula or visible", "with keys", "with a formula",
    "with interpolation step", "as many numbers in each key", "tangents", "times that ascend",
    "of which to is later", "duration times fps",
    // physics: what belongs together
    "mass or density", "two objects", "another object", "none by exact",
    // sheets, and the ground that shadows fall on
    "a scene that has a backdrop", "at most as many columns",
    // shapes
    "above min in every component", "a point other than base", "above 0 where base_radius is 0",
    "more than a constant", "total degree", "below major_radius", "not on the line through a and b",
    // the sun
    "either elevation_degrees", "longitude_degrees together", "a day that its month has",
    "at most 4 suns", "at most the samples of a pixel",
    // pictures of the sky
    "a whole PNG or JPEG picture", "a whole Radiance HDR picture", "a picture by latitude",
    // voxels: what lies in the grid, whose numbers are materials
    "cells of the grid are left", "below the size", "named with before", "at least one filled cell",
    "a grid of at most", "cells together", "has no materials", "of one of the materials",
    "one `material`", "numbered materials",
    // formulas
    "at column", "a name: a letter", "a name that means", "from below to", "something in common",
    "children that cost less",
    // meshes: lists that belong together, numbers inside of base64
    "bytes of numbers", "numbers of 4 bytes", "a multiple of 3 numbers", "for each of the",
    "the index of a position", "a normal of some length",
    // objects in objects: solids, copies, transforms
    "a solid (", "copies in all", "not 0 where there is more than one copy",
    "a group whose children have bounds", "a group without repeat", "can be undone",
    "with the transforms around it", "luminous balls",
    // walls
    "at most 512 points", "at least 3 points", "another point than the", "for its corners",
    "does not turn back", "not in the way of", "beyond the end of opening", "the walls' height",
    "where the opening ends", "where it begins", "between the corners",
    // lights
    "a number from radius_degrees", "a point other than position", "an edge that spans an area",
    "fading of a light that is at some distance",
    // pictures: what they decode to
    "PNG or JPEG picture", "a picture of at most", "pixels together",
    // links: names of materials, places of lights
    "the scene names none", "one of name ", "where the light is"};

TEST(SceneSchema, AgreesWithTheReaderOnMadeDocuments) {
  test::expect_agreement<Scene>(schema().document(), 1500, beyond_scene_schema);
}

}  // namespace
}  // namespace tia
