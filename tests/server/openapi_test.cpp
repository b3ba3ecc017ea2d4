// The OpenAPI document: all that the tables hold that serve requests, and nothing else.
#include <set>

#include "server/assets.h"
#include "server/explain_request.h"
#include "server/headers.h"
#include "server/refusals.h"
#include "tests/core/schema/corpus.h"
#include "tests/server/openapi_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

TEST(OpenApi, HoldsEveryRouteAndNothingElse) {
  std::set<std::string> table, told;
  for (const Route& route : routes())
    table.insert(server::lower(route.method) + " " + path_template(route));
  for (const Operation& each : operations()) told.insert(each.method + " " + each.path);
  EXPECT_EQ(told, table);
  EXPECT_EQ(table.size(), routes().size());
}

struct FieldNames {
  std::vector<std::string> names = {};
  template <class Base, class Member>
  void operator()(std::string_view name, Member Base::*, const Spec&) {
    names.emplace_back(name);
  }
};
template <class T>
std::vector<std::string> field_names() {
  FieldNames visitor;
  T::fields(visitor);
  return visitor.names;
}

TEST(OpenApi, HoldsEveryParameterOfTheTablesInOrder) {
  EXPECT_EQ(parameter_names(operation("get_render"), "query"), field_names<PictureRequest>());
  std::vector<std::string> explain = field_names<ExplainRequest>();
  for (const std::string& name : field_names<FreeRay>()) explain.push_back("ray." + name);
  EXPECT_EQ(parameter_names(operation("get_explain"), "query"), explain);
}

TEST(OpenApi, HoldsAParametersRangeDefaultAndUnit) {
  const Value& width = as_array(at(operation("get_render"), "parameters"))[3];
  EXPECT_EQ(text_at(width, "name"), "width");
  EXPECT_THAT(text_at(width, "description"), HasSubstr("in pixels"));
  EXPECT_EQ(at(width, "schema"),
            Value(Value::Object{
                {"type", "integer"}, {"minimum", 1}, {"maximum", 16'777'216}, {"default", 640}}));
}

// OpenAPI's words for what text_form.h reads: a list as 1,2,3, an object as JSON.
TEST(OpenApi, TellsHowAParameterStandsInAQuery) {
  const auto parameter = [](const char* name) -> const Value& {
    for (const Value& each : as_array(at(operation("get_explain"), "parameters")))
      if (text_at(each, "name") == name) return each;
    throw std::out_of_range(name);
  };
  for (const char* list : {"light", "ray.origin", "ray.direction"}) {
    EXPECT_EQ(text_at(parameter(list), "style"), "form") << list;
    EXPECT_EQ(at(parameter(list), "explode"), Value(false)) << list;
  }
  for (const char* object : {"camera", "ray"})
    EXPECT_NE(find(as_object(parameter(object)), "content"), nullptr) << object;
  const auto& either = as_array(at(at(parameter("scene"), "schema"), "anyOf"));
  ASSERT_EQ(either.size(), 2U);
  EXPECT_EQ(text_at(either[1], "contentMediaType"), "application/json");
  EXPECT_EQ(text_at(at(either[1], "contentSchema"), "$ref"), "#/components/schemas/scene");
}

template <class... Kinds>
std::set<std::string> types_of(const std::variant<Kinds...>*) {
  return {std::string(Kinds::type)...};
}
std::set<std::string> kinds_in(const std::string& schema) {
  std::set<std::string> kinds;
  for (const Value& each : as_array(at(component("schemas", schema), "oneOf")))
    kinds.insert(text_at(at(at(each, "properties"), "type"), "const"));
  return kinds;
}

TEST(OpenApi, HoldsEveryKindOfTheLists) {
  EXPECT_EQ(kinds_in("light"), types_of(static_cast<decltype(Light::kind)*>(nullptr)));
  const std::set<std::string> shapes = kinds_in("object");
  EXPECT_EQ(shapes, types_of(static_cast<Shape*>(nullptr)));
}

TEST(OpenApi, HoldsEveryProblemWithItsStatus) {
  std::set<std::pair<std::string, double>> told, table;
  for (const auto& [name, answer] :
       as_object(at(at(openapi().document(), "components"), "responses")))
    if (const Value* content = find(as_object(answer), "content"))
      for (const Value& type : as_array(at(
               at(at(at(at(*content, "application/problem+json"), "schema"), "properties"), "type"),
               "enum")))
        told.emplace(as_text(type), name == "default" ? 0 : std::stod(name));
  for (const ProblemRow& row : problem_rows()) {
    table.emplace(problem_uri(row), is_met_by_all(row) ? 0 : row.status);
  }
  EXPECT_EQ(told, table);
}

TEST(OpenApi, TheFilesOfThePageAreThoseThatThereAre) {
  const std::string_view file = "{file}";
  std::set<std::string> told;
  for (const auto& [path, item] : as_object(at(openapi().document(), "paths"))) {
    if (!path.ends_with(file)) continue;
    const Value& schema = at(as_array(at(at(item, "get"), "parameters"))[0], "schema");
    const std::string folder = path.substr(0, path.size() - file.size());
    for (const Value& name : as_array(at(schema, "enum"))) told.insert(folder + as_text(name));
  }
  for (const std::string& path : told) EXPECT_EQ(host().get(path).status, 200) << path;
  for (const Asset& asset : assets())
    EXPECT_EQ(told.contains(std::string(asset.path)), !asset.path.starts_with("/scenes/"));
}

// ---- examples -----------------------------------------------------------------------------------

TEST(OpenApi, EveryExampleObeysItsSchemaAndIsAnsweredWell) {
  int examples = 0;
  for (const Operation& each : operations()) {
    const Value* body = find(as_object(each.is), "requestBody");
    if (body == nullptr) continue;
    const Value* json = find(as_object(at(*body, "content")), "application/json");
    if (json == nullptr) continue;
    const Value& media = *json;
    for (const auto& [name, example] : as_object(at(media, "examples"))) {
      SCOPED_TRACE(each.path + " " + name);
      EXPECT_TRUE(openapi().valid(at(example, "value"), at(media, "schema")));
      EXPECT_LT(host().post(each.path, to_json(at(example, "value"))).status, 300);
      ++examples;
    }
  }
  EXPECT_GE(examples, 5);
  for (const Route& route : routes())
    for (const std::string_view target : route.examples)
      EXPECT_LT(host().get(std::string(target)).status, 400) << target;
}

// ---- bodies of requests -------------------------------------------------------------------------

// A patch alone, then the camera that it makes.
std::vector<Fault> faults_of_patch(const Value& patch) {
  Faults faults;
  CameraPatch read;
  read_value(patch, Place{}, Spec{}, faults, read);
  if (!faults.empty()) return faults.list();
  Camera camera;
  read_value(merge_patch(write_value(camera), patch), Place{}, Spec{}, faults, camera);
  return faults.list();
}

TEST(OpenApi, ThePatchOfACameraAgreesWithTheReader) {
  // What concerns several fields, and what the camera lacks when it has been patched.
  const std::vector<std::string> beyond = {"look_at or direction",
                                           "right goes with",
                                           "basis goes without",
                                           "goes with basis",
                                           "for basis",
                                           "goes with projection orthographic",
                                           "projection orthographic",
                                           "only projection perspective",
                                           "for aperture",
                                           "of aperture",
                                           "of pixel_size",
                                           "a point other than location",
                                           "a direction of some length",
                                           "not zero, not parallel",
                                           "a view plane of some size",
                                           "of the view plane's size",
                                           "a vector of length 1",
                                           "perpendicular",
                                           "u x v",
                                           "to the right",
                                           "upwards",
                                           "towards the viewer"};
  expect_agreement(whole_schema<CameraPatch>(), faults_of_patch, 2000, beyond);
}

TEST(OpenApi, TheSchemaOfAnExplanationHoldsEveryTerm) {
  const Value& names =
      at(at(at(at(at(component("schemas", "node"), "properties"), "terms"), "items"), "properties"),
         "name");
  EXPECT_EQ(as_array(at(names, "enum")).size(), tia::Names<TermName>::names.size());
}

// ---- GET /openapi.json
// ----------------------------------------------------------------------------

TEST(OpenApi, IsAnsweredAsJsonWithATag) {
  const Response response = host().get("/openapi.json");
  EXPECT_EQ(response.status, 200);
  EXPECT_EQ(response.content_type, "application/json");
  EXPECT_TRUE(parse_json(response.body) == openapi().document());
  const std::string etag = header(response, "ETag").value_or("");
  EXPECT_EQ(host().get("/openapi.json", {{"If-None-Match", etag}}).status, 304);
}

}  // namespace
}  // namespace tia::test
