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

/// A form whose light comes from one point, its `middle`, all of it to wherever it shines; of one
/// with an area, where that is reduced to its middle. What comes in from it follows from that.
template <class Form>
concept ShinesFromPoint = requires(const Form& form) {
  { form.middle } -> std::same_as<const Constant&>;
};
/// A form that says itself what comes in at p: `incoming(form, p)`.
template <class Form>
concept TellsIncoming = requires(const Form& form, const Vec3<Wide>& p) {
  { incoming(form, p) } -> std::same_as<Incoming<Wide>>;
};
/// LitForm: a light made ready. It has a middle or an incoming(form, p) and never both, so that
/// they cannot contradict one another.
template <class Form>
concept LitForm = (ShinesFromPoint<Form> != TellsIncoming<Form>);

/// What comes in at p from a light without an area, or from the middle of one that has an area.
template <class Real, LitForm Form>
Incoming<Real> incoming_from_middle(const Form& form, const Vec3<Real>& p) {
  if constexpr (ShinesFromPoint<Form>) return incoming_from(lift<Real>(form.middle), p);
  else return incoming(form, p);
}

/// One with an area: `incoming(form, p, u, v)` from the place of its visible area that a point of
/// the unit square stands for; equal areas of the square for equal shares of the light.
template <class Form>
concept AreaForm = LitForm<Form> && requires(const Form& form, const Vec3<Wide>& p, const Wide& u) {
  { incoming(form, p, u, u) } -> std::same_as<Incoming<Wide>>;
};

}  // namespace tia
