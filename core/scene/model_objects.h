// The objects that a model stands for.
#pragma once

#include <vector>

#include "core/models/kept_model.h"
#include "core/scene/model_pieces.h"

namespace tia {

/// The map from a model's space to its object's: turned upright, then fitted into a box.
/// Domain: the box around all that is shown, which is not empty.
Affine map_of(const PlacedModel& asked, const ModelChoice& choice, const Aabb& bounds);

/// A mesh for each part that a node shows, a group of them where the node has several instances; a
/// group of balls where the part is points. Each has the part's material, unless the object has one
/// for all. Where a place is not one that objects can have (is_usable), the vertices are moved
/// themselves, and their normals and tangents are left out. Colours of vertices go with the part's
/// own material: another one has none of them. Points of one colour are a group in that of all.
/// Returns: none where the budget does not reach, which is then exceeded.
/// Space/units: the object's own, before its transform. Domain: what choice_of has made of both.
std::vector<Object> model_objects(const KeptModel& kept, const Object& object,
                                  const ModelChoice& choice, ModelBudget& budget);

}  // namespace tia
