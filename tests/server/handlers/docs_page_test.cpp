// The page of documentation: all that the tables hold is on it, and every link leads somewhere.
#include "server/handlers/docs_page.h"
#include "server/handlers/route_table.h"

#include <regex>
#include <set>

#include "server/contract/openapi.h"
#include "server/contract/problem_table.h"
#include "server/handlers/html.h"
#include "server/handlers/schema_words.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

using testing::Contains;
using testing::HasSubstr;
using testing::Not;

const std::string& docs_text() {
  static const std::string text = host().get("/docs").body;
  return text;
}

std::vector<std::string> all_matches(const char* pattern) {
  const std::regex regex(pattern);
  std::vector<std::string> all;
  for (std::sregex_iterator it(docs_text().begin(), docs_text().end(), regex), end; it != end; ++it)
    all.push_back((*it)[1]);
  return all;
}
const std::set<std::string>& docs_ids() {
  static const auto list = all_matches(R"re( id="([^"]+)")re");
  static const std::set<std::string> ids(list.begin(), list.end());
  return ids;
}

TEST(Docs, IsAPageWithATag) {
  const Response response = host().get("/docs");
  EXPECT_EQ(response.status, 200);
  EXPECT_EQ(response.content_type, "text/html; charset=utf-8");
  const std::string etag = header(response, "ETag").value_or("");
  EXPECT_EQ(host().get("/docs", {{"If-None-Match", etag}}).status, 304);
}

TEST(Docs, ListsEveryRouteWithItsParameters) {
  for (const Route& route : routes()) {
    EXPECT_THAT(docs_ids(), Contains(std::string(route.name)));
    const std::size_t start = docs_text().find("id=\"" + std::string(route.name) + "\"");
    const std::string part =
        docs_text().substr(start, docs_text().find("<section", start + 1) - start);
    EXPECT_THAT(part, HasSubstr(path_template(route)));
    EXPECT_THAT(part, HasSubstr(escaped(route.about)));
    Definitions named;
    if (route.query == nullptr) continue;
    for (const Value& parameter : route.query(named)) {
      EXPECT_THAT(part, HasSubstr("<dt>" + code(text_at(parameter, "name")) + "</dt>"));
      EXPECT_THAT(part, HasSubstr(escaped(text_at(parameter, "description"))));
    }
  }
  EXPECT_THAT(docs_text(), HasSubstr("an integer from 1 to 16777216; default <code>640</code>"));
}

TEST(Docs, ListsEveryProblemEveryOptionAndEverySchema) {
  for (const ProblemRow& row : problem_rows())
    EXPECT_THAT(docs_ids(), Contains("problem-" + std::string(row.type)));
  for (const OptionRow& row : option_rows()) {
    EXPECT_THAT(docs_ids(), Contains("option-" + row.name));
    EXPECT_THAT(docs_text(), HasSubstr(code(row.flag + " " + row.variable)));
    EXPECT_THAT(docs_text(), HasSubstr(escaped(row.allowed)));
  }
  const Value document = openapi_document(routes());
  for (const auto& [name, schema] : *at(at(document, "components"), "schemas").as<Value::Object>())
    EXPECT_THAT(docs_ids(), Contains("json-" + name));
}

TEST(Docs, ListsEveryKindOfShapeWithItsFields) {
  const std::size_t start = docs_text().find("id=\"json-object-torus\"");
  ASSERT_NE(start, docs_text().npos);
  const std::string torus = docs_text().substr(start, docs_text().find("<h4", start) - start);
  EXPECT_THAT(torus, HasSubstr("<code>minor_radius</code>"));
  EXPECT_THAT(torus, Not(HasSubstr("<code>material</code>")));  // told once, of all kinds
}

TEST(Docs, EveryNameIsThereOnceAndEveryLinkLeadsToOne) {
  const std::set<std::string> names = docs_ids();
  EXPECT_EQ(all_matches(R"re( id="([^"]+)")re").size(), names.size());
  const auto links = all_matches(R"re(href="#([^"]+)")re");
  EXPECT_GT(links.size(), 200U);
  for (const std::string& link : links) EXPECT_THAT(names, Contains(link));
}

TEST(Docs, EveryLinkToTheServerIsAnswered) {
  for (const std::string& link : all_matches(R"re((?:href|src)="([^"#]+)")re"))
    EXPECT_EQ(
        host().get("/" + std::regex_replace(link == "." ? "" : link, std::regex("&amp;"), "&"))
                .status /
            100 * 100,
        link.starts_with("problems/") ? 300 : 200)
        << link;
}

TEST(Docs, AsksForNothingFromElsewhereAndHasNoScriptAndNoStyleInLine) {
  for (const char* outside : {"=\"http", "=\"//", "url(", "<script", "<style", "style="})
    EXPECT_THAT(docs_text(), Not(HasSubstr(outside)));
}

TEST(Docs, EveryTypeOfProblemLeadsToItsPlaceOnThePage) {
  for (const ProblemRow& row : problem_rows()) {
    const Response response = host().get(problem_uri(row));
    EXPECT_EQ(response.status, 308);
    const std::string location = header(response, "Location").value_or("");
    ASSERT_TRUE(location.starts_with("/docs#")) << location;
    EXPECT_THAT(docs_ids(), Contains(location.substr(6)));
  }
  EXPECT_EQ(host().get("/problems/none").status, 404);
}

// ---- words --------------------------------------------------------------------------------------

TEST(Html, EscapesWhatTheTextHolds) {
  EXPECT_EQ(escaped(R"(a < b && "c" > d)"), "a &lt; b &amp;&amp; &quot;c&quot; &gt; d");
  EXPECT_EQ(code("x<y"), "<code>x&lt;y</code>");
  EXPECT_EQ(element("p", "x", "class=\"y\""), "<p class=\"y\">x</p>");
}

TEST(SchemaWords, SayWhatASchemaAllows) {
  const std::pair<const char*, const char*> words[] = {
      {R"({"type":"number"})", "a number"},
      {R"({"type":"number","minimum":0,"maximum":1})", "a number from 0 to 1"},
      {R"({"type":"number","exclusiveMinimum":0,"maximum":1e9})", "a number above 0 to 1e9"},
      {R"({"type":"integer","minimum":3})", "an integer, at least 3"},
      {R"({"type":"number","maximum":1500000,"not":{"const":0}})",
       "a number, at most 1500000, not 0"},
      {R"({"type":"array","minItems":3,"maxItems":3,"items":{"type":"number"}})", "3 numbers"},
      {R"({"type":"array","items":{"type":"integer","minimum":0}})",
       "a list of integers, each at least 0"},
      {R"({"type":"array","minItems":2,"items":{"type":"string"}})",
       "a list of at least 2, each text"},
      {R"({"type":"string","maxLength":256})", "text of at most 256 characters"},
      {R"({"enum":["a","b"]})", "one of <code>a</code>, <code>b</code>"},
      {R"({"anyOf":[{"$ref":"#/$defs/thing"},{"type":"null"}]})",
       "<a href=\"#json-thing\">thing</a> or <code>null</code>"},
      {R"({"type":"object","additionalProperties":{"type":"boolean"}})",
       "an object whose members are each <code>true</code> or <code>false</code>"},
      {"{}", "any value"}};
  for (const auto& [schema, said] : words) EXPECT_EQ(schema_words(parse_json(schema)), said);
}

}  // namespace
}  // namespace tia::test
