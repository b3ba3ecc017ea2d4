// The triangles of a glTF primitive: its indices, and what strips and fans of them mean.
#pragma once

#include "core/models/gltf/gltf_accessors.h"

namespace tia::gltf {

/// PrimitiveMode: glTF's own numbers.
enum class PrimitiveMode : std::uint8_t {
  points,
  lines,
  line_loop,
  line_strip,
  triangles,
  triangle_strip,
  triangle_fan
};

/// How many triangles so many indices make.
std::uint64_t triangles_of(PrimitiveMode mode, std::uint64_t indices);

/// Triangles, three indices each, wound as glTF says. Of strips and fans those are left out that
/// have an index twice, as where strips are sewn together. Domain: a mode of triangles.
/// Source: Khronos, glTF 2.0 (2021), section 3.7.2.1.
std::vector<std::uint32_t> as_list(PrimitiveMode mode, std::vector<std::uint32_t> indices);

/// A primitive's indices: its accessor's, or without one 0, 1, 2, ... Errors: nothing and a fault
/// where one is no vertex or is the value that restarts a primitive.
std::optional<std::vector<std::uint32_t>> read_indices(const GltfSource& source,
                                                       const GltfObject& primitive,
                                                       const Accessor* accessor,
                                                       std::uint64_t vertices);
/// The accessor of a primitive's `indices`; null where it has none, or one that cannot be used.
const Accessor* indices_accessor(const GltfSource& source, const GltfObject& primitive);

}  // namespace tia::gltf
