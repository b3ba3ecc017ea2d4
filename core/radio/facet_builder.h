// FacetBuilder: objects' shapes to facets.
#pragma once

#include "core/radio/radio_body.h"
#include "core/scene/object.h"

namespace tia {

/// FacetBuilder: appends the facets of shapes, each of one body.
class FacetBuilder {
 public:
  explicit FacetBuilder(RadioBodies& into) : into_(into) {}

  /// Returns: whether it is made of facets. Errors: InputError (limit).
  bool add(const Shape& shape, const Affine& place, int body, bool closed);

 private:
  bool add_kind(const Plane& plane, const Affine& place);
  bool add_kind(const Box& box, const Affine& place);
  bool add_kind(const Triangle& triangle, const Affine& place);
  bool add_kind(const Mesh& mesh, const Affine& place);
  template <class Other>
  bool add_kind(const Other&, const Affine&) {
    return false;
  }
  using Polygon = std::vector<Vec3d>;
  // Coplanar polygons, which become one facet.
  void put(const FlatFace& face, int element, const std::vector<Polygon>& polygons);

  RadioBodies& into_;
  int body_ = 0;
  bool closed_ = true;
};

/// Whether a shape has an inside: a solid, a half space, a mesh whose edges all have two sides.
bool is_closed(const Shape& shape);

}  // namespace tia
