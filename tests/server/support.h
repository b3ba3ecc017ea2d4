// What the server's tests share: a whole service without a socket, JSON by pointer, query strings
// and problem documents taken apart.
#pragma once

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <map>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

#include "core/input/json.h"
#include "core/scene/read_scene.h"
#include "core/version.h"
#include "server/handlers/backend.h"
#include "server/handlers/dispatch.h"
#include "tests/sanitizer.h"

namespace tia::test {

using namespace tia::server;

/// KiB that a process may grow by beyond what is its own.
inline long sanitizers_kilobytes() { return sanitized() ? 1 << 20 : 0; }

/// The name of a row of a test: its law.
inline constexpr auto law_of = [](const auto& info) -> std::string { return info.param.law; };

std::string file_bytes(const std::string& path);

/// The first header field of that exact name, or nothing.
std::optional<std::string> header(const Response& response, std::string_view name);

/// Host: what `tia serve` sets up, without connections. The test fails where an answer is none that
/// the OpenAPI document allows.
class Host {
 public:
  static constexpr int threads = 7;  // more than most machines have: they must not matter
  static constexpr const char* id = "test-1";

  Host();
  explicit Host(Config config);
  ~Host();

  Response ask(const std::string& method, const std::string& target, const std::string& body = "",
               const Headers& headers = {}, const std::string& request_id = id);
  Response ask(const Request& request);
  Response get(const std::string& target, const Headers& headers = {});
  Response head(const std::string& target);
  Response post(const std::string& target, const std::string& body,
                const std::string& type = "application/json");
  /// As if nobody waited for any answer: whatever traces a ray is answered 503.
  void stop() { stop_.request_stop(); }
  const Gallery& gallery() const { return gallery_; }
  SceneStore& kept() { return backend_.kept; }
  GeometryStore& geometries() { return backend_.geometries; }
  Service& service() { return backend_.service; }
  Pool& pool() { return backend_.pool; }

 private:
  std::stop_source stop_;
  Gallery gallery_;
  Backend backend_;
};

/// One for all tests that need none of their own. The scenes that they post stay in it.
Host& host();

// ---- JSON -----------------------------------------------------------------------------------

/// The member, which must be there.
const Value& at(const Value& value, std::string_view name);
std::string text_at(const Value& value, std::string_view name);
double number_at(const Value& value, std::string_view name);

// ---- queries --------------------------------------------------------------------------------

/// RFC 3986: all but the unreserved characters as % and two digits.
std::string url_encode(std::string_view text);

/// The query that says what the object says: strings as they are, all else as JSON, URL-encoded.
std::string query_of(const Value& parameters);

// ---- metrics --------------------------------------------------------------------------------

/// Prometheus' text as the value of each series, by its name and labels.
std::map<std::string, double> series_of(const std::string& text);

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
Problem problem_of(const Response& response);

/// The problem's one error.
ProblemError only_error(const Response& response);

}  // namespace tia::test
