#include "core/integrators/features.h"

#include <array>

namespace tia {
namespace {

// Calls f(point, hit, part, lanes) for what the lanes' rays meet first.
template <class Real, class F>
void for_each_surface(WorldScope& scope, const Ray<Real>& ray, Mask<Real> active, F f) {
  const Hit<Real> hit = first_hit(scope, ray, active);
  for_each_winner(hit, active, [&](int part, Mask<Real> here) {
    f(scope.surface_of(ray, hit, part, here), hit, part, here);
  });
}

}  // namespace

template <class Real>
Vec3<Real> normal_feature(WorldScope& scope, const Ray<Real>& ray, Mask<Real> active) {
  Vec3<Real> n{Real(0), Real(0), Real(0)};
  for_each_surface(scope, ray, active,
                   [&](const SurfacePoint<Real>& at, const Hit<Real>&, int, Mask<Real> here) {
                     n = select(here, at.n, n);
                   });
  return n;
}

template <class Real>
Vec3<Real> depth_feature(WorldScope& scope, const Ray<Real>& ray, Mask<Real> active) {
  const Real t = first_hit(scope, ray, active).t;
  return {t, t, t};
}

template <class Real>
Vec3<Real> albedo_feature(WorldScope& scope, const Ray<Real>& ray, Mask<Real> active) {
  Vec3<Real> albedo{Real(0), Real(0), Real(0)};
  for_each_winner(first_hit(scope, ray, active), active, [&](int part, Mask<Real> here) {
    albedo = select(here, lift<Real>(scope.world.matte_of(part).albedo), albedo);
  });
  return albedo;
}

template <class Real>
Vec3<Real> object_feature(WorldScope& scope, const Ray<Real>& ray, Mask<Real> active) {
  Real number(0);
  for_each_winner(first_hit(scope, ray, active), active, [&](int part, Mask<Real> here) {
    const int object = scope.world.part(part).object;
    number = select(here, Real(static_cast<float>(object + 1)), number);
  });
  return {number, number, number};
}

template <class Real>
Vec3<Real> shadow_feature(WorldScope& scope, const Ray<Real>& ray, Mask<Real> active) {
  const std::vector<Lamp>& lamps = scope.world.lamps;
  Real share(1);
  for_each_surface(scope, ray, active,
                   [&](const SurfacePoint<Real>& at, const Hit<Real>& hit, int, Mask<Real> here) {
                     if (lamps.empty()) return;
                     Real seen(0);
                     for (const Lamp& lamp : lamps) {
                       const Real cosine =
                           visible_cosine(scope, at, lamp, shadow_offset(hit.t, at.p), here);
                       seen = seen + select(cosine > Real(0), Real(1), Real(0));
                     }
                     share = select(here, seen / Real(static_cast<float>(lamps.size())), share);
                   });
  return {share, share, share};
}

template <class Real>
Vec3<Real> cost_feature(WorldScope& scope, const Ray<Real>& ray, Mask<Real> active) {
  std::array<LaneOf<Real>, static_cast<std::size_t>(lanes<Real>)> cost{};
  scope.rays.primary += count(active);
  for (unsigned left = bits(active); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const auto alone = [&](const Vec3<Real>& v) {
      return Vec3f{static_cast<float>(lane(v.x, i)), static_cast<float>(lane(v.y, i)),
                   static_cast<float>(lane(v.z, i))};
    };
    std::int64_t tests = 0;
    closest_hit(scope.world, Ray<float>{alone(ray.origin), alone(ray.direction)}, true, tests);
    cost[static_cast<std::size_t>(i)] = static_cast<LaneOf<Real>>(tests);
  }
  const Real all = load<Real>(cost.data());
  return {all, all, all};
}

#define TIA_FEATURES(Real)                                                       \
  template Vec3<Real> normal_feature(WorldScope&, const Ray<Real>&, Mask<Real>); \
  template Vec3<Real> depth_feature(WorldScope&, const Ray<Real>&, Mask<Real>);  \
  template Vec3<Real> albedo_feature(WorldScope&, const Ray<Real>&, Mask<Real>); \
  template Vec3<Real> object_feature(WorldScope&, const Ray<Real>&, Mask<Real>); \
  template Vec3<Real> shadow_feature(WorldScope&, const Ray<Real>&, Mask<Real>); \
  template Vec3<Real> cost_feature(WorldScope&, const Ray<Real>&, Mask<Real>);
TIA_FEATURES(Wide)
TIA_FEATURES(float)
TIA_FEATURES(double)
#undef TIA_FEATURES

}  // namespace tia
