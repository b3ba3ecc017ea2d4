// Triangles that share vertices, as the scene writes them.
#pragma once

#include <array>

#include "core/input/numbers.h"

namespace tia {

/// Mesh. Surface: the triangles whose corners are three indices each into the positions; open or
/// closed. Normals, one a vertex, smooth the shading and tell the outer side, however the triangles
/// are wound; without them it is the side that sees the corners counter-clockwise. Uvs, two numbers
/// a vertex, place textures; colours multiply its material's. Space/units: scene units, object
/// space.
struct Mesh {
  static constexpr std::string_view type = "mesh";
  static constexpr std::size_t most_triangles = 1 << 24;  ///< a hit tells which one in a float
  Numbers<float> positions;
  Numbers<std::uint32_t> indices;
  Numbers<float> normals, uvs, colors;
  /// What models have besides, and JSON does not: a second set of uvs; x, y and z of each vertex'
  /// tangent and w, 1 or -1: the bitangent is w n x t.
  Numbers<float> more_uvs{}, tangents{};

  template <class Visitor>
  static void fields(Visitor&& visit) {
    constexpr double far = 1e9;
    visit("positions", &Mesh::positions,
          Spec{.about = "x, y and z of each vertex",
               .min = -far,
               .max = far,
               .required = true,
               .min_items = 9});
    visit("indices", &Mesh::indices,
          Spec{.about = "the three vertices of each triangle, of at most 16777216",
               .required = true,
               .min_items = 3});
    visit(
        "normals", &Mesh::normals,
        Spec{.about = "x, y and z of each vertex' normal, of any length but 0; they tell the outer "
                      "side, however the triangles are wound",
             .min = -far,
             .max = far});
    visit("uvs", &Mesh::uvs, Spec{.about = "u and v of each vertex", .min = -far, .max = far});
    visit("colors", &Mesh::colors,
          Spec{.about = "linear red, green, blue and alpha of each vertex; between them they are "
                        "interpolated and multiply the material's colour",
               .min = 0,
               .max = 1});
  }
  std::size_t vertices() const { return positions.values.size() / 3; }
  std::size_t triangles() const { return indices.values.size() / 3; }

  /// Too many triangles, lists of the wrong length, indices beyond the positions, normals of no
  /// length. A place in a list is that of its number, however the list is written.
  void check(const Place& at, Faults& faults) const;
  bool operator==(const Mesh&) const = default;
};

/// MeshLists: where a mesh's lists are in memory. Meshes in which that is the same are equal.
using MeshLists = std::array<const void*, 7>;
inline MeshLists lists_of(const Mesh& mesh) {
  return {mesh.positions.values.get().data(), mesh.indices.values.get().data(),
          mesh.normals.values.get().data(),   mesh.uvs.values.get().data(),
          mesh.colors.values.get().data(),    mesh.more_uvs.values.get().data(),
          mesh.tangents.values.get().data()};
}

}  // namespace tia
