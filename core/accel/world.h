// World: the compiled, immutable scene that every thread shares. Geometry stands in one packed
// array; an index over it comes with more kinds of it.
#pragma once

#include <vector>

#include "core/math/ray.h"
#include "core/scene/beam.h"
#include "core/scene/scene.h"

namespace tia {

/// Matte: what shading needs of a material. Linear RGB.
struct Matte {
  Constant albedo;    ///< diffuse * color
  Constant emission;  ///< light of its own
};

/// Lamp: a light as the thesis sees it, a point.
struct Lamp {
  Constant position;
  Constant color;   ///< color * intensity
  int object = -1;  ///< its own sphere, which never blocks it; -1: none
};

struct World {
  std::vector<Sphere> spheres;  ///< the scene's objects in order, then luminous lights
  std::vector<Matte> mattes;    ///< one a sphere
  std::vector<Lamp> lamps;
  Constant background;
};

/// Domain: a scene that read_scene has passed.
World compile(const Scene& scene);

/// The objects that rays of a beam may meet, in the scene's order.
std::vector<int> candidates(const World& world, const Beam& beam);

/// The nearest hit with t > 0 among some objects; at equal t the object earlier in the scene.
template <class Real>
Hit<Real> closest_hit(const World& world, const std::vector<int>& objects, const Ray<Real>& ray) {
  Hit<Real> nearest;
  if (objects.empty()) return nearest;
  const RootRay<Real> root_ray(ray);
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
};

/// Domain: lanes where the ray has not hit `object` come out meaningless.
template <class Real>
SurfacePoint<Real> surface(const World& world, const Ray<Real>& ray, Real t, int object) {
  SurfacePoint<Real> at;
  at.p = ray.at(t);
  at.n = normal(world.spheres[static_cast<std::size_t>(object)], at.p);
  at.n = select(dot(at.n, ray.direction) > Real(0), -at.n, at.n);
  return at;
}

/// Calls f(object, mask) once for each object that lanes have hit: a packet rarely sees more than
/// two, so what depends on the object alone is found once for all lanes.
template <class Real, class F>
void for_each_winner(const Hit<Real>& hit, F f) {
  Mask<Real> left = hit.t < Real(infinity);
  while (const unsigned lanes_left = bits(left)) {
    const auto object = static_cast<int>(lane(hit.object, std::countr_zero(lanes_left)));
    const Mask<Real> here = left & (hit.object == Real(static_cast<float>(object)));
    f(object, here);
    left = left & !here;
  }
}

}  // namespace tia
