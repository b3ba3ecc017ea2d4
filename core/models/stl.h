// STL: triangles with nothing else to them, as bytes or as text.
// Source: 3D Systems, Stereolithography Interface Specification (1989).
#pragma once

#include "core/input/errors.h"
#include "core/models/model.h"
#include "core/models/model_files.h"

namespace tia {

/// Whether a file is of exactly 84 + 50 n bytes, n being the number at its byte 80, or a text that
/// begins with the word `solid`, white space before it allowed.
bool is_stl(ModelBytes file);

/// Each solid is a mesh of one part and a node of its name. Equal corners are one vertex; stored
/// normals and attributes are not used. A file of both kinds is read as bytes.
/// Errors: as faults, those of a text with their lines.
/// Cost: that of StlVertices.
void read_stl(const ModelFiles& files, const ModelLimits& limits, Faults& faults, Model& model);

}  // namespace tia
