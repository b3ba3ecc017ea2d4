// A tree of boxes kept when few of its things move: its boxes are fitted anew, its shape stays.
#pragma once

#include <functional>
#include <vector>

#include "core/boxes/bvh.h"

namespace tia {

/// Fits the boxes around the things that have moved, by their numbers, from the leaves up. What is
/// met stays the same whatever the tree's shape; how fast, as long as things stay near.
/// Cost: O(things). Domain: a tree of build_bvh, whose nodes come before their children.
/// Source: Wald, Boulos, Shirley, "Ray tracing deformable scenes using dynamic bounding volume
/// hierarchies" (2007), section 4.
void refit_bvh(Bvh& bvh, const std::vector<bool>& has_moved,
               const std::function<Box32(std::uint32_t)>& box_of);

}  // namespace tia
