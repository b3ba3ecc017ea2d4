// Polynomials that are below 0 nowhere far out, and a box that holds all the rest.
#pragma once

#include <optional>
#include <vector>

#include "core/shapes/algebraic/algebraic_term.h"
#include "core/shapes/simple/box.h"

namespace tia {

/// A box outside of which the polynomial is proven to be above 0; nothing where that is not found
/// soon. Domain: terms that are collected.
std::optional<Box> compact_bounds(const std::vector<AlgebraicTerm>& terms);

}  // namespace tia
