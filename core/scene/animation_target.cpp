#include "core/scene/animation_target.h"

#include <algorithm>
#include <charconv>
#include <set>

#include "core/input/transform_steps.h"
#include "core/scene/scene.h"

namespace tia {
namespace {

// RFC 6901: ~1 is a slash, ~0 a tilde.
std::string unescaped(std::string_view step) {
  std::string text;
  for (std::size_t i = 0; i < step.size(); ++i) {
    const bool escaped = step[i] == '~' && i + 1 < step.size();
    if (escaped && step[i + 1] == '1') text += '/', ++i;
    else if (escaped && step[i + 1] == '0') text += '~', ++i;
    else text += step[i];
  }
  return text;
}

std::vector<std::size_t> elements_named(const Value::Array& list, std::string_view name) {
  std::vector<std::size_t> found;
  for (std::size_t i = 0; i < list.size(); ++i) {
    const auto* object = list[i].as<Value::Object>();
    const Value* own = object != nullptr ? find(*object, "name") : nullptr;
    const auto* text = own != nullptr ? own->as<std::string>() : nullptr;
    if (text != nullptr && *text == name) found.push_back(i);
  }
  return found;
}

std::vector<std::string_view> names_in(const Value::Array& list) {
  std::vector<std::string_view> names;
  for (const Value& each : list)
    if (const auto* object = each.as<Value::Object>())
      if (const Value* name = find(*object, "name"))
        if (const auto* text = name->as<std::string>()) names.push_back(*text);
  return names;
}

// The element that a step means, or a fault.
std::optional<std::size_t> element(const Value::Array& list, const std::string& step,
                                   const std::string& at, Faults& faults) {
  if (const auto number = number_of_step(step)) {
    if (*number < list.size()) return number;
    faults.add({FaultKind::unknown_name, at, Value(step),
                list.empty()
                    ? "a step into a list that has elements"
                    : "0 to " + std::to_string(list.size() - 1) + ", an element's number"});
    return std::nullopt;
  }
  const std::vector<std::size_t> found = elements_named(list, step);
  if (found.size() == 1) return found.front();
  const std::vector<std::string_view> names = names_in(list);
  if (found.empty())
    faults.add({FaultKind::unknown_name, at, Value(step),
                "an element's number" + (names.empty() ? "" : ", or one of " + listed(names)),
                nearest_name(step, names)});
  else
    faults.add(
        {FaultKind::conflict, at, Value(step), "a name that one element alone has, or its number"});
  return std::nullopt;
}

Value* member(Value::Object& object, std::string_view name) {
  for (auto& [key, value] : object)
    if (key == name) return &value;
  return nullptr;
}

// ---- colours --------------------------------------------------------------------------------

// Three numbers from 0 up, or one: what Codec<Color> says of itself, or a list of such.
bool is_color_schema(const Value& schema) {
  const auto* members = schema.as<Value::Object>();
  if (members == nullptr) return false;
  if (const Value* items = find(*members, "items"); items != nullptr && is_color_schema(*items))
    return true;
  const Value* one_of = find(*members, "oneOf");
  const auto* ways = one_of != nullptr ? one_of->as<Value::Array>() : nullptr;
  if (ways == nullptr || ways->size() != 2) return false;
  const auto* list = ways->front().as<Value::Object>();
  const Value* items = list != nullptr ? find(*list, "items") : nullptr;
  const auto* number = items != nullptr ? items->as<Value::Object>() : nullptr;
  const Value* least = number != nullptr ? find(*number, "minimum") : nullptr;
  return least != nullptr && *least == Value(0);
}

void collect_colors(const Value& schema, std::set<std::string, std::less<>>& names) {
  if (const auto* list = schema.as<Value::Array>())
    for (const Value& each : *list) collect_colors(each, names);
  const auto* members = schema.as<Value::Object>();
  if (members == nullptr) return;
  for (const auto& [word, value] : *members) {
    const auto* fields = word == "properties" ? value.as<Value::Object>() : nullptr;
    if (fields != nullptr)
      for (const auto& [name, field] : *fields)
        if (is_color_schema(field)) names.insert(name);
    collect_colors(value, names);
  }
}

const std::set<std::string, std::less<>>& color_fields() {
  static const auto names = [] {
    Definitions named;
    std::set<std::string, std::less<>> found;
    collect_colors(Codec<Scene>::schema({}, named), found);
    for (const auto& [name, schema] : named) collect_colors(schema, found);
    return found;
  }();
  return names;
}

}  // namespace

TargetPath steps_of(std::string_view pointer) {
  TargetPath steps;
  if (!pointer.starts_with('/')) return steps;
  while (!pointer.empty()) {
    pointer.remove_prefix(1);
    const std::size_t end = std::min(pointer.find('/'), pointer.size());
    steps.push_back(unescaped(pointer.substr(0, end)));
    pointer.remove_prefix(end);
  }
  return steps;
}

std::string pointer_of(const TargetPath& path) {
  std::string text;
  for (const std::string& step : path) text += Place{}.at(step).pointer();
  return text;
}

bool is_within(const TargetPath& path, const TargetPath& above) {
  return above.size() <= path.size() && std::equal(above.begin(), above.end(), path.begin());
}

std::optional<std::size_t> number_of_step(std::string_view step) {
  std::size_t number = 0;
  const bool plain = !step.empty() && (step == "0" || step.front() != '0');
  const auto [end, error] = std::from_chars(step.data(), step.data() + step.size(), number);
  if (!plain || error != std::errc() || end != step.data() + step.size()) return std::nullopt;
  return number;
}

TargetPath found_target(const TargetPath& steps, const Value& scene, const std::string& at,
                        Faults& faults) {
  TargetPath path;
  const Value* value = &scene;
  for (const std::string& step : steps) {
    path.push_back(step);
    if (value == nullptr) {  // of what is not written the reader knows what may be there
      if (!number_of_step(step)) continue;
      faults.add({FaultKind::missing, at, std::nullopt,
                  "a list that the scene writes out, or the whole of " +
                      pointer_of({path.begin(), path.end() - 1})});
      return {};
    }
    if (const auto* list = value->as<Value::Array>()) {
      const auto number = element(*list, step, at, faults);
      if (!number) return {};
      path.back() = std::to_string(*number);
      value = &(*list)[*number];
    } else if (const auto* object = value->as<Value::Object>()) {
      value = find(*object, step);
    } else {
      faults.add({FaultKind::unknown_name, at, Value(pointer_of(path)),
                  "a place of the scene; " + pointer_of({path.begin(), path.end() - 1}) +
                      " has no parts"});
      return {};
    }
  }
  return path;
}

void put_at(Value& scene, const TargetPath& path, Value value) {
  Value* at = &scene;
  for (const std::string& step : path) {
    if (auto* list = at->as<Value::Array>()) {
      at = &(*list)[*number_of_step(step)];
      continue;
    }
    if (at->as<Value::Object>() == nullptr) *at = Value::Object{};
    auto& object = *at->as<Value::Object>();
    Value* const found = member(object, step);
    at = found != nullptr ? found : &object.emplace_back(step, Value()).second;
  }
  *at = std::move(value);
}

Value* value_in(Value& scene, const TargetPath& path) {
  Value* at = &scene;
  for (const std::string& step : path) {
    if (auto* list = at->as<Value::Array>()) {
      const auto number = number_of_step(step);
      at = number && *number < list->size() ? &(*list)[*number] : nullptr;
    } else if (auto* object = at->as<Value::Object>()) {
      at = member(*object, step);
    } else {
      at = nullptr;
    }
    if (at == nullptr) return nullptr;
  }
  return at;
}

TrackTarget kind_of_target(const TargetPath& path) {
  const auto field = std::find_if(path.rbegin(), path.rend(),
                                  [](const std::string& step) { return !number_of_step(step); });
  if (field == path.rend()) return TrackTarget::numbers;
  if (*field == RotateQuaternion::key) return TrackTarget::quaternion;
  return color_fields().contains(*field) ? TrackTarget::color : TrackTarget::numbers;
}

}  // namespace tia
