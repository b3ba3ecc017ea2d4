// What the surfaces of a packet do with light besides scattering it, each lane its own.
#pragma once

#include <utility>

#include "core/integrators/direct.h"

namespace tia {

/// Finishes. Colours are linear RGB, shares of light 0 .. 1.
template <class Real>
struct Finishes {
  Vec3<Real> ambient{};  ///< light that it sends back of what comes from everywhere, untextured
  Gloss<Real> gloss{};
  Real reflection{}, transmission{};
  Mask<Real> fresnel{};
  Medium<Real> inside{};
  Real object{};  ///< the number of its object

  /// Lanes outside `here` keep what they have, unless it is the first.
  void take(const ShadingParameters& shading, int number, Mask<Real> here, bool first) {
    const auto put = [&](auto& to, const auto& from) {
      to = first ? from : select(here, from, to);
    };
    const auto into = [&](Real& to, double from) { put(to, lift<Real>(from)); };
    put(ambient, lift<Real>(shading.ambient));
    into(gloss.brilliance, shading.brilliance);
    into(gloss.specular, shading.specular);
    into(gloss.exponent, shading.exponent);
    into(reflection, shading.reflection);
    into(transmission, shading.transmission);
    if (shading.fresnel) fresnel = fresnel || here;
    into(inside.ior, shading.ior);
    put(inside.absorption, lift<Real>(shading.absorption));
    into(object, number);
  }
};

template <class Real>
Finishes<Real> finishes(const World& world, const Hit<Real>& hit, Mask<Real> active) {
  Finishes<Real> all;
  bool first = true;
  for_each_winner(hit, active, [&](int primitive, Mask<Real> here) {
    all.take(world.shading_of(primitive), world.primitive(primitive).object, here,
             std::exchange(first, false));
  });
  return all;
}

/// SpecularSplit: where light goes on from a surface, and how much of it.
template <class Real>
struct SpecularSplit {
  Real mirror = Real(0), glass = Real(0);  ///< the shares of either way
  Refraction<Real> bent{};                 ///< the way through the glass
  Medium<Real> behind{};                   ///< what that leads into
};

/// Domain: unit direction and n, direction.n <= 0; `front`: where the ray comes from outside.
/// Source: the slides; with Fresnel's equations in the place of T where a finish says so.
template <class Real>
SpecularSplit<Real> split_specular(const Vec3<Real>& direction, const Vec3<Real>& n,
                                   const Real& instance, Mask<Real> here, Mask<Real> front,
                                   const Finishes<Real>& finish, const Interface<Real>* through) {
  const Real zero(0), one(1);
  SpecularSplit<Real> split;
  split.mirror = select(here, (one - finish.transmission) * finish.reflection, zero);
  const Mask<Real> glass = here && finish.transmission > zero;
  if (!any(glass)) return split;
  const Medium<Real>& inside = finish.inside;
  const auto outside = medium_around(through, glass, !front, finish.object, instance);
  const Real before = select(front, outside.ior, inside.ior);
  split.behind = {select(front, inside.ior, outside.ior),
                  select(front, inside.absorption, outside.absorption)};
  split.bent = refracted(direction, n, before / split.behind.ior);
  const Real mirrored = select(finish.fresnel, fresnel(before, split.behind.ior, split.bent),
                               select(split.bent.total, one, zero));
  split.mirror = split.mirror + select(glass, finish.transmission * mirrored, zero);
  split.glass = select(glass, finish.transmission * (one - mirrored), zero);
  return split;
}

}  // namespace tia
