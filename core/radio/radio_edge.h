// RadioEdge: where two faces of a body meet, or a sheet ends: what waves are diffracted by.
#pragma once

#include <vector>

#include "core/radio/facet.h"

namespace tia {

struct RadioBodies;

/// RadioEdge: a straight edge between the faces 0 and n. Space/units: scene units, scene space.
struct RadioEdge {
  Vec3d from{}, along{};   ///< along: unit, along = into x normal
  double size = 0;         ///< its length
  Vec3d into{}, normal{};  ///< unit: from the edge into face 0, and that face's outer normal
  double n = 2;            ///< the outer angle between the faces over pi; 2: a sheet's end
  int body = 0, element = 0;

  /// The angle from face 0 around the edge, in [0, 2 pi). `away`: from the edge.
  double angle_of(const Vec3d& away) const;
};

/// The convex edges of closed bodies, and the ends of sheets; facets that only touch have none.
/// `slack`: how near corners are the same.
std::vector<RadioEdge> edges_of(const RadioBodies& all, double slack);

}  // namespace tia
