// The edges of a scene's bodies.
#pragma once

#include <vector>

#include "core/radio/radio_body.h"

namespace tia {

/// The convex edges of closed bodies, and the ends of sheets; facets that only touch have none.
/// `slack`: how near corners are the same.
std::vector<RadioEdge> edges_of(const RadioBodies& all, double slack);

}  // namespace tia
