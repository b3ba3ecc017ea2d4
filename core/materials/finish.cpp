#include "core/materials/finish.h"

namespace tia {

Matter matter_of(const Finish& finish, const Vec3d& ambient_light) {
  const Vec3d color = finish.texture ? Vec3d{1, 1, 1} : rgb_of(finish.color);
  Matter matter;
  matter.albedo = color * finish.diffuse;
  matter.ambient = color * ambient_light * finish.ambient;
  matter.emission = rgb_of(finish.emission);
  matter.absorption = rgb_of(finish.absorption);
  matter.brilliance = finish.brilliance;
  matter.specular = finish.specular;
  matter.exponent = 1 / finish.roughness;
  matter.reflection = finish.reflection;
  matter.transmission = finish.transmission;
  matter.ior = finish.ior;
  matter.fresnel = finish.fresnel;
  return matter;
}

}  // namespace tia
