// Materials at random, of the kinds that a scene can say, and what they scatter.
#pragma once

#include <gtest/gtest.h>

#include <functional>

#include "core/materials/bsdf.h"
#include "core/materials/material.h"
#include "core/math/lanes.h"
#include "core/math/sobol.h"
#include "tests/core/support.h"

namespace tia::test {

inline constexpr int n = lanes<Wide>;

inline Bsdf<Wide> bsdf_of(const BsdfParameters<double>& parameters, const Vec3d& wo, double eta,
                          const LayerFrames<Wide>* frames = nullptr) {
  BsdfParameters<Wide> wide;
  wide.take(parameters, Wide(0) == Wide(0), true);
  const Vec3<Wide> up{Wide(0), Wide(0), Wide(1)};
  return {wide, lift<Wide>(wo), up, up, lift<Wide>(eta), Wide(0) == Wide(0), frames};
}
/// In all lanes a coat of that normal and grain along that direction.
inline LayerFrames<Wide> frames_of(const Vec3d& coat_n, const Vec3d& grain) {
  const Mask<Wide> all = Wide(0) == Wide(0);
  return {lift<Wide>(coat_n), lift<Wide>(grain), all, all};
}
/// Of a coat that leans by 60 degrees at most.
inline LayerFrames<Wide> any_frames(Random& random) {
  const double z = random.in(0.5, 1), turn = random.in(0, 1), r = std::sqrt(1 - z * z);
  const Vec3d n{r * std::cos(2 * pi * turn), r * std::sin(2 * pi * turn), z};
  return frames_of(n, random.direction());
}
inline Vec3d direction_at(double z, double turn) {
  const double r = std::sqrt(1 - z * z);
  return {r * std::cos(2 * pi * turn), r * std::sin(2 * pi * turn), z};
}

inline BsdfParameters<double> parameters_of(const Principled& principled) {
  return shading_of(principled, {}).bsdf;
}
inline Principled white(double roughness) {
  Principled p;
  p.roughness = roughness;
  return p;
}
inline Principled any_of(Random& random) {
  Principled p = white(random.in(0.3, 1));
  p.base_color = Color{random.in(0, 1), random.in(0, 1), random.in(0, 1)};
  p.metallic = random.in(0, 1);
  p.transmission = random.in(0, 1);
  p.ior = random.in(1.1, 2.4);
  p.thin = random.in(0, 1) < 0.3;
  p.anisotropy = random.in(0, 1) < 0.7 ? 0 : random.in(0, 0.7);
  p.anisotropy_rotation = random.in(0, 6);
  return p;
}
inline Principled coated(Principled p, Random& random) {
  p.clearcoat = random.in(0, 1);
  p.clearcoat_roughness = random.in(0.2, 1);
  p.sheen_color = {random.in(0, 1), random.in(0, 1), random.in(0, 1)};
  p.sheen_roughness = random.in(0.3, 1);
  return p;
}

// ---- directions drawn --------------------------------------------------------------------------

// Calls to(sample, lane) with samples of a bsdf.
inline void each_sample(const Bsdf<Wide>& bsdf, int count,
                        const std::function<void(const BsdfSample<Wide>&, int)>& to) {
  const std::array<std::uint32_t, 1> origin{0};
  for (int begin = 0; begin < count; begin += n) {
    std::array<float, n> lobe, u, v;
    for (int i = 0; i < n; ++i) {
      const auto at = static_cast<std::size_t>(i);
      const auto words =
          sobol_words(origin, origin, static_cast<std::uint32_t>(begin + i), 7, RandomKey(3));
      lobe[at] = unit_float(words.a[0]), u[at] = unit_float(words.b[0]),
      v[at] = unit_float(words.c[0]);
    }
    const auto sample =
        bsdf.sample(load<Wide>(lobe.data()), load<Wide>(u.data()), load<Wide>(v.data()));
    for (int i = 0; i < n; ++i) to(sample, i);
  }
}
inline bool has(Mask<Wide> mask, int i) { return (bits(mask) >> i & 1U) != 0; }
inline Vec3d lane_of(const Vec3<Wide>& v, int i) {
  return {static_cast<double>(lane(v.x, i)), static_cast<double>(lane(v.y, i)),
          static_cast<double>(lane(v.z, i))};
}
inline Vec3d value_of(const BsdfParameters<double>& parameters, const Vec3d& wo, const Vec3d& wi,
                      double eta) {
  BsdfParameters<double> own = parameters;
  if (wo.z < 0) own.grain_sin = -own.grain_sin;  // as scatterers() has it behind a surface
  const Vec3d side{0, 0, wo.z < 0 ? -1.0 : 1.0};
  return Bsdf<double>(own, wo, side, side, eta, true).value(wi).f_cos * (1 / std::fabs(wi.z));
}

}  // namespace tia::test
