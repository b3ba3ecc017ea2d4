// What a request can be refused for. What is said of it to clients is in contract/problem.
#pragma once

#include <exception>
#include <string>
#include <string_view>

#include "server/http/message.h"

namespace tia::server {

/// HttpError: a request that is wrong as HTTP, whatever its content. `type` is a row of the table.
class HttpError : public std::exception {
 public:
  HttpError(std::string_view type, std::string detail, Headers headers = {})
      : type_(type), detail_(std::move(detail)), headers_(std::move(headers)) {}
  std::string_view type() const { return type_; }
  const std::string& detail() const { return detail_; }
  const Headers& headers() const { return headers_; }
  const char* what() const noexcept override { return detail_.c_str(); }

 private:
  std::string_view type_;
  std::string detail_;
  Headers headers_;
};

/// An HttpError for somebody else to answer with.
inline std::exception_ptr failure(std::string_view type, std::string detail, Headers headers = {}) {
  return std::make_exception_ptr(HttpError(type, std::move(detail), std::move(headers)));
}

/// The longest path and query together, in bytes, and the error for a longer one.
constexpr std::size_t longest_target = 4096;
HttpError uri_too_long();

}  // namespace tia::server
