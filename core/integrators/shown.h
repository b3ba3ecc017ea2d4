// How each integrator's numbers are shown, and whether a pixel's may be averaged.
#pragma once

#include "core/film/display.h"
#include "core/scene/scene.h"

namespace tia {

inline Shown shown(IntegratorName name) {
  switch (name) {
    case IntegratorName::normal: return Shown::normal;
    case IntegratorName::depth: return Shown::depth;
    case IntegratorName::object: return Shown::number;
    case IntegratorName::shadow: return Shown::share;
    case IntegratorName::cost: return Shown::cost;
    case IntegratorName::albedo:
    case IntegratorName::thesis:
    case IntegratorName::whitted: break;
  }
  return Shown::light;
}

/// Numbers of objects have no mean: such a picture takes one ray a pixel.
inline bool averages(IntegratorName name) { return name != IntegratorName::object; }

}  // namespace tia
