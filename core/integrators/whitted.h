// The slides' integrator (Whitted 1980): at the nearest surface the ambient, diffuse and specular
// light of the lights that it sees, then what its mirror and its glass show, traced the same way.
// The thesis' integrator is its preset without depth, with one point a light.
#pragma once

#include "core/integrators/finishes.h"
#include "core/integrators/ray_tree.h"

namespace tia {

/// The recorder takes down what is computed.
template <class AnyWorldView, class Real, class Recorder = NoRecorder>
class Whitted {
  using V = Vec3<Real>;

 public:
  Whitted(AnyWorldView& world_view, Recorder& recorder)
      : world_view_(world_view), recorder_(recorder) {}

  /// Light along rays. Returns: linear RGB, unclamped; meaningless in lanes that are not active.
  /// Source: the slides; Whitted, "An improved illumination model for shaded display" (1980).
  V trace(const Ray<Real>& ray, Mask<Real> active, const RayPath<Real>& path) {
    const Hit<Real> hit = first_hit(world_view_, ray, active, path.kind);
    const auto isect = surfaces(world_view_, ray, hit, active);
    recorder_.begin(ray, path.depth, hit, isect.at.p, isect.at.n);
    V L = lift<Real>(world_view_.world.background);
    if (any(isect.here)) L = select(isect.here, shade(ray, hit, isect, path), L);
    else recorder_.term(TermName::background, Real(1), L);
    if constexpr (AnyWorldView::plain) return L;
    const V transmittance = left_by(path.absorption, hit.t);
    recorder_.end(L, transmittance);
    return L * transmittance;
  }

 private:
  // With T the finish's transmission and F Fresnel's share (0, or 1 where light cannot pass):
  //   (1 - T) (emission + ambient * color
  //            + sum over lights of visible * fade * light
  //                * (color * diffuse * (n.l)^brilliance + specular * (r.l)^(1/roughness)))
  //   + ((1 - T) reflection + T F) * mirrored + T (1 - F) * refracted
  // The lights' terms are from_light's (direct.h), the two last weights split_specular's
  // (finishes.h).
  template <class Point>
  V shade(const Ray<Real>& ray, const Hit<Real>& hit, const SurfaceInteraction<Point, Real>& isect,
          const RayPath<Real>& path) {
    V L{Real(0), Real(0), Real(0)};
    if constexpr (AnyWorldView::plain) {
      L = isect.emission;
      add_lights(L, ray, isect, {}, Real(1), path);
    } else {
      const Finishes<Real> finish = finishes(world_view_.world, hit, isect.here);
      const Real keep = Real(1) - finish.transmission;  // of the surface's own light
      add(L, TermName::emission, keep, isect.emission);
      add(L, TermName::ambient, keep, finish.ambient * isect.tint);
      add_lights(L, ray, isect, finish.gloss, keep, path);
      if (path.depth < world_view_.rules.max_depth) add_children(L, ray, hit, isect, finish, path);
    }
    return L;
  }

  void add(V& L, TermName name, const Real& weight, const V& value) {
    L = L + value * weight;
    recorder_.term(name, weight, value);
  }

  // ---- light straight from the lights ----------------------------------------------------------

  template <class Point>
  void add_lights(V& L, const Ray<Real>& ray, const SurfaceInteraction<Point, Real>& isect,
                  const Gloss<Real>& gloss, const Real& keep, const RayPath<Real>& path) {
    const auto& lights = world_view_.world.lights;
    for (std::size_t i = 0; i < lights.size(); ++i) {
      const int number = static_cast<int>(i);
      const std::int64_t shadow_rays = world_view_.rays.shadow;
      const auto direct = from_light(world_view_, number, isect, ray.direction, gloss, path);
      if constexpr (Recorder::records)
        recorder_.light = record_of(number, isect, direct, world_view_.rays.shadow > shadow_rays);
      const V color = lift<Real>(lights[i].color);
      if (Recorder::records || any(direct.diffuse > Real(0)))
        add(L, TermName::diffuse, keep * direct.diffuse, isect.albedo * color);
      if (any(direct.specular > Real(0))) add(L, TermName::specular, keep * direct.specular, color);
    }
    if constexpr (Recorder::records) recorder_.light = {};
  }

  // What has cast no shadow ray lies below the horizon and needs no blocker.
  template <class Point>
  LightRecord record_of(int number, const SurfaceInteraction<Point, Real>& isect,
                        const DirectLight<Real>& direct, bool cast) {
    const Incoming<Real>& from = direct.middle;
    LightRecord record{number, from, dot(isect.at.n, from.wi), direct.visible, direct.fade};
    if (!cast || record.visible >= 1) return record;
    const WorldLight& light = world_view_.world.lights[static_cast<std::size_t>(number)];
    const auto [primitive, instance] =
        world_view_.blocker(isect.shadow_ray(from.wi), from.distance, light);
    record.blocker = primitive;
    record.blocker_instance = instance;
    return record;
  }

  // ---- mirrored and refracted light -----------------------------------------------------------

  void add_children(V& L, const Ray<Real>& ray, const Hit<Real>& hit,
                    const SurfaceInteraction<SurfacePoint<Real>, Real>& isect,
                    const Finishes<Real>& finish, const RayPath<Real>& path) {
    const SurfacePoint<Real>& at = isect.at;
    // A smooth normal that looks away from the viewer would send rays through the surface.
    const V n = select(dot(at.n, ray.direction) < Real(0), at.n, at.ng);
    const SpecularSplit<Real> on =
        split_specular(ray.direction, n, hit.instance, isect.here, at.front, finish, path.through);
    const V aside = at.ng * isect.offset;
    if (const Mask<Real> here = on.mirror > Real(0); any(here)) {
      const Ray<Real> child{at.p + aside, normalize(mirrored(ray.direction, n))};
      add_child(L, TermName::reflection, on.mirror, child, here, path.mirrored());
    }
    if (const Mask<Real> here = on.glass > Real(0); any(here)) {
      const Ray<Real> child{at.p - aside, on.bent.wt};
      const Interface<Real> entry{path.through,  here,         at.front,
                                  finish.object, hit.instance, finish.inside};
      add_child(L, TermName::refraction, on.glass, child, here, path.refracted(entry, on.behind));
    }
  }

  void add_child(V& L, TermName name, const Real& weight, const Ray<Real>& ray, Mask<Real> here,
                 const RayPath<Real>& path) {
    const V none{Real(0), Real(0), Real(0)};
    const V value = select(here, trace(ray, here, path), none);
    L = L + value * weight;
    recorder_.child(name, weight, value);
  }

  // What a medium leaves of light on its way. Source: the law of Beer and Lambert.
  static V left_by(const V& absorption, const Real& t) {
    const auto left = [&](const Real& a) {
      const Mask<Real> absorbs = a > Real(0);
      return any(absorbs) ? select(absorbs, exp_of(-a * t), Real(1)) : Real(1);
    };
    return {left(absorption.x), left(absorption.y), left(absorption.z)};
  }

  AnyWorldView& world_view_;
  Recorder& recorder_;
};

/// The light along camera rays in a world of few balls; in any other it is an Integrator's.
template <class Real>
Vec3<Real> whitted(FewBallsView& world_view, const Ray<Real>& ray, Mask<Real> active,
                   const SamplerState<Real>& sampler_state) {
  NoRecorder recorder;
  return Whitted<FewBallsView, Real>(world_view, recorder)
      .trace(ray, active, RayPath<Real>{sampler_state});
}

/// The whole tree of one camera ray, by the picture's own arithmetic. Errors: the limit's.
std::unique_ptr<RayNode> explain_whitted(WorldView& world_view, const Ray<float>& ray,
                                         const SamplerState<float>& sampler_state,
                                         const RayTreeLimit& limit);

}  // namespace tia
