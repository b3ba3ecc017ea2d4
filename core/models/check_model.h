// Whether a flat form fits together: what readers promise, and what is asked of a stranger's.
#pragma once

#include "core/input/errors.h"
#include "core/models/model.h"
#include "core/models/model_files.h"

namespace tia {

/// Numbers beyond their lists, lists of the wrong length, numbers that are not finite or out of
/// their range, nodes with two parents or none that leads to them, more than the limits allow; a
/// model without a scene. Pointers are into the flat form: /meshes/0/parts/1/indices.
/// Cost: O(size). Errors: Stopped, some thousand values after that is asked for.
void check_model(const Model& model, const ModelLimits& limits, Faults& faults);

}  // namespace tia
