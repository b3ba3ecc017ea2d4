// What the server's tests share: a whole service without a socket, JSON by pointer, query strings
// and problem documents taken apart.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <iterator>
#include <optional>
#include <stdexcept>
#include <stop_token>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/input/json.h"
#include "server/routes.h"

namespace tia::test {

using namespace tia::server;

/// Whether a sanitizer watches, which takes memory, descriptors and time of its own.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
inline constexpr bool sanitized = true;
#else
inline constexpr bool sanitized = false;
#endif
/// KiB that a process may grow by beyond what is its own.
inline constexpr long sanitizers_kilobytes = sanitized ? 1 << 20 : 0;

inline std::string file_bytes(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// The first header field of that exact name, or nothing.
inline std::optional<std::string> header(const Response& response, std::string_view name) {
  for (const auto& [key, value] : response.headers)
    if (key == name) return value;
  return std::nullopt;
}

/// Host: what `tia serve` sets up, without connections.
class Host {
 public:
  static constexpr int threads = 7;  // more than most machines have: they must not matter
  static constexpr const char* id = "test-1";

  explicit Host(Config config = {}) : config_(std::move(config)), kept_(config_.max_scenes_bytes) {}

  Response ask(const std::string& method, const std::string& target, const std::string& body = "",
               const Headers& headers = {}, const std::string& request_id = id) {
    Request request{method, target, headers, body, request_id};
    request.stop = stop_.get_token();
    return answer(request, service_);
  }
  /// As if nobody waited for any answer: whatever traces a ray is answered 503.
  void stop() { stop_.request_stop(); }
  Response ask(const Request& request) { return answer(request, service_); }
  Response get(const std::string& target, const Headers& headers = {}) {
    return ask("GET", target, "", headers);
  }
  Response head(const std::string& target) { return ask("HEAD", target); }
  Response post(const std::string& target, const std::string& body,
                const std::string& type = "application/json") {
    return ask("POST", target, body, {{"Content-Type", type}});
  }
  const Gallery& gallery() const { return gallery_; }
  SceneStore& kept() { return kept_; }
  Service& service() { return service_; }
  Pool& pool() { return pool_; }

 private:
  std::stop_source stop_;
  Config config_;
  Gallery gallery_;
  SceneStore kept_;
  Pool pool_{threads};
  Admission admission_{config_.renders};
  Metrics metrics_;
  Service service_{config_, {gallery_, kept_, pool_, config_.limits()}, admission_, metrics_};
};

// ---- JSON -----------------------------------------------------------------------------------

/// The member, which must be there.
inline const Value& at(const Value& value, std::string_view name) {
  const auto* object = value.as<Value::Object>();
  const Value* found = object != nullptr ? find(*object, name) : nullptr;
  if (found == nullptr) throw std::runtime_error("no member " + std::string(name));
  return *found;
}
inline std::string text_at(const Value& value, std::string_view name) {
  const auto* text = at(value, name).as<std::string>();
  if (text == nullptr) throw std::runtime_error(std::string(name) + " is no string");
  return *text;
}
inline double number_at(const Value& value, std::string_view name) {
  const auto* number = at(value, name).as<double>();
  if (number == nullptr) throw std::runtime_error(std::string(name) + " is no number");
  return *number;
}

// ---- queries --------------------------------------------------------------------------------

/// RFC 3986: all but the unreserved characters as % and two digits.
inline std::string url_encode(std::string_view text) {
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

/// The query that says what the object says: strings as they are, all else as JSON, URL-encoded.
inline std::string query_of(const Value& parameters) {
  std::string query;
  for (const auto& [name, value] : *parameters.as<Value::Object>()) {
    const auto* text = value.as<std::string>();
    if (!query.empty()) query += '&';
    query += url_encode(name) + "=" + url_encode(text != nullptr ? *text : to_json(value));
  }
  return query;
}

// ---- problem documents ----------------------------------------------------------------------

struct ProblemError {
  std::string pointer, allowed;
  std::optional<Value> got;
  std::string nearest;
};

struct Problem {
  std::string type, detail, instance;
  std::vector<ProblemError> errors;
};

/// Takes a problem document apart and checks its form: RFC 9457's five members, the status of the
/// answer, and errors that each have a pointer and what is allowed.
inline Problem problem_of(const Response& response) {
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

/// The problem's one error.
inline ProblemError only_error(const Response& response) {
  const Problem problem = problem_of(response);
  EXPECT_EQ(problem.errors.size(), 1U) << response.body;
  return problem.errors.empty() ? ProblemError{} : problem.errors.front();
}

}  // namespace tia::test
