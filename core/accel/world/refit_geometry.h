// The geometry of the moment before, put into the state of the next one, where few objects moved.
#pragma once

#include <vector>

#include "core/accel/world/geometry.h"

namespace tia {

/// Puts the moved objects, by their numbers in the scene, to where they are now. What rays then
/// find is what they find in geometry_of(scene), bit for bit; the tree's boxes are fitted anew.
/// Domain: the geometry of a scene that differs from this one in the places and sizes of these
/// objects alone. Returns: false, and a geometry that is of no use any more, where it has to be
/// built anew: where they are more than surfaces, which glow for nobody, or change their kind, or
/// the world's own origin may not stay.
/// Cost: O(moved objects), with a few nanoseconds for each other one. Errors: Stopped.
bool refit(Geometry& geometry, const Scene& scene, const std::vector<std::size_t>& moved,
           const Workers& workers = {});

}  // namespace tia
