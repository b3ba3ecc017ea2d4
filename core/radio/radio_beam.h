// RadioBeam: what an image can see through the facet that made it. It prunes the tree of images and
// loses nothing: all that it leaves out is provably out of reach.
#pragma once

#include <vector>

#include "core/radio/radio_world.h"

namespace tia {

/// RadioBeam: all points with inward . p >= from, of every plane; none: everything.
/// Source: Heckbert, Hanrahan, "Beam tracing polygonal objects", SIGGRAPH 1984.
struct RadioBeam {
  struct Side {
    Vec3d inward;
    double from;
  };
  std::vector<Side> sides;

  /// Whether none of a box is in it. Conservative: a box near it may count as in it.
  bool misses(const Aabb& box, double slack) const;
  /// Whether a point is in it, or within that slack of it.
  bool holds(const Vec3d& p, double slack) const;
};

/// What is left of a convex polygon in a beam. Source: Sutherland, Hodgman, "Reentrant polygon
/// clipping" (1974). `slack`: how far outside is still kept.
std::vector<Vec3d> clipped(const std::vector<Vec3d>& polygon, const RadioBeam& beam, double slack);

/// Whether anything is left of it. Cost: less, where no side of the beam cuts it.
bool sees(const RadioBeam& beam, const std::vector<Vec3d>& polygon, double slack);

/// The beam of an image, mirrored in a facet of which the earlier beam sees that much. Of an
/// endless one `seen` is empty, and the earlier beam is mirrored.
RadioBeam mirrored_beam(const RadioBeam& earlier, const Facet& facet, int side, const Vec3d& image,
                        const std::vector<Vec3d>& seen);

}  // namespace tia
