// What a still has to frame: the points of what a model shows.
#pragma once

#include <vector>

#include "core/scene/object.h"
#include "core/scene/still_framing.h"

namespace tia {

/// The points of what a model shows (PlacedModel::shown), each as often as its mesh is placed: of
/// vertices those that triangles use; of points the balls that stand for them. Of more than 2^22
/// vertices, the boxes' corners of the rest, within which they are.
/// Space/units: that of the objects' parent. Domain: meshes, balls and groups of them; all balls of
/// one size.
StillPoints points_of(const std::vector<Object>& shown);

}  // namespace tia
