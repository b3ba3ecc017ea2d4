// The light side of paths: one point of one of all lights, and the density of what is drawn so.
#pragma once

#include <array>

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
  Blocker own{};    ///< the surface that does not hide it
  int number = -1;  ///< of the light: which of PathLights, or from their size() on which sky
};

template <class Real, class F>
void each_lane(Mask<Real> here, F f) {
  for_each_lane(here, [&](int i) { f(i, static_cast<std::size_t>(i)); });
}
template <class Real>
Vec3d lane_of(const Vec3<Real>& v, int i) {
  return {lane(v.x, i), lane(v.y, i), lane(v.z, i)};
}

/// LightSampling: draws from the world's PathLights and its skies.
/// Source: Pharr, Jakob, Humphreys, "Physically Based Rendering", 4th ed., 12.6 and 13.2.
template <class Real>
class LightSampling {
  using V = Vec3<Real>;
  using Lane = LaneOf<Real>;
  using Lanes = std::array<Lane, static_cast<std::size_t>(lanes<Real>)>;

 public:
  explicit LightSampling(const World& world) : world_(world), lights_(world.path_lights) {}

  /// Calls f(draw, mask) for what the lanes of `here` ask for, once for each light that some of
  /// them have chosen by `choice`. Domain: unit n.
  template <class F>
  void draw(const V& p, const V& n, const Real& choice, const Real& u, const Real& v,
            Mask<Real> here, F f) const {
    if (lights_.empty()) return;
    Lanes light, chance;
    light.fill(-1), chance.fill(0);
    each_lane<Real>(here, [&](int i, std::size_t at) {
      const PathChoice chosen = lights_.choose(lane_of(p, i), lane_of(n, i), tia::lane(choice, i));
      light[at] = static_cast<Lane>(chosen.light), chance[at] = static_cast<Lane>(chosen.chance);
    });
    draw_of(load<Real>(light.data()), load<Real>(chance.data()), p, u, v, here, f);
  }
  /// The same of lights that are chosen already, with the density `share`; -1: none.
  template <class F>
  void draw_of(const Real& chosen, const Real& share, const V& p, const Real& u, const Real& v,
               Mask<Real> here, F f) const {
    here = here && chosen >= Real(0);
    while (const unsigned lanes_left = bits(here)) {
      const auto number = tia::lane(chosen, std::countr_zero(lanes_left));
      const Mask<Real> those = here && chosen == Real(number);
      LightDraw<Real> draw = sample(static_cast<int>(number), share, p, u, v, those);
      draw.number = static_cast<int>(number);
      f(draw, those);
      here = here && !those;
    }
  }

  /// The density with which draw() asks from p for the point that a ray has hit, where a light has
  /// the chance chance_of(light, lane).
  template <class F>
  Real pdf(const V& p, const Hit<Real>& hit, const V& at, Mask<Real> here, F chance_of) const {
    Lanes pdf{};
    each_lane<Real>(here, [&](int i, std::size_t k) {
      const int light = lights_.at(static_cast<int>(tia::lane(hit.primitive, i)),
                                   static_cast<int>(tia::lane(hit.instance, i)),
                                   static_cast<int>(tia::lane(hit.element, i)));
      if (light < 0) return;
      const Vec3d from = lane_of(p, i), way = lane_of(at, i) - from;
      const double distance = length(way);
      pdf[k] = static_cast<Lane>(chance_of(light, i) *
                                 area_pdf(lights_[light], from, way * (1 / distance), distance));
    });
    return load<Real>(pdf.data());
  }

  /// The chance that draw() has for that light, from p where the normal is n.
  double chance(int light, const Vec3d& p, const Vec3d& n) const {
    return lights_.chance(light, p, n);
  }
  /// The chance of each thing infinitely far away.
  Real chance_beyond() const {
    return Real(static_cast<float>(lights_.chance(lights_.size(), {}, {})));
  }
  /// Calls f(radiance, pdf, mask, light) for each thing that rays from p may find infinitely far
  /// away: each sky and each disc in it, with the density with which its direction was asked for,
  /// if it had the chance `share`, and its number as LightDraw has it.
  template <class F>
  void beyond(const V& wi, const Real& share, Mask<Real> here, F f) const {
    if (world_.skies.empty()) return;  // discs stand in skies
    int number = lights_.size();
    for (const WorldSky& sky : world_.skies)
      f(radiance(sky.form, wi, here) * lift<Real>(sky.color), pdf_sky(sky.form, wi, here) * share,
        here, number++);
    for (int i = lights_.first_endless(); i < lights_.size(); ++i)
      if (const auto* sun = std::get_if<SunForm>(&lights_[i].form)) {
        const Real pdf = pdf_li(*sun, {}, wi, Real(infinity));
        const Mask<Real> those = here && pdf > Real(0);
        if (!any(those)) continue;
        const Real scale = strength_of(*sun, wi) * lift<Real>(brightness_of(*sun));
        f(lift<Real>(lights_[i].color) * scale, pdf * share, those, i);
      }
  }

 private:
  static double area_pdf(const PathLight& light, const Vec3d& p, const Vec3d& wi, double distance) {
    return std::visit(
        [&]<class Form>(const Form& form) -> double {
          if constexpr (DrawsByArea<Form>) return pdf_area(form, p, wi, distance);
          else if constexpr (AreaForm<Form>)  // in the scalar in which draw() computes it
            return pdf_li(form, static_cast<Vec3<Lane>>(p), static_cast<Vec3<Lane>>(wi),
                          static_cast<Lane>(distance));
          else return 0;
        },
        light.form);
  }

  LightDraw<Real> sample(int number, const Real& share, const V& p, const Real& u, const Real& v,
                         Mask<Real> here) const {
    if (number < lights_.size()) return sample(lights_[number], share, p, u, v, here);
    const WorldSky& sky = world_.skies[static_cast<std::size_t>(number - lights_.size())];
    const SkySample<Real> at = sample_sky(sky.form, u, v, here);
    const V light = radiance(sky.form, at.wi, here && at.pdf > Real(0)) * lift<Real>(sky.color);
    return {at.wi, light, Real(infinity), at.pdf * share};
  }
  LightDraw<Real> sample(const PathLight& light, const Real& share, const V& p, const Real& u,
                         const Real& v, Mask<Real> here) const {
    const V color = lift<Real>(light.color);
    LightDraw<Real> draw = std::visit(
        [&]<class Form>(const Form& form) -> LightDraw<Real> {
          if constexpr (DrawsFromEight<Form> && lanes<Real> % Octet::size == 0) {
            return sample_eights(form, color, share, p, u, v, here);
          } else if constexpr (DrawsByArea<Form>) {
            return sample_lanes(form, color, share, p, u, v, here);
          } else if constexpr (AreaForm<Form>) {
            const LightSample<Real> at = sample_li(form, p, u, v);
            const Real pdf = pdf_li(form, p, at.wi, at.distance);
            const Real scale = at.strength * lift<Real>(brightness_of(form));
            return {at.wi, lit(color * scale, pdf), at.distance, pdf * share};
          } else {
            const LightSample<Real> at = sample_middle(form, p);
            const Real spread = select(at.distance < Real(infinity),
                                       Real(1) / (at.distance * at.distance), Real(1));
            return {at.wi, color * (at.strength * spread), at.distance, share, true};
          }
        },
        light.form);
    if (light.is_bare) draw.own = {light.primitive, light.instance};
    return draw;
  }
  template <DrawsByArea Form>
  static LightDraw<Real> sample_lanes(const Form& form, const V& color, const Real& share,
                                      const V& p, const Real& u, const Real& v, Mask<Real> here) {
    Lanes x{}, y{}, z{}, distance{}, pdf{};
    each_lane<Real>(here, [&](int i, std::size_t at) {
      const AreaSample one = sample_area(form, lane_of(p, i), tia::lane(u, i), tia::lane(v, i));
      x[at] = static_cast<Lane>(one.wi.x), y[at] = static_cast<Lane>(one.wi.y);
      z[at] = static_cast<Lane>(one.wi.z), distance[at] = static_cast<Lane>(one.distance);
      pdf[at] = static_cast<Lane>(one.pdf);
    });
    const Real density = load<Real>(pdf.data());
    return {{load<Real>(x.data()), load<Real>(y.data()), load<Real>(z.data())},
            lit(color, density),
            load<Real>(distance.data()),
            density * share};
  }
  // The same, eight lanes at a time, those of `here` closed up.
  template <DrawsFromEight Form>
  static LightDraw<Real> sample_eights(const Form& form, const V& color, const Real& share,
                                       const V& p, const Real& u, const Real& v, Mask<Real> here) {
    constexpr auto all = static_cast<std::size_t>(lanes<Real>);
    std::array<std::array<double, all>, 5> in{}, out{};
    std::array<std::size_t, all> place{};
    std::size_t count = 0;
    each_lane<Real>(here, [&](int i, std::size_t at) {
      std::size_t row = 0;
      for (const Real* each : {&p.x, &p.y, &p.z, &u, &v}) in[row++][count] = tia::lane(*each, i);
      place[count++] = at;
    });
    for (std::size_t first = 0; first < count; first += Octet::size) {
      const auto eight = [&](std::size_t row) {
        return Octet::load_unaligned(in[row].data() + first);
      };
      const AreaSamples<Octet> at =
          sample_area(form, Vec3<Octet>{eight(0), eight(1), eight(2)}, eight(3), eight(4));
      std::size_t row = 0;
      for (const Octet* each : {&at.wi.x, &at.wi.y, &at.wi.z, &at.distance, &at.pdf})
        each->store_unaligned(out[row++].data() + first);
    }
    std::array<Lanes, 5> drawn{};
    for (std::size_t row = 0; row < drawn.size(); ++row)
      for (std::size_t i = 0; i < count; ++i) drawn[row][place[i]] = static_cast<Lane>(out[row][i]);
    const auto got = [&](std::size_t row) { return load<Real>(drawn[row].data()); };
    return {{got(0), got(1), got(2)}, lit(color, got(4)), got(3), got(4) * share};
  }
  static V lit(const V& light, const Real& pdf) {
    return select(pdf > Real(0), light, {Real(0), Real(0), Real(0)});
  }

  const World& world_;
  const PathLights& lights_;
};

}  // namespace tia
