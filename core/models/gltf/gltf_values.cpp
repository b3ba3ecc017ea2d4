#include "core/models/gltf/gltf_values.h"

#include <algorithm>
#include <vector>

#include "core/input/json.h"

namespace tia::gltf {

std::optional<double> positive(const GltfObject& object, std::string_view name, double most) {
  const auto number = object.number(name);
  if (!number || (*number > 0 && *number <= most)) return number;
  object.fault(
      FaultKind::out_of_range, name, Value(*number),
      most < Range().max ? "a number above 0, at most " + number_text(most) : "a number above 0");
  return std::nullopt;
}

std::optional<std::size_t> word(const GltfObject& object, std::string_view name,
                                std::span<const std::string_view> words) {
  const Value* value = object.member(name);
  if (value == nullptr) return std::nullopt;
  const auto* text = value->as<std::string>();
  const auto found = text == nullptr ? words.end() : std::ranges::find(words, *text);
  if (found != words.end()) return static_cast<std::size_t>(found - words.begin());
  object.fault(text == nullptr ? FaultKind::wrong_type : FaultKind::unknown_name, name,
               excerpt(*value), listed({words.begin(), words.end()}));
  return std::nullopt;
}

double capped(const GltfObject& object, std::string_view name, double standard, Range range,
              Model& model) {
  const double number = object.number_or(name, standard, {range.min, Range().max});
  if (number <= range.max) return number;
  model.warn({object.at().at(name).pointer(), 0,
              "more than " + number_text(range.max) + " is taken as " + number_text(range.max)});
  return range.max;
}

}  // namespace tia::gltf
