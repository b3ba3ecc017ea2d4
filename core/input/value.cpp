#include "core/input/value.h"

#include <algorithm>

namespace tia {
namespace {

std::vector<const Value::Member*> by_name(const Value::Object& object) {
  std::vector<const Value::Member*> members;
  for (const auto& member : object) members.push_back(&member);
  std::sort(members.begin(), members.end(),
            [](const auto* a, const auto* b) { return a->first < b->first; });
  return members;
}

}  // namespace

bool Value::operator==(const Value& other) const {
  const auto* a = as<Object>();
  const auto* b = other.as<Object>();
  if (a == nullptr || b == nullptr) return is == other.is;
  const auto members = by_name(*a), others = by_name(*b);
  return std::equal(members.begin(), members.end(), others.begin(), others.end(),
                    [](const auto* x, const auto* y) { return *x == *y; });
}

// RFC 7396, section 2, "MergePatch". Depth is bounded by what parse() lets in.
Value merge_patch(Value target, const Value& patch) {
  const auto* changes = patch.as<Value::Object>();
  if (changes == nullptr) return patch;
  if (target.as<Value::Object>() == nullptr) target = Value::Object{};
  auto& members = *target.as<Value::Object>();
  for (const auto& [key, change] : *changes) {
    const auto at = std::find_if(members.begin(), members.end(), [&name = key](const auto& member) {
      return member.first == name;
    });
    const bool present = at != members.end();
    if (change.as<std::nullptr_t>() != nullptr) {
      if (present) members.erase(at);
    } else if (present) {
      at->second = merge_patch(std::move(at->second), change);
    } else {
      members.emplace_back(key, merge_patch(Value(), change));
    }
  }
  return target;
}

}  // namespace tia
