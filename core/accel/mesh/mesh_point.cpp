#include "core/accel/mesh/mesh_point.h"

#include <cmath>

namespace tia {
namespace {

Vec3d area(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return cross(b - a, c - a); }

std::array<Vec2d, 3> corner_uvs(const HugeVector<Vec2d>& uvs,
                                const std::array<std::uint32_t, 3>& corners) {
  return {uvs[corners[0]], uvs[corners[1]], uvs[corners[2]]};
}

const HugeVector<Vec2d>& uvs_of(const MeshIndex& mesh, std::size_t set) {
  return set == 1 && !mesh.more_uvs.empty() ? mesh.more_uvs : mesh.uvs;
}

Vec2d between(const std::array<Vec2d, 3>& uv, const std::array<double, 3>& share) {
  const auto& [s, t, r] = uv;
  const auto& [u, v, w] = share;
  return {s.u * u + t.u * v + r.u * w, s.v * u + t.v * v + r.v * w};
}

std::array<double, 4> between(const HugeVector<std::array<float, 4>>& list,
                              const std::array<std::uint32_t, 3>& corners,
                              const std::array<double, 3>& share) {
  std::array<double, 4> sum{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 4; ++k)
      sum[k] += static_cast<double>(list[corners[i]][k]) * share[i];
  return sum;
}

double uv_area_of(const std::array<Vec2d, 3>& uv) {
  const auto& [a, b, c] = uv;
  return std::fabs((b.u - a.u) * (c.v - a.v) - (c.u - a.u) * (b.v - a.v));
}

// Where a vector leads along a surface; none where it stands upright on it.
Vec3d along(const Vec3d& v, const Vec3d& n) {
  const Vec3d flat = v - n * dot(v, n);
  const double length = tia::length(flat);
  return length > 1e-9 * tia::length(v) ? flat * (1 / length) : Vec3d{};
}

// How u grows, and whether v grows to its left, seen from the side that the corners are
// counter-clockwise on. Source: Lengyel, "Mathematics for 3D game programming", 7.8.3.
MeshTangent uv_tangent(const TrianglePoint& at, const std::array<Vec2d, 3>& uv) {
  const Vec3d e = at.corner[1] - at.corner[0], f = at.corner[2] - at.corner[0];
  const double eu = uv[1].u - uv[0].u, ev = uv[1].v - uv[0].v;
  const double fu = uv[2].u - uv[0].u, fv = uv[2].v - uv[0].v;
  const double area = eu * fv - fu * ev;
  if (!(std::fabs(area) > 0)) return {};
  return {(e * fv - f * ev) * (area < 0 ? -1.0 : 1.0), area < 0 ? -1.0 : 1.0};
}

}  // namespace

TrianglePoint::TrianglePoint(const MeshIndex& of, std::size_t triangle, const Vec3d& p)
    : mesh(of),
      corners(of.triangles[triangle]),
      corner{of.positions[corners[0]], of.positions[corners[1]], of.positions[corners[2]]},
      whole(area(corner[0], corner[1], corner[2])) {
  const double v = dot(area(corner[0], p, corner[2]), whole) / dot(whole, whole);
  const double w = dot(area(corner[0], corner[1], p), whole) / dot(whole, whole);
  share = {1 - v - w, v, w};
}

Vec3d normal_of(const TrianglePoint& at) {
  const HugeVector<Vec3d>& normals = at.mesh.normals;
  if (!normals.empty()) {
    const auto& [i, j, k] = at.corners;
    const auto& [u, v, w] = at.share;
    const Vec3d smooth = normals[i] * u + normals[j] * v + normals[k] * w;
    if (dot(smooth, smooth) > 0) return normalize(smooth);
  }
  return normalize(at.whole);
}

MeshPoint point_of(const TrianglePoint& at) {
  MeshPoint point{normalize(at.whole), normal_of(at), {at.share[1], at.share[2]}};
  if (!at.mesh.uvs.empty()) point.uv = between(corner_uvs(at.mesh.uvs, at.corners), at.share);
  return point;
}

MeshTexturePoint texture_point_of(const TrianglePoint& at) {
  MeshTexturePoint point;
  const std::size_t sets = at.mesh.more_uvs.empty() ? 1 : 2;
  for (std::size_t set = 0; set < sets; ++set) {
    const HugeVector<Vec2d>& uvs = uvs_of(at.mesh, set);
    point.uv[set] = {at.share[1], at.share[2]};
    if (uvs.empty()) continue;
    const std::array<Vec2d, 3> uv = corner_uvs(uvs, at.corners);
    point.uv[set] = between(uv, at.share);
    point.uv_area[set] = uv_area_of(uv);
  }
  if (sets == 1) point.uv[1] = point.uv[0], point.uv_area[1] = point.uv_area[0];
  if (!at.mesh.colors.empty()) point.color = color_of(at);
  return point;
}

std::array<double, 4> color_of(const TrianglePoint& at) {
  return between(at.mesh.colors, at.corners, at.share);
}

MeshTangent tangent_of(const TrianglePoint& at, const TextureMap& map, const Vec3d& n) {
  MeshTangent found;
  if (!at.mesh.tangents.empty()) {
    const auto [x, y, z, w] = between(at.mesh.tangents, at.corners, at.share);
    found = {{x, y, z}, w < 0 ? -1.0 : 1.0};
  } else if (const HugeVector<Vec2d>& uvs = uvs_of(at.mesh, map.uv_set); !uvs.empty()) {
    std::array<Vec2d, 3> places = corner_uvs(uvs, at.corners);
    for (Vec2d& each : places) each = place_in(map, each), each.v = -each.v;
    found = uv_tangent(at, places);
    if (dot(at.whole, n) < 0) found.sign = -found.sign;
  }
  found.t = along(found.t, n);
  if (dot(found.t, found.t) > 0) return found;
  const Vec3d aside = along({1, 0, 0}, n);
  return {dot(aside, aside) > 0 ? aside : Vec3d{0, 1, 0}, found.sign};
}

}  // namespace tia
