// The images of a glTF document that its textures name.
#pragma once

#include <vector>

#include "core/models/gltf/gltf_parts.h"

namespace tia::gltf {

/// Reads the `wanted` ones' files into the model, and all names. Shape: `wanted` has one flag an
/// image. Returns: for each the number of the one that holds its bytes: of several that are the
/// same bytes of a file the first.
/// Errors: as faults; `limit` where all together hold more bytes than came.
std::vector<ModelIndex> read_images(const GltfSource& source, const std::vector<bool>& wanted,
                                    Model& model);

}  // namespace tia::gltf
