// The builder of a Bvh.
#pragma once

#include <span>

#include "core/boxes/bvh.h"
#include "core/parallel/workers.h"

namespace tia {

/// Binned surface area heuristic: of 16 bins along each axis of the centres the split with the
/// least expected cost; the middle of the list where no split separates anything. The widest
/// children of a node are replaced by their own two until it has eight.
/// The tree does not depend on the number of workers. Cost: O(n log n) time, 32 bytes a box for the
/// while. Domain: boxes that are not empty. Errors: Stopped. Source: Wald, "On fast construction of
/// SAH-based bounding volume hierarchies" (2007); eight children: Wald, Benthin, Boulos, "Getting
/// rid of packets" (2008).
Bvh build_bvh(std::span<const Box32> boxes, const Workers& workers = {});

}  // namespace tia
