// EXT_mesh_gpu_instancing: where else a node's mesh stands.
#pragma once

#include "core/models/gltf/gltf_parts.h"

namespace tia::gltf {

/// The instances of a node, none without the extension. `left`: how many the document may still
/// have, from which they are taken. Errors: faults.
/// Source: Khronos, EXT_mesh_gpu_instancing.
std::vector<Placement> read_instances(const GltfSource& source, const GltfObject& node,
                                      std::uint64_t& left);

}  // namespace tia::gltf
