#include "tests/server/support.h"

#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>
#include <utility>

#include "tests/server/contract/contract.h"
#include "tests/server/program.h"

namespace tia::test {

std::string file_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

std::optional<std::string> header(const Response& response, std::string_view name) {
  for (const auto& [key, value] : response.headers)
    if (key == name) return value;
  return std::nullopt;
}

Host::Host() : Host(Config{}) {}
Host::Host(Config config)
    : backend_(
          [&] {
            config.threads = threads;
            return config;
          }(),
          gallery_, {}, tia_program()) {}
Host::~Host() = default;

Response Host::ask(const std::string& method, const std::string& target, const std::string& body,
                   const Headers& headers, const std::string& request_id) {
  Request request{method, target, headers, body, request_id};
  request.stop = stop_.get_token();
  return ask(request);
}
Response Host::ask(const Request& request) {
  Response response = answer(request, service());
  if (response.shared) response.body = *std::exchange(response.shared, nullptr);
  if (!response.feed) expect_allowed(request, response);  // whose body is not there yet
  return response;
}
Response Host::get(const std::string& target, const Headers& headers) {
  return ask("GET", target, "", headers);
}
Response Host::head(const std::string& target) { return ask("HEAD", target); }
Response Host::post(const std::string& target, const std::string& body, const std::string& type) {
  return ask("POST", target, body, {{"Content-Type", type}});
}

Host& host() {
  static Host shared;
  return shared;
}

// ---- JSON -----------------------------------------------------------------------------------

const Value& at(const Value& value, std::string_view name) {
  const auto* object = value.as<Value::Object>();
  const Value* found = object != nullptr ? find(*object, name) : nullptr;
  if (found == nullptr) throw std::runtime_error("no member " + std::string(name));
  return *found;
}
std::string text_at(const Value& value, std::string_view name) {
  const auto* text = at(value, name).as<std::string>();
  if (text == nullptr) throw std::runtime_error(std::string(name) + " is no string");
  return *text;
}
double number_at(const Value& value, std::string_view name) {
  const auto* number = at(value, name).as<double>();
  if (number == nullptr) throw std::runtime_error(std::string(name) + " is no number");
  return *number;
}

// ---- queries --------------------------------------------------------------------------------

std::string url_encode(std::string_view text) {
  constexpr std::string_view digits = "0123456789ABCDEF";
  std::string out;
  for (const char c : text) {
    const auto byte = static_cast<unsigned char>(c);
    const bool plain = (c >= '0' && c <= '9') || (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') ||
                       c == '-' || c == '_' || c == '.' || c == '~';
    if (plain) out += c;
    else (out += '%').append(1, digits[byte >> 4U]).append(1, digits[byte & 15U]);
  }
  return out;
}

std::string query_of(const Value& parameters) {
  std::string query;
  for (const auto& [name, value] : *parameters.as<Value::Object>()) {
    const auto* text = value.as<std::string>();
    if (!query.empty()) query += '&';
    query += url_encode(name) + "=" + url_encode(text != nullptr ? *text : to_json(value));
  }
  return query;
}

// ---- metrics --------------------------------------------------------------------------------

std::map<std::string, double> series_of(const std::string& text) {
  std::map<std::string, double> series;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    if (line.empty() || line[0] == '#') continue;
    const std::size_t space = line.rfind(' ');
    EXPECT_TRUE(series.emplace(line.substr(0, space), std::stod(line.substr(space + 1))).second);
  }
  return series;
}

// ---- problem documents ----------------------------------------------------------------------

Problem problem_of(const Response& response) {
  EXPECT_EQ(response.content_type, "application/problem+json");
  Problem problem;
  try {
    const Value document = parse_json(response.body);
    problem.type = text_at(document, "type");
    problem.detail = text_at(document, "detail");
    problem.instance = text_at(document, "instance");
    EXPECT_THAT(problem.type, testing::StartsWith("/problems/"));
    EXPECT_FALSE(text_at(document, "title").empty());
    EXPECT_FALSE(problem.detail.empty());
    EXPECT_FALSE(problem.instance.empty());
    EXPECT_EQ(number_at(document, "status"), response.status);
    const Value* errors = find(*document.as<Value::Object>(), "errors");
    if (errors == nullptr) return problem;
    for (const Value& error : *errors->as<Value::Array>()) {
      ProblemError each{text_at(error, "pointer"), text_at(error, "allowed"), {}, {}};
      EXPECT_FALSE(each.allowed.empty());
      const auto& members = *error.as<Value::Object>();
      if (const Value* got = find(members, "got")) each.got = *got;
      if (find(members, "nearest") != nullptr) each.nearest = text_at(error, "nearest");
      problem.errors.push_back(std::move(each));
    }
  } catch (const std::exception& error) {
    ADD_FAILURE() << "not a problem document: " << error.what() << "\n" << response.body;
  }
  return problem;
}

ProblemError only_error(const Response& response) {
  const Problem problem = problem_of(response);
  EXPECT_EQ(problem.errors.size(), 1U) << response.body;
  return problem.errors.empty() ? ProblemError{} : problem.errors.front();
}

}  // namespace tia::test
