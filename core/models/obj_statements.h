// The statements of an OBJ file, one after the other.
#pragma once

#include "core/input/errors.h"
#include "core/models/model.h"
#include "core/models/model_files.h"
#include "core/models/obj_content.h"

namespace tia {

/// Reads the main file, and the materials of the files that it names into the model. Errors: as
/// faults, with lines. Cost: linear in the files.
ObjContent read_obj_content(const ModelFiles& files, const ModelLimits& limits, Faults& faults,
                            Model& model);

}  // namespace tia
