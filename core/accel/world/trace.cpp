#include "core/accel/world/trace.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>

#include "core/accel/world/search.h"
#include "core/accel/world/settled_distances.h"

namespace tia {

namespace {

template <class Real>
Hit<Real> nearest(const World& world, const Ray<Real>& ray, Mask<Real> active, Nearest<Real> query,
                  WorkCounter& work) {
  search(world, ray, active, query, work);
  if constexpr (!std::is_same_v<Real, double>) settle_distances(world, ray, active, query.hit);
  return query.hit;
}

}  // namespace

template <class Real>
Hit<Real> closest_hit(const World& world, const Ray<Real>& ray, Mask<Real> active,
                      WorkCounter& work) {
  return nearest<Real>(world, ray, active, {}, work);
}

template <class Real>
Hit<Real> closest_object(const World& world, const Ray<Real>& ray, Mask<Real> active,
                         WorkCounter& work) {
  Nearest<Real> query;
  Packet<Real> packet(ray);
  search(*world.of_objects, packet, active, query, work);
  if constexpr (!std::is_same_v<Real, double>) settle_distances(world, ray, active, query.hit);
  return query.hit;
}

template <class Real>
Mask<Real> occluded(const World& world, const Ray<Real>& ray, const Real& t_max,
                    const Blocker& left_out, Mask<Real> active, WorkCounter& work) {
  AnyHit<Real> query{t_max, left_out.primitive, static_cast<int>(left_out.instance)};
  search(world, ray, active, query, work);
  return query.blocked();
}

template <class Real>
Mask<Real> occluded(const World& world, const Ray<Real>& ray, const Real& t_max,
                    const WorldLight& light, Mask<Real> active, WorkCounter& work) {
  return occluded(world, ray, t_max, Blocker{light.primitive, light.instance}, active, work);
}

template <class Real>
Mask<Real> occluded(const World& world, const Ray<Real>& ray, const Real& t_max, Mask<Real> active,
                    WorkCounter& work) {
  return occluded(world, ray, t_max, Blocker{}, active, work);
}

namespace {

// Calls visit(ray, hit, lanes) for each surface between the ray's origin and t_max, the light's own
// left out; it returns the lanes that go on. Each next ray starts behind the surface by the same
// offset as shadow rays start in front of theirs.
template <class Real, class Visit>
void walk(const World& world, const Ray<Real>& ray, const Real& t_max, const WorldLight& light,
          Mask<Real> going, WorkCounter& work, Visit visit) {
  Real done(0);
  while (any(going)) {
    const Ray<Real> step{ray.at(done), ray.direction};
    const Nearest<Real> query{{}, light.primitive, light.instance};
    const Hit<Real> hit = nearest<Real>(world, step, going, query, work);
    const Real t = done + hit.t;
    going = visit(step, hit, going && t < t_max);
    done = select(going, t + offset_of(t, ray.at(t)), done);
  }
}

// Calls f(transmission, lanes) for what the lanes have met.
template <class Real, class F>
void each_transmission(const World& world, const Ray<Real>& ray, const Hit<Real>& hit,
                       Mask<Real> met, F f) {
  LaneNumbers<Real> numbers;
  for_each_winner(hit, met, [&](int primitive, Mask<Real> here) {
    if (world.shading_of(primitive).form >= 0)
      take_numbers(world, ray, hit, primitive, here, Real(0), numbers);
  });
  for_each_shading(world, hit, numbers, met,
                   [&](const ShadingParameters& shading, int, Mask<Real> here) {
                     f(shading.transmission, here);
                   });
}

}  // namespace

template <class Real>
Real transmitted(const World& world, const Ray<Real>& ray, const Real& t_max,
                 const WorldLight& light, Mask<Real> active, WorkCounter& work) {
  Real share(1);
  const auto take = [&](const Ray<Real>& step, const Hit<Real>& hit, Mask<Real> met) -> Mask<Real> {
    Real passed(0);
    each_transmission(world, step, hit, met, [&](double transmission, Mask<Real> here) {
      passed = select(here, lift<Real>(transmission), passed);
    });
    share = select(met, share * passed, share);
    return met && share > Real(0);
  };
  walk(world, ray, t_max, light, active, work, take);
  return share;
}

Blocker first_blocker(const World& world, const Ray<float>& ray, float t_max,
                      const WorldLight& light, bool transparent, WorkCounter& work) {
  Blocker blocking;
  const auto take = [&](const Ray<float>& step, const Hit<float>& hit, bool met) {
    bool passes = false;
    if (transparent)
      each_transmission(world, step, hit, met,
                        [&](double transmission, bool) { passes = transmission == 1; });
    if (met && !passes)
      blocking = {static_cast<int>(hit.primitive), static_cast<std::int64_t>(hit.instance)};
    return passes;
  };
  walk(world, ray, t_max, light, true, work, take);
  return blocking;
}

// ---- the three scalars ----------------------------------------------------------------------

#define TIA_TRACE(Real)                                                                        \
  template Hit<Real> closest_hit(const World&, const Ray<Real>&, Mask<Real>, WorkCounter&);    \
  template Hit<Real> closest_object(const World&, const Ray<Real>&, Mask<Real>, WorkCounter&); \
  template Mask<Real> occluded(const World&, const Ray<Real>&, const Real&, const Blocker&,    \
                               Mask<Real>, WorkCounter&);                                      \
  template Mask<Real> occluded(const World&, const Ray<Real>&, const Real&, const WorldLight&, \
                               Mask<Real>, WorkCounter&);                                      \
  template Mask<Real> occluded(const World&, const Ray<Real>&, const Real&, Mask<Real>,        \
                               WorkCounter&);                                                  \
  template Real transmitted(const World&, const Ray<Real>&, const Real&, const WorldLight&,    \
                            Mask<Real>, WorkCounter&);
TIA_TRACE(Wide)
TIA_TRACE(float)
TIA_TRACE(double)
#undef TIA_TRACE

}  // namespace tia
