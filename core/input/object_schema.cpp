#include "core/input/object_schema.h"

namespace tia {

Value object_schema(std::vector<SchemaMember> members) {
  Value::Object properties;
  Value::Array required;
  for (SchemaMember& member : members) {
    Value::Object property = std::move(*member.schema.as<Value::Object>());
    if (!member.about.empty()) property.emplace_back("description", member.about);
    properties.emplace_back(member.name, std::move(property));
    if (member.always) required.emplace_back(member.name);
  }
  return Value::Object{{"type", "object"},
                       {"properties", std::move(properties)},
                       {"required", std::move(required)},
                       {"additionalProperties", false}};
}

Value count_schema(int least) { return Value::Object{{"type", "integer"}, {"minimum", least}}; }

Value list_schema(Value items) {
  return Value::Object{{"type", "array"}, {"items", std::move(items)}};
}

Value nullable_schema(Value schema) {
  return Value::Object{{"anyOf", Value::Array{std::move(schema), Value::Object{{"type", "null"}}}}};
}

}  // namespace tia
