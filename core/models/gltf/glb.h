// GLB: the box that a glTF document and the bytes of its first buffer come in.
#pragma once

#include <optional>
#include <string_view>

#include "core/input/errors.h"
#include "core/models/model.h"
#include "core/models/model_files.h"

namespace tia::gltf {

/// GlbParts: what lies in a GLB.
struct GlbParts {
  std::string_view json;
  std::optional<ModelBytes> bytes;  ///< of the first buffer, up to three more than it has
};

/// Whether a file begins as one.
bool is_glb(ModelBytes file);
/// Errors: nothing and a fault. Warnings: of bytes after its end.
/// Source: Khronos, glTF 2.0 (2021), section 4.4.
std::optional<GlbParts> open_glb(ModelBytes file, Faults& faults, Model& model);

}  // namespace tia::gltf
