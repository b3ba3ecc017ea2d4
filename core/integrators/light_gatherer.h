// The light that a path gathers: what it meets by itself, and what is asked for at its vertices.
#pragma once

#include "core/integrators/fog.h"
#include "core/integrators/path_parts.h"
#include "core/integrators/path_record.h"
#include "core/integrators/path_state.h"
#include "core/integrators/phase.h"
#include "core/integrators/scatterers.h"

namespace tia {

/// LightGatherer: adds to the light of a packet's paths, state.light, what comes to the eye by
/// them. What both the path's own direction and a question for light can find is weighted by the
/// power heuristic. Source: Veach, "Robust Monte Carlo methods for light transport simulation"
/// (1997), ch. 9.
template <class Real, class Recorder>
class LightGatherer {
  using V = Vec3<Real>;
  using Surface = SurfaceInteraction<SurfacePoint<Real>, Real>;
  using Numbers = typename PathNumbers<Real>::AtVertex;

 public:
  /// `parts`: where it is told apart, too; may be null.
  LightGatherer(WorldView& world_view, PathState<Real>& state, PathParts<Real>* parts,
                Recorder& recorder)
      : world_view_(world_view),
        state_(state),
        parts_(parts),
        recorder_(recorder),
        lights_(world_view.world),
        fog_(world_view.world, lights_) {}

  // What the ray finds: what is infinitely far, or what the surface sends out by itself.
  void add_emitted(const Ray<Real>& ray, const Hit<Real>& hit, const Surface& isect,
                   const FogSpan<Real>& span, Mask<Real> active) {
    const Real passed = any(span.here) ? span.transmittance(state_.medium.density) : Real(1);
    if (const Mask<Real> missed = active && !isect.here; any(missed)) {
      add_met(missed, lift<Real>(world_view_.world.background) * passed, Real(1),
              GatheredLight::background);
      const Real chance = lights_.chance_beyond() * fog_.times_beyond(state_.fog_vertex);
      lights_.beyond(ray.direction, chance, missed,
                     [&](const V& radiance, const Real& pdf, Mask<Real> here, int light) {
                       const Real weight = drawn_weight(here, [&](auto) { return pdf; });
                       add_met(here, radiance * (weight * passed), weight, light);
                     });
    }
    const Mask<Real> luminous = isect.here && shines(isect.emission);
    if (!any(luminous)) return;
    const Real weight = drawn_weight(luminous, [&](Mask<Real> rivals) {
      return lights_.pdf(state_.from, hit, isect.at.p, rivals, [&](int light, int i) {
        if ((bits(state_.fog_vertex.here) >> i & 1U) != 0)
          return fog_.chance(state_.fog_vertex, light, i);
        return lights_.chance(light, lane_of(state_.from, i), lane_of(state_.from_n, i));
      });
    });
    add_met(luminous, isect.emission * (weight * passed), weight, GatheredLight::own_surface);
  }
  // What one point of one light gives the surface to scatter.
  void add_direct(const Surface& isect, const Bsdf<Real>& bsdf, const MediumBoundary<Real>& behind,
                  const Numbers& numbers) {
    const Mask<Real> here = bsdf.scatters();
    if (!any(here)) return;
    lights_.draw(isect.at.p, isect.at.ng, numbers.light, numbers.light_u, numbers.light_v, here,
                 [&](const LightDraw<Real>& draw, Mask<Real> those) {
                   add_light(draw, isect, bsdf, behind, those);
                 });
  }
  // What one point of one light gives the fog somewhere along the ray to scatter.
  void add_scattered(const Ray<Real>& ray, const FogSpan<Real>& span,
                     const typename PathNumbers<Real>::InFog& draws) {
    const WorldFog& fog = world_view_.world.fog;
    fog_.draw(ray, span, draws, span.here,
              [&](const auto& meeting, const LightDraw<Real>& draw, Mask<Real> here) {
                world_view_.work.test();
                const Real density = lift<Real>(fog.density);
                const Real phase = phase_.value(dot(ray.direction, draw.wi));
                const V p = ray.origin + ray.direction * meeting.t;
                if constexpr (Recorder::records) recorder_.asked(asked_in_fog(draw, p, phase));
                const V scattered = lift<Real>(fog.albedo) * draw.light * (meeting.met * phase);
                const Mask<Real> lit = here && shines(scattered) && is_finite(scattered);
                if (!any(lit)) return;
                const Real passing = passing_to(draw, p, {p, draw.wi}, Real(0), lit);
                const Real weight = asked_weight(draw, meeting.flown * phase);
                add_asked(lit && passing > Real(0),
                          scattered * (weight * fog_between(p, draw, density) * passing),
                          {weight, draw.pdf, passing});
              });
  }
  const FogSampling<Real>& fog() const { return fog_; }
  const HenyeyGreenstein<Real>& phase() const { return phase_; }

 private:
  // What is told of light that was asked for.
  struct Asked {
    Real weight, pdf, passing;
  };

  V add(Mask<Real> here, const V& radiance) {
    const V none{Real(0), Real(0), Real(0)}, light = select(here, state_.beta * radiance, none);
    state_.light = state_.light + light;
    return light;
  }
  void add_met(Mask<Real> here, const V& radiance, const Real& weight, int source) {
    const V light = add(here, radiance);
    if (parts_ != nullptr) parts_->add_met(light);
    if constexpr (Recorder::records) recorder_.met(source, light, weight);
  }
  void add_asked(Mask<Real> here, const V& radiance, const Asked& asked) {
    const V light = add(here, radiance);
    if (parts_ != nullptr) parts_->add_asked(light);
    if constexpr (Recorder::records)
      recorder_.given(light, asked.weight * asked.pdf, asked.passing);
  }
  // The weight of light that the surface's direction has found, where add_direct() could have asked
  // for it with a density of other_pdf(mask).
  template <class F>
  Real drawn_weight(Mask<Real> here, F other_pdf) const {
    const Mask<Real> rivals = here && state_.pdf > Real(0);
    if (!any(rivals)) return Real(1);
    const Real other = other_pdf(rivals) / state_.pdf;
    return select(rivals, Real(1) / (Real(1) + other * other), Real(1));
  }

  void add_light(const LightDraw<Real>& draw, const Surface& isect, const Bsdf<Real>& bsdf,
                 const MediumBoundary<Real>& behind, Mask<Real> here) {
    world_view_.work.test();
    const BsdfValue<Real> at = bsdf.value(draw.wi);
    const Mask<Real> below = dot(isect.at.ng, draw.wi) < Real(0);
    if constexpr (Recorder::records)
      recorder_.asked(asked_of_surface(draw, isect, at.f_cos, event_of(bsdf, draw.wi, below)));
    const Medium<Real> between = select(below, behind.medium, state_.medium);
    const V scattered = at.f_cos * draw.light * transmittance_of(between.absorption, draw.distance);
    const Mask<Real> lit = here && shines(scattered) && is_finite(scattered);
    if (!any(lit)) return;
    const Ray<Real> ray = isect.ray_off(draw.wi, below);
    const Real passing = passing_to(draw, isect.at.p, ray, isect.offset, lit);
    if (world_view_.guides != nullptr) world_view_.guides->see(lit, passing);
    const Real weight = asked_weight(draw, at.pdf);
    add_asked(lit && passing > Real(0),
              scattered * (weight * fog_between(isect.at.p, draw, between.density) * passing),
              {weight, draw.pdf, passing});
  }
  // The weight of light that was asked for, where the path itself finds its direction with pdf.
  static Real asked_weight(const LightDraw<Real>& draw, const Real& pdf) {
    if (draw.is_delta) return Real(1) / draw.pdf;
    const Real other = pdf / draw.pdf;
    return Real(1) / (draw.pdf * (Real(1) + other * other));
  }
  // The share of light that passes from there to p.
  // The ray starts off the surface and is aimed at the point of the light anew, for else it would
  // meet a near light beside that point, and before it. What is as near to the light as rays start
  // off surfaces is at it: the light itself, or a ceiling that it is part of.
  Real passing_to(const LightDraw<Real>& draw, const V& p, Ray<Real> ray, const Real& offset,
                  Mask<Real> lit) {
    world_view_.rays.shadow += count(lit);
    const Mask<Real> finite = draw.distance < Real(infinity);
    const Real span = select(finite, draw.distance, Real(1));
    const V to = p + draw.wi * span - ray.origin;
    const Real distance = length(to);
    ray.direction = select(finite, to * (Real(1) / distance), draw.wi);
    const Real reach = distance * Real(1 - 2 * tolerance::ray_offset) - offset;
    return world_view_.passing(ray, select(finite, reach, Real(infinity)), draw.own, lit);
  }

  // ---- what is told of it, in float
  // --------------------------------------------------------------

  static GatheredLight asked_of(const LightDraw<Real>& draw, const V& p, const V& bsdf) {
    GatheredLight told;
    told.light = draw.number, told.asked = true, told.bsdf = bsdf;
    told.from = p, told.direction = draw.wi, told.distance = draw.distance, told.pdf = draw.pdf;
    return told;
  }
  GatheredLight asked_in_fog(const LightDraw<Real>& draw, const V& p, const Real& phase) const {
    GatheredLight told = asked_of(draw, p, {phase, phase, phase});
    told.event = PathEvent::volume;
    return told;
  }
  GatheredLight asked_of_surface(const LightDraw<Real>& draw, const Surface& isect, const V& bsdf,
                                 PathEvent event) const {
    GatheredLight told = asked_of(draw, isect.at.p, bsdf);
    told.event = event;
    told.chance = static_cast<float>(
        lights_.chance(draw.number, lane_of(isect.at.p, 0), lane_of(isect.at.ng, 0)));
    return told;
  }

  // How much light comes through it from a light to p.
  Real fog_between(const V& p, const LightDraw<Real>& draw, const Real& density) const {
    const WorldFog& fog = world_view_.world.fog;
    if (!(fog.density > 0)) return Real(1);
    const FogSpan<Real> span(fog, {p, draw.wi}, draw.distance, density > Real(0));
    return span.transmittance(density);
  }

  WorldView& world_view_;
  PathState<Real>& state_;
  PathParts<Real>* const parts_;
  Recorder& recorder_;
  const LightSampling<Real> lights_;
  const FogSampling<Real> fog_;
  const HenyeyGreenstein<Real> phase_{lift<Real>(world_view_.world.fog.g)};
};

}  // namespace tia
