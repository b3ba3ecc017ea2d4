#include "core/radio/facet_builder.h"

#include "core/math/onb.h"
#include "core/radio/mesh_facets.h"

namespace tia {
namespace {

std::vector<Vec3d> corners_of(const Mesh& mesh, const Affine& place) {
  const auto& p = mesh.positions.values.get();
  std::vector<Vec3d> corners;
  for (const std::uint32_t i : mesh.indices.values.get()) {
    const std::size_t at = std::size_t{i} * 3;
    corners.push_back(place.point(Vec3d{p[at], p[at + 1], p[at + 2]}));
  }
  return corners;
}

FlatFace face_through(const Vec3d& p, const Vec3d& normal) { return {normal, dot(normal, p)}; }

}  // namespace

bool is_closed(const Shape& shape) {
  if (const auto* mesh = std::get_if<Mesh>(&shape)) return welded(corners_of(*mesh, {})).closed();
  return std::visit(
      []<class Kind>(const Kind&) {
        // Surfaces of formulas are cut open by their bounds.
        if constexpr (IsSurface<Kind>) return FormOf<Kind>::solid && !HasSpans<FormOf<Kind>>;
        else return IsComposite<Kind>;
      },
      shape);
}

bool FacetBuilder::add(const Shape& shape, const Affine& place, int body, bool closed) {
  body_ = body;
  closed_ = closed;
  return std::visit([&](const auto& kind) { return this->add_kind(kind, place); }, shape);
}

void FacetBuilder::put(const FlatFace& face, int element, const std::vector<Polygon>& polygons) {
  const auto number = static_cast<std::uint32_t>(into_.facets.size());
  if (number == RadioBodies::most_facets)
    throw InputError({FaultKind::limit, "/scene", std::nullopt,
                      "flat faces of at most " + std::to_string(RadioBodies::most_facets)});
  Facet facet{face, body_, element, closed_, polygons.empty()};
  facet.first_piece = static_cast<std::uint32_t>(into_.pieces.size());
  facet.pieces = static_cast<std::uint32_t>(polygons.size());
  Polygon all;
  for (const Polygon& each : polygons) {
    into_.pieces.push_back(piece_of(face, each));
    into_.pieces.back().facet = number;
    all.insert(all.end(), each.begin(), each.end());
  }
  if (!all.empty()) facet.hull = hull_of(face, all);
  into_.facets.push_back(std::move(facet));
}

bool FacetBuilder::add_kind(const Plane& plane, const Affine& place) {
  put(face_through(place.point(plane.point), unit(place.inverse().row(plane.normal))), 0, {});
  return true;
}

bool FacetBuilder::add_kind(const Box& box, const Affine& place) {
  const Vec3d size = box.max - box.min;
  if (size.x == 0 || size.y == 0 || size.z == 0) return false;
  const std::array edges{place.vector(Vec3d{size.x, 0, 0}), place.vector(Vec3d{0, size.y, 0}),
                         place.vector(Vec3d{0, 0, size.z})};
  const Vec3d low = place.point(box.min);
  for (std::size_t k = 0; k < 3; ++k) {
    const Vec3d &u = edges[(k + 1) % 3], &v = edges[(k + 2) % 3];
    Vec3d up = unit(cross(u, v));
    if (dot(up, edges[k]) < 0) up = -up;
    for (const int side : {0, 1}) {
      const Vec3d p = side == 0 ? low : low + edges[k];
      put(face_through(p, side == 0 ? -up : up), 2 * static_cast<int>(k) + side,
          {{p, p + u, p + u + v, p + v}});
    }
  }
  return true;
}

bool FacetBuilder::add_kind(const Triangle& t, const Affine& place) {
  const Vec3d a = place.point(t.a), b = place.point(t.b), c = place.point(t.c);
  put(face_through(a, unit(cross(b - a, c - a))), 0, {{a, b, c}});
  return true;
}

bool FacetBuilder::add_kind(const Mesh& mesh, const Affine& place) {
  const WeldedMesh sides = welded(corners_of(mesh, place));
  const bool turned = closed_ && sides.volume() < 0;
  for (const std::vector<std::size_t>& group : sides.coplanar()) {
    const WeldedMesh::Side& first = sides.sides[group.front()];
    std::vector<Polygon> polygons;
    for (const std::size_t i : group) {
      const auto& [a, b, c] = sides.sides[i].corners;
      polygons.push_back({sides.points[a], sides.points[b], sides.points[c]});
    }
    put(face_through(sides.points[first.corners[0]], turned ? -first.normal : first.normal),
        first.element, polygons);
  }
  return true;
}

}  // namespace tia
