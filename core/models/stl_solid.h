// What the readers of both kinds of STL share: a solid becomes a mesh and its node.
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "core/input/errors.h"
#include "core/models/model.h"
#include "core/models/model_files.h"
#include "core/models/stl_vertices.h"

namespace tia {

/// StlSolid: a solid of a file.
struct StlSolid {
  std::string_view name;
  std::optional<std::size_t> line;  ///< of a text
  StlVertices vertices;
};

/// Whether the model may have so many triangles. If not, adds a fault.
bool check_stl_triangles(std::uint64_t count, const ModelLimits& limits, Faults& faults);

/// Adds a mesh with one part, its node, and that to the model's scene; takes the vertices.
/// Domain: a model with a scene. Errors: `limit`, as a fault. Returns: whether there was none.
bool add_stl_solid(StlSolid& solid, const ModelLimits& limits, Faults& faults, Model& model);

/// Reads a text into a model that has its material and scene.
void read_stl_text(std::string_view text, const ModelLimits& limits, Faults& faults, Model& model);

}  // namespace tia
