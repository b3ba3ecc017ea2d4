#include "core/integrators/features.h"

#include <array>

#include "core/integrators/direct.h"

namespace tia {
template <class Real>
Vec3<Real> normal_feature(WorldScope& scope, const Ray<Real>& ray, Mask<Real> active) {
  const auto seen = surfaces(scope, ray, first_hit(scope, ray, active), active);
  return select(seen.here, seen.at.n, {Real(0), Real(0), Real(0)});
}

template <class Real>
Vec3<Real> depth_feature(WorldScope& scope, const Ray<Real>& ray, Mask<Real> active) {
  const Real t = first_hit(scope, ray, active).t;
  return {t, t, t};
}

template <class Real>
Vec3<Real> albedo_feature(WorldScope& scope, const Ray<Real>& ray, Mask<Real> active) {
  const auto seen = surfaces(scope, ray, first_hit(scope, ray, active), active);
  return select(seen.here, seen.albedo, {Real(0), Real(0), Real(0)});
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
  const auto seen = surfaces(scope, ray, first_hit(scope, ray, active), active);
  const std::vector<Lamp>& lamps = scope.world.lamps;
  if (lamps.empty() || !any(seen.here)) return {Real(1), Real(1), Real(1)};
  Real lit(0);
  for (const Lamp& lamp : lamps) {
    const auto from = scope.from_middle(lamp, seen.at.p);
    lit = lit + from_place(scope, lamp, from, seen, ray.direction, {}).visible;
  }
  const Real share = select(seen.here, lit / Real(static_cast<float>(lamps.size())), Real(1));
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
    WorkCounter work([&](std::int64_t portion) { scope.work.test(portion); });
    closest_hit(scope.world, Ray<float>{alone(ray.origin), alone(ray.direction)}, true, work);
    cost[static_cast<std::size_t>(i)] = static_cast<LaneOf<Real>>(work.tests());
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
