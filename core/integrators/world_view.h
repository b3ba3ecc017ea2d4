// What integrators share: the world, what this thread counts, first hits and the surfaces there.
#pragma once

#include <utility>
#include <vector>

#include "core/accel/world/trace.h"
#include "core/integrators/ray_path.h"

namespace tia {

/// RayTally: rays of one block by kind, exact.
struct RayTally {
  std::int64_t primary = 0, shadow = 0, reflection = 0, refraction = 0;
  std::int64_t all() const { return primary + shadow + reflection + refraction; }
  void count(RayKind kind, int rays) {
    (kind == RayKind::primary      ? primary
     : kind == RayKind::reflection ? reflection
                                   : refraction) += rays;
  }
};

/// WorldView: the world as one block of the picture sees it, and what the block's rays count to. Of
/// two kinds, which ask the same in their own way; an integrator is a template over them. In a
/// plain one surfaces scatter light and do nothing else.
struct WorldView {
  static constexpr bool plain = false;
  const World& world;
  WorkCounter work;
  Rules rules{};
  RayTally rays{};

  template <class Real>
  Hit<Real> closest(const Ray<Real>& ray, Mask<Real> active) {
    return closest_hit(world, ray, active, work);
  }
  /// The share of the light that comes from t_max to the ray's origin.
  template <class Real>
  Real visible(const Ray<Real>& ray, const Real& t_max, const WorldLight& light,
               Mask<Real> active) {
    if (shadows_are_transparent()) return transmitted(world, ray, t_max, light, active, work);
    const Mask<Real> dark = occluded(world, ray, t_max, light, active, work);
    return select(dark, Real(0), Real(1));
  }
  /// What takes light first on the way from the ray's origin to t_max.
  Blocker blocker(const Ray<float>& ray, float t_max, const WorldLight& light) {
    return first_blocker(world, ray, t_max, light, shadows_are_transparent(), work);
  }
  bool shadows_are_transparent() const {
    return world.transparent_shadows && rules.transparent_shadows;
  }
  template <class Real>
  Incoming<Real> from_middle(const WorldLight& light, const Vec3<Real>& p) const {
    return std::visit([&](const auto& form) { return incoming_from_middle(form, p); }, light.form);
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

/// A world of few plain balls, lit from points, and nothing else, of which the camera rays may meet
/// those listed: small enough to be tried one after another in registers.
struct FewBallsView {
  static constexpr bool plain = true;
  const World& world;
  std::vector<int> balls;
  RayTally rays{};

  template <class Real>
  Hit<Real> closest(const Ray<Real>& ray, Mask<Real>) const {
    return closest_ball(world, balls, ray);
  }
  template <class Real>
  Real visible(const Ray<Real>& ray, const Real& t_max, const WorldLight& light, Mask<Real>) const {
    return select(occluded_by_balls(world, ray, t_max, light), Real(0), Real(1));
  }
  template <class Real>
  Incoming<Real> from_middle(const WorldLight& light, const Vec3<Real>& p) const {
    return incoming_from(lift<Real>(light.middle), p);
  }
  template <class Real>
  BallPoint<Real> surface_of(const Ray<Real>& ray, const Hit<Real>& hit, int primitive,
                             Mask<Real>) const {
    return ball_surface(world.balls[static_cast<std::size_t>(primitive)], ray, hit.t);
  }
};

/// What rays meet first. Lanes that are not active do not count.
template <class AnyWorldView, class Real>
Hit<Real> first_hit(AnyWorldView& world_view, const Ray<Real>& ray, Mask<Real> active,
                    RayKind kind = RayKind::primary) {
  world_view.rays.count(kind, count(active));
  return world_view.closest(ray, active);
}

/// SurfaceInteraction: the surfaces that a packet's rays have hit, each lane its own, so that what
/// follows, their shadow rays above all, is done for all lanes at once.
template <class Point, class Real>
struct SurfaceInteraction {
  Mask<Real> here;  ///< the lanes that have hit anything; the others are meaningless
  Point at{};
  Vec3<Real> albedo{}, emission{};
  Vec3<Real> tint{Real(1), Real(1), Real(1)};  ///< a texture's colour
  bool tinted = false;                         ///< whether any lane has one; albedo has it then
  Real offset{};  ///< how far above or below the surface new rays start

  Ray<Real> shadow_ray(const Vec3<Real>& wi) const { return {at.p + at.side() * offset, wi}; }
  /// Lanes but those keep what they have, unless it is the first that they get.
  void take(const Point& point, const ShadingParameters& shading, Mask<Real> those, bool first) {
    const Vec3<Real> own_albedo = lift<Real>(shading.albedo);
    const Vec3<Real> own_emission = lift<Real>(shading.emission);
    if (first) at = point;
    else at.take(point, those);
    albedo = first ? own_albedo : select(those, own_albedo, albedo);
    emission = first ? own_emission : select(those, own_emission, emission);
  }
};

template <class AnyWorldView, class Real>
auto surfaces(const AnyWorldView& world_view, const Ray<Real>& ray, const Hit<Real>& hit,
              Mask<Real> active) {
  using Point = decltype(world_view.surface_of(ray, hit, 0, active));
  SurfaceInteraction<Point, Real> isect{active && hit.t < Real(infinity)};
  if (!any(isect.here)) return isect;
  // SurfaceInteraction::take would do for plain views as well, but its choice by `first` costs the
  // thesis' frame 8 % more instructions: their surfaces are so cheap that selecting always is
  // cheaper.
  if constexpr (AnyWorldView::plain) {
    for_each_winner(hit, active, [&](int primitive, Mask<Real> here) {
      const ShadingParameters& shading = world_view.world.shading_of(primitive);
      isect.at.take(world_view.surface_of(ray, hit, primitive, here), here);
      isect.albedo = select(here, lift<Real>(shading.albedo), isect.albedo);
      isect.emission = select(here, lift<Real>(shading.emission), isect.emission);
    });
  } else {
    bool first = true;  // most packets see one thing: there is nothing to select
    for_each_winner(hit, active, [&](int primitive, Mask<Real> here) {
      isect.take(world_view.surface_of(ray, hit, primitive, here),
                 world_view.world.shading_of(primitive), here, std::exchange(first, false));
      if (world_view.world.shading_of(primitive).texture < 0) return;
      isect.tint = select(here, world_view.colors_of(ray, hit, primitive, here), isect.tint);
      isect.tinted = true;
    });
    if (isect.tinted) isect.albedo = isect.albedo * isect.tint;
  }
  isect.offset = offset_of(hit.t, isect.at.p);
  return isect;
}

}  // namespace tia
