#include "core/accel/mesh/mesh_index.h"

#include <bit>

namespace tia {
namespace {

Vec3d triple(const std::vector<double>& values, std::size_t i) {
  return {values[3 * i], values[3 * i + 1], values[3 * i + 2]};
}

HugeVector<Vec2d> pairs_of(const std::vector<double>& values) {
  HugeVector<Vec2d> pairs;
  pairs.reserve(values.size() / 2);
  for (std::size_t i = 0; i + 1 < values.size(); i += 2)
    pairs.push_back({values[i], values[i + 1]});
  return pairs;
}

HugeVector<std::array<float, 4>> fours_of(const std::vector<double>& values) {
  HugeVector<std::array<float, 4>> fours;
  fours.reserve(values.size() / 4);
  for (std::size_t i = 0; i + 3 < values.size(); i += 4)
    fours.push_back({static_cast<float>(values[i]), static_cast<float>(values[i + 1]),
                     static_cast<float>(values[i + 2]), static_cast<float>(values[i + 3])});
  return fours;
}

Vec3d area_vector(const Vec3d& a, const Vec3d& b, const Vec3d& c) { return cross(b - a, c - a); }

// The square of the longest edge, which areas are compared with.
double extent(const Vec3d& a, const Vec3d& b, const Vec3d& c) {
  const Vec3d edges[] = {b - a, c - b, a - c};
  return std::max({dot(edges[0], edges[0]), dot(edges[1], edges[1]), dot(edges[2], edges[2])});
}

}  // namespace

MeshIndex::MeshIndex(const Mesh& mesh, const Workers& workers)
    : positions(mesh.positions.values.get()) {
  normals.reserve(mesh.normals.values.size() / 3);
  for (std::size_t i = 0; i < mesh.normals.values.size() / 3; ++i)
    normals.push_back(normalize(triple(mesh.normals.values.get(), i)));
  uvs = pairs_of(mesh.uvs.values);
  more_uvs = pairs_of(mesh.more_uvs.values);
  colors = fours_of(mesh.colors.values);
  tangents = fours_of(mesh.tangents.values);
  const auto& numbers = mesh.indices.values.get();
  triangles.reserve(numbers.size() / 3);
  for (std::size_t i = 0; i < numbers.size(); i += 3)
    triangles.push_back({numbers[i], numbers[i + 1], numbers[i + 2]});
  if (!normals.empty()) wind_to_normals();
  workers.end_if_asked();

  const std::vector<std::uint32_t> sound = sound_triangles(workers);
  measure(sound);
  std::vector<Box32> boxes(sound.size());
  workers.for_each_share(sound.size(), [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) boxes[i] = measured_box(sound[i]);
  });
  bvh = build_bvh(boxes, workers);
  for (std::uint32_t& each : bvh.order) each = sound[each];
  pack(workers);
}

// Triangles are wound to the side that their normals point to. So a mesh wound the other way gives
// the same picture to the bit, though sums depend on the order of corners. Where the normals favour
// neither side, the indices of the corners decide.
void MeshIndex::wind_to_normals() {
  for (auto& [i, j, k] : triangles) {
    const Vec3d across = area_vector(positions[i], positions[j], positions[k]);
    const double side = dot(across, normals[i] + (normals[j] + normals[k]));
    if (side < 0 || (!(side > 0) && k < j)) std::swap(j, k);
  }
}

// Whether it has an area. Others are never hit.
bool MeshIndex::is_sound(std::size_t triangle) const {
  // Twice the area as a share of the longest edge's square: 45 times the 2^-52 that the rounding of
  // the products makes of no area.
  constexpr double thinnest = 1e-14;
  const Vec3d a = corner(triangle, 0), b = corner(triangle, 1), c = corner(triangle, 2);
  const Vec3d across = area_vector(a, b, c);
  const double most = thinnest * extent(a, b, c);
  return dot(across, across) > most * most;
}

std::vector<std::uint32_t> MeshIndex::sound_triangles(const Workers& workers) {
  std::vector<char> is(triangles.size());
  workers.for_each_share(is.size(), [&](std::size_t from, std::size_t to) {
    for (std::size_t i = from; i < to; ++i) is[i] = is_sound(i);
  });
  std::vector<std::uint32_t> sound;
  sound.reserve(triangles.size());
  for (std::size_t i = 0; i < triangles.size(); ++i)
    if (is[i] != 0) sound.push_back(static_cast<std::uint32_t>(i));
  degenerate = triangles.size() - sound.size();
  return sound;
}

void MeshIndex::measure(const std::vector<std::uint32_t>& sound) {
  if (sound.empty()) return;
  Aabb all;
  for (const std::uint32_t i : sound)
    for (std::size_t k = 0; k < 3; ++k) all = around(all, corner(i, k));
  middle = all.center();
  const Vec3d half = all.size() * 0.5;
  unit = std::exp2(std::ilogb(std::max({half.x, half.y, half.z})) + 1);
}

double MeshIndex::plane_distance(std::size_t triangle, const Line& line) const {
  const Plane& plane = planes[triangle];
  return (plane.d - dot(plane.n, line.origin)) / dot(plane.n, line.direction);
}

// Larger than the triangle by more than what the test in float errs by.
Box32 MeshIndex::measured_box(std::size_t triangle) const {
  Vec3f low{infinity, infinity, infinity}, high = -low;
  for (std::size_t i = 0; i < 3; ++i) {
    const auto p = static_cast<Vec3f>(measured(corner(triangle, i)));
    low = {std::min(low.x, p.x), std::min(low.y, p.y), std::min(low.z, p.z)};
    high = {std::max(high.x, p.x), std::max(high.y, p.y), std::max(high.z, p.z)};
  }
  const Vec3f more = Vec3f{1, 1, 1} * tolerance::mesh_box;
  return {low - more, high + more};
}

void MeshIndex::pack(const Workers& workers) {
  planes.resize(triangles.size());
  packed = {bvh, workers, [this](std::uint32_t triangle) {
              std::array<Vec3d, 3> corners;
              std::array<float, 10> words;
              for (std::size_t i = 0; i < 3; ++i) {
                corners[i] = measured(corner(triangle, i));
                const auto p = static_cast<Vec3f>(corners[i]);
                words[i] = p.x, words[3 + i] = p.y, words[6 + i] = p.z;
              }
              words[9] = std::bit_cast<float>(triangle);
              const Vec3d n = area_vector(corners[0], corners[1], corners[2]);
              planes[triangle] = {n, dot(n, corners[0])};
              return words;
            }};
}

}  // namespace tia
