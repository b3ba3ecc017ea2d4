// The attributes of a glTF primitive: one list of numbers each, as many elements as it has
// vertices.
#pragma once

#include "core/models/gltf/gltf_draco.h"
#include "core/models/gltf/gltf_elements.h"

namespace tia::gltf {

inline constexpr Formats floats = format(Component::floating);

/// The set of a list of sets.
constexpr Formats any_of(std::initializer_list<Formats> sets) {
  unsigned all = 0;
  for (const Formats set : sets) all |= set;
  return static_cast<Formats>(all);
}

/// AttributeRule: what an accessor may be as this attribute.
struct AttributeRule {
  ElementTypes types = 0;
  Formats formats = 0;
  Formats quantized = 0;  ///< those that KHR_mesh_quantization adds
};

/// Attributes: of a primitive, or of one of its morph targets.
struct Attributes {
  const GltfSource& source;
  const GltfObject& object;
  std::uint64_t vertices;
  bool quantized;                               ///< whether the document uses KHR_mesh_quantization
  Model& model;                                 ///< for its warnings
  const UnpackedPrimitive* unpacked = nullptr;  ///< those that were packed
};

/// The accessor of an attribute, or null: where there is none, or where it cannot be used, which is
/// a fault then.
const Accessor* attribute_accessor(const Attributes& attributes, std::string_view name,
                                   const AttributeRule& rule);

/// An attribute's numbers, none without it, and none and a fault where it cannot be read.
template <class Number>
std::vector<Number> read_attribute(const Attributes& attributes, std::string_view name,
                                   const AttributeRule& rule) {
  const Accessor* accessor = attribute_accessor(attributes, name, rule);
  if (accessor == nullptr) return {};
  auto numbers = read_elements<Number>(attributes.source, *accessor, attributes.vertices, farthest);
  return numbers ? std::move(*numbers) : std::vector<Number>();
}

/// Fills a part's lists of vertices. Errors: faults. Warnings: of what is not taken, as normals
/// without a length.
void read_vertices(const Attributes& attributes, ModelPart& part);

/// The morph targets of a primitive. Domain: after its vertices.
void read_targets(const Attributes& attributes, const GltfObject& primitive, ModelPart& part);

}  // namespace tia::gltf
