#include "server/handlers/docs_page.h"
#include "server/handlers/route_table.h"

#include "core/input/json.h"
#include "core/version.h"
#include "server/contract/answer_headers.h"
#include "server/contract/openapi.h"
#include "server/contract/refusals.h"
#include "server/handlers/html.h"
#include "server/handlers/schema_words.h"
#include "server/operation/config.h"

namespace tia::server {
namespace {

std::string id(std::string_view name) { return "id=\"" + escaped(name) + "\""; }

// A part of the page that the contents list: under a heading of that level, or with one inside.
std::string section(std::string_view name, const char* heading, const std::string& title,
                    const std::string& html) {
  return element("section", element(heading, title) + html, id(name));
}

std::string paragraph(std::string_view text) { return element("p", escaped(text)); }

// ---- requests -------------------------------------------------------------------------------

std::string title_of(const Route& route) {
  return element("span", escaped(route.method), "class=\"method\"") + " " +
         code(path_template(route));
}

// The schema of an OpenAPI parameter, which is that of its text or of the JSON that it holds.
const Value& schema_of_parameter(const Value::Object& parameter) {
  if (const Value* schema = find(parameter, "schema")) return *schema;
  const Value& content = find(parameter, "content")->as<Value::Object>()->front().second;
  return *find(*content.as<Value::Object>(), "schema");
}

std::string parameters_html(const Route& route, Definitions& named) {
  std::vector<FieldRow> rows;
  if (route.path.ends_with("{}")) {
    rows.push_back(field_row(route.segment.name, segment_schema(route), true));
    rows.back().about = route.segment.about;
  }
  if (route.query != nullptr)
    for (const Value& each : route.query(named)) {
      const auto& parameter = *each.as<Value::Object>();
      const std::string* name = find(parameter, "name")->as<std::string>();
      rows.push_back(field_row(*name, schema_of_parameter(parameter), false));
      if (find(parameter, "content") != nullptr) rows.back().allowed.insert(0, "as JSON ");
      rows.back().about = *find(parameter, "description")->as<std::string>();
    }
  return rows.empty() ? "" : element("h4", "Parameters") + fields_html(rows);
}

std::string content_html(const Content& content, Definitions& named) {
  std::string html = code(content.type);
  if (content.schema != nullptr) html += ": " + schema_words(content.schema(named));
  return html;
}

std::string body_html(const Route& route, Definitions& named) {
  std::string html;
  for (const Content& content : route.body) {
    html += element("p", content_html(content, named));
    for (const Example& example : content.examples)
      html += element(
          "pre", element("code", "# " + escaped(example.about) + "\ncurl localhost:8080" +
                                     escaped(route.path) + " -d '" + escaped(example.text) + "'"));
  }
  return html.empty() ? "" : element("h4", "Body") + html;
}

std::string examples_html(const Route& route) {
  std::string html;
  for (const std::string_view target : route.examples)
    html += element("li", element("a", code(target), "href=\"" + escaped(target.substr(1)) + "\""));
  return html.empty() ? "" : element("ul", html, "class=\"examples\"");
}

std::string headers_html(const std::vector<std::string_view>& names) {
  std::string html;
  for (const std::string_view name : names)
    html.append(html.empty() ? "" : ", ")
        .append(link_to("header-" + std::string(name), code(name)));
  return html.empty() ? "" : element("p", "with " + html, "class=\"note\"");
}

std::string answer_html(int status, const std::string& html) {
  return element("div", element("dt", code(std::to_string(status))) + element("dd", html));
}

std::string answers_html(const Route& route, Definitions& named) {
  std::string html;
  for (const Answer& answer : route.answers) {
    std::string contents;
    for (const Content& each : answer.contents)
      contents.append(contents.empty() ? "" : ", or ").append(content_html(each, named));
    if (!contents.empty()) contents = element("p", contents, "class=\"note\"");
    html += answer_html(answer.status,
                        paragraph(answer.about) + contents + headers_html(answer.headers));
  }
  for (const int status : problem_statuses(route)) {
    std::string problems;
    for (const ProblemRow& row : problems_of(status))
      problems.append(problems.empty() ? "" : ", ")
          .append(link_to(problem_anchor(row.type), code(row.type)));
    html += answer_html(status, element("p", problems));
  }
  return element("h4", "Answers") + element("dl", html, "class=\"fields answers\"");
}

std::string route_html(const Route& route, Definitions& named) {
  return section(route.name, "h3", title_of(route),
                 paragraph(route.about) + examples_html(route) + parameters_html(route, named) +
                     body_html(route, named) + answers_html(route, named));
}

// ---- tables ---------------------------------------------------------------------------------

std::string headers_list() {
  std::vector<FieldRow> rows;
  for (const HeaderRow& row : header_rows())
    rows.push_back({std::string(row.name), std::string(row.about), code(row.pattern), "", false,
                    "header-" + std::string(row.name)});
  return fields_html(rows);
}

std::string problems_list() {
  std::vector<FieldRow> rows;
  for (const ProblemRow& row : problem_rows()) {
    std::string with = "status " + std::to_string(row.status);
    if (!row.header.empty())
      with += ", with " + link_to("header-" + std::string(row.header), code(row.header));
    rows.push_back({problem_uri(row), std::string(row.title) + ". " + std::string(row.about), with,
                    "", false, problem_anchor(row.type)});
  }
  return fields_html(rows);
}

std::string options_list() {
  std::vector<FieldRow> rows;
  for (const OptionRow& row : option_rows())
    rows.push_back({row.flag + " " + row.variable, row.about, escaped(row.allowed),
                    row.name == "threads" ? "" : row.value, false, "option-" + row.name});
  return fields_html(rows);
}

// ---- page -----------------------------------------------------------------------------------

constexpr const char* about_page =
    "Scenes go in, pictures come out. The same request gives the same bytes, by GET or by POST: a "
    "URL is a picture. HEAD is answered as GET without the body, OPTIONS of any path names its "
    "methods. What cannot be done is answered with a problem document (RFC 9457).";
constexpr const char* about_options =
    "Each is a flag of tia serve and an environment variable; the flag wins.";
constexpr const char* about_json =
    "The shapes of the JSON that requests bring and answers hold, by name.";

constexpr const char* head =
    R"(<meta charset="utf-8">
<meta name="viewport" content="width=device-width, initial-scale=1">
<title>Tia: documentation</title>
<meta name="description" content="Every request, answer, problem and option of Tia.">
<meta name="color-scheme" content="light dark">
<link rel="icon" href="favicon.svg" type="image/svg+xml">
<link rel="stylesheet" href="style.css">
<link rel="stylesheet" href="docs.css">)";

/// Sections: those of the page as they come, and the contents that list them.
struct Sections {
  std::string contents, html;

  void add(const char* name, const char* title, const std::string& inside,
           const std::string& inner_contents = "") {
    std::string inner = inner_contents.empty() ? "" : element("ul", inner_contents);
    contents += element("li", link_to(name, title) + inner);
    html += section(name, "h2", title, inside);
  }
};

void add_requests(Sections& page, Definitions& named) {
  std::string html, contents;
  for (const Route& route : routes()) {
    html += route_html(route, named);
    contents += element("li", link_to(route.name, title_of(route)));
  }
  page.add("requests", "Requests", html, contents);
}

void add_json(Sections& page, Definitions& named) {
  static_cast<void>(problem_schema(named));
  std::string html = paragraph(about_json), contents;
  for (const auto& [name, schema] : named) {
    html += section(schema_anchor(name), "h3", code(name), schema_html(name, schema));
    contents += element("li", link_to(schema_anchor(name), code(name)));
  }
  page.add("json", "JSON", html, contents);
}

}  // namespace

std::string problem_anchor(std::string_view type) { return "problem-" + std::string(type); }

std::string docs_page() {
  Definitions named;
  Sections page;
  add_requests(page, named);
  page.add("problems", "Problems", problems_list());
  page.add("headers", "Headers of answers", headers_list());
  page.add("options", "Options of the server", paragraph(about_options) + options_list());
  add_json(page, named);
  const std::string skip = element("a", "Skip the contents", R"(class="skip" href="#requests")");
  const std::string title = element(
      "h1",
      R"(<a href="."><img src="favicon.svg" alt="" width="32" height="32"> Tia</a> documentation)");
  const std::string formats = element(
      "p",
      R"(Version )" + escaped(version()) +
          R"(. For programs: <a href="openapi.json">openapi.json</a>, <a href="schema/scene.json">schema/scene.json</a>.)");
  const std::string nav = element("nav", element("h2", "Contents") + element("ul", page.contents),
                                  "aria-label=\"Contents\"");
  const std::string body = skip + element("header", title + paragraph(about_page) + formats) + nav +
                           element("main", page.html);
  return "<!doctype html>\n" +
         element("html", element("head", head) + element("body", body, "class=\"docs\""),
                 "lang=\"en\"") +
         "\n";
}

}  // namespace tia::server
