// What an object asks of a model, found in it: its words as the model's own numbers.
#pragma once

#include <set>
#include <string_view>

#include "core/models/pose.h"
#include "core/scene/object.h"

namespace tia {

/// ModelChoice. Domain: as long as the object that asks.
struct ModelChoice {
  ModelMoment moment;
  MaybeIndex variant;
  UpAxis up = UpAxis::y;
  double smooth = 0;                  ///< degrees
  std::set<std::string_view> hidden;  ///< names of nodes, meshes and materials
};

/// Errors: as faults, at the object's fields: numbers of scenes and animations, names of variants,
/// of what is hidden and of materials that the model does not have. They say what it has.
/// Domain: an object whose shape is that model; its place in the scene.
ModelChoice choice_of(const Model& model, const Object& object, const Place& at, Faults& faults);

}  // namespace tia
