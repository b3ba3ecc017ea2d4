#include "core/radio/body_edges.h"

#include <array>
#include <cmath>
#include <map>

#include "core/math/onb.h"

namespace tia {
namespace {

using CornerKey = std::array<std::int64_t, 3>;

// A side of a piece, by its body and its ends.
struct SideKey {
  int body;
  CornerKey low, high;
  auto operator<=>(const SideKey&) const = default;
};
struct PieceSide {
  const FacetPiece* piece;
  std::size_t side;
  const Vec3d& start() const { return piece->corners[side]; }
  const Vec3d& end() const { return piece->corners[(side + 1) % piece->sides]; }
};

CornerKey key_of(const Vec3d& p, double step) {
  // Off the middle between two numbers, on which round coordinates would fall.
  const auto of = [&](double x) { return std::llround(x / step + 0.2371); };
  return {of(p.x), of(p.y), of(p.z)};
}

RadioEdge edge_of(const PieceSide& side, const Facet& facet) {
  RadioEdge edge;
  edge.normal = facet.face.normal;
  edge.into = side.piece->inward[side.side];
  edge.along = cross(edge.into, edge.normal);
  edge.size = length(side.end() - side.start());
  edge.from = dot(side.end() - side.start(), edge.along) > 0 ? side.start() : side.end();
  edge.body = facet.body;
  return edge;
}

}  // namespace

std::vector<RadioEdge> edges_of(const RadioBodies& all, double slack) {
  std::map<SideKey, std::vector<PieceSide>> sides;
  for (const FacetPiece& piece : all.pieces)
    for (std::size_t i = 0; i < piece.sides; ++i) {
      const PieceSide side{&piece, i};
      const auto a = key_of(side.start(), 10 * slack), b = key_of(side.end(), 10 * slack);
      sides[{all.facets[piece.facet].body, std::min(a, b), std::max(a, b)}].push_back(side);
    }
  std::vector<RadioEdge> edges;
  std::map<int, int> count;
  for (const auto& [key, found] : sides) {
    const Facet& facet = all.facets[found[0].piece->facet];
    RadioEdge edge = edge_of(found[0], facet);
    if (found.size() == 1 && !facet.closed) {
      edge.n = 2;
    } else if (found.size() == 2 && facet.closed &&
               found[0].piece->facet != found[1].piece->facet) {
      const Vec3d& other = found[1].piece->inward[found[1].side];
      edge.n = edge.angle_of(other) / pi;
      if (edge.n <= 1 + 1e-6) continue;  // an inner edge, or none
    } else {
      continue;
    }
    edge.element = count[edge.body]++;
    edges.push_back(edge);
  }
  return edges;
}

}  // namespace tia
