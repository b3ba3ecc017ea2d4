// What walls are lowered to: boxes, and a prism at each corner that is not a right angle.
#pragma once

#include <variant>
#include <vector>

#include "core/math/transform.h"
#include "core/shapes/composite/walls.h"
#include "core/shapes/mesh/mesh.h"
#include "core/shapes/simple/box.h"

namespace tia {

/// WallPiece: a box, and where it stands: in the walls' own space where the run is along an axis;
/// or a closed mesh.
struct WallPiece {
  std::variant<Box, Mesh> shape;
  std::optional<Affine> place{};
};

/// The pieces along the line: of each run the wall up to an opening, the one below it, the one
/// above it, and so on; then its corner. Pieces touch and have no inside in common; a prism's
/// points are a mesh's, and rounded.
/// Errors: as faults; there are no pieces then.
std::vector<WallPiece> wall_pieces(const Walls& walls, const Place& at, Faults& faults);

}  // namespace tia
