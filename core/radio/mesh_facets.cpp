#include "core/radio/mesh_facets.h"

#include <algorithm>
#include <map>
#include <numeric>
#include <tuple>

#include "core/math/onb.h"

namespace tia {
namespace {

using Edge = std::array<std::uint32_t, 2>;

// Calls visit(edge, side) for the directed edges of each triangle.
template <class Visit>
void for_each_edge(const WeldedMesh& mesh, Visit visit) {
  for (std::size_t i = 0; i < mesh.sides.size(); ++i)
    for (std::size_t k = 0; k < 3; ++k)
      visit(Edge{mesh.sides[i].corners[k], mesh.sides[i].corners[(k + 1) % 3]}, i);
}

struct Groups {
  std::vector<std::size_t> first;

  explicit Groups(std::size_t count) : first(count) {
    std::iota(first.begin(), first.end(), std::size_t{0});
  }
  std::size_t of(std::size_t i) {
    while (first[i] != i) i = first[i] = first[first[i]];
    return i;
  }
  void join(std::size_t a, std::size_t b) {
    a = of(a), b = of(b);
    first[std::max(a, b)] = std::min(a, b);
  }
};

}  // namespace

WeldedMesh welded(const std::vector<Vec3d>& corners) {
  WeldedMesh mesh;
  std::map<std::tuple<double, double, double>, std::uint32_t> known;
  const auto number_of = [&](const Vec3d& p) {
    const auto next = static_cast<std::uint32_t>(mesh.points.size());
    const auto [at, is_new] = known.try_emplace({p.x, p.y, p.z}, next);
    if (is_new) mesh.points.push_back(p);
    return at->second;
  };
  for (std::size_t i = 0; i + 2 < corners.size(); i += 3) {
    const Vec3d area = cross(corners[i + 1] - corners[i], corners[i + 2] - corners[i]);
    if (!(dot(area, area) > 0)) continue;
    mesh.sides.push_back(
        {{number_of(corners[i]), number_of(corners[i + 1]), number_of(corners[i + 2])},
         static_cast<int>(i / 3),
         unit(area)});
  }
  return mesh;
}

bool WeldedMesh::closed() const {
  std::map<Edge, int> seen;
  for_each_edge(*this, [&](const Edge& edge, std::size_t) { ++seen[edge]; });
  return !seen.empty() && std::all_of(seen.begin(), seen.end(), [&](const auto& each) {
    const auto back = seen.find({each.first[1], each.first[0]});
    return each.second == 1 && back != seen.end();
  });
}

double WeldedMesh::volume() const {
  double sum = 0;
  const Vec3d& o = points.front();
  for (const Side& each : sides) {
    const auto& [a, b, c] = each.corners;
    sum += dot(points[a] - o, cross(points[b] - o, points[c] - o));
  }
  return sum;
}

std::vector<std::vector<std::size_t>> WeldedMesh::coplanar() const {
  constexpr double slack = 1e-9;
  Groups groups(sides.size());
  std::map<Edge, std::size_t> known;
  for_each_edge(*this, [&](const Edge& edge, std::size_t i) {
    const auto [low, high] = std::minmax(edge[0], edge[1]);
    const auto [at, is_new] = known.try_emplace({low, high}, i);
    if (is_new) return;
    const Vec3d &n = sides[i].normal, &m = sides[at->second].normal;
    const Vec3d off = n - m;
    if (dot(off, off) <= slack * slack) groups.join(i, at->second);
  });
  std::map<std::size_t, std::vector<std::size_t>> found;
  for (std::size_t i = 0; i < sides.size(); ++i) found[groups.of(i)].push_back(i);
  std::vector<std::vector<std::size_t>> all;
  for (auto& [first, members] : found) all.push_back(std::move(members));
  return all;
}

}  // namespace tia
