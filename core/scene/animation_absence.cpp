#include "core/scene/animation_absence.h"

#include <algorithm>
#include <tuple>

namespace tia {
namespace {

TargetPath list_of(const TargetPath& path) { return {path.begin(), path.end() - 1}; }
std::size_t number_in(const TargetPath& path) { return *number_of_step(path.back()); }

}  // namespace

// The inner ones first, and in a list the last ones, so that the others' numbers stay.
Absence::Absence(std::vector<TargetPath> paths) : paths_(std::move(paths)) {
  std::ranges::sort(paths_, [](const TargetPath& a, const TargetPath& b) {
    return std::tuple(a.size(), list_of(a), number_in(a)) >
           std::tuple(b.size(), list_of(b), number_in(b));
  });
}

bool Absence::has(const TargetPath& path) const {
  return std::ranges::any_of(paths_, [&](const auto& each) { return is_within(path, each); });
}

void Absence::erase_from(Value& scene) const {
  for (const TargetPath& path : paths_) {
    auto& list = *value_in(scene, list_of(path))->as<Value::Array>();
    list.erase(list.begin() + static_cast<std::ptrdiff_t>(number_in(path)));
  }
}

TargetPath Absence::before(TargetPath path) const {
  for (auto absent = paths_.rbegin(); absent != paths_.rend(); ++absent) {
    const TargetPath list = list_of(*absent);
    if (path.size() <= list.size() || !is_within(path, list)) continue;
    std::string& step = path[list.size()];
    const auto number = number_of_step(step);
    if (number && *number >= number_in(*absent)) step = std::to_string(*number + 1);
  }
  return path;
}

}  // namespace tia
