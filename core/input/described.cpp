#include "core/input/described.h"

#include <algorithm>

namespace tia::detail {

const Value* MemberReader::member(std::string_view name) {
  known.push_back(name);
  return find(object, name);
}

void MemberReader::add_missing(std::string_view name, const Spec& spec,
                               const std::string& allowed) {
  faults.add({FaultKind::missing, at.at(name).pointer(), std::nullopt,
              std::string(spec.about) + ": " + allowed});
}

std::optional<std::size_t> MemberReader::kind(const std::vector<std::string_view>& names,
                                              const Spec& spec) {
  const Value* const type = member("type");
  if (type == nullptr && !spec.required) return 0;
  if (type == nullptr) {
    add_missing("type", spec, "one of " + listed(names));
  } else {
    const auto* word = type->as<std::string>();
    const auto found = word != nullptr ? std::find(names.begin(), names.end(), *word) : names.end();
    if (found != names.end()) return static_cast<std::size_t>(found - names.begin());
    unknown_word(*type, at.at("type"), names, faults);
  }
  kind_known = false;
  return std::nullopt;
}

void MemberReader::finish() const {
  if (!kind_known) return;
  const std::size_t before = faults.count();
  for (const auto& [name, value] : object) {
    if (faults.full()) return;
    if (std::find(known.begin(), known.end(), name) != known.end()) continue;
    unknown_word(Value(name), at.at(name), known, faults);
  }
  if (faults.count() == before && check_kind) check_kind();
}

void ObjectSchema::add(std::string_view name, const Value& schema, const Spec& spec,
                       const std::optional<Value>& standard) {
  Value::Object property = *schema.as<Value::Object>();
  property.emplace_back("description", about_text(spec));
  if (spec.required) required.emplace_back(name);
  else if (standard) property.emplace_back("default", *standard);
  properties.emplace_back(name, std::move(property));
}

void ObjectSchema::add_kind(std::string_view type, ObjectSchema kind, bool asked_for) {
  kind.properties.emplace_back("type", Value::Object{{"const", type}});
  if (asked_for) kind.required.emplace_back("type");
  alternatives.push_back(std::move(kind));
}

void ObjectSchema::add_spelling(std::span<const std::string_view> names) {
  ObjectSchema spelling;
  for (const auto& property : properties)
    if (std::find(names.begin(), names.end(), property.first) != names.end()) {
      spelling.properties.push_back(property);
      spelling.required.emplace_back(property.first);
    }
  alternatives.push_back(std::move(spelling));
}

Value ObjectSchema::finish() const {
  Value::Array each;
  for (const ObjectSchema& alternative : alternatives) {
    ObjectSchema all = alternative;
    all.properties.insert(all.properties.end(), properties.begin(), properties.end());
    all.required.insert(all.required.end(), required.begin(), required.end());
    each.push_back(all.finish());
  }
  if (each.size() == 1) return each.front();
  if (!each.empty()) return Value::Object{{"oneOf", each}};
  Value::Object schema{
      {"type", "object"}, {"properties", properties}, {"additionalProperties", false}};
  if (!required.empty()) schema.emplace_back("required", required);
  return schema;
}

}  // namespace tia::detail
