#include "core/materials/principled.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/input/codec.h"
#include "core/materials/sheen.h"
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

// Source: Khronos, glTF 2.0 (2021), appendix B, and its extensions KHR_materials_*.
BsdfParameters<double> bsdf_of(const Principled& p, const Vec3d& base) {
  BsdfParameters<double> bsdf;
  bsdf.base = bsdf.tint = base;
  bsdf.tinted = true;
  bsdf.metal = p.metallic;
  bsdf.glass = (1 - p.metallic) * p.transmission;
  bsdf.matt = (1 - p.metallic) * (1 - p.transmission);
  bsdf.ior = p.ior;
  bsdf.dispersion = p.dispersion;
  bsdf.fresnel = true;
  bsdf.thin = p.thin;
  const double f0 = (p.ior - 1) * (p.ior - 1) / ((p.ior + 1) * (p.ior + 1));
  const auto layer = [&](double color) { return std::min(f0 * color, 1.0) * p.specular; };
  const Vec3d color = tia::rgb_of(p.specular_color);
  bsdf.f0 = {layer(color.x), layer(color.y), layer(color.z)};
  bsdf.f90 = p.specular;
  const double alpha = p.roughness * p.roughness;
  bsdf.alpha_x = alpha + (1 - alpha) * p.anisotropy * p.anisotropy;
  bsdf.alpha_y = alpha;
  bsdf.grain_cos = cos_of(p.anisotropy_rotation);
  bsdf.grain_sin = sin_of(p.anisotropy_rotation);
  bsdf.coat = p.clearcoat;
  bsdf.coat_f0 = 0.04, bsdf.coat_f90 = 1;
  bsdf.coat_alpha = p.clearcoat_roughness * p.clearcoat_roughness;
  bsdf.covers = true;
  bsdf.sheen = tia::rgb_of(p.sheen_color);
  bsdf.sheen_alpha =
      std::max(p.sheen_roughness * p.sheen_roughness, static_cast<double>(least_sheen));
  return bsdf;
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

// In whitted a metal is a mirror as far as it is smooth, without a colour, and else matt.
ShadingParameters shading_of(const Principled& p, const Vec3d&) {
  const Vec3d base = p.texture ? Vec3d{1, 1, 1} : rgb_of(p.base_color);
  ShadingParameters shading;
  shading.bsdf = bsdf_of(p, base);
  shading.albedo = base * (shading.bsdf.matt + p.metallic * p.roughness);
  shading.reflection = p.metallic * (1 - p.roughness);
  shading.transmission = shading.bsdf.glass;
  shading.ior = p.thin ? 1 : p.ior;
  shading.fresnel = true;
  shading.emission = tia::rgb_of(p.emissive) * p.emissive_strength;
  if (p.attenuation_distance && !p.thin)
    shading.absorption = absorption_of(tia::rgb_of(p.attenuation_color), *p.attenuation_distance);
  return shading;
}

}  // namespace tia
