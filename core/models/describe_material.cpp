#include "core/models/describe_material.h"

#include <array>
#include <string_view>

namespace tia {
namespace {

// What a principled has where nothing is said, in this form.
ModelMaterial plain_principled() {
  ModelMaterial plain;
  plain.base_color = {1, 1, 1};
  plain.thin = false;
  return plain;
}

template <class Member>
struct DescribedMember {
  std::string_view name;
  Member ModelMaterial::*member;
};
using M = ModelMaterial;
constexpr DescribedMember<Color> described_colors[] = {
    {"base_color", &M::base_color},         {"emissive", &M::emissive},
    {"specular_color", &M::specular_color}, {"attenuation_color", &M::attenuation_color},
    {"sheen_color", &M::sheen_color},
};
constexpr DescribedMember<double> described_numbers[] = {
    {"alpha", &M::alpha},
    {"metallic", &M::metallic},
    {"roughness", &M::roughness},
    {"occlusion", &M::occlusion},
    {"emissive_strength", &M::emissive_strength},
    {"alpha_cutoff", &M::alpha_cutoff},
    {"ior", &M::ior},
    {"specular", &M::specular},
    {"transmission", &M::transmission},
    {"clearcoat", &M::clearcoat},
    {"clearcoat_roughness", &M::clearcoat_roughness},
    {"sheen_roughness", &M::sheen_roughness},
    {"anisotropy", &M::anisotropy},
    {"anisotropy_rotation", &M::anisotropy_rotation},
    {"dispersion", &M::dispersion},
};
constexpr DescribedMember<MaybeTexture> described_textures[] = {
    {"base_color_texture", &M::base_color_texture},
    {"metallic_roughness_texture", &M::metallic_roughness_texture},
    {"metallic_texture", &M::metallic_texture},
    {"roughness_texture", &M::roughness_texture},
    {"alpha_texture", &M::alpha_texture},
    {"normal_texture", &M::normal_texture},
    {"occlusion_texture", &M::occlusion_texture},
    {"emissive_texture", &M::emissive_texture},
    {"specular_texture", &M::specular_texture},
    {"specular_color_texture", &M::specular_color_texture},
    {"transmission_texture", &M::transmission_texture},
    {"clearcoat_texture", &M::clearcoat_texture},
    {"clearcoat_roughness_texture", &M::clearcoat_roughness_texture},
    {"clearcoat_normal_texture", &M::clearcoat_normal_texture},
    {"sheen_color_texture", &M::sheen_color_texture},
    {"sheen_roughness_texture", &M::sheen_roughness_texture},
    {"anisotropy_texture", &M::anisotropy_texture},
};

Value use_value(const TextureUse& use) {
  const TextureUse plain;
  Value::Object out{{"texture", static_cast<double>(use.texture)}};
  const auto put_pair = [&](const char* name, const std::array<double, 2>& pair) {
    out.emplace_back(name, Value::Array{pair[0], pair[1]});
  };
  if (use.uv_set != plain.uv_set) out.emplace_back("uv_set", static_cast<double>(use.uv_set));
  if (use.offset != plain.offset) put_pair("offset", use.offset);
  if (use.rotation != plain.rotation) out.emplace_back("rotation", use.rotation);
  if (use.scale != plain.scale) put_pair("scale", use.scale);
  if (use.strength != plain.strength) out.emplace_back("strength", use.strength);
  return out;
}

void put_flags(const ModelMaterial& is, Value::Object& out) {
  if (is.alpha_mode != AlphaMode::opaque) out.emplace_back("alpha_mode", name_of(is.alpha_mode));
  if (is.attenuation_distance) out.emplace_back("attenuation_distance", *is.attenuation_distance);
  if (is.thin && (is.transmission > 0 || is.transmission_texture)) out.emplace_back("thin", true);
  if (!is.double_sided) out.emplace_back("double_sided", false);
  if (is.unlit) out.emplace_back("unlit", true);
}

}  // namespace

Value material_value(const Model&, const ModelMaterial& material) {
  const ModelMaterial plain = plain_principled();
  Value::Object out;
  if (!material.name.empty()) out.emplace_back("name", material.name);
  out.emplace_back("type", "principled");
  for (const auto& [name, member] : described_colors) {
    const Color& color = material.*member;
    if (color != plain.*member) out.emplace_back(name, Value::Array{color.r, color.g, color.b});
  }
  for (const auto& [name, member] : described_numbers)
    if (material.*member != plain.*member) out.emplace_back(name, material.*member);
  put_flags(material, out);
  for (const auto& [name, member] : described_textures)
    if (material.*member) out.emplace_back(name, use_value(*(material.*member)));
  return out;
}

}  // namespace tia
