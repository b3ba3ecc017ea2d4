#include "core/models/gltf/gltf_indices.h"

#include <algorithm>
#include <numeric>

#include "core/models/gltf/gltf_bytes.h"
#include "core/models/gltf/gltf_elements.h"

namespace tia::gltf {
namespace {

// The largest value of the accessor's type restarts a primitive where a graphics card is told so.
std::uint32_t restart_value(Component component) {
  switch (size_of(component)) {
    case 1: return 0xFF;
    case 2: return 0xFFFF;
    default: return 0xFFFF'FFFF;
  }
}

bool indices_are_vertices(const GltfObject& primitive, const std::vector<std::uint32_t>& indices,
                          std::uint64_t vertices, std::uint32_t restart) {
  const std::uint64_t allowed = std::min<std::uint64_t>(vertices, restart);
  std::uint32_t most = 0;
  for (const std::uint32_t index : indices) most = std::max(most, index);
  if (most < allowed) return true;
  const auto wrong =
      std::ranges::find_if(indices, [&](std::uint32_t index) { return index >= allowed; });
  primitive.fault(FaultKind::out_of_range, "indices", Value(static_cast<double>(*wrong)),
                  "indices below " + std::to_string(allowed) + ", which number " +
                      std::to_string(wrong - indices.begin()) + " is not");
  return false;
}

}  // namespace

std::uint64_t triangles_of(PrimitiveMode mode, std::uint64_t indices) {
  if (mode == PrimitiveMode::triangles) return indices / 3;
  return indices < 3 ? 0 : indices - 2;
}

std::vector<std::uint32_t> as_list(PrimitiveMode mode, std::vector<std::uint32_t> indices) {
  if (mode == PrimitiveMode::triangles) {
    indices.resize(indices.size() / 3 * 3);
    return indices;
  }
  std::vector<std::uint32_t> list;
  const std::size_t count = indices.size() < 3 ? 0 : indices.size() - 2;
  list.reserve(count * 3);
  for (std::size_t i = 0; i < count; ++i) {
    const bool fan = mode == PrimitiveMode::triangle_fan;
    const std::uint32_t a = indices[fan ? i + 1 : i], b = indices[fan ? i + 2 : i + 1 + i % 2],
                        c = indices[fan ? 0 : i + 2 - i % 2];
    if (a != b && b != c && c != a) list.insert(list.end(), {a, b, c});
  }
  return list;
}

const Accessor* indices_accessor(const GltfSource& source, const GltfObject& primitive) {
  const AccessorRule rule{
      only(ElementType::scalar),
      static_cast<Formats>(format(Component::unsigned_byte) | format(Component::unsigned_short) |
                           format(Component::unsigned_int))};
  const Accessor* accessor = accessor_for(source, primitive, "indices", rule);
  if (accessor == nullptr || !accessor->strided) return accessor;
  primitive.fault(FaultKind::conflict, "indices", std::nullopt, "a view without a byteStride");
  return nullptr;
}

std::optional<std::vector<std::uint32_t>> read_indices(const GltfSource& source,
                                                       const GltfObject& primitive,
                                                       const Accessor* accessor,
                                                       std::uint64_t vertices) {
  if (accessor == nullptr) {
    std::vector<std::uint32_t> all(vertices);
    std::iota(all.begin(), all.end(), 0U);
    return all;
  }
  auto all = read_elements<std::uint32_t>(source, *accessor, accessor->count);
  const std::uint32_t restart = restart_value(accessor->layout.component);
  if (all && !indices_are_vertices(primitive, *all, vertices, restart)) return std::nullopt;
  return all;
}

}  // namespace tia::gltf
