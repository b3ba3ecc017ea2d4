#include "core/integrators/whitted.h"

#include "core/integrators/integrator.h"

namespace tia {

template <>
template <class Real>
Vec3<Real> Integrator<IntegratorName::whitted>::radiance(WorldScope& scope, const Ray<Real>& ray,
                                                         Mask<Real> active,
                                                         const Draws<Real>& draws) {
  NoNotes notes;
  return Whitted<WorldScope, Real>(scope, notes).trace(ray, active, Path<Real>{draws});
}
TIA_INTEGRATOR(whitted)

// The same within narrower rules, which the scope has.
template <>
template <class Real>
Vec3<Real> Integrator<IntegratorName::thesis>::radiance(WorldScope& scope, const Ray<Real>& ray,
                                                        Mask<Real> active,
                                                        const Draws<Real>& draws) {
  return Integrator<IntegratorName::whitted>::radiance(scope, ray, active, draws);
}
TIA_INTEGRATOR(thesis)

std::unique_ptr<RayNode> explain_whitted(WorldScope& scope, const Ray<float>& ray,
                                         const Draws<float>& draws, const NoteLimit& limit) {
  Notes notes(limit);
  Whitted<WorldScope, float, Notes>(scope, notes).trace(ray, true, Path<float>{draws});
  return notes.take();
}

}  // namespace tia
