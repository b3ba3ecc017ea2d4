#include "core/materials/finish.h"

namespace tia {

ShadingParameters shading_of(const Finish& finish, const Vec3d& ambient_light) {
  const Vec3d color = finish.texture ? Vec3d{1, 1, 1} : rgb_of(finish.color);
  ShadingParameters shading;
  shading.albedo = color * finish.diffuse;
  shading.ambient = color * ambient_light * finish.ambient;
  shading.emission = rgb_of(finish.emission);
  shading.absorption = rgb_of(finish.absorption);
  shading.brilliance = finish.brilliance;
  shading.specular = finish.specular;
  shading.exponent = 1 / finish.roughness;
  shading.reflection = finish.reflection;
  shading.transmission = finish.transmission;
  shading.ior = finish.ior;
  shading.fresnel = finish.fresnel;
  return shading;
}

}  // namespace tia
