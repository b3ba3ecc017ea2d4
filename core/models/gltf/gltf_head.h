// What a glTF document says of itself.
#pragma once

#include "core/models/gltf/gltf_object.h"

namespace tia::gltf {

/// Reads the asset's version, generator and copyright, and which extensions are used. Returns:
/// whether the document can be read. Errors: faults where it cannot: of another version, or with
/// an extension that is needed and not taken.
bool read_head(const GltfObject& root, Model& model);

/// Whether a document says that it uses an extension.
bool uses(const Model& model, std::string_view extension);

}  // namespace tia::gltf
