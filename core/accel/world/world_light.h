// WorldLight: a light of the compiled scene.
#pragma once

#include <memory>
#include <string>

#include "core/lights/light.h"
#include "core/math/strata.h"

namespace tia {

/// WorldLight: a light that lights surfaces.
struct WorldLight {
  LightForm form;
  Constant middle;           ///< of a form that shines from a point (ShinesFromPoint)
  Constant color;            ///< color * intensity
  double fade_distance = 0;  ///< 0: it does not fade
  double fade_power = 0;
  /// Of its area, one a sample; null: one sample, its middle. Lights with as many samples share
  /// them.
  std::shared_ptr<const Strata> strata{};
  int primitive = -1;  ///< its own surface, which does not block its light; -1: none
  int instance = 0;    ///< which instance of that surface
  std::string name{};  ///< the JSON Pointer of one of the scene's lights; "": a luminous object
};

}  // namespace tia
