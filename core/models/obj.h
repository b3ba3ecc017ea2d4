// Wavefront OBJ: faces, and points where there are no faces.
#pragma once

#include "core/input/errors.h"
#include "core/models/model.h"
#include "core/models/model_files.h"

namespace tia {

/// Whether a file is one: a text whose first statement is one of OBJ's, with a position (v and a
/// number) and, unless the file is longer than what is looked at, some other statement of OBJ's.
/// The first MiB is looked at, for NUL bytes the first 4 KiB.
bool is_obj(ModelBytes file);

/// Reads the main file and the MTL files that it names. o begins a mesh with its node, and so does
/// g where no o has come; a mesh has a part for each material. Equal corners of a part are one
/// vertex. What only some corners of a part have (uv, normals, colours) it has not. Colours after
/// positions are sRGB's signals. Polygons are cut as triangulate() does.
/// Errors: as faults, with lines; of MTL files with "/PATH" as the pointer.
/// Cost: linear in the files, but for polygons that are not convex, and n log n for positions with
/// more than 16 different corners.
/// Source: Wavefront, "Advanced Visualizer Manual", appendix B1, "Object Files (.obj)" (1990s).
void read_obj(const ModelFiles& files, const ModelLimits& limits, Faults& faults, Model& model);

}  // namespace tia
