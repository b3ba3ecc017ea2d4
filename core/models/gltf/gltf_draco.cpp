#include "core/models/gltf/gltf_draco.h"

#include <algorithm>
#include <cstring>

#include "core/models/draco.h"
#include "core/models/gltf/gltf_bytes.h"

namespace tia::gltf {
namespace {

constexpr std::string_view draco_name = "KHR_draco_mesh_compression";

bool has_count(const GltfSource& source, const Accessor& accessor, std::uint64_t unpacked) {
  if (accessor.count == unpacked) return true;
  source.faults.add({FaultKind::conflict, "/accessors/" + std::to_string(accessor.index) + "/count",
                     Value(static_cast<double>(accessor.count)),
                     std::to_string(unpacked) + ", as many as are unpacked"});
  return false;
}

template <class Number>
std::optional<std::vector<std::uint8_t>> value_bytes(const DracoMesh& mesh, std::uint32_t id) {
  const auto values = mesh.values<Number>(id);
  if (!values) return std::nullopt;
  std::vector<std::uint8_t> bytes(values->size() * sizeof(Number));
  if (!bytes.empty()) std::memcpy(bytes.data(), values->data(), bytes.size());
  return bytes;
}

std::optional<std::vector<std::uint8_t>> value_bytes(const DracoMesh& mesh, std::uint32_t id,
                                                     Component component) {
  switch (component) {
    case Component::signed_byte: return value_bytes<std::int8_t>(mesh, id);
    case Component::unsigned_byte: return value_bytes<std::uint8_t>(mesh, id);
    case Component::signed_short: return value_bytes<std::int16_t>(mesh, id);
    case Component::unsigned_short: return value_bytes<std::uint16_t>(mesh, id);
    case Component::unsigned_int: return value_bytes<std::uint32_t>(mesh, id);
    case Component::floating: break;
  }
  return value_bytes<float>(mesh, id);
}

/// Unpacking: of one primitive.
struct Unpacking {
  const GltfSource& source;
  const PackedPrimitive& primitive;
  const DracoMesh& mesh;
  UnpackedPrimitive& to;

  void read_attribute(const GltfObject& packed, std::string_view name) const {
    const auto id = packed.integer(name, 0, 0xFFFF'FFFF);
    const std::vector<Accessor>& all = source.bytes.accessors();
    if (!id || !primitive.attributes.needs(name, "what the extension packs")) return;
    const MaybeIndex index = primitive.attributes.index(name, all.size());
    if (!index || !all[*index].good) return;
    Accessor accessor = all[*index];
    const std::size_t numbers = mesh.numbers(static_cast<std::uint32_t>(*id));
    if (numbers == 0)
      return packed.fault(FaultKind::out_of_range, name, Value(static_cast<double>(*id)),
                          "the id of an attribute that is packed");
    if (!has_count(source, accessor, mesh.vertices())) return;
    auto bytes = accessor.layout.columns == 1 && numbers == accessor.layout.rows
                     ? value_bytes(mesh, static_cast<std::uint32_t>(*id), accessor.layout.component)
                     : std::nullopt;
    if (!bytes)
      return packed.fault(FaultKind::conflict, name, Value(std::to_string(numbers) + " numbers"),
                          "such as the accessor has: " + words(accessor));
    to.bytes.push_back(std::move(*bytes));  // moved, they stay where they are
    accessor.bytes = to.bytes.back();
    accessor.stride = accessor.layout.stride();
    accessor.in_fours = true;
    to.accessors.emplace_back(name, accessor);
  }

  // A strip may have triangles without area, which are not packed.
  void read_indices() const {
    if (!primitive.object.needs("indices", "how many indices are packed") ||
        primitive.indices == nullptr)
      return;
    to.indices = mesh.indices();
    const std::uint64_t triangles = to.indices.size() / 3;
    if (primitive.mode == PrimitiveMode::triangles)
      has_count(source, *primitive.indices, to.indices.size());
    else if (triangles > triangles_of(primitive.mode, primitive.indices->count))
      has_count(source, *primitive.indices, triangles + 2);
  }
};

}  // namespace

const Accessor* UnpackedPrimitive::find(std::string_view attribute) const {
  const auto found =
      std::ranges::find(accessors, attribute, [](const auto& each) { return each.first; });
  return found == accessors.end() ? nullptr : &found->second;
}

bool is_packed(const GltfObject& primitive) {
  return primitive.with_extension(draco_name, [](const GltfObject&) {});
}

std::optional<UnpackedPrimitive> unpack(const GltfSource& source,
                                        const PackedPrimitive& primitive) {
  const std::size_t before = source.faults.count();
  UnpackedPrimitive to;
  if (primitive.mode != PrimitiveMode::triangles && primitive.mode != PrimitiveMode::triangle_strip)
    primitive.object.fault(FaultKind::conflict, "mode", std::nullopt,
                           "4 or 5, triangles, of what is packed by " + std::string(draco_name));
  primitive.object.with_extension(draco_name, [&](const GltfObject& extension) {
    extension.needs("bufferView", "the number of a view");
    extension.needs("attributes", "an object of ids by the attributes' names");
    const MaybeIndex view = extension.index("bufferView", source.bytes.views().size());
    if (source.faults.count() != before || !source.bytes.views()[*view].there) return;
    std::string why;
    const auto mesh = DracoMesh::unpack(source.bytes.views()[*view].bytes, why);
    if (!mesh)
      return extension.fault(FaultKind::malformed, "bufferView", excerpt(why),
                             "a mesh as Draco packs it");
    const Unpacking unpacking{source, primitive, *mesh, to};
    unpacking.read_indices();
    extension.with("attributes", [&](const GltfObject& packed) {
      packed.for_each_member(
          [&](std::string_view name, const Value&) { unpacking.read_attribute(packed, name); });
    });
  });
  if (source.faults.count() != before) return std::nullopt;
  return to;
}

}  // namespace tia::gltf
