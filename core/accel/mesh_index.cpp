#include "core/accel/mesh_index.h"

#include "core/input/stopped.h"

namespace tia {
namespace {

Vec3d triple(const std::vector<double>& values, std::size_t i) {
  return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}

Vec3d area_vector(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return cross(b - a, c - a); }

// Longest edge squared: what an area is large or small against.
double extent(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d edges[] = {b - a, c - b, a - c};
  return std::max({dot(edges[0], edges[0]), dot(edges[1], edges[1]), dot(edges[2], edges[2])});
}

}  // namespace

MeshIndex::MeshIndex(const Mesh& mesh, const std::stop_token& stop) {
  constexpr double thinnest =
      1e-14;  // an area below this share of the longest edge's square is none
  const auto& places = mesh.positions.values;
  for (std::size_t i = 0; i < places.size() / 3; ++i) positions.push_back(triple(places, i));
  for (std::size_t i = 0; i < mesh.normals.values.size() / 3; ++i)
    normals.push_back(normalize(triple(mesh.normals.values, i)));
  for (std::size_t i = 0; i < mesh.uvs.values.size() / 2; ++i)
    uvs.push_back({mesh.uvs.values[2 * i], mesh.uvs.values[2 * i + 1]});

  const auto& numbers = mesh.indices.values;
  std::vector<Aabb> boxes;
  std::vector<std::uint32_t> which;
  for (std::size_t i = 0; i < numbers.size() / 3; ++i) {
    if (i % 4096 == 0) end_if_asked(stop);
    triangles.push_back({numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]});
    const Vec3d &a = corner(i, 0), &b = corner(i, 1), &c = corner(i, 2);
    if (!(length(area_vector(a, b, c)) > thinnest * extent(a, b, c))) {
      ++degenerate;
      continue;
    }
    boxes.push_back(around(around(around(Aabb{}, a), b), c));
    which.push_back(static_cast<std::uint32_t>(i));
  }
  bvh = build_bvh(boxes, stop);
  for (std::uint32_t& each : bvh.order) each = which[each];
}

MeshPoint point_of(const MeshIndex& mesh, std::size_t triangle, const Vec3d& p) {
  const Vec3d &a = mesh.corner(triangle, 0), &b = mesh.corner(triangle, 1),
              &c = mesh.corner(triangle, 2);
  const Vec3d whole = area_vector(a, b, c);
  // Barycentric coordinates: the share of the area that faces each corner.
  const double v = dot(area_vector(a, p, c), whole) / dot(whole, whole);
  const double w = dot(area_vector(a, b, p), whole) / dot(whole, whole);
  const double u = 1 - v - w;
  MeshPoint point{normalize(whole), {}, {v, w}};
  const auto& [i, j, k] = mesh.triangles[triangle];
  point.n = point.ng;
  if (!mesh.normals.empty()) {
    const Vec3d smooth = mesh.normals[i] * u + mesh.normals[j] * v + mesh.normals[k] * w;
    if (dot(smooth, smooth) > 0) point.n = normalize(smooth);
  }
  if (!mesh.uvs.empty()) {
    const Vec2d &s = mesh.uvs[i], &t = mesh.uvs[j], &r = mesh.uvs[k];
    point.uv = {s.u * u + t.u * v + r.u * w, s.v * u + t.v * v + r.v * w};
  }
  return point;
}

}  // namespace tia
