// The materials of the surfaces that a packet has hit, for path tracing, and what lies behind them.
#pragma once

#include <algorithm>
#include <utility>

#include "core/integrators/media.h"
#include "core/integrators/world_view.h"
#include "core/materials/bsdf.h"

namespace tia {

/// Scatterers: what scatters light, lane by lane, and what fills the bodies that it bounds.
template <class Real>
struct Scatterers {
  BsdfParameters<Real> bsdf{};
  Medium<Real> inside{};
  Real object{};  ///< the number of its object
};

template <class Real>
Scatterers<Real> scatterers(const World& world, const Hit<Real>& hit,
                            const SurfaceInteraction<SurfacePoint<Real>, Real>& isect) {
  Scatterers<Real> all;
  bool first = true;
  const auto take = [&](const ShadingParameters& shading, int primitive, Mask<Real> here) {
    all.bsdf.take(shading.bsdf, here, std::exchange(first, false));
    all.inside.absorption = select(here, lift<Real>(shading.absorption), all.inside.absorption);
    all.object =
        select(here, Real(static_cast<float>(world.primitive(primitive).object)), all.object);
  };
  const auto own = [&](const PrincipledForm& form, const PrincipledNumbers& at, int i) {
    all.bsdf.put(bsdf_at(form, at), i);
  };
  for_each_shading(world, hit, isect.textures.numbers, isect.here, take, own);
  all.inside.ior = all.bsdf.ior;
  // Turned the other way from behind, for the grain is the same lines there.
  all.bsdf.grain_sin = select(isect.at.front, all.bsdf.grain_sin, -all.bsdf.grain_sin);
  if (!isect.tinted) return all;
  const Vec3<Real> white{Real(1), Real(1), Real(1)};
  all.bsdf.base = all.bsdf.base * isect.tint;
  all.bsdf.tint = all.bsdf.tint * select(all.bsdf.tinted, isect.tint, white);
  return all;
}

/// Whether a surface sends on any light.
template <class Real>
Mask<Real> scatters(const World& world, const Hit<Real>& hit,
                    const SurfaceInteraction<SurfacePoint<Real>, Real>& isect) {
  Mask<Real> any{};
  for_each_winner(hit, isect.here, [&](int primitive, Mask<Real> here) {
    const BsdfParameters<double>& bsdf = world.shading_of(primitive).bsdf;
    const double most = std::max({bsdf.base.x, bsdf.base.y, bsdf.base.z});
    if ((bsdf.matt + bsdf.metal) * most + bsdf.mirror + bsdf.glass + bsdf.coat + bsdf.f90 > 0)
      any = any || here;
  });
  return any;
}

/// MediumBoundary: what light that passes through the surfaces comes into.
template <class Real>
struct MediumBoundary {
  Real eta = Real(1);  ///< its index of refraction, over that of where the light comes from
  Medium<Real> medium{};
};

/// `transitions`: the surfaces that the rays have passed through before, from `space` on.
template <class Real>
MediumBoundary<Real> boundary(const Scatterers<Real>& all,
                              const SurfaceInteraction<SurfacePoint<Real>, Real>& isect,
                              const Hit<Real>& hit, const MediumTransition<Real>* transitions,
                              const Medium<Real>& space) {
  const Mask<Real> passes = isect.here && all.bsdf.glass > Real(0), front = isect.at.front;
  if (!any(passes)) return {};
  const Medium<Real> outside =
      medium_around(transitions, passes, !front, all.object, hit.instance, space);
  const Real eta = all.inside.ior / outside.ior;
  const Mask<Real> enters = front && !all.bsdf.thin;
  return {select(front, eta, Real(1) / eta), select(enters, all.inside, outside)};
}

}  // namespace tia
