// The slides' integrator (Whitted 1980): at the nearest surface emission, ambient light, and the
// diffuse and specular light of all lights that the point sees; then the light along the reflected
// and the refracted ray, found in the same way. The thesis' integrator is its preset with max_depth
// 0 and one sample a light, at the light's middle.
#pragma once

#include "core/integrators/finishes.h"
#include "core/integrators/ray_tree.h"

namespace tia {

/// The recorder gets every term of the sum (ray_tree.h); NoRecorder, of pictures, drops them.
template <class AnyWorldView, class Real, class Recorder = NoRecorder>
class Whitted {
  using V = Vec3<Real>;

 public:
  Whitted(AnyWorldView& world_view, Recorder& recorder)
      : world_view_(world_view), recorder_(recorder) {}

  /// Light along rays. Returns: linear RGB, unclamped; meaningless in lanes that are not active.
  /// Source: the slides; Whitted, "An improved illumination model for shaded display" (1980).
  V trace(const Ray<Real>& ray, Mask<Real> active, const RayPath<Real>& path) {
    const Hit<Real> hit = hit_of(ray, active, path);
    const auto isect = surfaces(world_view_, ray, hit, active, path.travelled);
    recorder_.begin(ray, path.depth, hit, isect.at.p, isect.at.n);
    V L = beyond(ray, active && !isect.here);
    if (any(isect.here)) L = select(isect.here, shade(ray, hit, isect, path), L);
    else recorder_.term(TermName::background, Real(1), L);
    if constexpr (AnyWorldView::plain) return L;
    const V transmittance = transmittance_of(path.absorption, hit.t);
    recorder_.end(L, transmittance);
    return L * transmittance;
  }

 private:
  // Rays that go straight on from the camera's are its own still, though they are not counted so.
  Hit<Real> hit_of(const Ray<Real>& ray, Mask<Real> active, const RayPath<Real>& path) {
    if constexpr (!AnyWorldView::plain) {
      if (path.seen && path.passed > 0) {
        world_view_.rays.count(path.kind, count(active));
        return world_view_.stop_of(ray, active, {}, path.seen);
      }
    }
    return first_hit(world_view_, ray, active, path.kind);
  }
  // Behind so many surfaces that are there in part the next counts as whole: calls go no deeper.
  static constexpr int most_passed = 64;
  template <class Point>
  Real opacity_of(const Hit<Real>& hit, const SurfaceInteraction<Point, Real>& isect,
                  const RayPath<Real>& path) const {
    return path.passed < most_passed ? opacities(world_view_.world, hit, isect) : Real(1);
  }

  // With T the finish's transmission and F the share that Fresnel's equations reflect, or, without
  // them, 1 at total internal reflection and else 0:
  //   (1 - T) (emission + ambient * color
  //            + sum over lights of visible * fade * light
  //                * (color * diffuse * (n.l)^brilliance + specular * (r.l)^(1/roughness)))
  //   + ((1 - T) reflection + T F) * reflected + T (1 - F) * refracted
  // All that counts the surface's opacity a, and 1 - a what the ray finds that goes straight on.
  // The lights' terms are sample_ld's (direct.h), the two last weights split_specular's
  // (finishes.h).
  template <class Point>
  V shade(const Ray<Real>& ray, const Hit<Real>& hit, const SurfaceInteraction<Point, Real>& isect,
          const RayPath<Real>& path) {
    V L{Real(0), Real(0), Real(0)};
    if constexpr (AnyWorldView::plain) {
      L = isect.emission;
      add_lights(L, ray, isect, {}, Real(1), path);
    } else {
      const Finishes<Real> finish = finishes(world_view_.world, hit, isect);
      const Real there = world_view_.world.see_through ? opacity_of(hit, isect, path) : Real(1);
      const Real keep = (Real(1) - finish.transmission) * there;  // of the surface's own light
      add(L, TermName::emission, keep, isect.emission);
      add(L, TermName::ambient, keep, finish.ambient * isect.tint);
      add_lights(L, ray, isect, finish.phong, keep, path);
      if (path.depth < world_view_.rules.max_depth)
        add_children(L, ray, hit, isect, finish, there, path);
      if (world_view_.world.see_through) add_straight(L, ray, hit, isect, there, path);
    }
    return L;
  }

  void add(V& L, TermName name, const Real& weight, const V& value) {
    L = L + value * weight;
    recorder_.term(name, weight, value);
  }

  // What rays find that hit nothing.
  V beyond(const Ray<Real>& ray, Mask<Real> missed) const {
    V L = lift<Real>(world_view_.world.background);
    if constexpr (!AnyWorldView::plain)
      for (const WorldSky& sky : world_view_.world.skies)
        L = L + radiance(sky.form, ray.direction, missed) * lift<Real>(sky.color);
    return L;
  }

  // ---- direct light -----------------------------------------------------------------------------

  template <class Point>
  void add_lights(V& L, const Ray<Real>& ray, const SurfaceInteraction<Point, Real>& isect,
                  const Phong<Real>& phong, const Real& keep, const RayPath<Real>& path) {
    const auto& lights = world_view_.world.lights;
    for (std::size_t i = 0; i < lights.size(); ++i) {
      const int number = static_cast<int>(i);
      const std::int64_t shadow_rays = world_view_.rays.shadow;
      const auto direct = sample_ld(world_view_, number, isect, ray.direction, phong, path);
      if constexpr (Recorder::records)
        recorder_.light = record_of(number, isect, direct, world_view_.rays.shadow > shadow_rays);
      const V color = lift<Real>(lights[i].color);
      if (Recorder::records || any(direct.diffuse > Real(0)))
        add(L, TermName::diffuse, keep * direct.diffuse, isect.albedo * color);
      if (any(direct.specular > Real(0))) add(L, TermName::specular, keep * direct.specular, color);
    }
    if constexpr (Recorder::records) recorder_.light = {};
  }

  // Without a shadow ray the light is below the horizon, and there is no blocker to look for.
  template <class Point>
  LightRecord record_of(int number, const SurfaceInteraction<Point, Real>& isect,
                        const LightContribution<Real>& direct, bool cast) {
    const LightSample<Real>& middle = direct.middle;
    LightRecord record{number, middle, dot(isect.at.n, middle.wi), direct.visible, direct.fade};
    if (!cast || record.visible >= 1) return record;
    const WorldLight& light = world_view_.world.lights[static_cast<std::size_t>(number)];
    const auto [primitive, instance] =
        world_view_.blocker(isect.shadow_ray(middle.wi), middle.distance, light);
    record.blocker = primitive;
    record.blocker_instance = instance;
    return record;
  }

  // ---- reflected and refracted light ----------------------------------------------------------

  void add_children(V& L, const Ray<Real>& ray, const Hit<Real>& hit,
                    const SurfaceInteraction<SurfacePoint<Real>, Real>& isect,
                    const Finishes<Real>& finish, const Real& there, const RayPath<Real>& path) {
    const SurfacePoint<Real>& at = isect.at;
    // An interpolated normal may face away from the viewer, and the reflected ray would then go
    // through the surface; the geometric normal takes its place.
    const V n = select(dot(at.n, ray.direction) < Real(0), at.n, at.ng);
    SpecularSplit<Real> split = split_specular(ray.direction, n, hit.instance, isect.here, at.front,
                                               finish, path.transitions);
    split.reflection = split.reflection * there, split.refraction = split.refraction * there;
    const V offset = at.ng * isect.offset;
    if (const Mask<Real> here = split.reflection > Real(0); any(here)) {
      const Ray<Real> child{at.p + offset, normalize(reflect(ray.direction, n))};
      add_child(L, TermName::reflection, split.reflection, child, here, path.reflected(hit.t));
    }
    if (const Mask<Real> here = split.refraction > Real(0); any(here)) {
      const Ray<Real> child{at.p - offset, split.refracted.wt};
      const MediumTransition<Real> transition{path.transitions, here,         at.front,
                                              finish.object,    hit.instance, finish.inside};
      add_child(L, TermName::refraction, split.refraction, child, here,
                path.refracted(transition, split.medium_t, hit.t));
    }
  }

  // A call of its own: most worlds never make it, and rays with mirrors are 1 to 4 % faster so.
  [[gnu::noinline]] void add_straight(V& L, const Ray<Real>& ray, const Hit<Real>& hit,
                                      const SurfaceInteraction<SurfacePoint<Real>, Real>& isect,
                                      const Real& there, const RayPath<Real>& path) {
    const Mask<Real> here = isect.here && there < Real(1);
    if (!any(here)) return;
    const Ray<Real> child{isect.at.p - isect.at.ng * isect.offset, ray.direction};
    add_child(L, TermName::straight, Real(1) - there, child, here, path.straight(hit.t));
  }

  void add_child(V& L, TermName name, const Real& weight, const Ray<Real>& ray, Mask<Real> here,
                 const RayPath<Real>& path) {
    const V none{Real(0), Real(0), Real(0)};
    const V value = select(here, trace(ray, here, path), none);
    L = L + value * weight;
    recorder_.child(name, weight, value);
  }

  AnyWorldView& world_view_;
  Recorder& recorder_;
};

/// The light along camera rays in a world of few balls. In any other world that is
/// Integrator<IntegratorName::whitted>::radiance.
template <class Real>
Vec3<Real> whitted(FewBallsView& world_view, const Ray<Real>& ray, Mask<Real> active,
                   const SamplerState<Real>& sampler_state) {
  NoRecorder recorder;
  return Whitted<FewBallsView, Real>(world_view, recorder)
      .trace(ray, active, RayPath<Real>{sampler_state});
}

/// The tree of rays of one camera ray, computed as in the picture, to the same bits. Errors: what
/// the limit throws.
std::unique_ptr<RayNode> explain_whitted(WorldView& world_view, const Ray<float>& ray,
                                         const SamplerState<float>& sampler_state,
                                         const RayTreeLimit& limit);

}  // namespace tia
