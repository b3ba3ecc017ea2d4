// Geometry: all that rays can hit, with its indices, and what shading needs of it. It is a tree of
// spaces: the world, and the inside of each repeated group, which is stored once however often it
// is repeated. Each space has its origin near the things in it (own_origin.h). Lights, camera and
// options belong to the World.
#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "core/accel/mesh/mesh_index.h"
#include "core/accel/world/instance_grid.h"
#include "core/accel/world/path_lights.h"
#include "core/accel/world/primitive.h"
#include "core/accel/world/solid.h"
#include "core/boxes/bvh.h"
#include "core/materials/shading_parameters.h"
#include "core/scene/scene.h"

namespace tia {

/// Ball: a sphere in the form in which whole packets are tried on it. It is in the space of its
/// primitive; the instances of a small grid are balls in the space that contains the grid.
struct Ball {
  Sphere sphere;
  int primitive = 0;
  int grid =
      -1;  ///< the geometry's grid of which it is an instance, -1 inside of one and where none is
  int instance = 0;  ///< which one
};

/// Flat: a plane in the form in which whole packets are tried on it, in the space of its primitive.
struct Flat {
  PlaneForm plane;
  int primitive = 0;
};

/// BallNumber: which primitive a ball is, and which instance.
struct BallNumber {
  int primitive, instance;
};

/// BallIndex: a tree over balls, and their numbers packed in the order of its leaves.
struct BallIndex {
  std::vector<std::uint32_t> balls;  ///< of the geometry's
  Bvh bvh;                           ///< over them
  PackedLeaves<double, 5> packed;    ///< centre, radius^2, the bits of a BallNumber

  /// Whether they are so few that every ray is tried on all of them, without a tree.
  bool few() const { return bvh.nodes.empty(); }
  /// Packs the balls as the leaves of `bvh` list them.
  void pack(const HugeVector<Ball>& all, const Workers& workers = {});
};

/// Item: a thing in a space other than a ball: what the leaves of the space's tree refer to.
struct Item {
  enum Kind { flat, primitive, mesh, solid, grid, instance };
  Kind kind = primitive;
  int index = 0;   ///< into the geometry's list of that kind; of a mesh: its primitive; of an
                   ///< instance: its grid
  int number = 0;  ///< of an instance: which one of its grid
};

/// Space: a part of the geometry with a tree of its own: the world, or the inside of a repeated
/// group, which is stored once for all instances. All things in it are in its own coordinates, into
/// which a ray is transformed for each instance that it reaches (instance_grid.h). Balls have a
/// tree of their own, because they are tried four at a time and scenes have many of them. Every
/// other thing is an item; items without bounds are in `rest` instead of the tree. Space/units: of
/// the world world space, of a group its own.
struct Space {
  BallIndex balls;
  std::vector<Item> items;
  std::vector<Box32> boxes;         ///< one an item
  Bvh bvh;                          ///< over the items that have bounds
  std::vector<std::uint32_t> rest;  ///< the items that have none
  int grid = -1;                    ///< what repeats it; -1: the world itself
};

/// Meshes are shared: a mesh keeps its index when the object that has it is moved.
using SharedMesh = std::shared_ptr<const MeshIndex>;

/// Unasked: luminous objects none of whose areas a path can ask for light, by their numbers: it
/// meets their light by chance alone.
struct Unasked {
  static constexpr std::size_t most_told = 20;
  std::size_t count = 0;
  std::vector<int> first{};  ///< as many as are told
};

struct Geometry {
  std::vector<Space> spaces;         ///< the first is the world itself
  HugeVector<Primitive> primitives;  ///< in the scene's order
  HugeVector<Ball> balls;
  std::vector<Flat> flats;
  std::vector<SharedMesh> meshes;
  std::vector<Solid> solids;
  std::vector<InstanceGrid> grids;
  std::vector<ShadingParameters> shadings;
  std::vector<TextureForm> textures;
  std::vector<PrincipledForm> forms;  ///< of materials whose numbers are textured
  std::vector<WorldLight> lights;     ///< of its luminous balls
  std::vector<PathLight> areas;       ///< of its luminous objects
  Unasked unasked;                    ///< of its luminous objects
  Vec3d origin{};                     ///< the world's, in the scene's coordinates
  int first_primitive = 0;            ///< the number of its first primitive, which is the world's
  int objects = 0;                    ///< how many, those of the primitives before it included
  bool passable = false;              ///< whether rays may go straight through some of it (Sight)
  bool see_through = false;           ///< whether shadow rays may, too, which back faces stop
  std::size_t degenerate = 0;         ///< triangles without area, which nothing meets

  /// Domain: one of its own, by the number that the world has for it.
  const Primitive& primitive(int i) const {
    return primitives[static_cast<std::size_t>(i - first_primitive)];
  }
  const ShadingParameters& shading_of(int i) const {
    return shadings[static_cast<std::size_t>(primitive(i).shading)];
  }
  Space& space(int i) { return spaces[static_cast<std::size_t>(i)]; }
  const Space& space(int i) const { return spaces[static_cast<std::size_t>(i)]; }
  /// From the world to that instance of a space.
  Affine to_space(int space, std::int64_t instance) const;
};

/// Geometries are shared between worlds and threads. They are constant, so reading takes no lock.
using SharedGeometry = std::shared_ptr<const Geometry>;

/// MeshSource: returns the index of a mesh, newly made or from a store. Errors: Stopped.
using MeshSource = std::function<SharedMesh(const Mesh&, const Workers&)>;
/// The MeshSource that makes every index anew.
SharedMesh indexed(const Mesh& mesh, const Workers& workers);

/// The geometry of a scene's objects. It depends on objects, materials and ambient light, and on
/// nothing else of the scene. Domain: a scene that read_scene has passed.
/// Errors: Stopped once that is asked for.
Geometry geometry_of(const Scene& scene, const Workers& workers = {},
                     const MeshSource& mesh = indexed);

/// Space/units: bytes, its own and all that it owns on the heap, its meshes left out: those are
/// shared. Pictures of textures, which the scene shares, count in full.
std::size_t bytes_of(const Geometry& geometry);
std::size_t bytes_of(const MeshIndex& mesh);
/// What a form owns on the heap.
std::size_t heap_of_form(const Form& form);

/// The instances of repeated groups that an instance of a space is in, the outermost first: which
/// one along x, y and z. Empty: the space is the world itself.
std::vector<std::array<int, 3>> instances_around(const Geometry& geometry, int space,
                                                 std::int64_t instance);

/// From the world's space to a primitive's own, by way of the instance of its group.
Affine to_object(const Geometry& geometry, const Primitive& primitive, std::int64_t instance);

}  // namespace tia
