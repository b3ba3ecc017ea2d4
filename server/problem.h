// Problem documents (RFC 9457): what went wrong, for people and programs. One table maps errors to
// types, titles and status codes.
#pragma once

#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/input/errors.h"
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

/// StorageError: what is kept cannot be reached. Its text is for the log, not for the client.
class StorageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// An HttpError for somebody else to answer with.
std::exception_ptr failure(std::string_view type, std::string detail, Headers headers = {});

/// The longest problem document: faults that have no room in it are counted and left out. In bytes.
constexpr std::size_t longest_problem = 16 << 10;

/// The answer to a request that failed with this exception. Anything unforeseen is a 500 whose
/// text stays here; it is logged.
Response problem_response(const std::exception_ptr& failure, const Request& request);

/// The longest path and query together, in bytes, and the error for a longer one.
constexpr std::size_t longest_target = 4096;
HttpError uri_too_long();

}  // namespace tia::server
