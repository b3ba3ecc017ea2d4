// What answers call the objects of a scene.
#pragma once

#include <map>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace tia {

/// ObjectLabel: an object's `name`, of what a model shows the node's, of a piece of walls theirs;
/// where it has none its JSON Pointer into the scene, which is the model's or the walls'; and the
/// `type` of its shape, of a luminous light that of the light.
struct ObjectLabel {
  std::string name;
  std::string_view type;
};

/// One label for each thing that a ray can meet, numbered as World's objects are: shapes and solids
/// in the scene's order, those inside groups in their place, then luminous lights that have a
/// place, the key light last.
std::vector<ObjectLabel> object_labels(const Scene& scene);

/// The JSON Pointers into the scene of those of these numbers.
std::map<int, std::string> object_pointers(const Scene& scene, const std::set<int>& numbers);

}  // namespace tia
