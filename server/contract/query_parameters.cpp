#include "server/contract/query_parameters.h"

namespace tia::server {

Value::Object query_parameter(const std::string& name, const Spec& spec, const Value& schema,
                              const std::optional<Value>& standard,
                              Value::Object (*in_query)(Value::Object)) {
  Value::Object is = *schema.as<Value::Object>();
  if (standard && !spec.required) is.emplace_back("default", *standard);
  Value::Object parameter{{"name", name}, {"in", "query"}, {"description", about_text(spec)}};
  for (auto& each : in_query(std::move(is))) parameter.push_back(std::move(each));
  return parameter;
}

}  // namespace tia::server
