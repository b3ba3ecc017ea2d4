#include "tests/server/contract/openapi_support.h"
#include "server/handlers/route_table.h"

#include <stdexcept>

namespace tia::test {

const JsonSchema& openapi() {
  static const JsonSchema document(openapi_document(routes()));
  return document;
}
const Value& component(const char* group, const std::string& name) {
  return at(at(at(openapi().document(), "components"), group), name);
}

std::vector<Operation> operations() {
  std::vector<Operation> all;
  for (const auto& [path, item] : as_object(at(openapi().document(), "paths")))
    for (const auto& [method, is] : as_object(item)) all.push_back({path, method, is});
  return all;
}
const Value& operation(const std::string& name) {
  for (const Operation& each : operations())
    if (text_at(each.is, "operationId") == name) return each.is;
  throw std::out_of_range(name);
}

std::vector<std::string> parameter_names(const Value& operation, const char* in) {
  std::vector<std::string> names;
  if (const Value* parameters = find(as_object(operation), "parameters"))
    for (const Value& each : as_array(*parameters))
      if (text_at(each, "in") == in) names.push_back(text_at(each, "name"));
  return names;
}

}  // namespace tia::test
