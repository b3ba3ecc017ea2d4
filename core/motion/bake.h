// Motion as tracks: what the animation of a scene says of a body.
#pragma once

#include <vector>

#include "core/motion/motion.h"
#include "core/motion/placed_object.h"
#include "core/motion/simulation.h"

namespace tia {

/// A path of parabolas as the step {"translate": ..} at the end of the object's transform, from
/// zero at the first knot, and its track: a cubic Hermite curve, which is the parabola itself.
/// Domain: knots whose times do not descend, the first before `until`.
/// Space/units: the knots are in the scene's space, the track in that of the object's parent.
void bake_parabolas(const PlacedObject& object, const std::vector<Knot>& knots, double until,
                    Simulation& into);

}  // namespace tia
