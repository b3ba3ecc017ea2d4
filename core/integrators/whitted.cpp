#include "core/integrators/whitted.h"

#include "core/integrators/integrator.h"

namespace tia {

template <>
template <class Real>
Vec3<Real> Integrator<IntegratorName::whitted>::radiance(WorldView& world_view,
                                                         const Ray<Real>& ray, Mask<Real> active,
                                                         const SamplerState<Real>& sampler_state) {
  NoRecorder recorder;
  return Whitted<WorldView, Real>(world_view, recorder)
      .trace(ray, active, RayPath<Real>{sampler_state});
}
TIA_INTEGRATOR(whitted)

// The same within narrower rules, which the world view has.
template <>
template <class Real>
Vec3<Real> Integrator<IntegratorName::thesis>::radiance(WorldView& world_view, const Ray<Real>& ray,
                                                        Mask<Real> active,
                                                        const SamplerState<Real>& sampler_state) {
  return Integrator<IntegratorName::whitted>::radiance(world_view, ray, active, sampler_state);
}
TIA_INTEGRATOR(thesis)

std::unique_ptr<RayNode> explain_whitted(WorldView& world_view, const Ray<float>& ray,
                                         const SamplerState<float>& sampler_state,
                                         const RayTreeLimit& limit) {
  RayTreeRecorder recorder(limit);
  Whitted<WorldView, float, RayTreeRecorder>(world_view, recorder)
      .trace(ray, true, RayPath<float>{sampler_state});
  return recorder.take();
}

}  // namespace tia
