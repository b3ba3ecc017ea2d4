#include "tests/server/contract/contract.h"
#include "server/handlers/route_table.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <map>
#include <regex>
#include <set>

#include "core/input/json.h"
#include "server/contract/openapi.h"
#include "server/http/headers.h"
#include "tests/core/png/png_reader.h"

namespace tia::test {
namespace {

using server::Request;
using server::Response;

// What HTTP itself says, and what every answer says to browsers: told of once, not of each answer.
const std::set<std::string_view> unsaid{"Accept-Ranges",
                                        "Connection",
                                        "Content-Length",
                                        "Content-Type",
                                        "Date",
                                        "Keep-Alive",
                                        "Transfer-Encoding",
                                        "Access-Control-Allow-Headers",
                                        "Access-Control-Allow-Methods",
                                        "Access-Control-Allow-Origin",
                                        "Access-Control-Expose-Headers",
                                        "Access-Control-Max-Age",
                                        "Content-Security-Policy",
                                        "Cross-Origin-Resource-Policy",
                                        "Referrer-Policy",
                                        "X-Content-Type-Options"};

const Value* member(const Value& value, std::string_view name) {
  const auto* object = value.as<Value::Object>();
  return object != nullptr ? find(*object, name) : nullptr;
}

bool is_json(const std::string& type) {
  return type == "application/json" || type.ends_with("+json");
}

// A method as the document writes it; methods are told apart by case.
std::string key_of(const Request& request) {
  if (request.is_head()) return "get";
  return request.method == server::lower(request.method) ? "" : server::lower(request.method);
}

bool matches(const std::string& text, const std::string& pattern) {
  thread_local std::map<std::string, std::regex> compiled;
  return std::regex_search(text, compiled.try_emplace(pattern, pattern).first->second);
}

/// Judge: gathers what is wrong with one exchange.
struct Judge {
  const JsonSchema& document;
  const Request& request;
  std::vector<std::string> faults = {};

  // No limits but memory's: answers may be as deep and long as they like.
  Value check_json(const std::string& text, const Value& schema, const std::string& what) {
    try {
      Value value = parse_json(text, {.depth = 1000, .values = 100'000'000});
      if (!document.valid(value, schema))
        faults.push_back(what + " at \"" + place_of_fault(document, value, schema) + "\"");
      return value;
    } catch (const InputError& error) {
      faults.push_back(what + " is no JSON: " + error.what());
      return {};
    }
  }

  void check_content(const Value& answer, const Response& response) {
    const Value* content = member(answer, "content");
    if (content == nullptr) {
      if (!response.content_type.empty() || !response.body.empty())
        faults.push_back("a body, " + response.content_type);
      return;
    }
    const Value* media = member(*content, response.content_type);
    if (media == nullptr) return faults.push_back("content type \"" + response.content_type + "\"");
    if (const Value* required = member(*media, "x-required-headers"))
      for (const Value& name : as_array(*required)) expect_header(as_text(name), response);
    const Value* schema = member(*media, "schema");
    if (schema == nullptr || request.is_head() || !is_json(response.content_type)) return;
    if (has(response, "Content-Encoding")) return;
    const Value body = check_json(response.body, *schema, "body");
    if (response.content_type != "application/problem+json") return;
    const Value* status = member(body, "status");
    if (status != nullptr && !(*status == Value(response.status)))
      faults.push_back("body at \"/status\": " + to_json(*status));
  }

  static bool has(const Response& response, const std::string& name) {
    return std::any_of(response.headers.begin(), response.headers.end(),
                       [&](const auto& each) { return each.first == name; });
  }

  // Of HEAD the document says that it is like GET, but what costs work may be missing.
  void expect_header(const std::string& name, const Response& response) {
    if (!request.is_head() && !has(response, name)) faults.push_back("no header " + name);
  }

  void check_headers(const Value& answer, const Response& response) {
    const Value* described = member(answer, "headers");
    static const Value nothing = Value::Object{};
    const Value& headers = described != nullptr ? *described : nothing;
    for (const auto& [name, reference] : as_object(headers)) {
      const Value* required = member(document.resolved(reference), "required");
      if (required != nullptr && *required == Value(true)) expect_header(name, response);
    }
    for (const auto& [name, value] : response.headers) {
      if (unsaid.contains(name)) continue;
      const Value* reference = member(headers, name);
      if (reference == nullptr) {
        faults.push_back("header " + name + " is not described");
      } else {
        const Value& header = document.resolved(*reference);
        if (!matches(value, as_text(*member(*member(header, "schema"), "pattern"))))
          faults.push_back("header " + name + ": " + value);
      }
    }
  }

  void check_query(const Value& operation) {
    std::set<std::string> known;
    if (const Value* parameters = member(operation, "parameters"))
      for (const Value& each : as_array(*parameters))
        if (as_text(*member(each, "in")) == "query") known.insert(as_text(*member(each, "name")));
    if (known.empty()) return;  // who takes no query does not look at it
    if (const Value* ways = member(*member(document.document(), "components"), "securitySchemes"))
      for (const auto& [name, way] : as_object(*ways))
        if (const Value* place = member(way, "in"); place != nullptr && *place == Value("query"))
          known.insert(name);
    std::string_view left = request.query();
    while (!left.empty()) {
      const std::string_view pair = left.substr(0, left.find('&'));
      left.remove_prefix(std::min(pair.size() + 1, left.size()));
      const std::string name(pair.substr(0, pair.find('=')));
      if (!name.empty() && name.find('%') == name.npos && !known.contains(name))
        faults.push_back("parameter " + name + " was taken");
    }
  }

  void check_request(const Value& operation) {
    check_query(operation);
    const Value* body = member(operation, "requestBody");
    const Value* json =
        body != nullptr ? member(*member(*body, "content"), "application/json") : nullptr;
    const auto start = request.body.find_first_not_of(" \t\r\n");
    constexpr std::size_t longest = 1 << 18;  // beyond that a check takes seconds
    if (json == nullptr || start == std::string::npos || request.body.size() > longest) return;
    if (request.body[start] == '{')
      check_json(request.body, *member(*json, "schema"), "the request's body, which was taken,");
  }
};

}  // namespace

std::string place_of_fault(const JsonSchema& document, const Value& value, const Value& schema) {
  const auto inside = [&](const std::string& step, const Value& part, const Value* rule) {
    if (rule == nullptr || document.valid(part, *rule)) return std::string();
    return "/" + step + place_of_fault(document, part, *rule);
  };
  if (schema.as<Value::Object>() == nullptr) return "";
  // What it refers to, and what it says besides.
  for (const Value* rules : {&document.resolved(schema), &schema}) {
    const Value *properties = member(*rules, "properties"), *items = member(*rules, "items");
    const auto* members = value.as<Value::Object>();
    for (std::size_t i = 0; members != nullptr && i < members->size(); ++i) {
      const auto& [name, part] = (*members)[i];
      const Value* rule = properties != nullptr ? member(*properties, name) : nullptr;
      if (rule == nullptr) rule = member(*rules, "additionalProperties");
      if (const std::string place = inside(name, part, rule); !place.empty()) return place;
    }
    const auto* list = value.as<Value::Array>();
    for (std::size_t i = 0; list != nullptr && i < list->size(); ++i)
      if (const std::string place = inside(std::to_string(i), (*list)[i], items); !place.empty())
        return place;
  }
  return "";
}

bool Contract::fits(const std::string& path, const Value& item, std::string_view asked) const {
  if (const auto last = path.rfind("/{"); last != path.find("/{")) {  // a second one ends the path
    const auto slash = asked.rfind('/');
    return slash + 1 < asked.size() && fits(path.substr(0, last), item, asked.substr(0, slash));
  }
  const auto open = path.find('{');
  if (open == path.npos || !asked.starts_with(path.substr(0, open))) return path == asked;
  const std::string end = path.substr(path.find('}') + 1);
  if (!asked.ends_with(end) || asked.size() < open + end.size()) return false;
  const std::string_view segment = asked.substr(open, asked.size() - open - end.size());
  if (segment.empty() || segment.find('/') != segment.npos) return false;
  const Value& operation = as_object(item).front().second;
  for (const Value& each : as_array(*member(operation, "parameters")))
    if (as_text(*member(each, "in")) == "path")
      return document_.valid(Value(segment), *member(each, "schema"));
  return false;
}

Contract::Operation Contract::operation_of(const Request& request) const {
  const std::string asked(request.path());
  const std::string method = key_of(request);
  for (const bool exact : {true, false})
    for (const auto& [path, item] : as_object(*member(document_.document(), "paths")))
      if (exact ? path == asked : fits(path, item, asked))
        if (const Value* is = member(item, method)) return {request.method + " " + path, is};
  return {request.method + " " + asked.substr(0, 200), nullptr};
}

// What is no operation may be answered with 404, 405 and what any request or any body meets.
const Value* Contract::answer_of(const Operation& operation, const Request& request,
                                 int status) const {
  const Value& shared = *member(*member(document_.document(), "components"), "responses");
  if (operation.is != nullptr) {
    const Value& own = *member(*operation.is, "responses");
    const Value* answer = member(own, std::to_string(status));
    return &document_.resolved(answer != nullptr ? *answer : *member(own, "default"));
  }
  if (request.method == "OPTIONS" && status == 204) return member(shared, "options");
  const Value* answer = member(shared, std::to_string(status));
  if (status == 422 || status == 406) return nullptr;
  return answer != nullptr ? answer : member(shared, "default");
}

std::vector<std::string> Contract::faults(const Request& request, const Response& response) const {
  const Operation operation = operation_of(request);
  Judge judge{document_, request};
  if (const Value* answer = answer_of(operation, request, response.status)) {
    judge.check_content(*answer, response);
    judge.check_headers(*answer, response);
  } else {
    judge.faults.emplace_back("no such answer");
  }
  if (operation.is != nullptr && response.status < 300) judge.check_request(*operation.is);
  for (std::string& fault : judge.faults)
    fault.insert(0, operation.name + " -> " + std::to_string(response.status) + ": ");
  return judge.faults;
}

void expect_allowed(const Request& request, const Response& response) {
  if (response.content_type == "image/png" && !request.is_head()) check_png(response.body);
  static const Contract contract(server::openapi_document(server::routes()));
  for (const std::string& fault : contract.faults(request, response))
    ADD_FAILURE() << "not by /openapi.json: " << fault << "\n" << response.body.substr(0, 500);
}

}  // namespace tia::test
