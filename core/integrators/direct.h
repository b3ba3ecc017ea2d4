// Light that comes to a point straight from a lamp.
#pragma once

#include "core/integrators/optics.h"
#include "core/integrators/scope.h"
#include "core/math/powers.h"

namespace tia {

/// Gloss: what shading a point by a lamp needs of its finish.
template <class Real>
struct Gloss {
  Real brilliance = Real(1), specular = Real(0), exponent = Real(20);
};

/// Direct: what a point makes of a lamp's light, of one place's or averaged over those that shine.
template <class Real>
struct Direct {
  Real diffuse = Real(0);   ///< of visible light: (n.l)^brilliance
  Real specular = Real(0);  ///< specular * (r.l)^exponent
  Real visible = Real(0);   ///< the share of the places that the point sees, none below its horizon
};

/// LampLight: all of a lamp's light at a point, faded.
template <class Real>
struct LampLight : Direct<Real> {
  Incoming<Real> middle;  ///< what comes in from the lamp's middle
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
Real fade(const Lamp& lamp, const Real& distance) {
  const Real share = distance / lift<Real>(lamp.fade_distance);
  return Real(2) / (Real(1) + pow_of(share, lift<Real>(lamp.fade_power)));
}

/// What is dark stays so, even at a distance that float cannot tell.
template <class Real>
Real faded(const Real& light, const Real& share) {
  return select(light > Real(0), light * share, Real(0));
}

/// The i-th of the lamp's places: evenly spread over its visible area, at random in each stratum.
template <class Real>
Incoming<Real> from_area(const Lamp& lamp, int number, int i, const Vec3<Real>& p,
                         const Path<Real>& path) {
  constexpr auto n = static_cast<std::size_t>(lanes<Real>);
  constexpr std::uint32_t of_lights = 0x80000000;  // no other dimension is so high
  RandomWords<n> words;
  words.a = path.draws.x;
  words.b = path.draws.y;
  words.c.fill(path.draws.sample);
  words.d.fill(of_lights | (path.node * 0x01000193U ^ static_cast<std::uint32_t>(number) << 13U ^
                            static_cast<std::uint32_t>(i)));
  philox(words, path.draws.key);
  const Strata::Cell& cell = (*lamp.places)[static_cast<std::uint32_t>(i)];
  std::array<LaneOf<Real>, n> u, v;
  for (std::size_t k = 0; k < n; ++k) {
    u[k] = cell.x + cell.width * unit_float(words.a[k]);
    v[k] = cell.y + cell.height * unit_float(words.b[k]);
  }
  const Real at_u = load<Real>(u.data()), at_v = load<Real>(v.data());
  return std::visit(
      [&]<class Form>(const Form& form) -> Incoming<Real> {
        if constexpr (AreaForm<Form>) return incoming(form, p, at_u, at_v);
        else return incoming(form, p);
      },
      lamp.form);
}

/// One place's light, not faded. Lanes outside `here` cast no shadow rays.
template <class Scope, class Point, class Real>
Direct<Real> from_place(Scope& scope, const Lamp& lamp, const Incoming<Real>& from,
                        const Seen<Point, Real>& seen, const Vec3<Real>& direction,
                        const Gloss<Real>& gloss) {
  if constexpr (!Scope::plain) scope.work.test();  // a lamp below the horizon takes time, too
  const Real n_dot_l = dot(seen.at.n, from.way);
  // Infinite or NaN where the lamp is nearer than float can tell.
  const Mask<Real> lit = seen.here && n_dot_l > Real(0) && n_dot_l < Real(infinity);
  if (!any(lit)) return {};
  scope.rays.shadow += count(lit);
  const Real visible = scope.visible(seen.shadow_ray(from.way), from.distance, lamp, lit);
  Direct<Real> light;
  light.visible = select(lit, visible, Real(0));
  const Real strength = visible * from.strength;
  if constexpr (Scope::plain) {
    light.diffuse = select(lit, strength * n_dot_l, Real(0));
  } else {
    light.diffuse = select(lit, strength * raised(n_dot_l, gloss.brilliance, lit), Real(0));
    const Mask<Real> shines = lit && strength > Real(0);
    if (any(shines && gloss.specular > Real(0))) {
      const Real r_dot_l = dot(mirrored(direction, seen.at.n), from.way);
      const Mask<Real> shiny = shines && r_dot_l > Real(0);
      light.specular = select(
          shiny, strength * (gloss.specular * raised(r_dot_l, gloss.exponent, shiny)), Real(0));
    }
  }
  return light;
}

/// The mean of the places that shine, not faded.
template <class Point, class Real>
Direct<Real> from_places(WorldScope& scope, int number, const Incoming<Real>& middle,
                         const Seen<Point, Real>& seen, const Vec3<Real>& direction,
                         const Gloss<Real>& gloss, const Path<Real>& path) {
  const Lamp& lamp = scope.world.lamps[static_cast<std::size_t>(number)];
  if (!scope.rules.areas || !lamp.places)
    return from_place(scope, lamp, middle, seen, direction, gloss);
  Direct<Real> sum;
  const int places = lamp.places->count();
  for (int i = 0; i < places; ++i) {
    const Incoming<Real> from = from_area(lamp, number, i, seen.at.p, path);
    const Direct<Real> one = from_place(scope, lamp, from, seen, direction, gloss);
    sum.diffuse = sum.diffuse + one.diffuse;
    sum.specular = sum.specular + one.specular;
    sum.visible = sum.visible + one.visible;
  }
  const Real share(1 / static_cast<float>(places));
  return {sum.diffuse * share, sum.specular * share, sum.visible * share};
}

/// All of a lamp's light; `number` tells the lamp from the scene's others. In a plain scope it has
/// one place and does not fade.
template <class Scope, class Point, class Real>
auto from_lamp(Scope& scope, int number, const Seen<Point, Real>& seen, const Vec3<Real>& direction,
               const Gloss<Real>& gloss, const Path<Real>& path) {
  const Lamp& lamp = scope.world.lamps[static_cast<std::size_t>(number)];
  if constexpr (Scope::plain) {
    return from_place(scope, lamp, scope.from_middle(lamp, seen.at.p), seen, direction, gloss);
  } else {
    const Incoming<Real> middle = scope.from_middle(lamp, seen.at.p);
    LampLight<Real> light{from_places(scope, number, middle, seen, direction, gloss, path), middle};
    if (lamp.fade_distance > 0) {
      light.fade = fade(lamp, middle.distance);
      light.diffuse = faded(light.diffuse, light.fade);
      light.specular = faded(light.specular, light.fade);
    }
    return light;
  }
}

}  // namespace tia
