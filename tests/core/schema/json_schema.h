// A validator of the JSON Schema 2020-12 words that Tia's schemas use; any other word throws.
#pragma once

#include <string>
#include <utility>

#include "core/input/json.h"

namespace tia::test {

/// JsonSchema: a schema document that values are valid or invalid by.
class JsonSchema {
 public:
  explicit JsonSchema(Value document) : document_(std::move(document)) {}
  const Value& document() const { return document_; }
  bool valid(const Value& value) const { return valid(value, document_); }
  /// By a schema that is a part of the document.
  bool valid(const Value& value, const Value& schema) const;
  /// What a part of the document refers to ("$ref" with a JSON Pointer), else itself.
  const Value& resolved(const Value& part) const;

 private:
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

inline double as_number(const Value& v) { return *v.as<double>(); }
inline const std::string& as_text(const Value& v) { return *v.as<std::string>(); }
inline const Value::Array& as_array(const Value& v) { return *v.as<Value::Array>(); }
inline const Value::Object& as_object(const Value& v) { return *v.as<Value::Object>(); }

}  // namespace tia::test
