// Queries: what a search through the world looks for. Each has the limit of t beyond which nothing
// changes its answer, and offer(), which takes a hit.
#pragma once

#include "core/accel/mesh/mesh_search.h"

namespace tia {

/// Nearest: the closest hit with t > 0; at equal t that of the first object, then of the first
/// instance, then of the first element.
template <class Real>
struct Nearest {
  Hit<Real> hit{};
  int own = -1, own_instance = 0;  ///< the primitive and its instance that are left out; -1: none

  const Real& limit() const { return hit.t; }
  bool skips(int primitive, int instance) const {
    return primitive == own && instance == own_instance;
  }
  void offer(const Real& t, const Real& primitive, const Real& element, int instance,
             Mask<Real> here) {
    const Real number(static_cast<float>(instance));
    const auto first = [](const Real& a, const Real& b, Mask<Real> after) -> Mask<Real> {
      return a < b || (a == b && after);
    };
    const Mask<Real> earlier =
        first(primitive, hit.primitive, first(number, hit.instance, element < hit.element));
    const Mask<Real> nearer = here && first(t, hit.t, t < Real(infinity) && earlier);
    hit.t = select(nearer, t, hit.t);
    hit.primitive = select(nearer, primitive, hit.primitive);
    hit.element = select(nearer, element, hit.element);
    hit.instance = select(nearer, number, hit.instance);
  }

  using Triangles = NearestTriangle<Real>;
  Triangles in(const MeshRay<Real>& ray) const {
    return {ray.m_of(hit.t * Real(box_grow)) * Real(box_grow)};
  }
  void take(const Triangles& found, const MeshRay<Real>& ray, int primitive, int instance,
            Mask<Real> here) {
    offer(ray.t_of(found.limit), Real(static_cast<float>(primitive)), found.number, instance,
          here && found.found());
  }

  Nearest<float> one(int i) const {
    return {{lane(hit.t, i), lane(hit.primitive, i), lane(hit.element, i), lane(hit.instance, i)},
            own,
            own_instance};
  }
  void set_one(int i, const Nearest<float>& ray) {
    set_lane(hit.t, i, ray.hit.t);
    set_lane(hit.primitive, i, ray.hit.primitive);
    set_lane(hit.element, i, ray.hit.element);
    set_lane(hit.instance, i, ray.hit.instance);
  }
};

/// AnyHit: whether the ray hits anything before t_max, one primitive's instance left out.
template <class Real>
struct AnyHit {
  Real t_max;  ///< below 0 once something is hit, so that nothing further is tried
  int own = -1, own_instance = 0;

  const Real& limit() const { return t_max; }
  Mask<Real> blocked() const { return t_max < Real(0); }
  bool skips(int primitive, int instance) const {
    return primitive == own && instance == own_instance;
  }
  void offer(const Real& t, const Real&, const Real&, int, Mask<Real> here) {
    t_max = select(here && t < t_max, Real(-1), t_max);
  }

  using Triangles = AnyTriangle<Real>;
  Triangles in(const MeshRay<Real>& ray) const { return {ray.m_of(t_max)}; }
  void take(const Triangles& found, const MeshRay<Real>&, int, int, Mask<Real> here) {
    t_max = select(here && found.found(), Real(-1), t_max);
  }

  AnyHit<float> one(int i) const { return {lane(t_max, i), own, own_instance}; }
  void set_one(int i, const AnyHit<float>& ray) { set_lane(t_max, i, ray.t_max); }
};

}  // namespace tia
