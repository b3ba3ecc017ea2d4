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

// Calls visit(ray, hit, lanes, t) for each surface that find(ray, lanes) finds between the ray's
// origin and t_max, at t along the whole ray; it returns the lanes that go on. Each next ray starts
// behind the surface by the same offset as shadow rays start in front of theirs.
template <class Real, class Find, class Visit>
void walk(const Ray<Real>& ray, const Real& t_max, Mask<Real> going, Find find, Visit visit) {
  Real done(0);
  while (any(going)) {
    const Ray<Real> step{ray.at(done), ray.direction};
    const Hit<Real> hit = find(step, going);
    const Real t = done + hit.t;
    going = visit(step, hit, going && t < t_max, t);
    done = select(going, t + offset_of(t, ray.at(t)), done);
  }
}
template <class Real, class Visit>
void walk(const World& world, const Ray<Real>& ray, const Real& t_max, const Blocker& left_out,
          Mask<Real> going, WorkCounter& work, Visit visit) {
  const Nearest<Real> query{{}, left_out.primitive, static_cast<int>(left_out.instance)};
  const auto find = [&](const Ray<Real>& step, Mask<Real> lanes_left) {
    return nearest<Real>(world, step, lanes_left, query, work);
  };
  walk(ray, t_max, going, find, visit);
}

// The share that goes straight on where the lanes have met something, by its opacity and its
// transmission. `wanted` tells by a primitive's shading whether it is asked for.
template <class Real, class Wanted, class Share>
Real share_passed(const World& world, const Ray<Real>& ray, const Hit<Real>& hit, Mask<Real> met,
                  Wanted wanted, Share share) {
  LaneNumbers<Real> numbers;
  Mask<Real> those{};
  for_each_winner(hit, met, [&](int primitive, Mask<Real> here) {
    const ShadingParameters& shading = world.shading_of(primitive);
    if (!wanted(shading)) return;
    if (shading.form >= 0) take_numbers(world, ray, hit, primitive, here, numbers);
    those = those || here;
  });
  Real passed(0);
  for_each_shading(
      world, hit, numbers, those,
      [&](const ShadingParameters& of, int, Mask<Real> here) {
        passed = select(here, lift<Real>(share(of.opacity, of.transmission)), passed);
      },
      [&](const PrincipledForm& form, const PrincipledNumbers& at, int i) {
        const VaryingShading of = varying_at(form, at);
        put_lane(passed, i, share(of.opacity, of.transmission));
      });
  return passed;
}
template <class Real>
Real share_lit(const World& world, const Ray<Real>& ray, const Hit<Real>& hit, Mask<Real> met,
               bool transparent) {
  return share_passed(
      world, ray, hit, met,
      [&](const ShadingParameters& shading) { return transparent || shading.see_through; },
      [&](double opacity, double transmission) {
        return 1 - opacity + (transparent ? opacity * transmission : 0);
      });
}
// The lanes that meet a primitive from in front, as surface() has it. A flat triangle's side is
// that of its area times two, to which rays are not so flat that surface()'s roundings, which are
// float's, could turn it: so neither points nor unit normals have to be found.
template <class Real>
Mask<Real> meet_front(const World& world, const Ray<Real>& ray, const Hit<Real>& hit, int primitive,
                      Mask<Real> here) {
  constexpr double least_cosine = 1e-4;
  const Geometry& geometry = world.geometry_of(primitive);
  const Primitive& own = geometry.primitive(primitive);
  const auto by_surface = [&] { return surface(world, ray, hit, primitive, here).front; };
  if (own.mesh < 0 || own.space != 0) return by_surface();
  const MeshIndex& mesh = *geometry.meshes[static_cast<std::size_t>(own.mesh)];
  if (!mesh.normals.empty()) return by_surface();
  bool clear = true;
  std::array<LaneOf<Real>, static_cast<std::size_t>(lanes<Real>)> cosines{};
  for_each_lane(here, [&](int i) {
    const auto& [a, b, c] = mesh.triangles[static_cast<std::size_t>(lane(hit.element, i))];
    const Vec3d p = mesh.positions[a];
    const Vec3d area = cross(mesh.positions[b] - p, mesh.positions[c] - p);
    const Vec3d n = own.to_object.row(own.inverted ? -area : area);
    const Vec3d d{lane(ray.direction.x, i), lane(ray.direction.y, i), lane(ray.direction.z, i)};
    const double cosine = dot(n, d);
    clear = clear && cosine * cosine > least_cosine * least_cosine * dot(n, n) * dot(d, d);
    cosines[static_cast<std::size_t>(i)] = static_cast<LaneOf<Real>>(cosine < 0 ? -1 : 1);
  });
  return clear ? load<Real>(cosines.data()) <= Real(0) : by_surface();
}
template <class Real>
Real share_seen(const World& world, const Ray<Real>& ray, const Hit<Real>& hit, Mask<Real> met,
                Mask<Real> straight) {
  Real passed(0);
  if (world.see_through)
    passed = share_passed(
        world, ray, hit, met, [](const ShadingParameters& shading) { return shading.see_through; },
        [](double opacity, double) { return 1 - opacity; });
  for_each_winner(hit, met && straight, [&](int primitive, Mask<Real> here) {
    if (!world.shading_of(primitive).one_sided || !world.primitive(primitive).culls) return;
    passed = select(here && !meet_front(world, ray, hit, primitive, here), Real(1), passed);
  });
  return passed;
}

}  // namespace

template <class Real>
Hit<Real> first_stop(const World& world, const Ray<Real>& ray, const Sight<Real>& sight,
                     Mask<Real> active, WorkCounter& work) {
  Hit<Real> stop;
  Real left(1);
  const auto find = [&](const Ray<Real>& step, Mask<Real> going) {
    return sight.objects_only ? closest_object(world, step, going, work)
                              : closest_hit(world, step, going, work);
  };
  const auto pass = [&](const Ray<Real>& step, const Hit<Real>& hit, Mask<Real> met,
                        const Real& t) -> Mask<Real> {
    left = select(met, left * share_seen(world, step, hit, met, sight.straight), left);
    const Mask<Real> passes = met && left > sight.u, stops = met && !passes;
    stop.t = select(stops, t, stop.t);
    stop.primitive = select(stops, hit.primitive, stop.primitive);
    stop.element = select(stops, hit.element, stop.element);
    stop.instance = select(stops, hit.instance, stop.instance);
    return passes;
  };
  walk(ray, Real(infinity), active, find, pass);
  return stop;
}

bool is_passed(const World& world, const Ray<double>& ray, const Hit<double>& hit) {
  return world.passable && share_seen(world, ray, hit, true, true) == 1;
}

template <class Real>
Real transmitted(const World& world, const Ray<Real>& ray, const Real& t_max,
                 const Shadows& shadows, Mask<Real> active, WorkCounter& work) {
  Real share(1);
  const auto take = [&](const Ray<Real>& step, const Hit<Real>& hit, Mask<Real> met,
                        const Real&) -> Mask<Real> {
    const Real passed = share_lit(world, step, hit, met, shadows.transparent);
    share = select(met, share * passed, share);
    return met && share > Real(0);
  };
  walk(world, ray, t_max, shadows.left_out, active, work, take);
  return share;
}

Blocker first_blocker(const World& world, const Ray<float>& ray, float t_max,
                      const Shadows& shadows, WorkCounter& work) {
  Blocker blocking;
  const auto take = [&](const Ray<float>& step, const Hit<float>& hit, bool met, float) {
    const bool passes = met && share_lit(world, step, hit, met, shadows.transparent) == 1;
    if (met && !passes)
      blocking = {static_cast<int>(hit.primitive), static_cast<std::int64_t>(hit.instance)};
    return passes;
  };
  walk(world, ray, t_max, shadows.left_out, true, work, take);
  return blocking;
}

// ---- the three scalars ----------------------------------------------------------------------

#define TIA_TRACE(Real)                                                                         \
  template Hit<Real> closest_hit(const World&, const Ray<Real>&, Mask<Real>, WorkCounter&);     \
  template Hit<Real> closest_object(const World&, const Ray<Real>&, Mask<Real>, WorkCounter&);  \
  template Mask<Real> occluded(const World&, const Ray<Real>&, const Real&, const Blocker&,     \
                               Mask<Real>, WorkCounter&);                                       \
  template Mask<Real> occluded(const World&, const Ray<Real>&, const Real&, const WorldLight&,  \
                               Mask<Real>, WorkCounter&);                                       \
  template Mask<Real> occluded(const World&, const Ray<Real>&, const Real&, Mask<Real>,         \
                               WorkCounter&);                                                   \
  template Hit<Real> first_stop(const World&, const Ray<Real>&, const Sight<Real>&, Mask<Real>, \
                                WorkCounter&);                                                  \
  template Real transmitted(const World&, const Ray<Real>&, const Real&, const Shadows&,        \
                            Mask<Real>, WorkCounter&);
TIA_TRACE(Wide)
TIA_TRACE(float)
TIA_TRACE(double)
#undef TIA_TRACE

}  // namespace tia
