// How a model stands in its object's space: which way up, and in which box.
#pragma once

#include "core/math/transform.h"
#include "core/shapes/composite/placed_model.h"

namespace tia {

/// The rotation that turns a model's axis to y.
Affine upright(UpAxis up);

/// The map of a box into another as Fit says: scaled alike in all directions until it first fills
/// it, then aligned. A box that is a point keeps its size.
/// Domain: a box that is not empty; a fit that was read without a fault.
Affine fitted(const Fit& fit, const Aabb& box);

}  // namespace tia
