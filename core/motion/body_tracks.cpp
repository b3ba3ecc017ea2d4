#include "core/motion/body_tracks.h"

#include <algorithm>
#include <limits>

namespace tia {
namespace {

// The number of the element that a step means, a number or a name; none where there is none.
std::optional<std::size_t> element_of(const std::vector<Object>& list, const std::string& step) {
  if (const auto number = number_of_step(step))
    return *number < list.size() ? number : std::nullopt;
  const auto found = std::ranges::find(list, step, &Object::name);
  if (found == list.end()) return std::nullopt;
  return static_cast<std::size_t>(found - list.begin());
}

// Steps through objects by their numbers; what is no such step stays as it is.
TargetPath numbered(TargetPath steps, const Scene& scene) {
  const std::vector<Object>* list = &scene.objects.get();
  for (std::size_t i = 0; list != nullptr && i + 1 < steps.size(); i += 2) {
    if (steps[i] != (i == 0 ? "objects" : "children")) break;
    const auto number = element_of(*list, steps[i + 1]);
    if (!number) break;
    steps[i + 1] = std::to_string(*number);
    list = children_of((*list)[*number]);
  }
  return steps;
}

// Whether something at `path` moves the object at `own` or changes its shape: what is around it,
// it itself, or a part of it or of a group around it that is neither look nor another object.
bool moves(const TargetPath& path, const TargetPath& own) {
  if (is_within(own, path)) return true;
  for (std::size_t size = own.size(); size >= 2; size -= 2) {
    const TargetPath around(own.begin(), own.begin() + static_cast<std::ptrdiff_t>(size));
    if (path.size() <= size || !is_within(path, around)) continue;
    const std::string& part = path[size];
    return part != "material" && part != "materials" && part != "children";
  }
  return false;
}

}  // namespace

BodyTracks::BodyTracks(const Scene& scene) {
  if (!scene.animation) return;
  for (const Track& track : scene.animation->tracks) {
    TargetPath steps = steps_of(track.target);
    if (!steps.empty() && steps.front() == "objects")
      led_.push_back({&track, numbered(std::move(steps), scene)});
  }
}

void BodyTracks::refuse_moved(const PlacedObject& object, const Place& where,
                              const std::string& called, Faults& faults) const {
  for (const Led& each : led_) {
    if (each.track->visible || !moves(each.path, object.path)) continue;
    return faults.add({FaultKind::conflict, where.pointer(), Value(called),
                       "an object that no track moves; one moves " + each.track->target});
  }
}

std::optional<std::array<double, 2>> BodyTracks::presence(const PlacedObject& object) const {
  constexpr double ever = std::numeric_limits<double>::infinity();
  std::array<double, 2> there{-ever, ever};
  for (const Led& each : led_) {
    if (!each.track->visible || !is_within(object.path, each.path)) continue;
    if (each.track->visible->size() != 1) return std::nullopt;
    const auto& [from, to] = each.track->visible->front();
    there = {std::max(there[0], from), std::min(there[1], to)};
  }
  if (!(there[0] < there[1] && there[1] > 0)) return std::nullopt;
  return there;
}

bool BodyTracks::comes_or_goes(const PlacedObject& object) const {
  return std::ranges::any_of(led_, [&](const Led& each) {
    return each.track->visible && is_within(object.path, each.path);
  });
}

}  // namespace tia
