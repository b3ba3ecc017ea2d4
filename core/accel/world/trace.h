// Queries of single rays and packets to the world: the closest hit, whether a ray is occluded, and
// the surface at a hit.
#pragma once

#include "core/accel/world/world.h"

namespace tia {

/// The closest hit with t > 0 of each active lane; at equal t that of the object that comes first
/// in the scene. Errors: what the work's report throws.
template <class Real>
Hit<Real> closest_hit(const World& world, const Ray<Real>& ray, Mask<Real> active,
                      WorkCounter& work);

/// The same of objects alone: the surfaces of lights are passed.
template <class Real>
Hit<Real> closest_object(const World& world, const Ray<Real>& ray, Mask<Real> active,
                         WorkCounter& work);

/// Sight: which surfaces rays go straight through. One of opacity a stops a of all rays, which is
/// decided for all surfaces along a ray by one number: the first surface stops it up to which the
/// product of 1 - a is not above that. Back faces of what is one-sided stop no straight sight.
template <class Real>
struct Sight {
  Real u = Real(0x1.fffffep-1F);  ///< in [0, 1), by chance; this one: whatever is there at all
  Mask<Real> straight = Mask<Real>(true);  ///< rays of the camera, of mirrors and of glass
  bool objects_only = false;               ///< whether the surfaces of lights are passed, too
};
/// The first hit that stops a ray. Rays start anew behind what they pass, by offset_of; what is
/// nearer to that is passed with it. Errors: as closest_hit's.
template <class Real>
Hit<Real> first_stop(const World& world, const Ray<Real>& ray, const Sight<Real>& sight,
                     Mask<Real> active, WorkCounter& work);
/// Whether straight sight passes the surface at a hit.
bool is_passed(const World& world, const Ray<double>& ray, const Hit<double>& hit);

/// The closest hit in a world of few balls. Domain: `balls` lists all that the ray may hit.
template <class Real>
Hit<Real> closest_ball(const World& world, const std::vector<int>& balls, const Ray<Real>& ray) {
  Hit<Real> nearest;
  if (balls.empty()) return nearest;
  const RootRay<Real> root_ray(ray);
  for (const int i : balls) {
    const Ball& ball = world.balls[static_cast<std::size_t>(i)];
    const Real t = intersect(ball.sphere, root_ray);
    const auto nearer = t < nearest.t;
    nearest.t = select(nearer, t, nearest.t);
    nearest.primitive = select(nearer, Real(static_cast<float>(ball.primitive)), nearest.primitive);
  }
  return nearest;
}

/// Blocker: a primitive between a point and a light, and which instance of it. -1: none.
struct Blocker {
  int primitive = -1;
  std::int64_t instance = 0;
};
/// Whether anything but the light's own surface is hit between the ray's origin and t_max. Lanes
/// that are not active are meaningless. Errors: what the work's report throws.
template <class Real>
Mask<Real> occluded(const World& world, const Ray<Real>& ray, const Real& t_max,
                    const WorldLight& light, Mask<Real> active, WorkCounter& work);

/// The same for a primitive and its instance instead of a light; -1: anything at all counts.
template <class Real>
Mask<Real> occluded(const World& world, const Ray<Real>& ray, const Real& t_max,
                    const Blocker& left_out, Mask<Real> active, WorkCounter& work);
/// The same where there is no light: whether anything at all is hit.
template <class Real>
Mask<Real> occluded(const World& world, const Ray<Real>& ray, const Real& t_max, Mask<Real> active,
                    WorkCounter& work);

/// How far from its surface a ray starts: in proportion to the distances, so that scenes of every
/// scale have neither shadow acne nor light leaks.
template <class Real>
Real offset_of(const Real& t, const Vec3<Real>& p) {
  const Real extent = max_of(max_of(abs_of(p.x), abs_of(p.y)), abs_of(p.z));
  return Real(tolerance::ray_offset) * max_of(t, extent);
}

/// Shadows: what takes no light from shadow rays.
struct Shadows {
  Blocker left_out;          ///< the light's own surface
  bool transparent = false;  ///< whether light passes what transmits, unbent
};
/// The share of light that passes straight from t_max to the ray's origin: the product over all
/// surfaces between them of 1 - a, a their opacity, and where shadows are transparent 1 - a + a
/// times their transmission. Errors: as occluded's.
template <class Real>
Real transmitted(const World& world, const Ray<Real>& ray, const Real& t_max,
                 const Shadows& shadows, Mask<Real> active, WorkCounter& work);

/// The first surface from the ray's origin to t_max that takes light. One of opacity 0 takes none,
/// nor, where shadows are transparent, one of transmission 1. Errors: as occluded's.
Blocker first_blocker(const World& world, const Ray<float>& ray, float t_max,
                      const Shadows& shadows, WorkCounter& work);

/// The same as occluded in a world of few balls.
template <class Real>
Mask<Real> occluded_by_balls(const World& world, const Ray<Real>& ray, const Real& t_max,
                             const WorldLight& light) {
  const RootRay<Real> root_ray(ray);
  Mask<Real> blocked(false);
  for (const Ball& ball : world.balls)
    if (ball.primitive != light.primitive)
      blocked = blocked | (intersect(ball.sphere, root_ray) < t_max);
  return blocked;
}

/// SurfacePoint: point and normals of a hit. They are computed for the closest hit alone.
/// Space/units: world space; the normals are unit and turned to the side that the ray comes from,
/// by the sign of ng.
template <class Real>
struct SurfacePoint {
  Vec3<Real> p, n, ng;  ///< n is the shading normal, ng the geometric one
  Mask<Real> front{};   ///< where the ray comes from outside of the object
  const Vec3<Real>& side() const { return ng; }
  void take(const SurfacePoint& other, Mask<Real> here) {
    p = select(here, other.p, p);
    n = select(here, other.n, n);
    ng = select(here, other.ng, ng);
    front = (here && other.front) || (!here && front);
  }
};

/// Normals: the shading normal and the geometric one, unit and outwards. On a surface that cuts a
/// solid they point out of what is left of it.
struct Normals {
  Vec3d n, ng;
};
/// The normals of a primitive at a point of it, in double, in world space.
Normals normals_at(const World& world, const Vec3d& p, int primitive, int element,
                   std::int64_t instance);
/// The surface coordinates of a primitive at a point of it.
Vec2d uv_at(const World& world, const Vec3d& p, int primitive, int element, std::int64_t instance);

/// The colours of a primitive's texture, times those of its mesh, where the lanes of `here` hit it.
/// Domain: a primitive with one of the two.
template <class Real>
Vec3<Real> texture_colors(const World& world, const Ray<Real>& ray, const Hit<Real>& hit,
                          int primitive, Mask<Real> here);

/// The surface in the lanes of `here`, computed one by one; normals are not turned to the viewer.
template <class Real>
SurfacePoint<Real> surface_by_lanes(const World& world, const Ray<Real>& ray, const Hit<Real>& hit,
                                    int primitive, Mask<Real> here);

/// The same for eight lanes at a time. Domain: a primitive in the world's own space whose form
/// computes eight normals at once (normals_go_in_eights). Lanes that have not hit it are
/// meaningless.
template <class Real>
SurfacePoint<Real> surface_in_eights(const Primitive& primitive, const Ray<Real>& ray,
                                     const Real& t);

/// n or -n, by the sign of the cosine between the geometric normal and the ray. Where a surface is
/// too small for double to give it a normal, the cosine is NaN, and the result is -direction.
template <class Real>
Vec3<Real> turned(const Vec3<Real>& n, const Real& cosine, const Vec3<Real>& direction) {
  return select(cosine <= Real(0), n, select(cosine > Real(0), -n, -direction));
}

/// BallPoint: a SurfacePoint of a ball, whose shading normal is the geometric one.
template <class Real>
struct BallPoint {
  Vec3<Real> p, n;
  Mask<Real> front{};
  const Vec3<Real>& side() const { return n; }
  void take(const BallPoint& other, Mask<Real> here) {
    p = select(here, other.p, p);
    n = select(here, other.n, n);
  }
};
template <class Real>
BallPoint<Real> ball_surface(const Ball& ball, const Ray<Real>& ray, const Real& t) {
  BallPoint<Real> at;
  at.p = ray.at(t);
  at.n = normal(ball.sphere, at.p);
  const Real cosine = dot(at.n, ray.direction);
  at.front = cosine <= Real(0);
  at.n = turned(at.n, cosine, ray.direction);
  return at;
}

/// The point of a plane that is hit; its normals are not turned to the viewer.
template <class Real>
SurfacePoint<Real> flat_surface(const Flat& flat, const Ray<Real>& ray, const Real& t) {
  const RootRay<Real> root(ray);
  const auto p = root.origin + root.direction * widen(t);
  const Vec3<Real> n = lift<Real>(flat.plane.frame.n);
  return {{narrow<Real>(p.x), narrow<Real>(p.y), narrow<Real>(p.z)}, n, n, {}};
}
/// Of a ball in a group that is repeated in the world's own space; each lane may have hit another
/// instance.
template <class Real>
SurfacePoint<Real> copied_ball_surface(const Ball& ball, const InstanceGrid& grid,
                                       const Ray<Real>& ray, const Hit<Real>& hit);

/// Of any primitive, with normals that are not turned to the viewer: for the whole packet where the
/// primitive's kind allows that, else lane by lane.
template <class Real>
SurfacePoint<Real> outward_surface(const World& world, const Ray<Real>& ray, const Hit<Real>& hit,
                                   int primitive, Mask<Real> here) {
  const Geometry& geometry = world.geometry_of(primitive);
  const Primitive& own = geometry.primitive(primitive);
  if (own.space == 0 && own.flat >= 0)
    return flat_surface(geometry.flats[static_cast<std::size_t>(own.flat)], ray, hit.t);
  if (own.space != 0 && own.ball >= 0) {
    const int number = geometry.space(own.space).grid;
    const InstanceGrid& grid = geometry.grids[static_cast<std::size_t>(number)];
    const Ball& ball = geometry.balls[static_cast<std::size_t>(own.ball)];
    if (grid.outside == 0) return copied_ball_surface(ball, grid, ray, hit);
  }
  if constexpr ((lanes<Real>) > 1) {
    const bool aside = any(here && hit.element > Real(0));
    if (own.space == 0 && !aside && normals_go_in_eights(own))
      return surface_in_eights(own, ray, hit.t);
  }
  return surface_by_lanes(world, ray, hit, primitive, here);
}

/// The surface of a primitive in the lanes of `here`, which have hit it; other lanes are
/// meaningless.
template <class Real>
SurfacePoint<Real> surface(const World& world, const Ray<Real>& ray, const Hit<Real>& hit,
                           int primitive, Mask<Real> here) {
  const Geometry& geometry = world.geometry_of(primitive);
  const Primitive& own = geometry.primitive(primitive);
  if (own.space == 0 && own.ball >= 0) {
    const Ball& ball = geometry.balls[static_cast<std::size_t>(own.ball)];
    const BallPoint<Real> at = ball_surface(ball, ray, hit.t);
    return {at.p, at.n, at.n, at.front};
  }
  SurfacePoint<Real> at = outward_surface(world, ray, hit, primitive, here);
  const Real cosine = dot(at.ng, ray.direction);
  at.n = turned(at.n, cosine, ray.direction);
  at.ng = turned(at.ng, cosine, ray.direction);
  at.front = cosine <= Real(0);
  return at;
}

}  // namespace tia
