// The patches of a parametric surface: rectangles of (u, v) in a tree, made once by interval
// arithmetic, each with a box around its piece of the surface and what its slopes may be.
#pragma once

#include "core/boxes/line_traversal.h"
#include "core/formulas/program.h"

namespace tia {

/// Rectangle: of (u, v), by its middle and half its sides.
struct Rectangle {
  double u = 0, v = 0, half_u = 0, half_v = 0;
  bool operator==(const Rectangle&) const = default;
};

/// SurfacePatch: what is proven of the surface S over a rectangle. Where it is `smooth`, S is
/// defined and continuous, and S_u and S_v differ from `by_u` and `by_v` by at most the spreads.
struct SurfacePatch {
  Rectangle where{};
  Vec3d middle{};  ///< S at the rectangle's middle
  Vec3d by_u{}, by_v{}, spread_u{}, spread_v{};
  bool smooth = false;
};

/// SurfacePiece: a patch and a box around it, empty where S is nowhere defined.
struct SurfacePiece {
  SurfacePatch patch;
  Aabb box;
};
/// Of eight rectangles at once. Domain: a program of u and v with three results.
std::array<SurfacePiece, 8> pieces_of(const Program& surface,
                                      const std::array<Rectangle, 8>& where);
/// The rectangle in eight, halved three times where its patch is longest.
std::array<Rectangle, 8> eighths(const SurfacePatch& patch);

struct SurfacePatches {
  OffsetBvh tree;  ///< whose leaves are the patches
  std::vector<SurfacePatch> patches;
  Aabb box;
};

/// Patches shrink until each is nearly a plane's, or there are too many. What is nowhere bounded,
/// like a pole of tan, is left out when it is too small to part.
/// Cost: bounded: some tenth of a second, whatever the surface.
SurfacePatches patches_of(const Program& surface, const Rectangle& domain);

}  // namespace tia
