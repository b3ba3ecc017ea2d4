// LightSample: what a light sends to a point, and what the forms of lights have in common.
#pragma once

#include <concepts>

#include "core/math/wide.h"

namespace tia {

/// LightSample: light that comes to a point p from one point of a light, if nothing is between
/// them. It is pbrt's LightLiSample without a density, for samples have equal shares of the light.
/// Space/units: world space; `wi` is unit, from p to the light; `distance` is infinite for a light
/// that is infinitely far; `strength`, 0 .. 1, is a factor on the light's colour.
template <class Real>
struct LightSample {
  Vec3<Real> wi;
  Real distance, strength;
};

/// What a point light at `position` sends to p: all of its light.
template <class Real>
LightSample<Real> sample_from(const Vec3<Real>& position, const Vec3<Real>& p) {
  const Vec3<Real> to_light = position - p;
  const Real distance = length(to_light);
  return {to_light * (Real(1) / distance), distance, Real(1)};
}

/// A form whose light comes from one point, its `middle`, with strength 1 in every direction; that
/// of a light with an area does so where the area is reduced to its middle. Its sample follows.
template <class Form>
concept ShinesFromPoint = requires(const Form& form) {
  { form.middle } -> std::same_as<const Constant&>;
};
/// A form with a sample_li(form, p) of its own.
template <class Form>
concept SamplesLi = requires(const Form& form, const Vec3<Wide>& p) {
  { sample_li(form, p) } -> std::same_as<LightSample<Wide>>;
};
/// A form with an area: `sample_li(form, p, u, v)` is the sample for a point (u, v) of the unit
/// square. Equal areas of the square have equal shares of the light that p gets.
template <class Form>
concept SamplesArea = requires(const Form& form, const Vec3<Wide>& p, const Wide& u) {
  { sample_li(form, p, u, u) } -> std::same_as<LightSample<Wide>>;
};
/// `pdf_li(form, p, wi, distance)` is the density with which that sample comes from wi, where the
/// area is at that distance, by solid angle; 0 where none does.
template <class Form>
concept HasDensity = requires(const Form& form, const Vec3<Wide>& p, const Wide& distance) {
  { pdf_li(form, p, p, distance) } -> std::same_as<Wide>;
};

/// LitForm: a light made ready. It has either a middle or a sample_li(form, p). With both, the two
/// could contradict each other, so it is none. One with an area tells its density.
template <class Form>
concept LitForm = (ShinesFromPoint<Form> != SamplesLi<Form>)&&(SamplesArea<Form> ==
                                                               HasDensity<Form>);
/// AreaForm: one with an area.
template <class Form>
concept AreaForm = LitForm<Form> && SamplesArea<Form>;

/// AreaForm infinitely far away: a disc in the sky. `strength_of(form, wi)` is the strength of what
/// comes from a direction within it.
template <class Form>
concept EndlessForm = AreaForm<Form> && requires(const Form& form, const Vec3<Wide>& wi) {
  { strength_of(form, wi) } -> std::same_as<Wide>;
};

/// The radiance of an area over its light's colour: 1, or what the form says.
template <class Form>
double brightness_of(const Form& form) {
  if constexpr (requires { form.brightness(); }) return form.brightness();
  else return 1;
}

/// The sample of a light without an area, or at the middle of one that has an area.
template <class Real, LitForm Form>
LightSample<Real> sample_middle(const Form& form, const Vec3<Real>& p) {
  if constexpr (ShinesFromPoint<Form>) return sample_from(lift<Real>(form.middle), p);
  else return sample_li(form, p);
}

}  // namespace tia
