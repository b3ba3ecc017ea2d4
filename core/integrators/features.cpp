// Feature images: what the camera rays find, as numbers instead of light.
#include <array>

#include "core/integrators/direct.h"
#include "core/integrators/integrator.h"

namespace tia {

// The shading normal, towards the viewer; 0 where nothing is hit.
template <>
template <class Real>
Vec3<Real> Integrator<IntegratorName::normal>::radiance(WorldView& world_view, const Ray<Real>& ray,
                                                        Mask<Real> active,
                                                        const SamplerState<Real>&) {
  const auto isect = surfaces(world_view, ray, first_hit(world_view, ray, active), active);
  return select(isect.here, isect.at.n, {Real(0), Real(0), Real(0)});
}

// Distance along the unit ray; infinite where nothing is hit.
template <>
template <class Real>
Vec3<Real> Integrator<IntegratorName::depth>::radiance(WorldView& world_view, const Ray<Real>& ray,
                                                       Mask<Real> active,
                                                       const SamplerState<Real>&) {
  const Real t = first_hit(world_view, ray, active).t;
  return {t, t, t};
}

// Distance along the view's axis, of a view that has none along the ray; infinite where nothing is
// hit.
template <>
template <class Real>
Vec3<Real> Integrator<IntegratorName::planar_depth>::radiance(WorldView& world_view,
                                                              const Ray<Real>& ray,
                                                              Mask<Real> active,
                                                              const SamplerState<Real>&) {
  const Real t = first_hit(world_view, ray, active).t;
  if (world_view.view == nullptr || !world_view.view->is_flat()) return {t, t, t};
  const View& view = *world_view.view;
  const Vec3<Real> axis = lift<Real>(view.axis);
  const Real before = dot(ray.origin - lift<Real>(view.origin), axis);
  const Real depth = before + t * dot(ray.direction, axis);
  return {depth, depth, depth};
}

// The material's own colour; white where nothing is hit.
template <>
template <class Real>
Vec3<Real> Integrator<IntegratorName::label>::radiance(WorldView& world_view, const Ray<Real>& ray,
                                                       Mask<Real> active,
                                                       const SamplerState<Real>&) {
  Vec3<Real> label{Real(1), Real(1), Real(1)};
  for_each_winner(first_hit(world_view, ray, active), active, [&](int primitive, Mask<Real> here) {
    label = select(here, lift<Real>(world_view.world.shading_of(primitive).label), label);
  });
  return label;
}

// The surface's colour times what it scatters; 0 where nothing is hit.
template <>
template <class Real>
Vec3<Real> Integrator<IntegratorName::albedo>::radiance(WorldView& world_view, const Ray<Real>& ray,
                                                        Mask<Real> active,
                                                        const SamplerState<Real>&) {
  const auto isect = surfaces(world_view, ray, first_hit(world_view, ray, active), active);
  return select(isect.here, isect.albedo, {Real(0), Real(0), Real(0)});
}

// The object's number in the scene, from 1; 0 where nothing is hit.
template <>
template <class Real>
Vec3<Real> Integrator<IntegratorName::object>::radiance(WorldView& world_view, const Ray<Real>& ray,
                                                        Mask<Real> active,
                                                        const SamplerState<Real>&) {
  Real number(0);
  for_each_winner(first_hit(world_view, ray, active), active, [&](int primitive, Mask<Real> here) {
    const int object = world_view.world.primitive(primitive).object;
    number = select(here, Real(static_cast<float>(object + 1)), number);
  });
  return {number, number, number};
}

namespace {

// 1 where nothing is hit or nothing shines.
template <class Real>
Real share_of_lights(WorldView& world_view, const Ray<Real>& ray,
                     const SurfaceInteraction<SurfacePoint<Real>, Real>& isect) {
  const std::vector<WorldLight>& lights = world_view.world.lights;
  if (lights.empty() || !any(isect.here)) return Real(1);
  Real lit(0);
  for (const WorldLight& light : lights) {
    const auto middle = world_view.sample_middle(light, isect.at.p);
    lit = lit + estimate_direct(world_view, light, middle, isect, ray.direction, {}).visible;
  }
  return select(isect.here, lit / Real(static_cast<float>(lights.size())), Real(1));
}

}  // namespace

// The share of the lights that the point sees.
template <>
template <class Real>
Vec3<Real> Integrator<IntegratorName::shadow>::radiance(WorldView& world_view, const Ray<Real>& ray,
                                                        Mask<Real> active,
                                                        const SamplerState<Real>&) {
  const auto isect = surfaces(world_view, ray, first_hit(world_view, ray, active), active);
  const Real share = share_of_lights(world_view, ray, isect);
  return {share, share, share};
}

template <class Real>
void find_guides(WorldView& world_view, const Ray<Real>& ray, Mask<Real> active) {
  const Hit<Real> hit = first_hit(world_view, ray, active);
  const auto isect = surfaces(world_view, ray, hit, active);
  world_view.guides->take(isect, hit.t);
  world_view.guides->see(isect.here, share_of_lights(world_view, ray, isect));
}
template void find_guides(WorldView&, const Ray<Wide>&, Mask<Wide>);
template void find_guides(WorldView&, const Ray<float>&, Mask<float>);
template void find_guides(WorldView&, const Ray<double>&, Mask<double>);

// Tests of boxes and surfaces that the ray costs when it goes alone.
template <>
template <class Real>
Vec3<Real> Integrator<IntegratorName::cost>::radiance(WorldView& world_view, const Ray<Real>& ray,
                                                      Mask<Real> active,
                                                      const SamplerState<Real>&) {
  std::array<LaneOf<Real>, static_cast<std::size_t>(lanes<Real>)> cost{};
  world_view.rays.primary += count(active);
  for (unsigned left = bits(active); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const auto alone = [&](const Vec3<Real>& v) {
      return Vec3f{static_cast<float>(lane(v.x, i)), static_cast<float>(lane(v.y, i)),
                   static_cast<float>(lane(v.z, i))};
    };
    WorkCounter work([&](std::int64_t portion) { world_view.work.test(portion); });
    closest_hit(world_view.world, Ray<float>{alone(ray.origin), alone(ray.direction)}, true, work);
    cost[static_cast<std::size_t>(i)] = static_cast<LaneOf<Real>>(work.tests());
  }
  const Real all = load<Real>(cost.data());
  return {all, all, all};
}

TIA_INTEGRATOR(normal)
TIA_INTEGRATOR(depth)
TIA_INTEGRATOR(albedo)
TIA_INTEGRATOR(object)
TIA_INTEGRATOR(shadow)
TIA_INTEGRATOR(cost)
TIA_INTEGRATOR(planar_depth)
TIA_INTEGRATOR(label)

}  // namespace tia
