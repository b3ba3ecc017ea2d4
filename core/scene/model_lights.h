// The lights of a model's file as a scene's.
#pragma once

#include <vector>

#include "core/lights/light.h"
#include "core/math/transform.h"
#include "core/models/pose.h"

namespace tia {

/// The lights that shown nodes have, where their node is and along its -z. Candela and lux are
/// taken as W/sr and W/m^2, as path has them. A spot is full within its inner cone and falls to
/// nothing at the outer one as SpotLight does, which is smoother than KHR_lights_punctual proposes.
/// Left out are those that shine nowhere: whose node is not is_usable(), as one of scale 0.
/// Space/units: `to_scene` goes from the model's space to the scene's. Domain: as pose_of's.
std::vector<Light> model_lights(const Model& model, const Pose& pose, const Affine& to_scene);

}  // namespace tia
