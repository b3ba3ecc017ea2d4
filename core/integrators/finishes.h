// What the surfaces that a packet has hit do with light besides scattering it, lane by lane.
#pragma once

#include <utility>

#include "core/integrators/direct.h"

namespace tia {

/// Finishes. Colours are linear RGB, shares of light 0 .. 1.
template <class Real>
struct Finishes {
  Vec3<Real> ambient{};  ///< ambient reflection times the scene's ambient light, untextured
  Phong<Real> phong{};
  Real reflection{}, transmission{};
  Mask<Real> fresnel{};
  Medium<Real> inside{};
  Real object{};  ///< the number of its object

  /// Sets the lanes of `here`. The first call sets all lanes, which spares selecting.
  void take(const ShadingParameters& shading, int number, Mask<Real> here, bool first) {
    const auto put = [&](auto& to, const auto& from) {
      to = first ? from : select(here, from, to);
    };
    const auto into = [&](Real& to, double from) { put(to, lift<Real>(from)); };
    put(ambient, lift<Real>(shading.ambient));
    into(phong.brilliance, shading.brilliance);
    into(phong.specular, shading.specular);
    into(phong.exponent, shading.exponent);
    into(reflection, shading.reflection);
    into(transmission, shading.transmission);
    if (shading.fresnel) fresnel = fresnel || here;
    into(inside.ior, shading.ior);
    put(inside.absorption, lift<Real>(shading.absorption));
    into(object, number);
  }
};

template <class Point, class Real>
Finishes<Real> finishes(const World& world, const Hit<Real>& hit,
                        const SurfaceInteraction<Point, Real>& isect) {
  Finishes<Real> all;
  bool first = true;
  const auto take = [&](const ShadingParameters& shading, int primitive, Mask<Real> here) {
    all.take(shading, world.primitive(primitive).object, here, std::exchange(first, false));
  };
  const auto own = [&](const PrincipledForm& form, const PrincipledNumbers& at, int i) {
    const VaryingShading of = varying_at(form, at);
    put_lane(all.ambient, i, of.ambient);
    put_lane(all.reflection, i, of.reflection), put_lane(all.transmission, i, of.transmission);
  };
  for_each_shading(world, hit, isect.textures.numbers, isect.here, take, own);
  return all;
}

/// The share of the rays that each lane's surface stops.
template <class Point, class Real>
Real opacities(const World& world, const Hit<Real>& hit,
               const SurfaceInteraction<Point, Real>& isect) {
  Real opacity(1);
  for_each_shading(
      world, hit, isect.textures.numbers, isect.here,
      [&](const ShadingParameters& shading, int, Mask<Real> here) {
        opacity = select(here, lift<Real>(shading.opacity), opacity);
      },
      [&](const PrincipledForm& form, const PrincipledNumbers& at, int i) {
        put_lane(opacity, i, alpha_at(form, at));
      });
  return opacity;
}

/// SpecularSplit: how light divides at a surface between the reflected and the refracted ray.
template <class Real>
struct SpecularSplit {
  Real reflection = Real(0), refraction = Real(0);  ///< the weights of the two rays
  Refraction<Real> refracted{};                     ///< the refracted ray
  Medium<Real> medium_t{};                          ///< the medium that it goes on in
};

/// Domain: unit direction and n, direction.n <= 0; `front`: where the ray comes from outside of the
/// object; `transitions`: the surfaces that it has passed through before.
/// Source: the slides; where a finish says `fresnel`, Fresnel's equations in addition.
template <class Real>
SpecularSplit<Real> split_specular(const Vec3<Real>& direction, const Vec3<Real>& n,
                                   const Real& instance, Mask<Real> here, Mask<Real> front,
                                   const Finishes<Real>& finish,
                                   const MediumTransition<Real>* transitions) {
  const Real zero(0), one(1);
  SpecularSplit<Real> split;
  split.reflection = select(here, (one - finish.transmission) * finish.reflection, zero);
  const Mask<Real> transmits = here && finish.transmission > zero;
  if (!any(transmits)) return split;
  const Medium<Real>& inside = finish.inside;
  const auto outside = medium_around(transitions, transmits, !front, finish.object, instance);
  const Real eta_i = select(front, outside.ior, inside.ior);
  const Real eta_t = select(front, inside.ior, outside.ior);
  split.medium_t = {eta_t, select(front, inside.absorption, outside.absorption)};
  split.refracted = refract(direction, n, eta_i / eta_t);
  const Real reflected = select(finish.fresnel, fr_dielectric(eta_i, eta_t, split.refracted),
                                select(split.refracted.total, one, zero));
  split.reflection = split.reflection + select(transmits, finish.transmission * reflected, zero);
  split.refraction = select(transmits, finish.transmission * (one - reflected), zero);
  return split;
}

}  // namespace tia
