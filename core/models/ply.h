// PLY: vertices and polygons with properties of any number, as text or as bytes.
// Source: Turk, The PLY Polygon File Format (1994).
#pragma once

#include "core/input/errors.h"
#include "core/models/model.h"
#include "core/models/model_files.h"

namespace tia {

/// Whether a file's first line is `ply`.
bool is_ply(ModelBytes file);

/// One mesh of one part, of points where the file has no faces. A picture that a comment
/// `TextureFile` names is the material's base colour, where it came too and vertices have texture
/// coordinates. Properties and elements that are not used are passed over with a warning.
/// Errors: as faults, those of the header and of a text with their lines.
/// Cost: linear but for polygons with many corners (triangulate); memory of some 30 times the
/// file's size at most, where numbers are kept as single bytes.
void read_ply(const ModelFiles& files, const ModelLimits& limits, Faults& faults, Model& model);

}  // namespace tia
