#include "core/models/tangents.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <unordered_map>

#include "core/math/deterministic.h"
#include "core/math/vec3.h"

namespace tia {
namespace {

constexpr std::uint32_t none = 0xffffffffU;
constexpr double smallest = 0x1p-126;  // what counts as more than nothing

bool is_some(double x) { return std::fabs(x) > smallest; }
Vec3d unit_or_none(const Vec3d& v) {
  return is_some(v.x) || is_some(v.y) || is_some(v.z) ? normalize(v) : Vec3d{};
}
Vec3d in_plane(const Vec3d& v, const Vec3d& n) { return unit_or_none(v - n * dot(n, v)); }

/// TangentMaking: a mesh's corners, three a triangle, grouped where they share a tangent.
class TangentMaking {
 public:
  explicit TangentMaking(const TangentSource& mesh) : mesh_(mesh), faces_(mesh.indices.size() / 3) {
    for (std::uint32_t f = 0; f < faces_.size(); ++f) set_directions(f);
    weld();
    link_edges();
    for (std::uint32_t f = 0; f < faces_.size(); ++f)
      for (std::uint32_t i = 0; i < 3; ++i)
        if (faces_[f].sound && !faces_[f].any && faces_[f].groups[i] == none) add_group(f, i);
    adopt();
  }

  TangentVertices vertices() const {
    TangentVertices out;
    const auto n = static_cast<std::uint32_t>(mesh_.positions.size() / 3);
    std::vector<std::uint32_t> own(n, none);  // of each given vertex its group
    std::vector<bool> is_taken(n);
    std::unordered_map<std::uint64_t, std::uint32_t> known;
    out.indices.reserve(mesh_.indices.size());
    out.tangents.reserve(4 * own.size());
    for (std::uint32_t c = 0; c < mesh_.indices.size(); ++c) {
      const std::uint32_t vertex = mesh_.indices[c], group = faces_[c / 3].groups[c % 3];
      if (!is_taken[vertex]) own[vertex] = group, is_taken[vertex] = true;
      std::uint32_t number = vertex;
      if (own[vertex] != group) {
        const auto next = static_cast<std::uint32_t>(n + out.from.size());
        const auto [at, is_new] = known.try_emplace(std::uint64_t{vertex} << 32U | group, next);
        if (is_new) out.from.push_back(vertex), own.push_back(group);
        number = at->second;
      }
      out.indices.push_back(number);
    }
    for (const std::uint32_t group : own) {
      const Group one = group == none ? Group{{1, 0, 0}, false} : groups_[group];
      out.tangents.insert(out.tangents.end(),
                          {one.sum.x, one.sum.y, one.sum.z, one.forward ? 1.0 : -1.0});
    }
    return out;
  }

 private:
  struct Face {
    Vec3d s;                                                   // how u grows; unit, or 0
    bool forward = false;                                      // whether uvs run counter-clockwise
    bool any = true;                                           // whether they tell no direction
    bool sound = false;                                        // whether its corners are three
    std::array<std::uint32_t, 3> neighbors{none, none, none};  // over the edge from each corner
    std::array<std::uint32_t, 3> groups{none, none, none};
  };
  struct Group {
    Vec3d sum{};  // the tangent, once it is closed
    bool forward = false;
  };
  struct Edge {
    std::uint64_t ends;    // their points, the lower one first
    std::uint32_t corner;  // from which it goes
    bool turned;           // whether that is the higher one
  };

  static std::uint32_t next(std::uint32_t i) { return i == 2 ? 0 : i + 1; }
  static std::uint32_t before(std::uint32_t i) { return i == 0 ? 2 : i - 1; }
  Vec3d triple(std::span<const double> list, std::uint32_t vertex) const {
    const double* at = &list[3 * std::size_t{vertex}];
    return {at[0], at[1], at[2]};
  }
  Vec3d position(std::uint32_t corner) const {
    return triple(mesh_.positions, mesh_.indices[corner]);
  }
  // Of any length, as the mesh has it.
  Vec3d given_normal(std::uint32_t corner) const {
    if (!mesh_.normals.empty()) return triple(mesh_.normals, mesh_.indices[corner]);
    const std::uint32_t f = corner / 3 * 3;
    const Vec3d a = position(f);
    return unit_or_none(cross(position(f + 1) - a, position(f + 2) - a));
  }
  Vec3d normal(std::uint32_t corner) const { return unit_or_none(given_normal(corner)); }
  std::array<double, 2> uv(std::uint32_t corner) const {
    const double* at = &mesh_.uvs[2 * std::size_t{mesh_.indices[corner]}];
    return {at[0], at[1]};
  }

  // Source: Mikkelsen (2008), (18).
  void set_directions(std::uint32_t f) {
    Face& face = faces_[f];
    const Vec3d a = position(3 * f), b = position(3 * f + 1), c = position(3 * f + 2);
    face.sound = !(a == b || b == c || c == a);
    const Vec3d e = b - a, g = c - a;
    const auto [au, av] = uv(3 * f);
    const auto [bu, bv] = uv(3 * f + 1);
    const auto [cu, cv] = uv(3 * f + 2);
    const double area = (bu - au) * (cv - av) - (bv - av) * (cu - au);
    face.forward = area > 0;
    if (!is_some(area)) return;
    const Vec3d s = e * (cv - av) - g * (bv - av), t = g * (bu - au) - e * (cu - au);
    face.any = !is_some(length(s) / std::fabs(area)) || !is_some(length(t) / std::fabs(area));
    face.s = unit_or_none(s) * (face.forward ? 1.0 : -1.0);
  }

  using Key = std::array<double, 8>;
  Key key_of(std::uint32_t corner) const {
    const Vec3d p = position(corner), n = given_normal(corner);
    const auto [u, v] = uv(corner);
    return {p.x, p.y, p.z, n.x, n.y, n.z, u, v};
  }
  static std::uint64_t hash_of(const Key& key) {
    std::uint64_t hash = 0;
    for (const double each : key) {  // 0 makes +0 of -0, which are equal
      hash = (hash ^ std::bit_cast<std::uint64_t>(each + 0)) * 0x9e3779b97f4a7c15U;
      hash ^= hash >> 32U;
    }
    return hash;
  }
  // Each point is known by the first corner that is there. Corners of one vertex are, unless it is
  // flat there.
  void weld() {
    points_.resize(mesh_.indices.size());
    const bool by_vertex = !mesh_.normals.empty();
    std::vector<std::uint32_t> of_vertex(by_vertex ? mesh_.positions.size() / 3 : 0, none);
    const std::size_t most = by_vertex ? of_vertex.size() : points_.size();
    std::vector<std::uint32_t> table(std::bit_ceil(2 * most + 2), none);
    for (std::uint32_t c = 0; c < points_.size(); ++c) {
      std::uint32_t& point = by_vertex ? of_vertex[mesh_.indices[c]] : points_[c];
      if (!by_vertex || point == none) point = first_in(table, c);
      points_[c] = point;
    }
  }
  // The first corner in the table that is the same point as this one, which is put there else.
  std::uint32_t first_in(std::vector<std::uint32_t>& table, std::uint32_t corner) const {
    const Key key = key_of(corner);
    std::size_t at = hash_of(key) & (table.size() - 1);
    while (table[at] != none && key_of(table[at]) != key) at = (at + 1) & (table.size() - 1);
    if (table[at] == none) table[at] = corner;
    return table[at];
  }

  std::vector<Edge> edges() const {
    std::vector<Edge> all;
    all.reserve(points_.size());
    for (std::uint32_t c = 0; c < points_.size(); ++c) {
      if (!faces_[c / 3].sound) continue;
      const std::uint64_t from = points_[c], to = points_[c / 3 * 3 + next(c % 3)];
      all.push_back({std::min(from, to) << 32U | std::max(from, to), c, to < from});
    }
    std::sort(all.begin(), all.end(), [](const Edge& a, const Edge& b) {
      return a.ends != b.ends ? a.ends < b.ends : a.corner < b.corner;
    });
    return all;
  }
  // Pairs that run opposite ways, the first with the first.
  void link_edges() {
    const std::vector<Edge> all = edges();
    for (std::size_t first = 0, end = 0; first < all.size(); first = end) {
      while (end < all.size() && all[end].ends == all[first].ends) ++end;
      std::size_t a = first, b = first;
      while (true) {
        while (a < end && all[a].turned) ++a;
        while (b < end && !all[b].turned) ++b;
        if (a == end || b == end) break;
        link(all[a++].corner, all[b++].corner);
      }
    }
  }
  void link(std::uint32_t a, std::uint32_t b) {
    faces_[a / 3].neighbors[a % 3] = b / 3;
    faces_[b / 3].neighbors[b % 3] = a / 3;
  }

  void add_group(std::uint32_t f, std::uint32_t i) {
    const std::uint32_t point = points_[3 * f + i];
    const auto number = static_cast<std::uint32_t>(groups_.size());
    Group group{{}, faces_[f].forward};
    left_.assign(1, f);
    while (!left_.empty()) {
      const std::uint32_t at = left_.back();
      left_.pop_back();
      const std::uint32_t k = corner_at(at, point);
      if (!joins(faces_[at], k, group.forward)) continue;
      faces_[at].groups[k] = number;
      if (!faces_[at].any) group.sum = group.sum + share(at, k);
      for (const std::uint32_t beyond : {before(k), k})  // the latter is gone to first
        if (faces_[at].neighbors[beyond] != none) left_.push_back(faces_[at].neighbors[beyond]);
    }
    group.sum = unit_or_none(group.sum);
    groups_.push_back(group);
  }
  std::uint32_t corner_at(std::uint32_t f, std::uint32_t point) const {
    return points_[3 * f] == point ? 0 : points_[3 * f + 1] == point ? 1 : 2;
  }
  // The first group that a face without directions joins tells which way round it is.
  static bool joins(Face& face, std::uint32_t i, bool forward) {
    if (face.groups[i] != none) return false;
    const bool is_new = std::ranges::count(face.groups, none) == 3;
    if (face.any && is_new) face.forward = forward;
    return face.forward == forward;
  }
  // What a face adds: its direction, weighted by the angle at the corner.
  Vec3d share(std::uint32_t f, std::uint32_t i) const {
    const std::uint32_t corner = 3 * f + i;
    const Vec3d n = normal(corner), p = position(corner);
    const Vec3d a = in_plane(position(3 * f + before(i)) - p, n);
    const Vec3d b = in_plane(position(3 * f + next(i)) - p, n);
    return in_plane(faces_[f].s, n) * acos_of(std::clamp(dot(a, b), -1.0, 1.0));
  }

  // Faces whose corners are not three take the tangents of others there.
  void adopt() {
    std::vector<std::uint32_t> first(points_.size(), none);
    for (std::uint32_t c = 0; c < points_.size(); ++c)
      if (faces_[c / 3].sound && first[points_[c]] == none)
        first[points_[c]] = faces_[c / 3].groups[c % 3];
    for (std::uint32_t c = 0; c < points_.size(); ++c)
      if (!faces_[c / 3].sound) faces_[c / 3].groups[c % 3] = first[points_[c]];
  }

  const TangentSource mesh_;
  std::vector<Face> faces_;
  std::vector<std::uint32_t> points_;  // of each corner
  std::vector<Group> groups_;
  std::vector<std::uint32_t> left_;  // faces that add_group() has still to look at
};

}  // namespace

TangentVertices tangents_of(const TangentSource& mesh) { return TangentMaking(mesh).vertices(); }

}  // namespace tia
