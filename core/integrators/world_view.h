// What integrators share: the world, what this thread counts, first hits and the surfaces there.
#pragma once

#include <utility>
#include <vector>

#include "core/accel/world/trace.h"
#include "core/accel/world/winners.h"
#include "core/integrators/guides.h"
#include "core/integrators/path_parts.h"
#include "core/integrators/ray_path.h"
#include "core/scene/view.h"

namespace tia {

/// WorldView: the queries that an integrator asks of the world, and the counters of one block's
/// rays and work. There are two kinds with the same functions, and an integrator is a template over
/// them. In a `plain` one surfaces scatter light and do nothing else.
struct WorldView {
  static constexpr bool plain = false;
  const World& world;
  WorkCounter work;
  Rules rules{};
  RayCounts rays{};
  unsigned met = 0;             ///< the lanes, as bits, of the last camera rays that met an object
  PixelCone cone{};             ///< of the camera's rays
  const View* view = nullptr;   ///< whose rays they are, in the world's space; null: nobody's
  LightParts* parts = nullptr;  ///< where path tells what its light consists of; null: nowhere
  Guides* guides = nullptr;     ///< where camera rays tell what they find; null: nowhere

  template <class Real>
  Hit<Real> closest(const Ray<Real>& ray, Mask<Real> active) {
    if (world.passable) return first_stop(world, ray, Sight<Real>{}, active, work);
    return closest_hit(world, ray, active, work);
  }
  /// Of rays from the camera, which before a backdrop pass the surfaces of lights.
  template <class Real>
  Hit<Real> closest_seen(const Ray<Real>& ray, Mask<Real> active) {
    if (!world.backdrop && !is_clipped()) return closest(ray, active);
    const Hit<Real> hit =
        world.passable ? stop_of(ray, active, Sight<Real>{}, true) : closest_thing(ray, active);
    met = bits(active && hit.t < Real(infinity));
    return hit;
  }
  /// The first surface that stops rays of this sight. `seen`: of rays from the camera, or that go
  /// on straight from these. Domain: a world that is passable.
  template <class Real>
  Hit<Real> stop_of(const Ray<Real>& ray, Mask<Real> active, Sight<Real> sight, bool seen) {
    sight.objects_only = seen && world.backdrop;
    if (seen && is_clipped())
      return closest_between(
          ray, [&](const Ray<Real>& from) { return first_stop(world, from, sight, active, work); });
    return first_stop(world, ray, sight, active, work);
  }
  bool is_clipped() const { return view != nullptr && view->is_clipped(); }
  /// The closest object that rays from the camera see, or, without a backdrop, light.
  template <class Real>
  Hit<Real> closest_thing(const Ray<Real>& ray, Mask<Real> active) {
    const auto find = [&](const Ray<Real>& from) {
      return world.backdrop ? closest_object(world, from, active, work)
                            : closest_hit(world, from, active, work);
    };
    return is_clipped() ? closest_between(ray, find) : find(ray);
  }
  /// What `find` finds along rays from the near plane on, or from where they begin behind it, up to
  /// the far plane. Domain: a view that is clipped, whose rays they are or go straight on from.
  template <class Real, class Find>
  [[gnu::noinline]] Hit<Real> closest_between(const Ray<Real>& ray, const Find& find) const {
    const Vec3<Real> axis = lift<Real>(view->axis);
    const Real depth = dot(ray.origin - lift<Real>(view->origin), axis);
    const Real cosine = dot(ray.direction, axis);
    const Real skipped = max_of((lift<Real>(view->near) - depth) / cosine, Real(0));
    Hit<Real> hit = find(Ray<Real>{ray.at(skipped), ray.direction});
    hit.t = skipped + hit.t;
    const Mask<Real> seen = depth + hit.t * cosine <= lift<Real>(view->far);
    hit.t = select(seen, hit.t, Real(infinity));
    hit.primitive = select(seen, hit.primitive, Real(-1));
    return hit;
  }
  /// The share of the light that passes from t_max to the ray's origin, 0 or 1 unless shadows are
  /// transparent.
  template <class Real>
  Real visible(const Ray<Real>& ray, const Real& t_max, const WorldLight& light,
               Mask<Real> active) {
    if (world.see_through || shadows_are_transparent())
      return transmitted(world, ray, t_max, shadows_of(light), active, work);
    const Mask<Real> dark = occluded(world, ray, t_max, light, active, work);
    return select(dark, Real(0), Real(1));
  }
  /// The same of light from a thing whose surface is left out, where what transmits is dark.
  template <class Real>
  Real passing(const Ray<Real>& ray, const Real& t_max, const Blocker& left_out,
               Mask<Real> active) {
    if (world.see_through) return transmitted(world, ray, t_max, {left_out}, active, work);
    return select(occluded(world, ray, t_max, left_out, active, work), Real(0), Real(1));
  }
  /// The first thing between the ray's origin and t_max that takes light.
  Blocker blocker(const Ray<float>& ray, float t_max, const WorldLight& light) {
    return first_blocker(world, ray, t_max, shadows_of(light), work);
  }
  Shadows shadows_of(const WorldLight& light) const {
    return {{light.primitive, light.instance}, shadows_are_transparent()};
  }
  bool shadows_are_transparent() const {
    return world.transparent_shadows && rules.transparent_shadows;
  }
  template <class Real>
  LightSample<Real> sample_middle(const WorldLight& light, const Vec3<Real>& p) const {
    return std::visit([&](const auto& form) { return tia::sample_middle(form, p); }, light.form);
  }
  template <class Real>
  SurfacePoint<Real> surface_of(const Ray<Real>& ray, const Hit<Real>& hit, int primitive,
                                Mask<Real> here) const {
    return surface(world, ray, hit, primitive, here);
  }
  template <class Real>
  Vec3<Real> colors_of(const Ray<Real>& ray, const Hit<Real>& hit, int primitive,
                       Mask<Real> here) const {
    return texture_colors(world, ray, hit, primitive, here);
  }
};

/// FewBallsView: a world of few plain balls, lit from points. It is so small that every ray is
/// tried on all balls, camera rays on those of `balls` alone, which the block's beam may meet.
struct FewBallsView {
  static constexpr bool plain = true;
  const World& world;
  std::vector<int> balls;
  RayCounts rays{};

  template <class Real>
  Hit<Real> closest(const Ray<Real>& ray, Mask<Real>) const {
    return closest_ball(world, balls, ray);
  }
  template <class Real>
  Real visible(const Ray<Real>& ray, const Real& t_max, const WorldLight& light, Mask<Real>) const {
    return select(occluded_by_balls(world, ray, t_max, light), Real(0), Real(1));
  }
  template <class Real>
  LightSample<Real> sample_middle(const WorldLight& light, const Vec3<Real>& p) const {
    return sample_from(lift<Real>(light.middle), p);
  }
  template <class Real>
  BallPoint<Real> surface_of(const Ray<Real>& ray, const Hit<Real>& hit, int primitive,
                             Mask<Real>) const {
    return ball_surface(world.balls[static_cast<std::size_t>(primitive)], ray, hit.t);
  }
};

/// The first hit of the rays, which are counted. Lanes that are not active do not count.
template <class AnyWorldView, class Real>
Hit<Real> first_hit(AnyWorldView& world_view, const Ray<Real>& ray, Mask<Real> active,
                    RayKind kind = RayKind::primary) {
  world_view.rays.count(kind, count(active));
  if constexpr (!AnyWorldView::plain)
    if (kind == RayKind::primary) return world_view.closest_seen(ray, active);
  return world_view.closest(ray, active);
}

/// SurfaceInteraction: the surfaces that a packet's rays have hit, lane by lane. What follows, such
/// as shadow rays, is then done for all lanes at once, whatever primitives they have hit.
template <class Point, class Real>
struct SurfaceInteraction {
  Mask<Real> here;  ///< the lanes that have hit something; the others are meaningless
  Point at{};
  Vec3<Real> albedo{}, emission{};
  Vec3<Real> tint{Real(1), Real(1), Real(1)};  ///< a texture's colour, times a mesh's
  bool tinted = false;            ///< whether any lane has one, which albedo then includes
  LaneTextures<Real> textures{};  ///< whose numbers albedo then follows
  Real offset{};  ///< how far from the surface new rays start, along its normal (offset_of)

  Ray<Real> shadow_ray(const Vec3<Real>& wi) const { return {at.p + at.side() * offset, wi}; }
  /// A ray from the surface: where `below`, from behind it.
  Ray<Real> ray_off(const Vec3<Real>& wi, Mask<Real> below) const {
    return {at.p + at.ng * select(below, -offset, offset), wi};
  }
  /// Sets those lanes. The first call sets all lanes, which spares selecting.
  void take(const Point& point, const ShadingParameters& shading, Mask<Real> those, bool first) {
    const Vec3<Real> own_albedo = lift<Real>(shading.albedo);
    const Vec3<Real> own_emission = lift<Real>(shading.emission);
    if (first) at = point;
    else at.take(point, those);
    albedo = first ? own_albedo : select(those, own_albedo, albedo);
    emission = first ? own_emission : select(those, own_emission, emission);
  }
};

/// The surface of a primitive as its material's textures have it.
template <class Real>
SurfacePoint<Real> textured_surface(const WorldView& world_view, const Ray<Real>& ray,
                                    const Hit<Real>& hit, int primitive, Mask<Real> here,
                                    const Real& travelled, LaneTextures<Real>& textures) {
  const World& world = world_view.world;
  SurfacePoint<Real> at = world_view.surface_of(ray, hit, primitive, here);
  if (world.shading_of(primitive).form < 0) return at;
  const PixelCone& cone = world_view.cone;
  const Real width = lift<Real>(cone.width) + lift<Real>(cone.spread) * (travelled + hit.t);
  take_textures(world, ray, hit, primitive, here, width, textures, at);
  return at;
}

/// `travelled`: how far the light's way is from the camera to the rays' origins.
template <class AnyWorldView, class Real>
auto surfaces(const AnyWorldView& world_view, const Ray<Real>& ray, const Hit<Real>& hit,
              Mask<Real> active, const Real& travelled = Real(0)) {
  using Point = decltype(world_view.surface_of(ray, hit, 0, active));
  SurfaceInteraction<Point, Real> isect{active && hit.t < Real(infinity)};
  if (!any(isect.here)) return isect;
  // Measured: with SurfaceInteraction::take, which chooses by `first`, plain views take 8 % more
  // instructions for the thesis' frame than by selecting always.
  if constexpr (AnyWorldView::plain) {
    for_each_winner(hit, active, [&](int primitive, Mask<Real> here) {
      const ShadingParameters& shading = world_view.world.shading_of(primitive);
      isect.at.take(world_view.surface_of(ray, hit, primitive, here), here);
      isect.albedo = select(here, lift<Real>(shading.albedo), isect.albedo);
      isect.emission = select(here, lift<Real>(shading.emission), isect.emission);
    });
  } else {
    bool first = true;  // most packets hit a single primitive, and nothing has to be selected
    for_each_winner(hit, active, [&](int primitive, Mask<Real> here) {
      const ShadingParameters& shading = world_view.world.shading_of(primitive);
      isect.take(textured_surface(world_view, ray, hit, primitive, here, travelled, isect.textures),
                 shading, here, std::exchange(first, false));
      if (shading.texture < 0 && !world_view.world.primitive(primitive).colored) return;
      isect.tint = select(here, world_view.colors_of(ray, hit, primitive, here), isect.tint);
      isect.tinted = true;
    });
    if (isect.textures.numbers)
      for_each_shading(
          world_view.world, hit, isect.textures.numbers, isect.here,
          [](const ShadingParameters&, int, Mask<Real>) {},
          [&](const PrincipledForm& form, const PrincipledNumbers& at, int i) {
            const VaryingShading of = varying_at(form, at);
            put_lane(isect.albedo, i, of.albedo), put_lane(isect.emission, i, of.emission);
          });
    if (isect.tinted) isect.albedo = isect.albedo * isect.tint;
  }
  isect.offset = offset_of(hit.t, isect.at.p);
  return isect;
}

}  // namespace tia
