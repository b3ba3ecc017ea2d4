// How much there is of a shape, and where its middle is: volume and centre of mass.
#pragma once

#include <optional>
#include <string>

#include "core/shapes/shape.h"

namespace tia {

/// Measure: of a solid of even density. Space/units: the shape's own space.
struct Measure {
  double volume = 0;
  Vec3d center{};
};

/// In closed form, or of a mesh by tetrahedra. None of open shapes, of meshes whose triangles do
/// not close, and of surfaces without a closed form (measured_shapes()).
std::optional<Measure> measure_of(const Shape& shape);
/// What it is known of, in words.
std::string measured_shapes();

}  // namespace tia
