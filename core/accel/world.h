// World: the compiled, immutable scene that every thread shares. Geometry stands in one packed
// array; an index over it comes with more kinds of it.
#pragma once

#include <vector>

#include "core/math/ray.h"
#include "core/scene/scene.h"

namespace tia {

/// Matte: what shading needs of a material. Linear RGB.
struct Matte {
  Vec3d albedo{};    ///< diffuse * color
  Vec3d emission{};  ///< light of its own
};

/// Lamp: a light as the thesis sees it, a point.
struct Lamp {
  Vec3d position;
  Vec3d color;      ///< color * intensity
  int object = -1;  ///< its own sphere, which never blocks it; -1: none
};

struct World {
  std::vector<Sphere> spheres;  ///< the scene's objects in order, then luminous lights
  std::vector<Matte> mattes;    ///< one a sphere
  std::vector<Lamp> lamps;
  Vec3d background;
};

/// Domain: a scene that read_scene has passed.
World compile(const Scene& scene);

/// The objects that rays of a beam may meet, in the scene's order.
std::vector<int> candidates(const World& world, const Beam& beam);

/// The nearest hit with t > 0 among some objects; at equal t the object earlier in the scene.
template <class Real>
Hit<Real> closest_hit(const World& world, const std::vector<int>& objects, const Ray<Real>& ray) {
  const RootRay<Real> root_ray(ray);
  Hit<Real> nearest;
  for (const int i : objects) {
    const Real t = intersect(world.spheres[static_cast<std::size_t>(i)], root_ray);
    const auto nearer = t < nearest.t;
    nearest.t = select(nearer, t, nearest.t);
    nearest.object = select(nearer, Real(static_cast<float>(i)), nearest.object);
  }
  return nearest;
}

/// Whether anything but object `own` stands between the ray's origin and the distance t_max.
template <class Real>
Mask<Real> occluded(const World& world, const Ray<Real>& ray, Real t_max, int own) {
  const RootRay<Real> root_ray(ray);
  Mask<Real> blocked(false);
  for (std::size_t i = 0; i < world.spheres.size(); ++i) {
    if (static_cast<int>(i) == own) continue;
    blocked = blocked | (intersect(world.spheres[i], root_ray) < t_max);
  }
  return blocked;
}

/// SurfacePoint: the costly half of a hit, for the winner only.
/// Space/units: world space; n is unit and faces the viewer.
template <class Real>
struct SurfacePoint {
  Vec3<Real> p, n;
  Vec3<Real> albedo, emission;
};

/// Calls f(object, mask) once for each object among the lanes in `found`.
template <class Real, class F>
void for_each_winner(Real object, Mask<Real> found, F f) {
  while (const unsigned left = bits(found)) {
    const auto i = static_cast<std::size_t>(lane(object, std::countr_zero(left)));
    const Mask<Real> mask = found & (object == Real(static_cast<float>(i)));
    f(i, mask);
    found = found & !mask;
  }
}

/// Domain: lanes outside `found` hold zeros.
template <class Real>
SurfacePoint<Real> surface(const World& world, const Ray<Real>& ray, const Hit<Real>& hit,
                           Mask<Real> found) {
  const Vec3<Real> zero{Real(0), Real(0), Real(0)};
  SurfacePoint<Real> at{ray.at(select(found, hit.t, Real(0))), zero, zero, zero};
  for_each_winner(hit.object, found, [&](std::size_t i, Mask<Real> mask) {
    at.n = select(mask, normal(world.spheres[i], at.p), at.n);
    at.albedo = select(mask, lift<Real>(world.mattes[i].albedo), at.albedo);
    at.emission = select(mask, lift<Real>(world.mattes[i].emission), at.emission);
  });
  at.n = select(dot(at.n, ray.direction) > Real(0), -at.n, at.n);
  return at;
}

}  // namespace tia
