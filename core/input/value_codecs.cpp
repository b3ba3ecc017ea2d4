#include "core/input/value_codecs.h"

#include <cmath>

namespace tia {

Value::Object with_definitions(const Value& schema, const Definitions& named) {
  Value::Object members = *schema.as<Value::Object>();
  if (!named.empty()) members.emplace_back("$defs", Value::Object(named.begin(), named.end()));
  return members;
}

}  // namespace tia

namespace tia::detail {

std::optional<double> read_number(const Value& value, const Place& at, const Spec& spec,
                                  bool integer, Faults& faults) {
  const auto* number = value.as<double>();
  if (number == nullptr || (integer && *number != std::trunc(*number))) {
    wrong_type(value, at, range_text(spec, integer), faults);
    return std::nullopt;
  }
  if (!in_range(*number, spec) || !std::isfinite(*number)) {
    faults.add({FaultKind::out_of_range, at.pointer(), value, range_text(spec, integer)});
    return std::nullopt;
  }
  return *number + 0.0;  // -0 becomes 0
}

Value::Object number_schema(const Spec& spec, bool integer) {
  Value::Object schema{{"type", integer ? "integer" : "number"}};
  if (std::isfinite(spec.min))
    schema.emplace_back(spec.open_min ? "exclusiveMinimum" : "minimum", spec.min);
  if (std::isfinite(spec.max)) schema.emplace_back("maximum", spec.max);
  if (spec.not_zero) schema.emplace_back("not", Value::Object{{"const", 0}});
  return schema;
}

bool short_enough(const std::string& text, const Place& at, const Spec& spec, Faults& faults) {
  if (text.size() <= spec.max_bytes) return true;
  faults.add({FaultKind::out_of_range, at.pointer(), excerpt(text), text_words(spec)});
  return false;
}

std::string text_words(const Spec& spec) {
  if (spec.max_bytes == Spec{}.max_bytes) return "a string";
  return "a string of at most " + std::to_string(spec.max_bytes) + " bytes";
}

Value::Object text_schema(const Spec& spec) {
  Value::Object schema{{"type", "string"}};
  if (spec.max_bytes != Spec{}.max_bytes)
    schema.emplace_back("maxLength", static_cast<double>(spec.max_bytes));
  return schema;
}

std::string array_text(const Spec& spec) {
  if (spec.min_items == 0) return "an array";
  return "an array of at least " + std::to_string(spec.min_items);
}

const Value::Array* read_array(const Value& value, const Place& at, const Spec& spec,
                               Faults& faults) {
  const auto* list = value.as<Value::Array>();
  if (list != nullptr && list->size() >= spec.min_items) return list;
  wrong_type(value, at, array_text(spec), faults);
  return nullptr;
}

void unknown_word(const Value& got, const Place& at, const std::vector<std::string_view>& names,
                  Faults& faults) {
  const auto* word = got.as<std::string>();
  faults.add({word != nullptr ? FaultKind::unknown_name : FaultKind::wrong_type, at.pointer(),
              excerpt(got), "one of " + listed(names),
              word != nullptr ? nearest_name(*word, names) : ""});
}

}  // namespace tia::detail
