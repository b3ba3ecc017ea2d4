// The skins of a glTF document.
#pragma once

#include "core/models/gltf/gltf_parts.h"

namespace tia::gltf {

/// Reads skins. Errors: faults, also of nodes whose mesh names joints that their skin lacks.
/// Domain: after meshes and nodes.
void read_skins(const GltfSource& source, Model& model);

}  // namespace tia::gltf
