// A validator of the JSON Schema 2020-12 words that Tia's schemas use; any other word throws.
#pragma once

#include <cmath>
#include <map>
#include <regex>
#include <stdexcept>

#include "core/input/json.h"

namespace tia::test {

/// JsonSchema: a schema document that values are valid or invalid by.
class JsonSchema {
 public:
  explicit JsonSchema(Value document) : document_(std::move(document)) {}
  const Value& document() const { return document_; }
  bool valid(const Value& value) const { return valid(value, document_); }
  /// The schema that a schema refers to, else itself.
  const Value& resolved(const Value& schema) const;

 private:
  bool valid(const Value& value, const Value& schema) const;
  bool obeys(const std::string& word, const Value& is, const Value& value,
             const Value::Object& schema) const;
  bool members_obey(const std::string& word, const Value& is, const Value::Object& object,
                    const Value::Object& schema) const;
  bool items_obey(const std::string& word, const Value& is, const Value::Array& array,
                  const Value::Object& schema) const;
  bool number_obeys(const std::string& word, double bound, double number) const;
  int matches(const Value& value, const Value& alternatives) const;

  Value document_;
};

inline double number(const Value& v) { return *v.as<double>(); }
inline const std::string& text(const Value& v) { return *v.as<std::string>(); }
inline const Value::Array& array(const Value& v) { return *v.as<Value::Array>(); }
inline const Value::Object& object(const Value& v) { return *v.as<Value::Object>(); }

inline bool has_type(const Value& value, const std::string& type) {
  if (type == "object") return value.as<Value::Object>() != nullptr;
  if (type == "array") return value.as<Value::Array>() != nullptr;
  if (type == "string") return value.as<std::string>() != nullptr;
  if (type == "boolean") return value.as<bool>() != nullptr;
  if (type == "number") return value.as<double>() != nullptr;
  if (type == "integer")
    return value.as<double>() != nullptr && number(value) == std::trunc(number(value));
  throw std::runtime_error("type " + type);
}

inline const Value& JsonSchema::resolved(const Value& schema) const {
  const Value* ref = find(object(schema), "$ref");
  if (ref == nullptr) return schema;
  const std::string start = "#/$defs/";
  if (!text(*ref).starts_with(start)) throw std::runtime_error("$ref " + text(*ref));
  const Value* definitions = find(object(document_), "$defs");
  const Value* named = definitions != nullptr
                           ? find(object(*definitions), text(*ref).substr(start.size()))
                           : nullptr;
  if (named == nullptr) throw std::runtime_error("$ref " + text(*ref) + " points nowhere");
  return *named;
}

inline bool JsonSchema::valid(const Value& value, const Value& schema) const {
  if (const auto* verdict = schema.as<bool>()) return *verdict;
  for (const auto& [word, is] : object(schema))
    if (!obeys(word, is, value, object(schema))) return false;
  return true;
}

inline bool matches_pattern(const std::string& value, const std::string& pattern) {
  static std::map<std::string, std::regex> compiled;
  const auto at = compiled.try_emplace(pattern, pattern).first;
  return std::regex_search(value, at->second);
}

// A word says nothing about values of another type than its own.
inline bool JsonSchema::obeys(const std::string& word, const Value& is, const Value& value,
                              const Value::Object& schema) const {
  for (const char* annotation :
       {"description", "default", "title", "examples", "$schema", "$defs", "contentEncoding"})
    if (word == annotation) return true;
  if (word == "type") return has_type(value, text(is));
  if (word == "const") return value == is;
  if (word == "enum")
    return std::find(array(is).begin(), array(is).end(), value) != array(is).end();
  if (word == "$ref") return valid(value, resolved(schema));
  if (word == "oneOf") return matches(value, is) == 1;
  if (word == "anyOf") return matches(value, is) >= 1;
  if (word == "not") return !valid(value, is);
  for (const char* of_members :
       {"properties", "additionalProperties", "required", "minProperties", "maxProperties"})
    if (word == of_members)
      return value.as<Value::Object>() == nullptr || members_obey(word, is, object(value), schema);
  for (const char* of_items : {"items", "prefixItems", "minItems", "maxItems"})
    if (word == of_items)
      return value.as<Value::Array>() == nullptr || items_obey(word, is, array(value), schema);
  for (const char* of_numbers : {"minimum", "exclusiveMinimum", "maximum", "exclusiveMaximum"})
    if (word == of_numbers)
      return value.as<double>() == nullptr || number_obeys(word, number(is), number(value));
  if (word == "pattern")
    return value.as<std::string>() == nullptr || matches_pattern(text(value), text(is));
  throw std::runtime_error("schema word " + word);
}

inline bool JsonSchema::members_obey(const std::string& word, const Value& is,
                                     const Value::Object& members,
                                     const Value::Object& schema) const {
  if (word == "minProperties") return static_cast<double>(members.size()) >= number(is);
  if (word == "maxProperties") return static_cast<double>(members.size()) <= number(is);
  if (word == "required") {
    for (const Value& name : array(is))
      if (find(members, text(name)) == nullptr) return false;
    return true;
  }
  const Value* named = find(schema, "properties");
  for (const auto& [name, member] : members) {
    const Value* property = named != nullptr ? find(object(*named), name) : nullptr;
    if (word == "properties" ? property != nullptr && !valid(member, *property)
                             : property == nullptr && !valid(member, is))
      return false;
  }
  return true;
}

inline bool JsonSchema::items_obey(const std::string& word, const Value& is,
                                   const Value::Array& items, const Value::Object& schema) const {
  if (word == "minItems") return static_cast<double>(items.size()) >= number(is);
  if (word == "maxItems") return static_cast<double>(items.size()) <= number(is);
  const Value* prefix = find(schema, "prefixItems");
  const std::size_t first = prefix != nullptr ? array(*prefix).size() : 0;
  if (word == "prefixItems") {
    for (std::size_t i = 0; i < std::min(first, items.size()); ++i)
      if (!valid(items[i], array(is)[i])) return false;
    return true;
  }
  for (std::size_t i = first; i < items.size(); ++i)
    if (!valid(items[i], is)) return false;
  return true;
}

inline bool JsonSchema::number_obeys(const std::string& word, double bound, double value) const {
  if (word == "minimum") return value >= bound;
  if (word == "exclusiveMinimum") return value > bound;
  return word == "maximum" ? value <= bound : value < bound;
}

// The const of a property `type` tells most alternatives apart before their parts are looked at.
inline int JsonSchema::matches(const Value& value, const Value& alternatives) const {
  int count = 0;
  const auto* members = value.as<Value::Object>();
  const Value* type = members != nullptr ? find(*members, "type") : nullptr;
  for (const Value& each : array(alternatives)) {
    const Value* properties = find(object(resolved(each)), "properties");
    const Value* tag = properties != nullptr ? find(object(*properties), "type") : nullptr;
    const Value* only = tag != nullptr ? find(object(*tag), "const") : nullptr;
    if (type != nullptr && only != nullptr && !(*type == *only)) continue;
    count += valid(value, each) ? 1 : 0;
  }
  return count;
}

}  // namespace tia::test
