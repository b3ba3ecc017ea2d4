// The paths around edges.
#pragma once

#include "core/radio/images.h"

namespace tia {

/// Adds the paths that are diffracted once, and sorts those of each receiver.
/// Cost: edges times receivers. Errors: as check_paths; Stopped.
void add_edge_paths(const RadioWorld& world, const PathSearch& search, const Workers& workers,
                    PathsTo& out);

}  // namespace tia
