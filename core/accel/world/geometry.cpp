#include "core/accel/world/geometry.h"

#include <algorithm>
#include <bit>
#include <set>

#include "core/math/heap.h"

namespace tia {

Affine Geometry::to_space(int space, std::int64_t instance) const {
  const int repeated_by = spaces[static_cast<std::size_t>(space)].grid;
  if (repeated_by < 0) return {};
  const InstanceGrid& grid = grids[static_cast<std::size_t>(repeated_by)];
  const std::int64_t all = grid.repeat.copies();
  const Affine to_copy = Affine::translation(-grid.offset(instance % all));
  return to_copy * grid.to_group * to_space(grid.outside, instance / all);
}

void BallIndex::pack(const HugeVector<Ball>& all, const Workers& workers) {
  packed = {bvh, workers, [&](std::uint32_t i) -> std::array<double, 5> {
              const auto& [center, radius] = all[i].sphere;
              const BallNumber ball{all[i].primitive, all[i].instance};
              return {center.x, center.y, center.z, radius * radius, std::bit_cast<double>(ball)};
            }};
}

std::vector<std::array<int, 3>> instances_around(const Geometry& geometry, int space,
                                                 std::int64_t instance) {
  std::vector<std::array<int, 3>> inwards;
  while (geometry.space(space).grid >= 0) {
    const InstanceGrid& grid = geometry.grids[static_cast<std::size_t>(geometry.space(space).grid)];
    const std::int64_t all = grid.repeat.copies();
    inwards.push_back(grid.place(instance % all));
    instance /= all;
    space = grid.outside;
  }
  std::ranges::reverse(inwards);
  return inwards;
}

Affine to_object(const Geometry& geometry, const Primitive& primitive, std::int64_t instance) {
  return primitive.space == 0 ? primitive.to_object
                              : primitive.to_object * geometry.to_space(primitive.space, instance);
}

SharedMesh indexed(const Mesh& mesh, const Workers& workers) {
  return std::make_shared<const MeshIndex>(mesh, workers);
}

// ---- how much memory it holds ---------------------------------------------------------------

namespace {

using tia::heap_bytes;

template <class... T>
std::size_t heap_bytes(const std::variant<T...>& value) {
  return std::visit([](const auto& is) { return heap_bytes(is); }, value);
}
// The primitives of one object's numbered materials share its form, which counts once.
std::size_t heap_bytes(const Primitive& primitive) {
  return primitive.numbers < 0 ? 0 : heap_bytes(primitive.form);
}
std::size_t heap_bytes(const TextureForm& texture) { return heap_bytes(texture.kind); }
std::size_t heap_bytes(const Solid& solid) { return heap_bytes(solid.steps); }
std::size_t heap_bytes(const Space& space) {
  const BallIndex& balls = space.balls;
  return heap_bytes(space.items) + heap_bytes(space.boxes) + heap_bytes(space.bvh) +
         heap_bytes(space.rest) + heap_bytes(balls.balls) + heap_bytes(balls.bvh) +
         balls.packed.bytes();
}
// The bytes of a list and of what its elements own.
template <class T, class Allocator>
std::size_t deep_heap_of(const std::vector<T, Allocator>& list) {
  std::size_t bytes = heap_bytes(list);
  for (const T& each : list) bytes += heap_bytes(each);
  return bytes;
}

// The pictures of materials' maps, which several may share, each once.
std::size_t picture_bytes(const std::vector<PrincipledForm>& forms) {
  std::set<const MipPyramid*> all;
  for (const PrincipledForm& form : forms) {
    if (!form.maps) continue;
    for (const MapUse& use : form.maps->uses) all.insert(use.map.pyramid.get());
    for (const auto* map : {&form.maps->normal, &form.maps->coat_normal})
      if (*map) all.insert((*map)->pyramid.get());
  }
  std::size_t bytes = 0;
  for (const MipPyramid* each : all) bytes += heap_bytes(*each);
  return bytes;
}

}  // namespace

std::size_t bytes_of(const Geometry& g) {
  return sizeof(Geometry) + deep_heap_of(g.spaces) + deep_heap_of(g.primitives) +
         heap_bytes(g.balls) + heap_bytes(g.flats) + heap_bytes(g.meshes) + deep_heap_of(g.solids) +
         heap_bytes(g.grids) + heap_bytes(g.shadings) + deep_heap_of(g.textures) +
         deep_heap_of(g.forms) + picture_bytes(g.forms) + heap_bytes(g.lights) +
         heap_bytes(g.areas) + heap_bytes(g.unasked.first);
}

std::size_t heap_of_form(const Form& form) { return heap_bytes(form); }

std::size_t bytes_of(const MeshIndex& mesh) {
  return sizeof(MeshIndex) + heap_bytes(mesh.positions) + heap_bytes(mesh.normals) +
         heap_bytes(mesh.uvs) + heap_bytes(mesh.more_uvs) + heap_bytes(mesh.colors) +
         heap_bytes(mesh.tangents) + heap_bytes(mesh.triangles) + heap_bytes(mesh.planes) +
         heap_bytes(mesh.bvh) + mesh.packed.bytes();
}

}  // namespace tia
