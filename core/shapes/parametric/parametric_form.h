// What a parametric surface is made of, and where a line meets it.
#pragma once

#include <memory>

#include "core/shapes/crossing.h"
#include "core/shapes/parametric/patches.h"

namespace tia {

/// ParametricForm. Its elements are its patches.
struct ParametricForm {
  static constexpr bool solid = false;
  Program surface;
  Rectangle domain;
  std::shared_ptr<const SurfacePatches> patches;
};

std::size_t heap_bytes(const ParametricForm& form);

/// SurfaceHit: where a line meets a surface, and the rectangle in which that is the only place.
struct SurfaceHit {
  Crossing at;
  Bracket bracket;
};
}  // namespace tia
