// The OpenAPI document's form. Source: OpenAPI Specification 3.1.0, 4.8.
#include <functional>
#include <regex>
#include <set>

#include "core/version.h"
#include "tests/server/contract/openapi_support.h"

namespace tia::test {
namespace {

using testing::Contains;

void visit_all(const Value& value, const std::function<void(const Value::Object&)>& see) {
  if (const auto* items = value.as<Value::Array>())
    for (const Value& item : *items) visit_all(item, see);
  if (const auto* members = value.as<Value::Object>()) {
    see(*members);
    for (const auto& [name, part] : *members) visit_all(part, see);
  }
}

TEST(OpenApi, SaysWhatItIs) {
  const Value& all = openapi().document();
  EXPECT_EQ(text_at(all, "openapi"), "3.1.0");
  EXPECT_EQ(text_at(all, "jsonSchemaDialect"), "https://json-schema.org/draft/2020-12/schema");
  EXPECT_EQ(text_at(at(all, "info"), "title"), "Tia");
  EXPECT_EQ(text_at(at(all, "info"), "version"), version());
  for (const auto& [name, part] : as_object(all))
    EXPECT_THAT((std::set<std::string>{"openapi", "info", "jsonSchemaDialect", "servers", "paths",
                                       "components", "x-problems"}),
                Contains(name));
}

TEST(OpenApi, EveryReferenceResolves) {
  int references = 0;
  visit_all(openapi().document(), [&](const Value::Object& object) {
    if (find(object, "$ref") == nullptr) return;
    ++references;
    EXPECT_NO_THROW(openapi().resolved(object)) << to_json(object);
  });
  EXPECT_GT(references, 100);
}

TEST(OpenApi, EveryOperationHasANameOfItsOwnASummaryAndAnswers) {
  std::set<std::string> names;
  for (const Operation& each : operations()) {
    SCOPED_TRACE(each.method + " " + each.path);
    EXPECT_TRUE(names.insert(text_at(each.is, "operationId")).second);
    EXPECT_FALSE(text_at(each.is, "summary").empty());
    const auto& answers = as_object(at(each.is, "responses"));
    EXPECT_NE(find(answers, "default"), nullptr);
    EXPECT_GE(answers.size(), 2U);
    for (const auto& [status, answer] : answers) {
      EXPECT_THAT(status, testing::MatchesRegex("default|[2345][0-9][0-9]"));
      EXPECT_FALSE(text_at(openapi().resolved(answer), "description").empty());
    }
  }
}

TEST(OpenApi, EveryParameterIsDescribedWithASchema) {
  for (const Operation& each : operations()) {
    if (find(as_object(each.is), "parameters") == nullptr) continue;
    for (const Value& parameter : as_array(at(each.is, "parameters"))) {
      SCOPED_TRACE(each.path + " " + text_at(parameter, "name"));
      EXPECT_FALSE(text_at(parameter, "description").empty());
      const Value *schema = find(as_object(parameter), "schema"),
                  *content = find(as_object(parameter), "content");
      EXPECT_TRUE((schema != nullptr) != (content != nullptr));  // one of them: 4.8.12.2
      if (content != nullptr) {
        EXPECT_EQ(as_object(*content).size(), 1U);
        EXPECT_NE(find(as_object(at(*content, "application/json")), "schema"), nullptr);
      }
      const bool in_path = text_at(parameter, "in") == "path";
      EXPECT_EQ(find(as_object(parameter), "required") != nullptr, in_path);
      EXPECT_EQ(in_path, each.path.find("{" + text_at(parameter, "name") + "}") != each.path.npos);
    }
  }
}

TEST(OpenApi, EveryPathIsATemplateWhoseNamesAreParameters) {
  const std::regex name(R"(\{([a-z]+)\})");
  for (const Operation& each : operations()) {
    EXPECT_TRUE(each.path.starts_with('/'));
    std::vector<std::string> expected;
    for (std::sregex_iterator i(each.path.begin(), each.path.end(), name), end; i != end; ++i)
      expected.push_back((*i)[1]);
    EXPECT_EQ(parameter_names(each.is, "path"), expected) << each.path;
  }
}

TEST(OpenApi, EveryComponentHasANameThatToolsTake) {
  for (const auto& [group, components] : as_object(at(openapi().document(), "components")))
    for (const auto& [name, is] : as_object(components))
      EXPECT_THAT(name, testing::MatchesRegex("[a-zA-Z0-9._-]+")) << group;
}

// A stream has not all headers of a picture: so these are required by the types that are none.
TEST(OpenApi, PicturesRequireTheirHeadersWhereThereAreStreams) {
  const std::set<std::string> of_pictures{"Cache-Control", "Cache-Status",  "ETag",
                                          "Tia-Rays",      "Server-Timing", "X-Request-Id"};
  int pictures = 0;
  for (const Operation& each : operations()) {
    const Value* answer = find(as_object(at(each.is, "responses")), "200");
    if (answer == nullptr || find(as_object(*answer), "content") == nullptr) continue;
    if (each.path == "/film") continue;  // of which those that play live alone have no tag
    std::set<std::string> of_all;
    for (const auto& [name, header] : as_object(at(*answer, "headers")))
      if (at(openapi().resolved(header), "required") == Value(true)) of_all.insert(name);
    for (const auto& [type, media] : as_object(at(*answer, "content"))) {
      const Value* own = find(as_object(media), "x-required-headers");
      if (own == nullptr) continue;
      std::set<std::string> names = of_all;
      for (const Value& name : as_array(*own)) names.insert(as_text(name));
      const bool is_stream = type == "text/event-stream" || type.starts_with("multipart/");
      EXPECT_EQ(names == of_pictures, !is_stream) << each.path << ' ' << type;
      pictures += is_stream ? 0 : 1;
    }
  }
  EXPECT_GE(pictures, 5 * 5);  // five formats of /render, /still, both by GET and POST, /pictures
}

}  // namespace
}  // namespace tia::test
