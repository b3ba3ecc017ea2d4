// The light side of paths: one point of one of all lights, and the density of what is drawn so.
#pragma once

#include <array>
#include <cmath>

#include "core/integrators/world_view.h"

namespace tia {

/// LightDraw: what comes to a point from one point of one light, if nothing is between them.
/// Space/units: world space; `light` is a radiance or, where `is_delta`, an irradiance on what
/// faces it; `pdf` is by solid angle, that of choosing the light included, and of choosing alone
/// where `is_delta`.
template <class Real>
struct LightDraw {
  Vec3<Real> wi, light;
  Real distance, pdf;
  bool is_delta = false;
  const WorldLight* from = nullptr;  ///< null: the sky
};

/// PathLights: all that a path asks for light: the world's lights, each as likely as any other, and
/// its skies.
/// Source: Pharr, Jakob, Humphreys, "Physically Based Rendering", 4th ed., 12.6 and 13.2.
template <class Real>
class PathLights {
  using V = Vec3<Real>;

 public:
  explicit PathLights(const World& world)
      : world_(world),
        count_(static_cast<float>(world.lights.size() + world.skies.size())),
        share_(Real(1) / Real(std::max(count_, 1.0F))) {}

  /// Calls f(draw, mask) for what the lanes of `here` ask for, once for each light that some of
  /// them have chosen by `choice`.
  template <class F>
  void draw(const V& p, const Real& choice, const Real& u, const Real& v, Mask<Real> here,
            F f) const {
    if (count_ == 0) return;
    std::array<LaneOf<Real>, static_cast<std::size_t>(lanes<Real>)> each;
    for (std::size_t i = 0; i < each.size(); ++i)
      each[i] = std::floor(static_cast<float>(lane(choice, static_cast<int>(i))) * count_);
    const Real chosen = load<Real>(each.data());
    while (const unsigned lanes_left = bits(here)) {
      const auto number = each[static_cast<std::size_t>(std::countr_zero(lanes_left))];
      const Mask<Real> those = here && chosen == Real(number);
      f(sample(static_cast<std::size_t>(number), p, u, v, those), those);
      here = here && !those;
    }
  }

  /// The density with which draw() asks from `p` for the point that a ray has hit.
  Real pdf(const V& p, const Hit<Real>& hit, const V& at, Mask<Real> here) const {
    Real pdf(0);
    const V to_light = at - p;
    const Real distance = length(to_light);
    const V wi = to_light * (Real(1) / distance);
    for_each_winner(hit, here, [&](int primitive, Mask<Real> those) {
      for (const WorldLight& light : world_.lights) {
        if (light.primitive != primitive) continue;
        const Mask<Real> own = those && hit.instance == Real(static_cast<float>(light.instance));
        pdf = select(own, area_pdf(light, p, wi, distance), pdf);
      }
    });
    return pdf * share_;
  }

  /// Calls f(radiance, pdf, mask) for each thing that rays may find infinitely far away: each sky
  /// and each disc in it, with the density with which draw() asks for the direction.
  template <class F>
  void beyond(const V& wi, Mask<Real> here, F f) const {
    for (const WorldSky& sky : world_.skies)
      f(radiance(sky.form, wi, here) * lift<Real>(sky.color), pdf_sky(sky.form, wi, here) * share_,
        here);
    if (world_.skies.empty()) return;  // discs stand in skies
    for (const WorldLight& light : world_.lights)
      std::visit(
          [&]<class Form>(const Form& form) {
            if constexpr (EndlessForm<Form>) {
              const Real pdf = pdf_li(form, {}, wi, Real(infinity));
              const Mask<Real> those = here && pdf > Real(0);
              const Real scale = strength_of(form, wi) * lift<Real>(brightness_of(form));
              if (any(those)) f(lift<Real>(light.color) * scale, pdf * share_, those);
            }
          },
          light.form);
  }

 private:
  static Real area_pdf(const WorldLight& light, const V& p, const V& wi, const Real& distance) {
    return std::visit(
        [&]<class Form>(const Form& form) -> Real {
          if constexpr (AreaForm<Form>) return pdf_li(form, p, wi, distance);
          else return Real(0);
        },
        light.form);
  }

  LightDraw<Real> sample(std::size_t number, const V& p, const Real& u, const Real& v,
                         Mask<Real> here) const {
    if (number < world_.lights.size()) return sample(world_.lights[number], p, u, v);
    const WorldSky& sky = world_.skies[number - world_.lights.size()];
    const SkySample<Real> at = sample_sky(sky.form, u, v, here);
    const V light = radiance(sky.form, at.wi, here && at.pdf > Real(0)) * lift<Real>(sky.color);
    return {at.wi, light, Real(infinity), at.pdf * share_};
  }
  // Point, spot and directional lights have an intensity and an irradiance, those with an area a
  // radiance. A luminous object's is found by the directions that surfaces draw.
  LightDraw<Real> sample(const WorldLight& light, const V& p, const Real& u, const Real& v) const {
    const V color = lift<Real>(light.color), none{Real(0), Real(0), Real(0)};
    return std::visit(
        [&]<class Form>(const Form& form) -> LightDraw<Real> {
          if constexpr (AreaForm<Form>) {
            const LightSample<Real> at = sample_li(form, p, u, v);
            const Real pdf = pdf_li(form, p, at.wi, at.distance);
            const V radiance = color * (at.strength * lift<Real>(brightness_of(form)));
            return {at.wi, select(pdf > Real(0), radiance, none), at.distance, pdf * share_, false,
                    &light};
          } else {
            const LightSample<Real> at = sample_middle(form, p);
            const Real spread = select(at.distance < Real(infinity),
                                       Real(1) / (at.distance * at.distance), Real(1));
            const V irradiance = light.primitive < 0 ? color * (at.strength * spread) : none;
            return {at.wi, irradiance, at.distance, share_, true, &light};
          }
        },
        light.form);
  }

  const World& world_;
  float count_;  // of lights and skies
  Real share_;   // the chance of each
};

}  // namespace tia
