// What every integrator computes: the numbers along a camera ray. THE LIST of them is
// core/scene/integrators.h; each one's radiance() is defined in a file beside this one.
#pragma once

#include <utility>

#include "core/integrators/world_view.h"

namespace tia {

/// Integrator: one of the list's. Its file defines radiance() for it,
///   template <>
///   template <class Real>
///   Vec3<Real> Integrator<IntegratorName::depth>::radiance(...) {...}
///   TIA_INTEGRATOR(depth)
/// and one of another signature does not compile; without any, nothing that draws links.
template <IntegratorName name>
struct Integrator {
  /// Returns: linear RGB, unclamped, or a feature. Lanes that are not active come out meaningless
  /// and do not count as rays. The sampler state tells pixels and sample.
  template <class Real>
  static Vec3<Real> radiance(WorldView& world_view, const Ray<Real>& ray, Mask<Real> active,
                             const SamplerState<Real>& sampler_state);
};

/// Makes an integrator's radiance() for the three scalars.
#define TIA_INTEGRATOR_OF(name, Real)                             \
  template Vec3<Real> Integrator<IntegratorName::name>::radiance( \
      WorldView&, const Ray<Real>&, Mask<Real>, const SamplerState<Real>&);
#define TIA_INTEGRATOR(name)     \
  TIA_INTEGRATOR_OF(name, Wide)  \
  TIA_INTEGRATOR_OF(name, float) \
  TIA_INTEGRATOR_OF(name, double)

/// The radiance() of an integrator by its name.
template <class Real>
Vec3<Real> radiance(IntegratorName name, WorldView& world_view, const Ray<Real>& ray,
                    Mask<Real> active, const SamplerState<Real>& sampler_state) {
  using Radiance =
      Vec3<Real> (*)(WorldView&, const Ray<Real>&, Mask<Real>, const SamplerState<Real>&);
  static constexpr auto all = []<std::size_t... i>(std::index_sequence<i...>) {
    return std::array<Radiance, sizeof...(i)>{
        &Integrator<integrators[i].name>::template radiance<Real>...};
  }
  (std::make_index_sequence<integrators.size()>());
  return all[static_cast<std::size_t>(name)](world_view, ray, active, sampler_state);
}

/// Tells world_view.guides what camera rays find, by a search of their own: for integrators that do
/// not tell it themselves. Seen is the share of the lights' middles.
template <class Real>
void find_guides(WorldView& world_view, const Ray<Real>& ray, Mask<Real> active);

/// Whether radiance() tells the guides by itself.
constexpr bool tells_guides(IntegratorName name) { return row_of(name).is_chance(); }

}  // namespace tia
