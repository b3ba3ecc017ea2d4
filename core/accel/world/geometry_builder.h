// GeometryBuilder: puts surfaces, solids and grids into the spaces of a geometry, and indexes them
// there. Of scenes it knows nothing (build_geometry.cpp, compile.cpp).
#pragma once

#include <map>
#include <utility>
#include <vector>

#include "core/accel/world/geometry.h"

namespace tia {

/// Setting: how a surface stands in a geometry.
struct Setting {
  Affine place{};  ///< from its own space to the geometry's space where it stands
  int shading = 0;
  int space = 0;
  bool inverted = false;  ///< whether it is cut out of a solid
};

/// Puts a value at the end of a list. Returns: its number there.
template <class List, class T>
int pushed(List& list, T&& value) {
  list.push_back(std::forward<T>(value));
  return static_cast<int>(list.size()) - 1;
}

class GeometryBuilder {
 public:
  /// Domain: a geometry without spaces; it and the workers outlive the builder. Stopped is what
  /// all functions throw once that is asked for.
  GeometryBuilder(Geometry& geometry, const Workers& workers)
      : geometry_(geometry), workers_(workers) {
    geometry_.spaces.emplace_back();
  }

  /// An object that is one surface. Returns: its primitive.
  int add(Form form, const Setting& at);
  int add(SharedMesh mesh, const Setting& at);
  /// A surface that belongs to an object, and that nothing meets but the object's solid.
  int add_primitive(Form form, const Setting& at, int object);
  /// Gives the last primitive that was added one more for each of its numbered materials.
  void add_numbered(const std::vector<int>& shadings);
  /// Its primitives are there already. Space/units: the box is in that space.
  void add(Solid solid, const Aabb& box, int space);
  /// A grid, whose inside takes what comes until it ends. Space/units: the box of one instance is
  /// in the grid's own space. Returns: which of the geometry's instances it is.
  int begin_grid(const Repeat& repeat, const Aabb& box, const Setting& at);
  void end_grid(int grid, const Setting& at);
  /// Moves the origin of each space amid what stands there (own_origin.h).
  /// Domain: before finish; after that nothing is added.
  void settle();
  /// Indexes all that is there.
  void finish();

 private:
  void put(Item item, const Aabb& box, int space);
  void put(const PlaneForm& plane, int primitive, const Setting& at);
  void put(const Sphere& sphere, int primitive, const Setting& at);
  void put(const Ball& ball, int space);
  void put_balls(int grid, const Affine& place, double scale);
  bool is_small(const InstanceGrid& grid) const;
  void index(BallIndex& index) const;
  void index(Space& space, const std::vector<Aabb>& boxes) const;

  static constexpr std::size_t most_forms_bytes = std::size_t{256} << 20;

  Geometry& geometry_;
  const Workers& workers_;
  std::size_t forms_bytes_ = 0;
  std::int64_t copied_balls_ = 0;           // of small grids
  std::map<int, std::vector<Aabb>> boxes_;  // one an item, space by space
};

}  // namespace tia
