// Source: OpenAPI Specification 3.1.0, 4.8.
#include "server/contract/openapi.h"

#include <algorithm>

#include "core/version.h"
#include "server/contract/answer_headers.h"
#include "server/contract/refusals.h"
#include "server/contract/security.h"
#include "server/http/headers.h"

namespace tia::server {
namespace {

constexpr const char* about_all =
    "Scenes go in, pictures come out. The same request gives the same bytes, by GET or by POST: a "
    "URL is a picture.\n\n"
    "HEAD is answered as GET without the body (of /render nothing is drawn, nor counted), OPTIONS "
    "of any path with 204 and Allow, other methods with 405. In a query, numbers with commas "
    "between may be a JSON array, too. What cannot be done is answered with a problem document "
    "(RFC 9457).";

Value reference(const char* to, std::string_view name) {
  return Value::Object{{"$ref", std::string("#/components/") + to + "/" + std::string(name)}};
}

// ---- answers --------------------------------------------------------------------------------

using HeaderNames = std::vector<std::string_view>;

Value header_object(const HeaderRow& row, bool is_always) {
  return Value::Object{{"description", row.about},
                       {"required", is_always},
                       {"schema", Value::Object{{"type", "string"}, {"pattern", row.pattern}}}};
}

const HeaderRow& header_row(std::string_view name) {
  return *std::ranges::find(header_rows(), name, &HeaderRow::name);
}

bool is_of_types(std::string_view header, const std::vector<Content>& contents) {
  return std::ranges::any_of(
      contents, [&](const Content& each) { return std::ranges::count(each.headers, header) > 0; });
}

// Every answer carries the request's ids and, where CORS knows origins, varies with them; to a key
// it says what is left, and who may keep it. Those that not each type of its body has are required
// by the types (x-required-headers).
Value headers_object(HeaderNames names, const std::vector<Content>& contents = {}) {
  for (const char* any : {"RateLimit", "RateLimit-Policy", "Vary", "X-Request-Id", "traceparent"})
    names.emplace_back(any);
  Value::Object headers;
  if (!contents.empty() && std::ranges::find(names, "Cache-Control") == names.end())
    headers.emplace_back("Cache-Control", header_object(header_row("Cache-Control"), false));
  for (const std::string_view name : names) {
    if (find(headers, name) != nullptr) continue;
    const HeaderRow& row = header_row(name);
    headers.emplace_back(name, row.always && is_of_types(name, contents)
                                   ? header_object(row, false)
                                   : reference("headers", name));
  }
  return headers;
}

Value media_object(const Content& content, Definitions& named) {
  Value::Object media;
  if (content.schema != nullptr) media.emplace_back("schema", content.schema(named));
  Value::Object examples;
  for (const Example& each : content.examples)
    examples.emplace_back(std::to_string(examples.size() + 1),
                          Value::Object{{"summary", each.about}, {"value", parse_json(each.text)}});
  if (!examples.empty()) media.emplace_back("examples", std::move(examples));
  if (!content.headers.empty())
    media.emplace_back("x-required-headers",
                       Value::Array(content.headers.begin(), content.headers.end()));
  return media;
}

Value content_object(const std::vector<Content>& contents, Definitions& named) {
  Value::Object object;
  for (const Content& each : contents) object.emplace_back(each.type, media_object(each, named));
  return object;
}

Value::Object problem_content(const std::vector<ProblemRow>& rows, Definitions& named) {
  Value::Array types;
  for (const ProblemRow& row : rows) types.emplace_back(problem_uri(row));
  Value::Object schema = *problem_schema(named).as<Value::Object>();
  const Value::Object type{{"type", Value::Object{{"enum", types}}}};
  schema.emplace_back("properties", type);
  return {{"application/problem+json", Value::Object{{"schema", std::move(schema)}}}};
}

HeaderNames problem_headers(int status) {
  HeaderNames names{"Cache-Control"};
  for (const ProblemRow& row : problems_of(status))
    if (!row.header.empty()) names.push_back(row.header);
  return names;
}

Value::Object answer_object(const Answer& answer, bool or_problem, Definitions& named) {
  Value content = content_object(answer.contents, named);
  HeaderNames headers = answer.headers;
  if (or_problem) {
    for (auto& each : problem_content(problems_of(answer.status), named))
      content.as<Value::Object>()->push_back(std::move(each));
    for (const std::string_view name : problem_headers(answer.status)) headers.push_back(name);
  }
  Value::Object object{{"description", answer.about},
                       {"headers", headers_object(headers, answer.contents)}};
  if (!content.as<Value::Object>()->empty()) object.emplace_back("content", std::move(content));
  return object;
}

Value responses_object(const Route& route, Definitions& named) {
  Value::Object responses;
  const std::vector<int> problems = problem_statuses(route);
  for (const Answer& answer : route.answers) {
    const bool or_problem = std::count(problems.begin(), problems.end(), answer.status) > 0;
    responses.emplace_back(std::to_string(answer.status), answer_object(answer, or_problem, named));
  }
  for (const int status : problems) {
    const std::string key = std::to_string(status);
    if (find(responses, key) == nullptr) responses.emplace_back(key, reference("responses", key));
  }
  responses.emplace_back("default", reference("responses", "default"));
  return responses;
}

// ---- operations -----------------------------------------------------------------------------

Value::Array parameters_array(const Route& route, Definitions& named) {
  Value::Array parameters;
  if (route.query != nullptr) parameters = route.query(named);
  const auto add = [&](const Segment& segment, const Value& schema) {
    parameters.push_back(Value::Object{{"name", segment.name},
                                       {"in", "path"},
                                       {"required", true},
                                       {"description", segment.about},
                                       {"schema", schema}});
  };
  if (route.path.find("{}") != route.path.npos) add(route.segment, segment_schema(route));
  if (!route.last_segment.name.empty()) add(route.last_segment, Value::Object{{"type", "string"}});
  return parameters;
}

Value operation_object(const Route& route, Definitions& named) {
  Value::Object operation{{"operationId", route.name}, {"summary", route.about}};
  std::string examples;
  for (const std::string_view target : route.examples)
    examples.append(examples.empty() ? "Such as `" : ", `").append(target).append("`");
  if (!examples.empty()) {
    operation.emplace_back("description", examples + ".");
    operation.emplace_back("x-examples",
                           Value::Array(route.examples.begin(), route.examples.end()));
  }
  if (Value::Array parameters = parameters_array(route, named); !parameters.empty())
    operation.emplace_back("parameters", std::move(parameters));
  if (!route.body.empty())
    operation.emplace_back(
        "requestBody",
        Value::Object{{"required", true}, {"content", content_object(route.body, named)}});
  if (!route.rights.empty()) operation.emplace_back("security", security_array(route));
  operation.emplace_back("responses", responses_object(route, named));
  return operation;
}

Value::Object paths_object(const std::vector<Route>& routes, Definitions& named) {
  Value::Object paths;
  for (const Route& route : routes) {
    const std::string path = path_template(route);
    auto found = std::ranges::find(paths, path, &Value::Member::first);
    if (found == paths.end()) found = paths.insert(found, {path, Value::Object{}});
    found->second.as<Value::Object>()->emplace_back(lower(route.method),
                                                    operation_object(route, named));
  }
  return paths;
}

// ---- components -----------------------------------------------------------------------------

std::string problem_titles(int status) {
  std::string titles;
  for (const ProblemRow& row : problems_of(status))
    titles.append(titles.empty() ? "" : "; ").append(row.title);
  return titles;
}

Value problem_answer(int status, Definitions& named) {
  return Value::Object{{"description", problem_titles(status)},
                       {"headers", headers_object(problem_headers(status))},
                       {"content", problem_content(problems_of(status), named)}};
}

Value::Object problem_answers(Definitions& named) {
  Value::Object answers;
  std::vector<ProblemRow> any;
  for (const ProblemRow& row : problem_rows()) {
    const std::string key = std::to_string(row.status);
    if (is_met_by_all(row)) any.push_back(row);
    else if (find(answers, key) == nullptr)
      answers.emplace_back(key, problem_answer(row.status, named));
  }
  answers.emplace_back("default",
                       Value::Object{{"description", "a problem that any request may meet"},
                                     {"headers", headers_object({"Cache-Control"})},
                                     {"content", problem_content(any, named)}});
  answers.emplace_back("options", Value::Object{{"description", "of OPTIONS, with status 204"},
                                                {"headers", headers_object({"Allow"})}});
  return answers;
}

Value::Object header_components() {
  Value::Object headers;
  for (const HeaderRow& row : header_rows())
    headers.emplace_back(row.name, header_object(row, row.always));
  return headers;
}

Value::Array problems_array() {
  Value::Array problems;
  for (const ProblemRow& row : problem_rows()) {
    Value::Object problem{{"type", problem_uri(row)},
                          {"title", row.title},
                          {"status", row.status},
                          {"description", row.about}};
    if (!row.header.empty()) problem.emplace_back("header", row.header);
    problems.emplace_back(std::move(problem));
  }
  return problems;
}

// References to definitions as what they are in the document.
Value rebased(Value value) {
  constexpr std::string_view from = "#/$defs/", to = "#/components/schemas/";
  if (auto* items = value.as<Value::Array>())
    for (Value& item : *items) item = rebased(std::move(item));
  if (auto* members = value.as<Value::Object>())
    for (auto& [name, member] : *members) {
      auto* text = member.as<std::string>();
      if (name == "$ref" && text != nullptr && text->starts_with(from))
        text->replace(0, from.size(), to);
      else member = rebased(std::move(member));
    }
  return value;
}

}  // namespace

std::string path_template(const Route& route) {
  std::string path(route.path);
  const std::size_t open = path.find("{}");
  if (open != path.npos) path.insert(open + 1, route.segment.name);
  if (!route.last_segment.name.empty())
    path.insert(path.size() - 1, std::string(route.last_segment.name));
  return path;
}

Value openapi_document(const std::vector<Route>& routes) {
  Definitions named;
  Value::Object paths = paths_object(routes, named);
  Value::Object answers = problem_answers(named);
  const Value::Object license{{"name", "MIT"}, {"identifier", "MIT"}};
  const Value::Object info{{"title", "Tia"},
                           {"version", version()},
                           {"summary", "A ray-tracing render service"},
                           {"description", about_all},
                           {"license", license}};
  Value::Object components{{"schemas", Value::Object(named.begin(), named.end())},
                           {"headers", header_components()},
                           {"responses", std::move(answers)},
                           {"securitySchemes", security_schemes()}};
  return rebased(
      Value::Object{{"openapi", "3.1.0"},
                    {"info", info},
                    {"jsonSchemaDialect", "https://json-schema.org/draft/2020-12/schema"},
                    {"servers", Value::Array{Value::Object{{"url", "/"}}}},
                    {"paths", std::move(paths)},
                    {"components", std::move(components)},
                    {"x-problems", problems_array()}});
}

}  // namespace tia::server
