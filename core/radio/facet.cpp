#include "core/radio/facet.h"

#include <algorithm>

#include "core/math/onb.h"

namespace tia {
namespace {

// A point of the plane by two coordinates in it.
struct Flat2 {
  double u, v;
  Vec3d p;
};
double turn_of(const Flat2& a, const Flat2& b, const Flat2& c) {
  return (b.u - a.u) * (c.v - a.v) - (b.v - a.v) * (c.u - a.u);
}

// Appends the chain below the points, which are sorted, without its last point.
template <class Points>
void add_chain(const Points& points, std::vector<Flat2>& out) {
  const std::size_t bottom = out.size();
  for (const Flat2& p : points) {
    while (out.size() >= bottom + 2 && turn_of(out[out.size() - 2], out.back(), p) <= 0)
      out.pop_back();
    out.push_back(p);
  }
  out.pop_back();
}

}  // namespace

FacetPiece piece_of(const FlatFace& face, const std::vector<Vec3d>& corners) {
  FacetPiece piece;
  piece.sides = corners.size();
  Vec3d middle{};
  for (const Vec3d& p : corners) middle = middle + p * (1.0 / static_cast<double>(corners.size()));
  for (std::size_t i = 0; i < piece.sides; ++i) {
    const Vec3d& a = piece.corners[i] = corners[i];
    Vec3d inward = unit(cross(face.normal, corners[(i + 1) % piece.sides] - a));
    if (dot(inward, middle - a) < 0) inward = -inward;
    piece.inward[i] = inward;
    piece.from[i] = dot(inward, a);
  }
  return piece;
}

std::vector<Vec3d> hull_of(const FlatFace& face, const std::vector<Vec3d>& points) {
  const Onb basis = onb_around(face.normal);
  std::vector<Flat2> sorted, chain;
  for (const Vec3d& p : points) sorted.push_back({dot(basis.u, p), dot(basis.v, p), p});
  std::sort(sorted.begin(), sorted.end(),
            [](const Flat2& a, const Flat2& b) { return a.u < b.u || (a.u == b.u && a.v < b.v); });
  add_chain(sorted, chain);
  std::reverse(sorted.begin(), sorted.end());
  add_chain(sorted, chain);
  std::vector<Vec3d> hull;
  for (const Flat2& each : chain) hull.push_back(each.p);
  return hull;
}

}  // namespace tia
