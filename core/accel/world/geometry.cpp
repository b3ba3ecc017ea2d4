#include "core/accel/world/geometry.h"

#include <type_traits>

namespace tia {

Affine Geometry::to_space(int space, std::int64_t copy) const {
  const int repeated_by = spaces[static_cast<std::size_t>(space)].copies;
  if (repeated_by < 0) return {};
  const Copies& grid = copies[static_cast<std::size_t>(repeated_by)];
  const std::int64_t all = grid.repeat.copies();
  const Affine to_copy = Affine::translation(-grid.offset(copy % all));
  return to_copy * grid.to_group * to_space(grid.outside, copy / all);
}

void BallIndex::pack(const std::vector<Ball>& all, const Workers& workers) {
  packed = {bvh, workers, [&](std::uint32_t i) -> std::array<double, 4> {
              const auto& [center, radius] = all[i].sphere;
              return {center.x, center.y, center.z, radius * radius};
            }};
}

Affine to_object(const Geometry& geometry, const Part& part, std::int64_t copy) {
  return part.space == 0 ? part.to_object : part.to_object * geometry.to_space(part.space, copy);
}

SharedMesh indexed(const Mesh& mesh, const Workers& workers) {
  return std::make_shared<const MeshIndex>(mesh, workers);
}

// ---- how much memory it holds ---------------------------------------------------------------

namespace {

constexpr std::size_t block = 16;  // what the allocator adds to each piece

template <class T>
concept Plain = std::is_trivially_copyable_v<T>;
template <class T>
concept Ramped = requires(const T& form) {
  form.ramp;
};

template <class T>
std::size_t heap_of(const std::vector<T>& list) {
  return list.capacity() > 0 ? block + list.capacity() * sizeof(T) : 0;
}
template <class T>
std::size_t heap_of(const std::vector<T, HugePages<T>>& list) {
  return list.capacity() > 0 ? block + HugePages<T>::bytes_for(list.capacity()) : 0;
}
std::size_t heap_of(const ImageForm& form) {
  return form.pixels ? 2 * block + sizeof(Image8) + heap_of(form.pixels->rgb) : 0;
}
std::size_t heap_of(const FieldForm& form) {
  return heap_of(form.field.instructions) + heap_of(form.field.results) + 2 * block +
         sizeof(FieldCells) + heap_of(form.cells->tree.nodes) + heap_of(form.cells->cells);
}
std::size_t heap_of(const AlgebraicForm& form) { return form.polynomial.heap(); }
std::size_t heap_of(const ParametricForm& form) {
  return heap_of(form.surface.instructions) + heap_of(form.surface.results) + 2 * block +
         sizeof(SurfacePatches) + heap_of(form.patches->tree.nodes) +
         heap_of(form.patches->patches);
}
std::size_t heap_of(const VoxelsForm& form) {
  return form.grid ? 2 * block + sizeof(VoxelGrid) + heap_of(form.grid->cells) : 0;
}
template <Ramped T>
std::size_t heap_of(const T& form) {
  return heap_of(form.ramp.stops);
}
template <Plain T>
std::size_t heap_of(const T&) {
  return 0;
}
template <class... T>
std::size_t heap_of(const std::variant<T...>& value) {
  return std::visit([](const auto& is) { return heap_of(is); }, value);
}
std::size_t heap_of(const Bvh& bvh) { return heap_of(bvh.nodes) + heap_of(bvh.order); }
// Those of one object share their form.
std::size_t heap_of(const Part& part) { return part.numbers < 0 ? 0 : heap_of(part.form); }
std::size_t heap_of(const TextureForm& texture) { return heap_of(texture.kind); }
std::size_t heap_of(const Solid& solid) { return heap_of(solid.steps); }
std::size_t heap_of(const Space& space) {
  const BallIndex& balls = space.balls;
  return heap_of(space.items) + heap_of(space.boxes) + heap_of(space.bvh) + heap_of(space.rest) +
         heap_of(balls.balls) + heap_of(balls.bvh) + balls.packed.bytes();
}
// Of a list with what its elements own.
template <class T>
std::size_t deep_heap_of(const std::vector<T>& list) {
  std::size_t bytes = heap_of(list);
  for (const T& each : list) bytes += heap_of(each);
  return bytes;
}

}  // namespace

std::size_t bytes_of(const Geometry& g) {
  return sizeof(Geometry) + deep_heap_of(g.spaces) + deep_heap_of(g.parts) + heap_of(g.balls) +
         heap_of(g.flats) + heap_of(g.meshes) + deep_heap_of(g.solids) + heap_of(g.copies) +
         heap_of(g.matters) + deep_heap_of(g.textures) + heap_of(g.lamps);
}

std::size_t heap_of_form(const Form& form) { return heap_of(form); }

std::size_t bytes_of(const MeshIndex& mesh) {
  return sizeof(MeshIndex) + heap_of(mesh.positions) + heap_of(mesh.normals) + heap_of(mesh.uvs) +
         heap_of(mesh.triangles) + heap_of(mesh.bvh) + mesh.packed.bytes();
}

}  // namespace tia
