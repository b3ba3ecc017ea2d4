// Poses at every step as tracks, thinned out: what the animation says of a body that turns.
#pragma once

#include "core/motion/placed_object.h"
#include "core/motion/rigid.h"
#include "core/motion/simulation.h"

namespace tia {

/// Poses as steps at the end of the object's transform that turn it about its centre of mass and
/// then move it, and their tracks: cubic Hermite curves that are never farther than `tolerance`
/// from any pose, on the body's surface. Domain: one pose at least, at ascending times; `radius`
/// is the body's around its centre of mass.
/// Space/units: the poses are in the scene's space, the tracks in that of the object's parent.
void bake_poses(const PlacedObject& object, const std::vector<RigidPose>& poses, double radius,
                double tolerance, Simulation& into);

}  // namespace tia
