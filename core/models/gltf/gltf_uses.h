// What the views of a glTF document are used for.
#pragma once

#include "core/models/gltf/gltf_object.h"

namespace tia::gltf {

/// Refuses views whose bytes are more than one of vertices, indices and other things, and numbers
/// of sparse accessors between others. Errors: faults, where gltf-validator has them.
/// Domain: a document that has been read without a fault. Cost: linear in its lists.
/// Source: Khronos, glTF 2.0 (2021), sections 3.6.1 and 3.6.2.3.
void check_uses(const GltfObject& root);

}  // namespace tia::gltf
