#include "core/scene/model_material.h"

#include <utility>

namespace tia {
namespace {

Principled unlit_of(const ModelMaterial& m) {
  Principled p;
  p.base_color = Color{};
  p.roughness = 1;
  p.specular = 0;
  p.emissive = m.base_color;
  return p;
}

Principled lit_of(const ModelMaterial& m) {
  Principled p;
  p.base_color = m.base_color;
  p.metallic = m.metallic;
  p.roughness = m.roughness;
  p.ior = m.ior;
  p.specular = m.specular;
  p.specular_color = m.specular_color;
  p.transmission = m.transmission;
  p.attenuation_color = m.attenuation_color;
  p.attenuation_distance = m.attenuation_distance;
  p.thin = m.thin;
  p.clearcoat = m.clearcoat;
  p.clearcoat_roughness = m.clearcoat_roughness;
  p.sheen_color = m.sheen_color;
  p.sheen_roughness = m.sheen_roughness;
  p.anisotropy = m.anisotropy;
  p.anisotropy_rotation = m.anisotropy_rotation;
  p.dispersion = m.dispersion;
  p.emissive = m.emissive;
  p.emissive_strength = m.emissive_strength;
  return p;
}

}  // namespace

Material material_of(const ModelMaterial& material, std::shared_ptr<const PrincipledMaps> maps,
                     double ambient) {
  Principled made = material.unlit ? unlit_of(material) : lit_of(material);
  made.ambient = material.unlit ? 0 : ambient;
  made.alpha = material.alpha;
  made.alpha_mode = material.alpha_mode;
  made.alpha_cutoff = material.alpha_cutoff;
  made.double_sided = material.double_sided;
  made.maps = std::move(maps);
  return {Boxed<Principled>(std::move(made))};
}

}  // namespace tia
