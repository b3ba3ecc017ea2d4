// Vertices and triangles of what an OBJ file says.
#pragma once

#include "core/input/errors.h"
#include "core/models/model.h"
#include "core/models/model_files.h"
#include "core/models/obj_content.h"

namespace tia {

/// Adds meshes with their nodes, one each, to the model, which has its materials: the faces', or
/// where there are none the points'. A mesh has a part for each material, in the order in which
/// they first come; a part's vertices come in the order in which its corners first have them.
/// Errors: as faults: `limit` of vertices.
/// Cost: n log n at worst, usually linear.
void add_obj_meshes(const ObjContent& content, const ModelLimits& limits, Faults& faults,
                    Model& model);

}  // namespace tia
