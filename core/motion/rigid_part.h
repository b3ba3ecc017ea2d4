// Objects as parts of a rigid world: shapes in frames.
#pragma once

#include <optional>

#include "core/motion/inertia.h"
#include "core/motion/rigid.h"
#include "core/scene/object.h"

namespace tia {

/// What an object is that stands still: its parts, those of a group one by one, are appended.
/// Returns: whether the solver knows all of them.
bool add_fixed_parts(const Object& object, const Affine& parent, std::vector<RigidPart>& into);

/// MovingPart: what moves, with the inertia of that mass, and a radius around its centre of mass.
struct MovingPart {
  RigidPart part;
  Inertia inertia;
  double radius = 0;
};
/// None of what the solver does not let move: open meshes, planes, what has no closed form.
std::optional<MovingPart> moving_part(const Shape& shape, const Affine& place, double mass);

}  // namespace tia
