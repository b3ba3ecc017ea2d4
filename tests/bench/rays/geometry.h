// The things that rays are traced against: made here once, in float, for both tracers alike.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

#include "core/scene/scene.h"

namespace tia::bench {

/// Geometry: spheres, or else triangles that share vertices. Space/units: within [-1,1]^3 but for
/// what reaches out of it by its own size.
struct Geometry {
  std::vector<float> spheres;          ///< x, y, z and radius of each
  std::vector<float> positions;        ///< x, y and z of each vertex
  std::vector<std::uint32_t> indices;  ///< three a triangle

  std::size_t primitives() const { return spheres.size() / 4 + indices.size() / 3; }
};

/// What kinds there are, and the sizes that each is measured at unless others are asked for.
struct GeometryKind {
  std::string_view name;
  Geometry (*make)(int n);
  std::vector<int> sizes;
};
/// spheres: n balls, strewn over the cube; triangles: n of them, the same way; tubes: a curled
/// tube of about n small triangles, the smooth mesh that most meshes are.
const std::vector<GeometryKind>& geometry_kinds();

/// Where the light of the shadow rays is.
inline constexpr Vec3d light_position{3, 5, 6};

/// The same as Tia's input: a mesh, or one object a sphere; and one point light.
Scene scene_of(const Geometry& geometry);

}  // namespace tia::bench
