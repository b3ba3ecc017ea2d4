// Light that comes to a point straight from a light source.
#pragma once

#include "core/integrators/optics.h"
#include "core/integrators/world_view.h"
#include "core/math/powers.h"

namespace tia {

/// Gloss: what shading a point by a light needs of its finish.
template <class Real>
struct Gloss {
  Real brilliance = Real(1), specular = Real(0), exponent = Real(20);
};

/// Direct: what a point makes of a light's light, of one place's or averaged over those that shine.
template <class Real>
struct Direct {
  Real diffuse = Real(0);   ///< of visible light: (n.l)^brilliance
  Real specular = Real(0);  ///< specular * (r.l)^exponent
  Real visible = Real(0);   ///< the share of the places that the point sees, none below its horizon
};

/// DirectLight: all of a light's light at a point, faded.
template <class Real>
struct DirectLight : Direct<Real> {
  Incoming<Real> middle;  ///< what comes in from the light's middle
  Real fade = Real(1);    ///< by the distance to it, from whichever place the light comes
};

/// base^exponent, the base itself where the exponent is 1.
template <class Real>
Real raised(const Real& base, const Real& exponent, Mask<Real> here) {
  const Mask<Real> bent = here && !(exponent == Real(1));
  if (!any(bent)) return base;
  return select(bent, pow_of(max_of(base, Real(0)), exponent), base);
}

/// The factor of a light's distance. Source: POV-Ray 3.7, fade_distance and fade_power.
template <class Real>
Real fade(const WorldLight& light, const Real& distance) {
  const Real share = distance / lift<Real>(light.fade_distance);
  return Real(2) / (Real(1) + pow_of(share, lift<Real>(light.fade_power)));
}

/// What is dark stays so, even at a distance that float cannot tell.
template <class Real>
Real faded(const Real& light, const Real& share) {
  return select(light > Real(0), light * share, Real(0));
}

/// The i-th of the light's places: evenly spread over its visible area, at random in each stratum.
template <class Real>
Incoming<Real> from_area(const WorldLight& light, int number, int i, const Vec3<Real>& p,
                         const RayPath<Real>& path) {
  constexpr auto n = static_cast<std::size_t>(lanes<Real>);
  constexpr std::uint32_t of_lights = 0x80000000;  // no other dimension is so high
  RandomWords<n> words;
  words.a = path.sampler_state.x;
  words.b = path.sampler_state.y;
  words.c.fill(path.sampler_state.sample);
  words.d.fill(of_lights | (path.node * 0x01000193U ^ static_cast<std::uint32_t>(number) << 13U ^
                            static_cast<std::uint32_t>(i)));
  philox(words, path.sampler_state.key);
  const Strata::Cell& cell = (*light.places)[static_cast<std::uint32_t>(i)];
  std::array<LaneOf<Real>, n> u, v;
  for (std::size_t k = 0; k < n; ++k) {
    u[k] = cell.x + cell.width * unit_float(words.a[k]);
    v[k] = cell.y + cell.height * unit_float(words.b[k]);
  }
  const Real at_u = load<Real>(u.data()), at_v = load<Real>(v.data());
  return std::visit(
      [&]<class Form>(const Form& form) -> Incoming<Real> {
        if constexpr (AreaForm<Form>) return incoming(form, p, at_u, at_v);
        else return incoming_from_middle(form, p);
      },
      light.form);
}

/// One place's light, not faded. Lanes outside `here` cast no shadow rays.
template <class AnyWorldView, class Point, class Real>
Direct<Real> from_place(AnyWorldView& world_view, const WorldLight& light,
                        const Incoming<Real>& from, const SurfaceInteraction<Point, Real>& isect,
                        const Vec3<Real>& direction, const Gloss<Real>& gloss) {
  if constexpr (!AnyWorldView::plain)
    world_view.work.test();  // a light below the horizon takes time, too
  const Real n_dot_l = dot(isect.at.n, from.wi);
  // Infinite or NaN where the light is nearer than float can tell.
  const Mask<Real> lit = isect.here && n_dot_l > Real(0) && n_dot_l < Real(infinity);
  if (!any(lit)) return {};
  world_view.rays.shadow += count(lit);
  const Real visible = world_view.visible(isect.shadow_ray(from.wi), from.distance, light, lit);
  Direct<Real> direct;
  direct.visible = select(lit, visible, Real(0));
  const Real strength = visible * from.strength;
  if constexpr (AnyWorldView::plain) {
    direct.diffuse = select(lit, strength * n_dot_l, Real(0));
  } else {
    direct.diffuse = select(lit, strength * raised(n_dot_l, gloss.brilliance, lit), Real(0));
    const Mask<Real> shines = lit && strength > Real(0);
    if (any(shines && gloss.specular > Real(0))) {
      const Real r_dot_l = dot(mirrored(direction, isect.at.n), from.wi);
      const Mask<Real> shiny = shines && r_dot_l > Real(0);
      direct.specular = select(
          shiny, strength * (gloss.specular * raised(r_dot_l, gloss.exponent, shiny)), Real(0));
    }
  }
  return direct;
}

/// The mean of the places that shine, not faded.
template <class Point, class Real>
Direct<Real> from_places(WorldView& world_view, int number, const Incoming<Real>& middle,
                         const SurfaceInteraction<Point, Real>& isect, const Vec3<Real>& direction,
                         const Gloss<Real>& gloss, const RayPath<Real>& path) {
  const WorldLight& light = world_view.world.lights[static_cast<std::size_t>(number)];
  if (!world_view.rules.areas || !light.places)
    return from_place(world_view, light, middle, isect, direction, gloss);
  Direct<Real> sum;
  const int places = light.places->count();
  for (int i = 0; i < places; ++i) {
    const Incoming<Real> from = from_area(light, number, i, isect.at.p, path);
    const Direct<Real> one = from_place(world_view, light, from, isect, direction, gloss);
    sum.diffuse = sum.diffuse + one.diffuse;
    sum.specular = sum.specular + one.specular;
    sum.visible = sum.visible + one.visible;
  }
  const Real share(1 / static_cast<float>(places));
  return {sum.diffuse * share, sum.specular * share, sum.visible * share};
}

/// All of a light's light; `number` tells the light from the scene's others. In a plain world view
/// it has one place and does not fade.
template <class AnyWorldView, class Point, class Real>
auto from_light(AnyWorldView& world_view, int number, const SurfaceInteraction<Point, Real>& isect,
                const Vec3<Real>& direction, const Gloss<Real>& gloss, const RayPath<Real>& path) {
  const WorldLight& light = world_view.world.lights[static_cast<std::size_t>(number)];
  if constexpr (AnyWorldView::plain) {
    return from_place(world_view, light, world_view.from_middle(light, isect.at.p), isect,
                      direction, gloss);
  } else {
    const Incoming<Real> middle = world_view.from_middle(light, isect.at.p);
    DirectLight<Real> direct{from_places(world_view, number, middle, isect, direction, gloss, path),
                             middle};
    if (light.fade_distance > 0) {
      direct.fade = fade(light, middle.distance);
      direct.diffuse = faded(direct.diffuse, direct.fade);
      direct.specular = faded(direct.specular, direct.fade);
    }
    return direct;
  }
}

}  // namespace tia
