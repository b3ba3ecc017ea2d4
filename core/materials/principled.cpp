#include "core/materials/principled.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/input/codec.h"
#include "core/math/deterministic.h"

namespace tia {
namespace {

// Indices n + ik at 650, 550 and 450 nm, as refractiveindex.info interpolates the measurements of
// Johnson and Christy, Phys. Rev. B 6 (1972) and 9 (1974), and for aluminium of Rakic, Appl. Opt.
// 34 (1995).
struct Indices {
  Vec3d n, k;
};
constexpr std::array<Indices, Names<Metal>::names.size()> indices{{
    {{0.18299, 0.42108, 1.3734}, {3.4242, 2.3459, 1.7704}},
    {{0.27105, 0.67693, 1.3164}, {3.6092, 2.6247, 2.2921}},
    {{0.15943, 0.14512, 0.13547}, {3.9291, 3.1900, 2.3808}},
    {{1.3456, 0.96521, 0.61722}, {7.4746, 6.3995, 5.3031}},
    {{2.9114, 2.9497, 2.5845}, {3.0893, 2.9318, 2.7670}},
    {{2.7407, 2.5418, 2.2670}, {3.8143, 3.4345, 3.0385}},
}};
// What it reflects straight on. Source: Born, Wolf, "Principles of Optics", 14.2 (19).
Vec3d rgb_of(Metal metal) {
  const Indices& at = indices[static_cast<std::size_t>(metal)];
  const auto share = [](double n, double k) {
    return ((n - 1) * (n - 1) + k * k) / ((n + 1) * (n + 1) + k * k);
  };
  return {share(at.n.x, at.k.x), share(at.n.y, at.k.y), share(at.n.z, at.k.z)};
}

Vec3d rgb_of(const BaseColor& color) {
  if (const auto* metal = std::get_if<Metal>(&color)) return rgb_of(*metal);
  return tia::rgb_of(std::get<Color>(color));
}

// What its numbers have no say in.
BsdfParameters<double> bsdf_of(const Principled& p, const Vec3d& base) {
  BsdfParameters<double> bsdf;
  bsdf.base = bsdf.tint = base;
  bsdf.tinted = true;
  bsdf.ior = p.ior;
  bsdf.dispersion = p.dispersion;
  bsdf.fresnel = true;
  bsdf.thin = p.thin;
  bsdf.grain_cos = cos_of(p.anisotropy_rotation);
  bsdf.grain_sin = sin_of(p.anisotropy_rotation);
  bsdf.coat_f0 = 0.04, bsdf.coat_f90 = 1;
  bsdf.covers = true;
  bsdf.sheen = tia::rgb_of(p.sheen_color);
  return bsdf;
}

// What the layer over what is matt reflects straight on, before it is bounded by 1.
Vec3d layer_of(const Principled& p) {
  const double f0 = (p.ior - 1) * (p.ior - 1) / ((p.ior + 1) * (p.ior + 1));
  return tia::rgb_of(p.specular_color) * f0;
}

bool is_zero(const NumberOrTexture& number) {
  const auto* everywhere = std::get_if<double>(&number);
  return everywhere != nullptr && *everywhere == 0;
}
// Whether rays may go straight on somewhere.
bool may_be_passed(const Principled& p, const PrincipledForm& form) {
  const bool textured = std::get_if<double>(&p.alpha) == nullptr || p.maps;
  return textured ? p.alpha_mode != AlphaMode::opaque : alpha_at(form, form.numbers) < 1;
}

// What a unit of length absorbs where `color` is left after `distance`.
Vec3d absorption_of(const Vec3d& color, double distance) {
  const auto one = [&](double left) { return -log_of(std::max(left, 1e-30)) / distance; };
  return {one(color.x), one(color.y), one(color.z)};
}

}  // namespace

void Codec<BaseColor>::read(const Value& v, const Place& at, const Spec& spec, Faults& faults,
                            BaseColor& out) {
  if (v.as<std::string>() != nullptr) return read_value(v, at, spec, faults, out.emplace<Metal>());
  if (v.as<double>() == nullptr && v.as<Value::Array>() == nullptr)
    return detail::wrong_type(v, at, allowed(spec), faults);
  read_value(v, at, spec, faults, out.emplace<Color>());
}
Value Codec<BaseColor>::write(const BaseColor& v) {
  return std::visit([](const auto& is) { return write_value(is); }, v);
}
Value Codec<BaseColor>::schema(const Spec& spec, Definitions& named) {
  return Value::Object{
      {"anyOf", Value::Array{schema_of<Color>(spec, named), schema_of<Metal>(spec, named)}}};
}
std::string Codec<BaseColor>::allowed(const Spec& spec) {
  return Codec<Color>::allowed(spec) + ", or " + Codec<Metal>::allowed(spec);
}

PrincipledForm prepare(const Principled& p, const Vec3d& ambient_light) {
  PrincipledForm form;
  form.base = p.texture ? Vec3d{1, 1, 1} : rgb_of(p.base_color);
  form.layer = layer_of(p);
  form.rest.label = rgb_of(p.base_color);
  form.rest.bsdf = bsdf_of(p, form.base);
  form.rest.ior = p.thin ? 1 : p.ior;
  form.rest.fresnel = true;
  form.rest.ambient = ambient_light * p.ambient;
  form.rest.emission = tia::rgb_of(p.emissive) * p.emissive_strength;
  if (p.attenuation_distance && !p.thin)
    form.rest.absorption = absorption_of(tia::rgb_of(p.attenuation_color), *p.attenuation_distance);
  const auto put = [&](double PrincipledNumbers::*number, const NumberOrTexture& is) {
    if (const auto* everywhere = std::get_if<double>(&is))
      return void(form.numbers.*number = *everywhere);
    const NumberTexture& texture = *std::get<Boxed<NumberTexture>>(is);
    form.numbers.*number = (texture.range[0] + texture.range[1]) / 2;
    form.textured.push_back({number, prepare(texture)});
  };
  using At = PrincipledNumbers;
  put(&At::metallic, p.metallic), put(&At::roughness, p.roughness);
  put(&At::specular, p.specular), put(&At::transmission, p.transmission);
  put(&At::clearcoat, p.clearcoat), put(&At::clearcoat_roughness, p.clearcoat_roughness);
  put(&At::sheen_roughness, p.sheen_roughness), put(&At::anisotropy, p.anisotropy);
  put(&At::alpha, p.alpha);
  form.maps = p.maps;
  form.alpha = {p.alpha_mode, p.alpha_cutoff};
  form.rest.see_through = may_be_passed(p, form);
  form.rest.one_sided = !p.double_sided && is_zero(p.transmission);
  return form;
}

ShadingParameters shading_of(const Principled& p, const Vec3d& ambient_light) {
  const PrincipledForm form = prepare(p, ambient_light);
  return shading_at(form, form.numbers);
}

}  // namespace tia
