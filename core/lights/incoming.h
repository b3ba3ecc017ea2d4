// What a light sends to a point, and what the kinds of lights have in common.
#pragma once

#include <concepts>

#include "core/math/wide.h"

namespace tia {

/// Incoming: light that a point gets from one place of a light, if nothing stands between.
/// Space/units: world space; `wi` is unit, towards the light; `distance` to it is infinite where
/// the light is; `strength` is the kind's own factor on its colour, 0 .. 1.
template <class Real>
struct Incoming {
  Vec3<Real> wi;
  Real distance, strength;
};

/// From a place of the light, all of it.
template <class Real>
Incoming<Real> incoming_from(const Vec3<Real>& place, const Vec3<Real>& p) {
  const Vec3<Real> to_light = place - p;
  const Real distance = length(to_light);
  return {to_light * (Real(1) / distance), distance, Real(1)};
}

/// LitForm: a light made ready: `incoming(form, p)` from its middle.
template <class Form>
concept LitForm = requires(const Form& form, const Vec3<Wide>& p) {
  { incoming(form, p) } -> std::same_as<Incoming<Wide>>;
};
/// One with an area: `incoming(form, p, u, v)` from the place of its visible area that a point of
/// the unit square stands for; equal areas of the square for equal shares of the light.
template <class Form>
concept AreaForm = LitForm<Form> && requires(const Form& form, const Vec3<Wide>& p, const Wide& u) {
  { incoming(form, p, u, u) } -> std::same_as<Incoming<Wide>>;
};

}  // namespace tia
