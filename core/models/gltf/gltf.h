// The glTF 2.0 reader: JSON with files beside it, or GLB. Other versions are not read.
#pragma once

#include "core/input/errors.h"
#include "core/models/model.h"
#include "core/models/model_files.h"

namespace tia {

/// Whether a file is a GLB or a glTF's JSON, by its bytes alone.
bool is_gltf(ModelBytes file);

/// Reads the main file and what it names. Errors: as faults, with pointers into the JSON, which are
/// gltf-validator's where that calls the same an error; then the model is of no meaning.
/// Cost: linear in the bytes of all files and in what the limits allow.
/// Source: Khronos, glTF 2.0 specification (2021).
void read_gltf(const ModelFiles& files, const ModelLimits& limits, Faults& faults, Model& model);

}  // namespace tia
