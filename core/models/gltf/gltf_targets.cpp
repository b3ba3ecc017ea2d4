// Morph targets: what is added to the vertices of a glTF primitive.
#include "core/models/gltf/gltf_attributes.h"

namespace tia::gltf {
namespace {

constexpr Formats moved_directions =
    any_of({format(Component::signed_byte, true), format(Component::signed_short, true)});
constexpr Formats moved_positions =
    any_of({moved_directions, format(Component::signed_byte), format(Component::signed_short)});

// Source: Khronos, glTF 2.0 (2021), section 3.7.2.2, and KHR_mesh_quantization.
constexpr AttributeRule moved_position_rule{only(ElementType::vec3), floats, moved_positions};
constexpr AttributeRule moved_direction_rule{only(ElementType::vec3), floats, moved_directions};

MorphTarget read_target(const Attributes& target, const GltfObject& base, const ModelPart& part) {
  for (const auto name : {"POSITION", "NORMAL", "TANGENT"})
    if (target.object.has(name) && !base.has(name))
      target.object.fault(FaultKind::conflict, name, std::nullopt, "what the primitive has itself");
  MorphTarget read;
  read.positions = read_attribute<float>(target, "POSITION", moved_position_rule);
  read.normals = read_attribute<float>(target, "NORMAL", moved_direction_rule);
  read.tangents = read_attribute<float>(target, "TANGENT", moved_direction_rule);
  if (part.normals.empty()) read.normals.clear();
  if (part.tangents.empty()) read.tangents.clear();
  return read;
}

}  // namespace

void read_targets(const Attributes& attributes, const GltfObject& primitive, ModelPart& part) {
  primitive.for_each("targets", [&](const GltfObject& object, std::size_t) {
    const Attributes target{attributes.source, object, attributes.vertices, attributes.quantized,
                            attributes.model};
    part.targets.push_back(read_target(target, attributes.object, part));
  });
}

}  // namespace tia::gltf
