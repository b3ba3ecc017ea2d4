#include "core/models/mtl_material.h"

#include <algorithm>
#include <cmath>

namespace tia {
namespace {

// A picture multiplies what the file says, and stands alone where it says nothing.
double mtl_factor(const std::optional<double>& said, const MaybeTexture& map, double otherwise) {
  return said.value_or(map ? 1 : otherwise);
}

void set_mtl_emission(const MtlMaterial& mtl, ModelMaterial& material) {
  const double alone = mtl.emission_map ? 1 : 0;
  const Color light = mtl.emission.value_or(Color{alone, alone, alone});
  material.emissive_strength = std::max({light.r, light.g, light.b, 1.0});
  const double strength = material.emissive_strength;
  material.emissive = {light.r / strength, light.g / strength, light.b / strength};
  material.emissive_texture = mtl.emission_map;
}

void set_mtl_roughness(const MtlMaterial& mtl, ModelMaterial& material) {
  const bool has_own = mtl.roughness || mtl.roughness_map;
  if (!has_own && mtl.exponent) {
    const double alpha = std::sqrt(2 / (*mtl.exponent + 2));
    material.roughness = std::sqrt(alpha);
  } else {
    material.roughness = mtl_factor(mtl.roughness, mtl.roughness_map, material.roughness);
  }
  material.roughness_texture = mtl.roughness_map;
}

// d, or where there is none Tr, which is its complement.
void set_mtl_opacity(const MtlMaterial& mtl, ModelMaterial& material) {
  const double opacity = mtl.dissolve.value_or(1 - mtl.transparency.value_or(0));
  const double model = mtl.illumination.value_or(2);
  const bool is_glass = model == 4 || model == 6 || model == 7 || model == 9;
  (is_glass ? material.transmission : material.alpha) = is_glass ? 1 - opacity : opacity;
  material.alpha_texture = mtl.dissolve_map;
  if (material.alpha < 1 || mtl.dissolve_map) material.alpha_mode = AlphaMode::blend;
}

}  // namespace

ModelMaterial mtl_material_of(const MtlMaterial& mtl) {
  ModelMaterial material;
  material.name = mtl.name;
  material.base_color =
      mtl.diffuse.value_or(mtl.diffuse_map ? Color{1, 1, 1} : material.base_color);
  material.base_color_texture = mtl.diffuse_map;
  set_mtl_emission(mtl, material);
  set_mtl_roughness(mtl, material);
  set_mtl_opacity(mtl, material);
  material.metallic = mtl_factor(mtl.metallic, mtl.metallic_map, material.metallic);
  material.metallic_texture = mtl.metallic_map;
  material.normal_texture = mtl.normal_map;
  material.ior = mtl.ior.value_or(material.ior);
  const double sheen = mtl.sheen.value_or(0);
  material.sheen_color = {sheen, sheen, sheen};
  material.clearcoat = mtl.clearcoat.value_or(material.clearcoat);
  material.clearcoat_roughness = mtl.clearcoat_roughness.value_or(material.clearcoat_roughness);
  return material;
}

}  // namespace tia
