// The OpenAPI document taken apart, for its tests.
#pragma once

#include <string>
#include <vector>

#include "server/contract/openapi.h"
#include "tests/core/schema/json_schema.h"
#include "tests/server/support.h"

namespace tia::test {

const JsonSchema& openapi();
const Value& component(const char* group, const std::string& name);

/// Operation: one of the document's, by its path.
struct Operation {
  std::string path, method;
  const Value& is;
};
std::vector<Operation> operations();
const Value& operation(const std::string& name);

/// The names of its parameters in "query" or "path".
std::vector<std::string> parameter_names(const Value& operation, const char* in);

}  // namespace tia::test
