#include "core/input/value.h"

#include <algorithm>
#include <unordered_map>

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

// RFC 7396, section 2, "MergePatch", by an index of names: patches may be long. Depth is bounded by
// what parse_json lets in.
Value merge_patch(Value target, const Value& patch) {
  const auto* changes = patch.as<Value::Object>();
  if (changes == nullptr) return patch;
  if (target.as<Value::Object>() == nullptr) target = Value::Object{};
  auto& members = *target.as<Value::Object>();
  std::unordered_map<std::string, std::size_t> index;
  for (std::size_t i = 0; i < members.size(); ++i) index.emplace(members[i].first, i);
  std::vector<bool> removed(members.size());
  for (const auto& [key, change] : *changes) {
    const auto at = index.find(key);
    const bool present = at != index.end();
    if (change.as<std::nullptr_t>() != nullptr) {
      if (present) removed[at->second] = true;
    } else if (present) {
      Value& value = members[at->second].second;
      value = merge_patch(std::move(value), change);
    } else {
      members.emplace_back(key, merge_patch(Value(), change));
    }
  }
  Value::Object kept;
  for (std::size_t i = 0; i < members.size(); ++i)
    if (i >= removed.size() || !removed[i]) kept.push_back(std::move(members[i]));
  return kept;
}

}  // namespace tia
