#include "core/materials/finish.h"

#include <algorithm>
#include <cmath>

namespace tia {
namespace {

// A Lambertian of albedo color * diffuse, a mirror and a smooth dielectric; its highlight is a
// rough mirror beside them, of the alpha whose peak falls as Phong's. Source: Walter et al.,
// "Microfacet models for refraction through rough surfaces" (2007), 5.2.
BsdfParameters<double> bsdf_of(const Finish& finish, const Vec3d& color) {
  const double most = std::max(1.0, finish.transmission + finish.reflection);
  BsdfParameters<double> bsdf;
  bsdf.base = color * finish.diffuse;
  bsdf.matt = std::max(0.0, 1 - finish.transmission - finish.reflection);
  bsdf.mirror = finish.reflection / most;
  bsdf.glass = finish.transmission / most;
  bsdf.ior = finish.ior;
  bsdf.fresnel = finish.fresnel;
  bsdf.coat = finish.specular;
  bsdf.coat_f0 = bsdf.coat_f90 = 1;
  bsdf.coat_alpha = std::sqrt(2 / (1 / finish.roughness + 2));
  return bsdf;
}

}  // namespace

ShadingParameters shading_of(const Finish& finish, const Vec3d& ambient_light) {
  const Vec3d color = finish.texture ? Vec3d{1, 1, 1} : rgb_of(finish.color);
  ShadingParameters shading;
  shading.albedo = color * finish.diffuse;
  shading.ambient = color * ambient_light * finish.ambient;
  shading.emission = rgb_of(finish.emission);
  shading.absorption = rgb_of(finish.absorption);
  shading.label = rgb_of(finish.color);
  shading.brilliance = finish.brilliance;
  shading.specular = finish.specular;
  shading.exponent = 1 / finish.roughness;
  shading.reflection = finish.reflection;
  shading.transmission = finish.transmission;
  shading.ior = finish.ior;
  shading.fresnel = finish.fresnel;
  shading.bsdf = bsdf_of(finish, color);
  return shading;
}

}  // namespace tia
