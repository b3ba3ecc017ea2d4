// GeometryBuilder: adds surfaces, solids and grids to the spaces of a geometry and builds the
// trees. Scenes are translated to its calls by build_geometry.cpp and compile.cpp.
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "core/accel/world/geometry.h"

namespace tia {

/// Setting: transform, shading and space of a surface in a geometry.
struct Setting {
  Affine place{};  ///< from its own space to the space that contains it
  int shading = 0;
  int space = 0;
  bool inverted = false;  ///< whether it is subtracted from a solid
  bool culls = true;      ///< as Primitive's
};

/// Appends a value to a list. Returns: its index.
template <class List, class T>
int pushed(List& list, T&& value) {
  list.push_back(std::forward<T>(value));
  return static_cast<int>(list.size()) - 1;
}

class GeometryBuilder {
 public:
  /// Domain: a geometry without spaces; it and the workers outlive the builder.
  /// Errors, of all functions: Stopped once that is asked for.
  GeometryBuilder(Geometry& geometry, const Workers& workers)
      : geometry_(geometry), workers_(workers) {
    geometry_.spaces.emplace_back();
  }

  /// Adds an object that is one surface. Returns: its primitive's number.
  int add(Form form, const Setting& at);
  int add(SharedMesh mesh, const Setting& at);
  /// Adds a surface of a solid: rays are tried on the solid, never on the surface by itself.
  int add_primitive(Form form, const Setting& at, int object);
  /// Adds one more primitive for each numbered material of the primitive that was added last.
  void add_numbered(const std::vector<int>& shadings);
  /// Domain: the solid's primitives have been added. Space/units: the box is in that space.
  void add(Solid solid, const Aabb& box, int space);
  /// Begins a grid: what is added to its inside until end_grid is repeated. Space/units: the box of
  /// one instance is in the grid's own space. Returns: the grid's index in the geometry.
  int begin_grid(const Repeat& repeat, const Aabb& box, const Setting& at);
  void end_grid(int grid, const Setting& at);
  /// Moves the origin of each space near the things in it (own_origin.h).
  /// Domain: after all that is added, before finish.
  void settle();
  /// Builds the trees.
  void finish();
  /// The boxes of the world's items.
  const std::vector<Aabb>& boxes() { return boxes_[0]; }

 private:
  void put(Item item, const Aabb& box, int space);
  void put(const PlaneForm& plane, int primitive, const Setting& at);
  void put(const Sphere& sphere, int primitive, const Setting& at);
  void put(const Ball& ball, int space);
  void put_balls(int grid, const Affine& place, double scale);
  void put_instances(int grid, const Affine& place, int space);
  bool takes(std::int64_t copies);
  void index(BallIndex& index) const;
  void index(Space& space, const std::vector<Aabb>& boxes) const;

  static constexpr std::size_t most_forms_bytes = std::size_t{256} << 20;

  Geometry& geometry_;
  const Workers& workers_;
  std::size_t forms_bytes_ = 0;
  std::int64_t copies_ = 0;                 // of what is in small grids, one by one in trees
  std::map<int, std::vector<Aabb>> boxes_;  // one an item, space by space
};

/// PlacedObjects: a scene's objects in its own coordinates, without an index. `boxes` are those of
/// the world's items.
struct PlacedObjects {
  Geometry geometry;
  std::vector<Aabb> boxes;
};
/// Domain, errors: as geometry_of.
PlacedObjects placed_objects(const Scene& scene, const Workers& workers);

}  // namespace tia
