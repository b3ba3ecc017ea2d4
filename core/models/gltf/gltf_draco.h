// KHR_draco_mesh_compression: what is packed of a glTF primitive.
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/models/gltf/gltf_accessors.h"
#include "core/models/gltf/gltf_indices.h"

namespace tia::gltf {

/// UnpackedPrimitive: accessors whose bytes were packed, by their attributes' names.
struct UnpackedPrimitive {
  std::vector<std::pair<std::string, Accessor>> accessors;
  std::vector<std::vector<std::uint8_t>> bytes;  ///< which the accessors look at
  std::vector<std::uint32_t> indices;            ///< three a triangle

  /// Null: that attribute was not packed.
  const Accessor* find(std::string_view attribute) const;
};

/// PackedPrimitive: a primitive with that extension, and what it says of itself.
struct PackedPrimitive {
  const GltfObject& object;
  const GltfObject& attributes;
  PrimitiveMode mode;
  const Accessor* indices;  ///< null: none, or none that can be used
};

/// Whether a primitive is packed.
bool is_packed(const GltfObject& primitive);

/// Unpacks a primitive. Strips are unpacked as lists. Errors: none, and faults: of bytes that are
/// no mesh, of attributes that are not in it, of counts that are not the accessors'. Source:
/// Khronos, KHR_draco_mesh_compression (2018).
std::optional<UnpackedPrimitive> unpack(const GltfSource& source, const PackedPrimitive& primitive);

}  // namespace tia::gltf
