#include "core/scene/left_out.h"

namespace tia {

std::vector<LeftOut> left_out_by(IntegratorName integrator, const Scene& scene) {
  std::vector<LeftOut> left_out;
  const auto heeds = [&](IntegratorName only, bool is_said, const LeftOut& what) {
    if (is_said && integrator != only) left_out.push_back(what);
  };
  const SceneOptions& options = scene.options;
  heeds(IntegratorName::path, scene.fog.has_value(), {"/fog", "only path sees fog"});
  heeds(IntegratorName::ambient_occlusion, options.ao_radius.has_value(),
        {"/options/ao_radius", "only ambient_occlusion looks so far"});
  heeds(IntegratorName::path, options.clamp.has_value(),
        {"/options/clamp", "only path's samples are clamped"});
  return left_out;
}

}  // namespace tia
