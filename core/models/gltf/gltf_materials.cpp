// materials of glTF, with the extensions that Tia takes.
#include <algorithm>
#include <array>
#include <string>

#include "core/models/gltf/gltf_textures.h"
#include "core/models/gltf/gltf_values.h"

namespace tia::gltf {
namespace {

constexpr Range share_range{0, 1};
constexpr Strength normal_scale{"scale", {-1e6, 1e6}}, occlusion_strength{"strength", share_range};

// ---- the core -----------------------------------------------------------------------------------

// What glTF takes for members that are not there.
ModelMaterial gltf_material() {
  ModelMaterial material;
  material.base_color = {1, 1, 1};
  material.metallic = material.roughness = 1;
  material.double_sided = false;
  return material;
}

void read_metallic_roughness(const GltfObject& from, const GltfTextures& textures,
                             ModelMaterial& to) {
  if (const auto rgba = from.numbers<4>("baseColorFactor", share_range)) {
    to.base_color = {(*rgba)[0], (*rgba)[1], (*rgba)[2]};
    to.alpha = (*rgba)[3];
  }
  to.metallic = from.number_or("metallicFactor", 1, share_range);
  to.roughness = from.number_or("roughnessFactor", 1, share_range);
  to.base_color_texture = textures.use(from, "baseColorTexture");
  to.metallic_roughness_texture = textures.use(from, "metallicRoughnessTexture");
}

void read_alpha(const GltfObject& from, ModelMaterial& to) {
  constexpr std::array<std::string_view, 3> modes{"OPAQUE", "MASK", "BLEND"};
  to.alpha_mode = static_cast<AlphaMode>(word(from, "alphaMode", modes).value_or(0));
  to.alpha_cutoff = from.number_or("alphaCutoff", 0.5, {0, Range().max});
}

// ---- extensions ---------------------------------------------------------------------------------

void read_unlit(const GltfObject&, const GltfTextures&, ModelMaterial& to) { to.unlit = true; }

void read_emissive_strength(const GltfObject& from, const GltfTextures& textures,
                            ModelMaterial& to) {
  to.emissive_strength = capped(from, "emissiveStrength", 1, {0, 1e6}, textures.model());
}

void read_specular(const GltfObject& from, const GltfTextures& textures, ModelMaterial& to) {
  to.specular = from.number_or("specularFactor", 1, share_range);
  to.specular_color = from.color_or("specularColorFactor", {1, 1, 1}, {0, 1e6});
  to.specular_texture = textures.use(from, "specularTexture");
  to.specular_color_texture = textures.use(from, "specularColorTexture");
}

// 0 stands for a surface that reflects all, which specular_color then darkens. The largest index
// reflects ((ior - 1) / (ior + 1))^2, which specular_color makes up for: what it reflects is the
// same. Source: KHR_materials_ior, "Extending Materials".
void read_ior(const GltfObject& from, const GltfTextures& textures, ModelMaterial& to) {
  constexpr double most = 10, makes_up = (most + 1) * (most + 1) / ((most - 1) * (most - 1));
  const auto ior = from.number("ior", {0, Range().max});
  if (ior && *ior > 0) to.ior = capped(from, "ior", 1.5, {1, most}, textures.model());
  if (!ior || *ior > 0) return;
  Color& color = to.specular_color;
  to.ior = most;
  color = {color.r * makes_up, color.g * makes_up, color.b * makes_up};
  textures.model().warn({from.at().at("ior").pointer(), 0,
                         "0 is taken as 10, with a specular_color that reflects as much"});
}

void read_transmission(const GltfObject& from, const GltfTextures& textures, ModelMaterial& to) {
  to.transmission = from.number_or("transmissionFactor", 0, share_range);
  to.transmission_texture = textures.use(from, "transmissionTexture");
}

// How thick it is, rays find out.
void read_volume(const GltfObject& from, const GltfTextures&, ModelMaterial& to) {
  constexpr double infinite = 1e9;
  to.thin = from.number_or("thicknessFactor", 0, {0, Range().max}) <= 0;
  to.attenuation_color = from.color_or("attenuationColor", {1, 1, 1});
  // JSON has no word for infinity: some writers put null.
  const Value* distance = from.member("attenuationDistance");
  if (distance == nullptr || distance->as<std::nullptr_t>() != nullptr) return;
  to.attenuation_distance = positive(from, "attenuationDistance");
  if (to.attenuation_distance > infinite) to.attenuation_distance.reset();
}

void read_clearcoat(const GltfObject& from, const GltfTextures& textures, ModelMaterial& to) {
  to.clearcoat = from.number_or("clearcoatFactor", 0, share_range);
  to.clearcoat_roughness = from.number_or("clearcoatRoughnessFactor", 0, share_range);
  to.clearcoat_texture = textures.use(from, "clearcoatTexture");
  to.clearcoat_roughness_texture = textures.use(from, "clearcoatRoughnessTexture");
  to.clearcoat_normal_texture = textures.use(from, "clearcoatNormalTexture", normal_scale);
}

void read_sheen(const GltfObject& from, const GltfTextures& textures, ModelMaterial& to) {
  to.sheen_color = from.color_or("sheenColorFactor", {});
  to.sheen_roughness = from.number_or("sheenRoughnessFactor", 0, share_range);
  to.sheen_color_texture = textures.use(from, "sheenColorTexture");
  to.sheen_roughness_texture = textures.use(from, "sheenRoughnessTexture");
}

void read_anisotropy(const GltfObject& from, const GltfTextures& textures, ModelMaterial& to) {
  to.anisotropy = from.number_or("anisotropyStrength", 0, share_range);
  to.anisotropy_rotation = from.number_or("anisotropyRotation", 0, {-1e3, 1e3});
  to.anisotropy_texture = textures.use(from, "anisotropyTexture");
}

void read_dispersion(const GltfObject& from, const GltfTextures& textures, ModelMaterial& to) {
  to.dispersion = capped(from, "dispersion", 0, {0, 10}, textures.model());
}

/// MaterialExtension: one that is taken.
struct MaterialExtension {
  std::string_view name;
  void (*read)(const GltfObject& from, const GltfTextures& textures, ModelMaterial& to);
};
// In the order in which they are read: `ior` changes what `specular` has read.
constexpr std::array<MaterialExtension, 10> material_extensions{{
    {"KHR_materials_unlit", read_unlit},
    {"KHR_materials_emissive_strength", read_emissive_strength},
    {"KHR_materials_specular", read_specular},
    {"KHR_materials_ior", read_ior},
    {"KHR_materials_transmission", read_transmission},
    {"KHR_materials_volume", read_volume},
    {"KHR_materials_clearcoat", read_clearcoat},
    {"KHR_materials_sheen", read_sheen},
    {"KHR_materials_anisotropy", read_anisotropy},
    {"KHR_materials_dispersion", read_dispersion},
}};

bool takes_extension(std::string_view name) {
  return std::ranges::any_of(material_extensions,
                             [&](const auto& each) { return each.name == name; });
}

// Of each extension that is not taken the first place: a file has it in many materials.
void warn_of_others(const GltfObject& material, Model& model) {
  const auto* members = material.member("extensions")->as<Value::Object>();
  if (members == nullptr) return;
  const Place at = material.at().at("extensions");
  for (const auto& [name, value] : *members) {
    if (!name.starts_with("KHR_materials_") || takes_extension(name)) continue;
    const std::string text = excerpt_of(name, longest_name) + " is not taken";
    const bool is_known = std::ranges::any_of(
        model.warnings, [&](const ModelWarning& warning) { return warning.text == text; });
    if (!is_known) model.warn({at.at(name).pointer(), 0, text});
  }
}

void read_extensions(const GltfObject& material, const GltfTextures& textures, ModelMaterial& to) {
  material.with("extensions", [&](const GltfObject& all) {
    for (const MaterialExtension& each : material_extensions)
      all.with(each.name, [&](const GltfObject& from) { each.read(from, textures, to); });
    warn_of_others(material, textures.model());
  });
}

ModelMaterial read_material(const GltfObject& from, const GltfTextures& textures) {
  ModelMaterial to = gltf_material();
  to.name = from.text("name");
  from.with("pbrMetallicRoughness",
            [&](const GltfObject& pbr) { read_metallic_roughness(pbr, textures, to); });
  to.normal_texture = textures.use(from, "normalTexture", normal_scale);
  to.occlusion_texture = textures.use(from, "occlusionTexture", occlusion_strength);
  to.emissive_texture = textures.use(from, "emissiveTexture");
  to.emissive = from.color_or("emissiveFactor", {});
  read_alpha(from, to);
  to.double_sided = from.flag("doubleSided", false);
  read_extensions(from, textures, to);
  return to;
}

}  // namespace

void read_materials(const GltfSource& source, Model& model) {
  const GltfTextures textures(source, model);
  source.root.for_each("materials", [&](const GltfObject& material, std::size_t) {
    model.materials.push_back(read_material(material, textures));
  });
}

}  // namespace tia::gltf
