// The materials of the surfaces that a packet has hit, for path tracing, and what lies behind them.
#pragma once

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
  for_each_winner(hit, isect.here, [&](int primitive, Mask<Real> here) {
    const ShadingParameters& shading = world.shading_of(primitive);
    all.bsdf.take(shading.bsdf, here, std::exchange(first, false));
    all.inside.absorption = select(here, lift<Real>(shading.absorption), all.inside.absorption);
    all.object =
        select(here, Real(static_cast<float>(world.primitive(primitive).object)), all.object);
  });
  all.inside.ior = all.bsdf.ior;
  if (!isect.tinted) return all;
  const Vec3<Real> white{Real(1), Real(1), Real(1)};
  all.bsdf.base = all.bsdf.base * isect.tint;
  all.bsdf.tint = all.bsdf.tint * select(all.bsdf.tinted, isect.tint, white);
  return all;
}

/// MediumBoundary: what light that passes through the surfaces comes into.
template <class Real>
struct MediumBoundary {
  Real eta = Real(1);  ///< its index of refraction, over that of where the light comes from
  Vec3<Real> absorption{Real(0), Real(0), Real(0)};
};

/// `transitions`: the surfaces that the rays have passed through before.
template <class Real>
MediumBoundary<Real> boundary(const Scatterers<Real>& all,
                              const SurfaceInteraction<SurfacePoint<Real>, Real>& isect,
                              const Hit<Real>& hit, const MediumTransition<Real>* transitions) {
  const Mask<Real> passes = isect.here && all.bsdf.glass > Real(0), front = isect.at.front;
  if (!any(passes)) return {};
  const Medium<Real> outside = medium_around(transitions, passes, !front, all.object, hit.instance);
  const Real eta = all.inside.ior / outside.ior;
  const Vec3<Real> absorption = select(front, all.inside.absorption, outside.absorption);
  return {select(front, eta, Real(1) / eta), select(all.bsdf.thin, outside.absorption, absorption)};
}

}  // namespace tia
