// The server's OpenAPI document as a judge of what was asked and answered, by the independent
// validator.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "server/http/message.h"
#include "tests/core/schema/json_schema.h"

namespace tia::test {

/// Contract: an OpenAPI document. Any thread may ask.
class Contract {
 public:
  explicit Contract(Value openapi) : document_(std::move(openapi)) {}

  /// What the document does not allow of the answer, or of a request that was answered well: each
  /// with the operation and the place. A request whose method is "" could not be read.
  std::vector<std::string> faults(const server::Request& request,
                                  const server::Response& response) const;

 private:
  /// An operation's object and what it is called; null for what the document does not know.
  struct Operation {
    std::string name;
    const Value* is = nullptr;
  };
  Operation operation_of(const server::Request& request) const;
  bool fits(const std::string& path, const Value& item, std::string_view asked) const;
  const Value* answer_of(const Operation& operation, const server::Request& request,
                         int status) const;

  const JsonSchema document_;
};

/// Where a value breaks its schema: a JSON Pointer to the innermost part that does.
std::string place_of_fault(const JsonSchema& document, const Value& value, const Value& schema);

/// Fails the running test for each fault by the server's own document, and for a PNG that is none.
void expect_allowed(const server::Request& request, const server::Response& response);

}  // namespace tia::test
