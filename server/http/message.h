// A request and its answer as plain data: all that the rest of the server sees of HTTP.
#pragma once

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace tia::server {

/// Header fields in order. Names compare without case.
using Headers = std::vector<std::pair<std::string, std::string>>;

struct Request {
  std::string method;
  std::string target;  ///< path and query as they came, still percent-encoded
  Headers headers;
  std::string body;
  std::string id;  ///< X-Request-Id: the client's where it is fit for a log line, else our own

  std::string_view path() const { return std::string_view(target).substr(0, target.find('?')); }
  std::string_view query() const {
    const auto mark = target.find('?');
    return mark == target.npos ? std::string_view() : std::string_view(target).substr(mark + 1);
  }
  /// The first field of that name, or "".
  std::string_view header(std::string_view name) const;
  bool is_head() const { return method == "HEAD"; }
};

struct Response {
  int status = 200;
  std::string content_type;  ///< "" = no body
  std::string body;
  Headers headers = {};
  bool unsized = false;  ///< HEAD of something that would have to be made to be measured
};

/// Strict percent-decoding, '+' as it stands. Errors: InputError of kind malformed at `pointer`.
std::string percent_decode(std::string_view text, std::string_view pointer = "");

}  // namespace tia::server
