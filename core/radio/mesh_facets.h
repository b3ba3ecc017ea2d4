// Triangles of a mesh that are one face.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/math/vec3.h"

namespace tia {

/// WeldedMesh: triangles without doubled corners; those without area are left out.
struct WeldedMesh {
  struct Side {
    std::array<std::uint32_t, 3> corners;
    int element;
    Vec3d normal;  ///< unit, by its winding
  };
  std::vector<Vec3d> points;
  std::vector<Side> sides;

  /// Whether each edge has one triangle on either side.
  bool closed() const;
  /// Six times the volume inside. Domain: closed; below 0 where it is wound inside out.
  double volume() const;
  /// The triangles in groups of neighbours in one plane, each by its first triangle.
  std::vector<std::vector<std::size_t>> coplanar() const;
};
/// Domain: triangles' corners, three after each other.
WeldedMesh welded(const std::vector<Vec3d>& corners);

}  // namespace tia
