// ShadingParameters: the numbers that shading needs of a material of any kind.
#pragma once

#include "core/materials/bsdf_parameters.h"
#include "core/math/wide.h"

namespace tia {

/// Whether any component is above 0.
inline bool emits(const Vec3d& light) { return light.x > 0 || light.y > 0 || light.z > 0; }

/// ShadingParameters: what shading needs of a material, as whitted takes it, and for `path` as a
/// BSDF. Linear RGB.
struct ShadingParameters {
  Constant albedo;    ///< diffuse * color; a texture's colour is multiplied in at each point
  Constant ambient;   ///< ambient reflection times ambient light, without a texture's colour
  Constant emission;  ///< emitted light
  Constant absorption;
  Constant label{
      Vec3d{1, 1, 1}};  ///< the colour that the material is told by, whatever textures it
  double brilliance = 1;
  double specular = 0, exponent = 20;
  double reflection = 0, transmission = 0, ior = 1;
  bool fresnel = false;
  double opacity = 1;        ///< the share of rays that meets it; the rest goes straight on
  bool see_through = false;  ///< whether that is below 1 anywhere
  bool one_sided = false;    ///< whether straight sight passes its back faces (Sight)
  int texture = -1;          ///< the index of its texture in the geometry; -1: none
  int form = -1;  ///< the index of what tells them at each point, likewise; -1: all are the same

  BsdfParameters<double> bsdf{};

  bool operator==(const ShadingParameters&) const = default;
};

}  // namespace tia
