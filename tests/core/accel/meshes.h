// Meshes that tests make: a box, a ball, needles.
#pragma once

#include <array>
#include <cstdint>
#include <map>
#include <vector>

#include "core/shapes/mesh/mesh.h"
#include "tests/core/accel/worlds.h"

namespace tia::test {

using Triple = std::array<std::uint32_t, 3>;

inline Mesh mesh_of(const std::vector<Vec3d>& places, const std::vector<Triple>& triangles) {
  Mesh mesh;
  for (const Vec3d& p : places)
    mesh.positions.values.insert(mesh.positions.values.end(), {p.x, p.y, p.z});
  for (const Triple& t : triangles)
    mesh.indices.values.insert(mesh.indices.values.end(), t.begin(), t.end());
  return mesh;
}
inline Vec3d place(const Mesh& mesh, std::size_t i) {
  const auto& v = mesh.positions.values;
  return {v[3 * i], v[3 * i + 1], v[3 * i + 2]};
}

// A box of twelve triangles, all wound to be seen from outside.
inline Mesh box_mesh(const Vec3d& half) {
  std::vector<Vec3d> places;
  for (unsigned i = 0; i < 8; ++i)
    places.push_back(half * Vec3d{i & 1U ? 1.0 : -1, i & 2U ? 1.0 : -1, i & 4U ? 1.0 : -1});
  return mesh_of(places, {{0, 4, 6},
                          {0, 6, 2},
                          {1, 3, 7},
                          {1, 7, 5},
                          {0, 1, 5},
                          {0, 5, 4},
                          {2, 6, 7},
                          {2, 7, 3},
                          {0, 2, 3},
                          {0, 3, 1},
                          {4, 5, 7},
                          {4, 7, 6}});
}

// An octahedron whose faces are cut in four, again and again, the vertices moved onto the unit
// sphere.
inline Mesh ball_mesh(int times) {
  std::vector<Vec3d> places{{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  std::vector<Triple> faces{{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                            {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int i = 0; i < times; ++i) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [at, added] = middles.try_emplace({std::min(a, b), std::max(a, b)},
                                                   static_cast<std::uint32_t>(places.size()));
      if (added) places.push_back(normalize(places[a] + places[b]));
      return at->second;
    };
    std::vector<Triple> finer;
    for (const auto& [a, b, c] : faces) {
      const std::uint32_t ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {b, bc, ab}, {c, ca, bc}, {ab, bc, ca}});
    }
    faces = finer;
  }
  return mesh_of(places, faces);
}

// A bipyramid of n needles around an axis.
inline Mesh needles(int n) {
  std::vector<Vec3d> places{{0, 1, 0}, {0, -1, 0}};
  std::vector<Triple> faces;
  for (int i = 0; i < n; ++i) {
    const double turn = 360.0 * i / n;
    places.push_back({cos_degrees(turn), 0, sin_degrees(turn)});
    const auto a = static_cast<std::uint32_t>(2 + i),
               b = static_cast<std::uint32_t>(2 + (i + 1) % n);
    faces.insert(faces.end(), {{0, b, a}, {1, a, b}});
  }
  return mesh_of(places, faces);
}

}  // namespace tia::test
