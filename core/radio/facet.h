// Facet: a flat part of a body that waves are mirrored in, and the convex pieces that it is made
// of.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "core/math/aabb.h"
#include "core/math/vec3.h"

namespace tia {

/// FlatFace: all points p with normal . p = offset. The normal is unit and outwards.
struct FlatFace {
  Vec3d normal{0, 1, 0};
  double offset = 0;

  /// Above it by how much.
  double height_of(const Vec3d& p) const { return dot(normal, p) - offset; }
  Vec3d mirror(const Vec3d& p) const { return p - normal * (2 * height_of(p)); }
  /// Of a direction.
  Vec3d mirror_way(const Vec3d& v) const { return v - normal * (2 * dot(normal, v)); }
};

/// FacetPiece: a triangle or a convex quadrilateral of a facet.
struct FacetPiece {
  std::array<Vec3d, 4> corners{};
  std::array<Vec3d, 4> inward{};  ///< of each side: unit, in the plane
  std::array<double, 4> from{};   ///< inside where inward . p >= from
  std::size_t sides = 0;
  std::uint32_t facet = 0;

  /// Domain: a point of the plane. `slack`: how far outside still counts.
  bool holds(const Vec3d& p, double slack) const {
    for (std::size_t i = 0; i < sides; ++i)
      if (!(dot(inward[i], p) >= from[i] - slack)) return false;
    return true;
  }
  Aabb box() const {
    Aabb all;
    for (std::size_t i = 0; i < sides; ++i) all = around(all, corners[i]);
    return all;
  }
};
/// Domain: corners in order, in the face. Its sides' inner sides are told by its middle.
FacetPiece piece_of(const FlatFace& face, const std::vector<Vec3d>& corners);

/// Facet: coplanar neighbours of one body. Space/units: scene units, scene space.
struct Facet {
  FlatFace face;
  int body = 0, element = 0;     ///< the least of the elements that it is made of
  bool closed = true;            ///< whether it is the outside of a body: else both sides are free
  bool endless = false;          ///< a whole plane
  std::vector<Vec3d> hull = {};  ///< convex, in order, around all of it; none where it is endless
  std::uint32_t first_piece = 0, pieces = 0;
};

/// The convex hull of points of a face, in order. Source: Andrew, "Another efficient algorithm for
/// convex hulls in two dimensions" (1979).
std::vector<Vec3d> hull_of(const FlatFace& face, const std::vector<Vec3d>& points);

}  // namespace tia
