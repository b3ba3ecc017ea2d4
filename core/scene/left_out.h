// What a scene says and a picture of it does not show.
#pragma once

#include <vector>

#include "core/scene/scene.h"

namespace tia {

/// LeftOut: a part of a scene that an integrator leaves out.
struct LeftOut {
  const char* pointer;  ///< into the scene
  const char* about;    ///< a sentence: who heeds it
};
/// All of them, in the order of the scene's fields.
std::vector<LeftOut> left_out_by(IntegratorName integrator, const Scene& scene);

}  // namespace tia
