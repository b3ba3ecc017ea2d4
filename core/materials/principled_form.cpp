#include "core/materials/principled_form.h"

#include <algorithm>

#include "core/materials/microfacet.h"
#include "core/materials/sheen.h"

namespace tia {

std::size_t heap_bytes(const PrincipledForm& form) {
  std::size_t bytes = heap_bytes(form.textured);
  for (const PrincipledForm::Textured& each : form.textured)
    bytes +=
        std::visit([](const auto& kind) { return heap_bytes(kind); }, each.texture.texture.kind);
  return bytes;
}

bool wants_uv(const PrincipledForm& form) {
  return form.maps || std::any_of(form.textured.begin(), form.textured.end(), [](const auto& each) {
           return std::holds_alternative<ImageForm>(each.texture.texture.kind);
         });
}

PrincipledNumbers numbers_at(const PrincipledForm& form, TextureReader& reader) {
  const TexturePoint& at = reader.at();
  PrincipledNumbers numbers = form.numbers;
  for (const auto& [number, texture] : form.textured)
    numbers.*number = number_at(texture, at.p, at.uv[0], at.blur);
  if (form.maps) multiply(*form.maps, reader, numbers);
  return numbers;
}

double alpha_at(const PrincipledForm& form, const PrincipledNumbers& at) {
  return opacity_of(form.alpha, at.alpha);
}

namespace {

// What the layer over what is matt reflects straight on.
Vec3d layer_at(const Vec3d& layer, const PrincipledNumbers& at) {
  const auto bounded = [&](double f0, double color) {
    return std::min(f0 * color, 1.0) * at.specular;
  };
  const Vec3d& color = at.specular_color;
  return {bounded(layer.x, color.x), bounded(layer.y, color.y), bounded(layer.z, color.z)};
}

constexpr double least_alpha = static_cast<double>(smooth_alpha);

void set_numbers(BsdfParameters<double>& bsdf, const PrincipledNumbers& at, const Vec3d& layer) {
  bsdf.base = bsdf.base * at.base;
  bsdf.tint = bsdf.tint * at.base;
  bsdf.sheen = bsdf.sheen * at.sheen_color;
  bsdf.metal = at.metallic;
  bsdf.glass = (1 - at.metallic) * at.transmission;
  bsdf.matt = (1 - at.metallic) * (1 - at.transmission);
  bsdf.f0 = layer_at(layer, at);
  bsdf.f90 = at.specular;
  const double alpha = at.roughness * at.roughness;
  bsdf.alpha_x = alpha + (1 - alpha) * at.anisotropy * at.anisotropy;
  // What is stretched is never smooth, though it be so across its lines, which are of some width:
  // glTF (KHR_materials_anisotropy) would have a light's reflection without any. pbrt-v4 keeps the
  // smaller alpha from 0, too, where the larger one is not (TrowbridgeReitzDistribution).
  bsdf.alpha_y = bsdf.alpha_x < least_alpha ? alpha : std::max(alpha, least_alpha);
  bsdf.coat = at.clearcoat;
  bsdf.coat_alpha = at.clearcoat_roughness * at.clearcoat_roughness;
  bsdf.sheen_alpha =
      std::max(at.sheen_roughness * at.sheen_roughness, static_cast<double>(least_sheen));
}

}  // namespace

// In whitted a metal is a mirror as far as it is smooth, without a colour, and else matt.
VaryingShading varying_at(const PrincipledForm& form, const PrincipledNumbers& at) {
  const double matt = (1 - at.metallic) * (1 - at.transmission);
  return {form.base * at.base * (matt + at.metallic * at.roughness),
          form.rest.ambient.exact * form.base * at.base * at.occlusion,
          form.rest.emission.exact * at.emissive,
          at.metallic * (1 - at.roughness),
          (1 - at.metallic) * at.transmission,
          alpha_at(form, at)};
}

BsdfParameters<double> bsdf_at(const PrincipledForm& form, const PrincipledNumbers& at) {
  BsdfParameters<double> bsdf = form.rest.bsdf;
  set_numbers(bsdf, at, form.layer);
  return bsdf;
}

ShadingParameters shading_at(const PrincipledForm& form, const PrincipledNumbers& at) {
  ShadingParameters shading = form.rest;
  const VaryingShading own = varying_at(form, at);
  shading.bsdf = bsdf_at(form, at);
  shading.albedo = own.albedo, shading.ambient = own.ambient, shading.emission = own.emission;
  shading.reflection = own.reflection, shading.transmission = own.transmission;
  shading.opacity = own.opacity;
  return shading;
}

}  // namespace tia
