// Those of a scene's fields that tracks change, as JSON and back.
#pragma once

#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/animation_target.h"
#include "core/scene/scene.h"

namespace tia {

/// SceneFields: names of a scene's own fields.
using SceneFields = std::set<std::string, std::less<>>;

/// The fields that a track may change.
std::vector<std::string_view> movable_fields();

/// MovedObjects: the numbers of the scene's objects that tracks change. Those alone are written and
/// read again, however many others there are, which stand as their own numbers in the written list
/// meanwhile. None: the list is written as it is.
using MovedObjects = std::optional<std::set<std::size_t>>;

/// The objects that the targets are in or, visible, are; names among the targets' steps become
/// numbers. Returns: none, and the targets as they are, where a target is the list or an object
/// itself, or one that is not to be found by its number, or by a name that it alone has.
MovedObjects moved_objects(const std::vector<Object>& objects, const std::vector<Track>& tracks,
                           std::vector<TargetPath>& targets);

/// These fields as canonical text has them, those at their defaults left out.
Value::Object written_fields(const Scene& scene, const SceneFields& names,
                             const MovedObjects& moved);

/// Reads these fields again, as they are by default where they are not written. Domain: `scene` has
/// the objects that have been written.
void read_fields(const Value::Object& written, const SceneFields& names, const MovedObjects& moved,
                 Faults& faults, Scene& scene);

}  // namespace tia
