// WorldLight: a light of the compiled scene.
#pragma once

#include <string>

#include "core/lights/light.h"

namespace tia {

/// WorldLight: a light that lights surfaces.
struct WorldLight {
  LightForm form;
  Constant middle;           ///< of a form that shines from a point (ShinesFromPoint)
  Constant color;            ///< color * intensity
  double fade_distance = 0;  ///< 0: it does not fade
  double fade_power = 0;
  int samples = 1;     ///< of its area, for whitted; 1: its middle
  int primitive = -1;  ///< its own surface, which does not block its light; -1: none
  int instance = 0;    ///< which instance of that surface
  std::string name{};  ///< the JSON Pointer of one of the scene's lights; "": a luminous object
};

}  // namespace tia
