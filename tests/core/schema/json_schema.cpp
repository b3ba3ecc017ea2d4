#include "tests/core/schema/json_schema.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <regex>
#include <stdexcept>

namespace tia::test {
namespace {

bool has_type(const Value& value, const std::string& type) {
  if (type == "object") return value.as<Value::Object>() != nullptr;
  if (type == "array") return value.as<Value::Array>() != nullptr;
  if (type == "string") return value.as<std::string>() != nullptr;
  if (type == "boolean") return value.as<bool>() != nullptr;
  if (type == "null") return value.as<std::nullptr_t>() != nullptr;
  if (type == "number") return value.as<double>() != nullptr;
  if (type == "integer")
    return value.as<double>() != nullptr && as_number(value) == std::trunc(as_number(value));
  throw std::runtime_error("type " + type);
}

// All bytes but those that go on with a character of UTF-8.
double characters(const std::string& text) {
  return static_cast<double>(std::count_if(text.begin(), text.end(), [](char byte) {
    return (static_cast<unsigned char>(byte) & 0xC0U) != 0x80U;
  }));
}

bool matches_pattern(const std::string& value, const std::string& pattern) {
  thread_local std::map<std::string, std::regex> compiled;
  const auto at = compiled.try_emplace(pattern, pattern).first;
  return std::regex_search(value, at->second);
}

}  // namespace

const Value& JsonSchema::resolved(const Value& part) const {
  const Value* ref = find(as_object(part), "$ref");
  if (ref == nullptr) return part;
  const std::string& pointer = as_text(*ref);
  if (!pointer.starts_with("#/")) throw std::runtime_error("$ref " + pointer);
  const Value* here = &document_;
  for (std::size_t at = 1; at != std::string::npos && here != nullptr;) {
    const std::size_t slash = pointer.find('/', at + 1);
    here = find(as_object(*here), pointer.substr(at + 1, slash - at - 1));
    at = slash;
  }
  if (here == nullptr) throw std::runtime_error("$ref " + pointer + " points nowhere");
  return *here;
}

bool JsonSchema::valid(const Value& value, const Value& schema) const {
  if (const auto* verdict = schema.as<bool>()) return *verdict;
  for (const auto& [word, is] : as_object(schema))
    if (!obeys(word, is, value, as_object(schema))) return false;
  return true;
}

// A word says nothing about values of another type than its own.
bool JsonSchema::obeys(const std::string& word, const Value& is, const Value& value,
                       const Value::Object& schema) const {
  for (const char* annotation :
       {"description", "default", "title", "examples", "$schema", "$defs", "contentEncoding",
        "contentMediaType", "contentSchema", "x-gathers", "x-samples", "x-max-depth"})
    if (word == annotation) return true;
  if (word == "type") return has_type(value, as_text(is));
  if (word == "const") return value == is;
  if (word == "enum")
    return std::find(as_array(is).begin(), as_array(is).end(), value) != as_array(is).end();
  if (word == "$ref") return valid(value, resolved(schema));
  if (word == "oneOf") return matches(value, is) == 1;
  if (word == "anyOf") return matches(value, is) >= 1;
  if (word == "not") return !valid(value, is);
  for (const char* of_members : {"properties", "propertyNames", "additionalProperties", "required",
                                 "minProperties", "maxProperties"})
    if (word == of_members)
      return value.as<Value::Object>() == nullptr ||
             members_obey(word, is, as_object(value), schema);
  for (const char* of_items : {"items", "prefixItems", "minItems", "maxItems"})
    if (word == of_items)
      return value.as<Value::Array>() == nullptr || items_obey(word, is, as_array(value), schema);
  for (const char* of_numbers : {"minimum", "exclusiveMinimum", "maximum", "exclusiveMaximum"})
    if (word == of_numbers)
      return value.as<double>() == nullptr || number_obeys(word, as_number(is), as_number(value));
  if (word == "maxLength")
    return value.as<std::string>() == nullptr || characters(as_text(value)) <= as_number(is);
  if (word == "pattern")
    return value.as<std::string>() == nullptr || matches_pattern(as_text(value), as_text(is));
  throw std::runtime_error("schema word " + word);
}

bool JsonSchema::members_obey(const std::string& word, const Value& is,
                              const Value::Object& members, const Value::Object& schema) const {
  if (word == "minProperties") return static_cast<double>(members.size()) >= as_number(is);
  if (word == "maxProperties") return static_cast<double>(members.size()) <= as_number(is);
  if (word == "required") {
    for (const Value& name : as_array(is))
      if (find(members, as_text(name)) == nullptr) return false;
    return true;
  }
  const Value* named = find(schema, "properties");
  for (const auto& [name, member] : members) {
    if (word == "propertyNames") {
      if (!valid(Value(name), is)) return false;
      continue;
    }
    const Value* property = named != nullptr ? find(as_object(*named), name) : nullptr;
    if (word == "properties" ? property != nullptr && !valid(member, *property)
                             : property == nullptr && !valid(member, is))
      return false;
  }
  return true;
}

bool JsonSchema::items_obey(const std::string& word, const Value& is, const Value::Array& items,
                            const Value::Object& schema) const {
  if (word == "minItems") return static_cast<double>(items.size()) >= as_number(is);
  if (word == "maxItems") return static_cast<double>(items.size()) <= as_number(is);
  const Value* prefix = find(schema, "prefixItems");
  const std::size_t first = prefix != nullptr ? as_array(*prefix).size() : 0;
  if (word == "prefixItems") {
    for (std::size_t i = 0; i < std::min(first, items.size()); ++i)
      if (!valid(items[i], as_array(is)[i])) return false;
    return true;
  }
  for (std::size_t i = first; i < items.size(); ++i)
    if (!valid(items[i], is)) return false;
  return true;
}

bool JsonSchema::number_obeys(const std::string& word, double bound, double value) const {
  if (word == "minimum") return value >= bound;
  if (word == "exclusiveMinimum") return value > bound;
  return word == "maximum" ? value <= bound : value < bound;
}

// The const of a property `type` tells most alternatives apart before their parts are looked at.
int JsonSchema::matches(const Value& value, const Value& alternatives) const {
  int count = 0;
  const auto* members = value.as<Value::Object>();
  const Value* type = members != nullptr ? find(*members, "type") : nullptr;
  for (const Value& each : as_array(alternatives)) {
    const Value* properties = find(as_object(resolved(each)), "properties");
    const Value* tag = properties != nullptr ? find(as_object(*properties), "type") : nullptr;
    const Value* only = tag != nullptr ? find(as_object(*tag), "const") : nullptr;
    if (type != nullptr && only != nullptr && !(*type == *only)) continue;
    count += valid(value, each) ? 1 : 0;
  }
  return count;
}

}  // namespace tia::test
