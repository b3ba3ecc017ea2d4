// The page of documentation: what the server gives it, and what leads to it. That it tells all of
// that, tests/browser/docs.test.mjs holds.
#include <algorithm>

#include "core/input/json.h"
#include "server/contract/openapi.h"
#include "server/contract/problem_table.h"
#include "server/handlers/route_table.h"
#include "server/http/headers.h"
#include "server/operation/config.h"
#include "server/stores/assets.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

const Value& document() {
  static const Value parsed = parse_json(host().get("/openapi.json").body);
  return parsed;
}

// Its members' names as the text has them, which is the order that people read them in.
std::vector<std::string> names_in(const Value& object) {
  std::vector<std::string> names;
  for (const auto& [name, member] : *object.as<Value::Object>()) names.push_back(name);
  return names;
}

TEST(Docs, IsAPageWithATag) {
  const Response response = host().get("/docs");
  EXPECT_EQ(response.status, 200);
  EXPECT_EQ(response.content_type, "text/html; charset=utf-8");
  EXPECT_TRUE(response.body == find_asset("/docs.html")->bytes);
  const std::string etag = header(response, "ETag").value_or("");
  EXPECT_EQ(host().get("/docs", {{"If-None-Match", etag}}).status, 304);
}

TEST(Docs, AreDrawnFromADocumentThatHoldsAllRoutesInOrder) {
  std::vector<std::string> paths;
  for (const Route& route : routes()) {
    const std::string path = path_template(route);
    if (paths.empty() || paths.back() != path) paths.push_back(path);
    const Value& operation = at(at(at(document(), "paths"), path), server::lower(route.method));
    EXPECT_EQ(text_at(operation, "operationId"), route.name);
    if (route.examples.empty()) continue;
    EXPECT_EQ(at(operation, "x-examples"),
              Value(Value::Array(route.examples.begin(), route.examples.end())));
  }
  EXPECT_EQ(names_in(at(document(), "paths")), paths);
}

TEST(Docs, HaveTheFieldsOfASceneInOrder) {
  const auto fields = [](const Value& all) {
    return names_in(at(at(at(at(all, "components"), "schemas"), "scene"), "properties"));
  };
  EXPECT_EQ(fields(document()), fields(openapi_document(routes())));
  EXPECT_FALSE(std::ranges::is_sorted(fields(document())));
}

TEST(Docs, HaveTheTablesOfProblemsAndOptions) {
  const auto& problems = *at(document(), "x-problems").as<Value::Array>();
  ASSERT_EQ(problems.size(), problem_rows().size());
  for (std::size_t i = 0; i < problems.size(); ++i) {
    EXPECT_EQ(text_at(problems[i], "type"), problem_uri(problem_rows()[i]));
    EXPECT_EQ(text_at(problems[i], "description"), problem_rows()[i].about);
  }
  const auto& options = *at(document(), "x-options").as<Value::Array>();
  const std::vector<OptionRow> rows = option_rows();
  ASSERT_EQ(options.size(), rows.size());
  for (std::size_t i = 0; i < options.size(); ++i) {
    const OptionRow& row = rows[i];
    EXPECT_EQ(text_at(options[i], "variable"), row.variable);
    EXPECT_EQ(text_at(options[i], "allowed"), row.allowed);
    const bool of_the_machine = row.name == "threads" || row.name == "memory_bytes";
    EXPECT_EQ(find(*options[i].as<Value::Object>(), "default") == nullptr,
              of_the_machine || row.value.empty())
        << row.name;
  }
}

TEST(Docs, EveryTypeOfProblemLeadsToItsPlaceOnThePage) {
  for (const ProblemRow& row : problem_rows()) {
    const Response response = host().get(problem_uri(row));
    EXPECT_EQ(response.status, 308);
    EXPECT_EQ(header(response, "Location"), "/docs#problem-" + std::string(row.type));
  }
  EXPECT_EQ(host().get("/problems/none").status, 404);
}

}  // namespace
}  // namespace tia::test
