// The documents that tell of the server itself: /openapi.json, and /problems/TYPE, which leads to
// the page that is drawn from it.
#include <algorithm>

#include "core/input/json.h"
#include "server/contract/answers.h"
#include "server/contract/openapi.h"
#include "server/contract/problem_table.h"
#include "server/handlers/handlers.h"
#include "server/handlers/route_table.h"
#include "server/http/error.h"
#include "server/operation/config.h"
#include "server/requests/tagged_body.h"

namespace tia::server {
namespace {

// The table of options, without the defaults that are the machine's own.
Value::Array options_array() {
  Value::Array options;
  for (const OptionRow& row : option_rows()) {
    Value::Object option{{"name", row.name},
                         {"flag", row.flag},
                         {"variable", row.variable},
                         {"description", row.about},
                         {"allowed", row.allowed}};
    const bool of_the_machine = row.about.find("(default: ") != row.about.npos;
    if (!row.value.empty() && !of_the_machine) option.emplace_back("default", row.value);
    options.emplace_back(std::move(option));
  }
  return options;
}

// JSON whose members stand as the tables have them, which is the order to read them in.
std::string text_in_order(const Value& value) {
  std::string inside;
  if (const auto* items = value.as<Value::Array>()) {
    for (const Value& item : *items)
      inside.append(inside.empty() ? "" : ",").append(text_in_order(item));
    return "[" + inside + "]";
  }
  const auto* members = value.as<Value::Object>();
  if (members == nullptr) return to_json(value);
  for (const auto& [name, member] : *members)
    inside.append(inside.empty() ? "" : ",")
        .append(to_json(name))
        .append(":")
        .append(text_in_order(member));
  return "{" + inside + "}";
}

std::string openapi_text() {
  Value document = openapi_document(routes());
  document.as<Value::Object>()->emplace_back("x-options", options_array());
  return text_in_order(document);
}

Response get_openapi(const Request& request, const std::string&, Service&) {
  static const std::string text = openapi_text();
  static const TaggedBody tagged(text);
  return tagged_response(request, tagged, "application/json");
}

Value any_openapi(Definitions&) {
  return Value::Object{{"type", "object"}, {"required", Value::Array{"openapi"}}};
}

Response get_problem(const Request&, const std::string& type, Service&) {
  const auto rows = problem_rows();
  if (std::none_of(rows.begin(), rows.end(),
                   [&](const ProblemRow& row) { return row.type == type; }))
    throw HttpError("not-found", "there is no such type of problem");
  return {.status = 308,
          .content_type = "",
          .body = "",
          .headers = {{"Location", "/docs#problem-" + type}}};
}

}  // namespace

std::vector<Route> document_routes() {
  return {{.method = "GET",
           .path = "/openapi.json",
           .name = "get_openapi",
           .about = "this interface, as an OpenAPI 3.1 document",
           .handler = get_openapi,
           .answers = tagged("the document", {{media::json, any_openapi}})},
          {.method = "GET",
           .path = "/problems/{}",
           .name = "get_problem",
           .about = "what a problem's type means",
           .handler = get_problem,
           .answers = {{308, "the place on the page of documentation", {}, {"Location"}}},
           .segment = {"type", "the last part of a problem's type"},
           .examples = {"/problems/busy"}}};
}

}  // namespace tia::server
