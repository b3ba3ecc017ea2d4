// Problem documents (RFC 9457): what went wrong, for people and programs. One table maps errors to
// types, titles and status codes.
#pragma once

#include <exception>
#include <stdexcept>
#include <string>
#include <string_view>

#include "core/input/errors.h"
#include "server/http/error.h"
#include "server/http/message.h"

namespace tia::server {

/// StorageError: what is kept cannot be reached. Its text is for the log, not for the client.
class StorageError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// StorageAway: what is kept is on another machine, which cannot be reached now.
class StorageAway : public StorageError {
 public:
  using StorageError::StorageError;
};

/// The longest problem document: faults that have no room in it are counted and left out. In bytes.
constexpr std::size_t longest_problem = 16 << 10;
/// The same where a form was sent: Drake's client shows no longer ones.
constexpr std::size_t longest_form_problem = (8 << 10) - 1;

/// The answer to a request that failed with this exception. Anything unforeseen is a 500 whose
/// text is for the log alone: the answer's `failure`.
Response problem_response(const std::exception_ptr& failure, const Request& request);

}  // namespace tia::server
