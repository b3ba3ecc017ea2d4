// What shading needs of a material, whichever kind it is of.
#pragma once

#include "core/math/wide.h"

namespace tia {

/// Whether any of it is light.
inline bool emits(const Vec3d& light) { return light.x > 0 || light.y > 0 || light.z > 0; }

/// ShadingParameters: what shading needs of a material. Linear RGB.
struct ShadingParameters {
  Constant albedo;    ///< diffuse * color, the colour of a texture left out
  Constant ambient;   ///< what it sends back of the light from everywhere, that colour left out
  Constant emission;  ///< light of its own
  Constant absorption;
  double brilliance = 1;
  double specular = 0, exponent = 20;
  double reflection = 0, transmission = 0, ior = 1;
  bool fresnel = false;
  int texture = -1;  ///< which of the geometry's gives its points their colours; -1: none

  bool operator==(const ShadingParameters&) const = default;
};

}  // namespace tia
