// Ambient occlusion: how much of the sky over a surface is free.
#include "core/integrators/integrator.h"
#include "core/math/sobol.h"
#include "core/math/unit_lanes.h"
#include "core/math/warp.h"

namespace tia {

// (1 / pi) times the integral of V(wi) n.wi over the upper hemisphere, V = 0 where something is
// nearer than the radius: one ray a sample. 1 where nothing is hit. A direction below the geometric
// horizon, which an interpolated normal may have, meets the surface itself.
// Source: Zhukov, Iones, Kronin, "An ambient light illumination model" (1998), with V for their
// fall-off.
template <>
template <class Real>
Vec3<Real> Integrator<IntegratorName::ambient_occlusion>::radiance(
    WorldView& world_view, const Ray<Real>& ray, Mask<Real> active,
    const SamplerState<Real>& sampler_state) {
  const Hit<Real> hit = first_hit(world_view, ray, active);
  const auto isect = surfaces(world_view, ray, hit, active);
  if (world_view.guides != nullptr) world_view.guides->take(isect, hit.t, false);
  if (!any(isect.here)) return {Real(1), Real(1), Real(1)};
  constexpr std::uint32_t block = 0x40000000;  // of dimensions: no other integrator's
  const auto words =
      sobol_words(sampler_state.x, sampler_state.y, sampler_state.sample, block, sampler_state.key);
  const Vec3<Real> wi =
      square_to_cosine_hemisphere(isect.at.n, unit_lanes<Real>(words.a), unit_lanes<Real>(words.b));
  const Mask<Real> upper = isect.here && dot(isect.at.ng, wi) > Real(0);
  world_view.rays.shadow += count(upper);
  const Real radius = lift<Real>(world_view.rules.ao_radius);
  const Real passing = world_view.passing(isect.shadow_ray(wi), radius, {}, upper);
  const Real seen = select(isect.here, select(upper, passing, Real(0)), Real(1));
  return {seen, seen, seen};
}

TIA_INTEGRATOR(ambient_occlusion)

}  // namespace tia
