// RadioEdge: where two faces of a body meet, or a sheet ends: what waves are diffracted by.
#pragma once

#include "core/math/deterministic.h"
#include "core/math/vec3.h"

namespace tia {

/// RadioEdge: a straight edge between the faces 0 and n. Space/units: scene units, scene space.
struct RadioEdge {
  Vec3d from{}, along{};   ///< along: unit, along = into x normal
  double size = 0;         ///< its length
  Vec3d into{}, normal{};  ///< unit: from the edge into face 0, and that face's outer normal
  double n = 2;            ///< the outer angle between the faces over pi; 2: a sheet's end
  int body = 0, element = 0;

  /// The angle from face 0 around the edge, in [0, 2 pi). `away`: from the edge.
  double angle_of(const Vec3d& away) const {
    const double angle = atan2_of(dot(away, normal), dot(away, into));
    return angle < 0 ? angle + 2 * pi : angle;
  }
};

}  // namespace tia
