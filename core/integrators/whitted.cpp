#include "core/integrators/whitted.h"

namespace tia {

template <class Real>
Vec3<Real> whitted(WorldScope& scope, const Ray<Real>& ray, Mask<Real> active,
                   const Draws<Real>& draws) {
  NoNotes notes;
  return Whitted<WorldScope, Real>(scope, notes).trace(ray, active, Path<Real>{draws});
}

template Vec3<Wide> whitted(WorldScope&, const Ray<Wide>&, Mask<Wide>, const Draws<Wide>&);
template Vec3<float> whitted(WorldScope&, const Ray<float>&, bool, const Draws<float>&);
template Vec3<double> whitted(WorldScope&, const Ray<double>&, bool, const Draws<double>&);

std::unique_ptr<RayNode> explain_whitted(WorldScope& scope, const Ray<float>& ray,
                                         const Draws<float>& draws, const NoteLimit& limit) {
  Notes notes(limit);
  Whitted<WorldScope, float, Notes>(scope, notes).trace(ray, true, Path<float>{draws});
  return notes.take();
}

}  // namespace tia
