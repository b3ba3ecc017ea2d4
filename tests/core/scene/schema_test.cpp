// The scene's JSON Schema, against the reader it describes: a validator of the words that it uses.
#include <gtest/gtest.h>

#include "core/scene/read_scene.h"
#include "tests/core/support.h"

namespace tia {
namespace {

double number(const Value& v) { return *v.as<double>(); }

bool has_type(const Value& value, const std::string& type) {
  if (type == "object") return value.as<Value::Object>() != nullptr;
  if (type == "array") return value.as<Value::Array>() != nullptr;
  if (type == "string") return value.as<std::string>() != nullptr;
  if (type == "number") return value.as<double>() != nullptr;
  if (type == "integer")
    return value.as<double>() != nullptr && number(value) == std::trunc(number(value));
  throw std::runtime_error("type " + type);
}

// Whether a value is valid, by JSON Schema 2020-12. Throws at a word that it does not know.
bool valid(const Value& value, const Value& schema_value) {
  const auto& schema = *schema_value.as<Value::Object>();
  const auto* object = value.as<Value::Object>();
  const auto* array = value.as<Value::Array>();
  const auto* numeric = value.as<double>();
  for (const auto& [word, is] : schema) {
    bool good = true;
    if (word == "type") {
      good = has_type(value, *is.as<std::string>());
    } else if (word == "properties") {
      for (const auto& [name, each] : *is.as<Value::Object>())
        if (const Value* member = object != nullptr ? find(*object, name) : nullptr)
          good = good && valid(*member, each);
    } else if (word == "additionalProperties") {
      const Value* named = find(schema, "properties");
      for (const auto& [name, member] : object != nullptr ? *object : Value::Object{}) {
        if (named != nullptr && find(*named->as<Value::Object>(), name) != nullptr) continue;
        good = good && (is.as<bool>() != nullptr ? *is.as<bool>() : valid(member, is));
      }
    } else if (word == "required") {
      for (const Value& name : *is.as<Value::Array>())
        good = good && (object == nullptr || find(*object, *name.as<std::string>()) != nullptr);
    } else if (word == "maxProperties") {
      good = object == nullptr || static_cast<double>(object->size()) <= number(is);
    } else if (word == "items") {
      for (const Value& each : array != nullptr ? *array : Value::Array{})
        good = good && valid(each, is);
    } else if (word == "minItems") {
      good = array == nullptr || static_cast<double>(array->size()) >= number(is);
    } else if (word == "maxItems") {
      good = array == nullptr || static_cast<double>(array->size()) <= number(is);
    } else if (word == "minimum") {
      good = numeric == nullptr || *numeric >= number(is);
    } else if (word == "exclusiveMinimum") {
      good = numeric == nullptr || *numeric > number(is);
    } else if (word == "maximum") {
      good = numeric == nullptr || *numeric <= number(is);
    } else if (word == "enum") {
      const auto& list = *is.as<Value::Array>();
      good = std::find(list.begin(), list.end(), value) != list.end();
    } else if (word == "const") {
      good = value == is;
    } else if (word == "oneOf") {
      int matches = 0;
      for (const Value& each : *is.as<Value::Array>()) matches += valid(value, each);
      good = matches == 1;
    } else if (word == "not") {
      good = !valid(value, is);
    } else if (word != "description" && word != "default" && word != "title" && word != "$schema") {
      throw std::runtime_error("schema word " + word);
    }
    if (!good) return false;
  }
  return true;
}

const Value& schema() {
  static const Value parsed = parse_json(scene_schema());
  return parsed;
}

// The schema found along names, through "properties" and "items".
const Value& at(std::initializer_list<const char*> path) {
  const Value* here = &schema();
  for (const char* step : path) here = find(*here->as<Value::Object>(), step);
  return *here;
}

TEST(SceneSchema, IsAnObjectSchemaOf2020) {
  EXPECT_EQ(at({"$schema"}), Value("https://json-schema.org/draft/2020-12/schema"));
  EXPECT_EQ(at({"type"}), Value("object"));
  EXPECT_EQ(at({"additionalProperties"}), Value(false));
}

TEST(SceneSchema, HoldsTheFieldsRangesDefaultsAndWords) {
  const Value& fov = at({"properties", "camera", "properties", "fov_degrees"});
  EXPECT_EQ(*find(*fov.as<Value::Object>(), "exclusiveMinimum"), Value(0));
  EXPECT_EQ(*find(*fov.as<Value::Object>(), "maximum"), Value(179));
  EXPECT_EQ(*find(*fov.as<Value::Object>(), "default"), Value(25));
  EXPECT_EQ(*find(*fov.as<Value::Object>(), "description"),
            Value("vertical field of view, in degrees"));
  const Value& radius = at({"properties", "objects", "items", "properties", "radius"});
  EXPECT_EQ(*find(*radius.as<Value::Object>(), "exclusiveMinimum"), Value(0));
  EXPECT_EQ(*find(*radius.as<Value::Object>(), "maximum"), Value(1e9));
  EXPECT_EQ(find(*radius.as<Value::Object>(), "default"), nullptr) << "it is required";
  const Value& seed = at({"properties", "options", "properties", "seed"});
  EXPECT_EQ(*find(*seed.as<Value::Object>(), "type"), Value("integer"));
  EXPECT_EQ(*find(*seed.as<Value::Object>(), "maximum"), Value(9007199254740991.0));
  const Value& transfer = at({"properties", "options", "properties", "transfer", "enum"});
  EXPECT_EQ(transfer, Value(Value::Array{"srgb", "linear"}));
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
      R"({"options":{"samples":65536,"threshold":0}})",
      R"({"objects":[{"type":"sphere","center":[0,0,0],"radius":1e9,"material":{"color":2}}]})",
      R"({"lights":[{"type":"sphere","position":[0,0,0],"radius":1,"color":[1,1,1]}]})",
      R"({"materials":{"any name":{"type":"finish","emission":3}}})",
      R"({"keys":{"a":{"light":[1,2,3]},"b":{"title":"x"},"c":{"light":1,"title":"x"},"d":{}}})",
      R"({"options":{"integrator":"thesis","transfer":"srgb","seed":9007199254740991}})"};
  for (const char* json : scenes) {
    EXPECT_NO_THROW(read_scene(json)) << json;
    EXPECT_TRUE(valid(parse_json(json), schema())) << json;
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
        R"({"camera":{"projection":"fisheye"}})",
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
        R"({"keys":{"a":{"light":[1,2]}}})",
        R"({"keys":{"a":5}})",
        R"({"options":{"seed":-1}})",
        R"({"options":{"seed":1.5}})",
        R"({"options":{"transfer":"gamma"}})",
        R"({"options":{"integrator":"path"}})"}) {
    EXPECT_THROW(read_scene(json), InputError) << json;
    EXPECT_FALSE(valid(parse_json(json), schema())) << json;
  }
}

}  // namespace
}  // namespace tia
