// Those of a scene's fields that tracks change, as JSON and back.
#pragma once

#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace tia {

/// SceneFields: names of a scene's own fields.
using SceneFields = std::set<std::string, std::less<>>;

/// The fields that a track may change.
std::vector<std::string_view> movable_fields();

/// These fields as canonical text has them, those at their defaults left out.
Value::Object written_fields(const Scene& scene, const SceneFields& names);

/// Reads these fields again, as they are by default where they are not written.
void read_fields(const Value::Object& written, const SceneFields& names, Faults& faults,
                 Scene& scene);

}  // namespace tia
