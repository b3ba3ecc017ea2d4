// A model's file as a scene: itself, its camera, its lights.
#pragma once

#include <stop_token>
#include <string>

#include "core/models/kept_model.h"
#include "core/scene/scene.h"

namespace tia {

/// The scene of a file: one object, the model of that id; the first of the file's cameras that its
/// scene shows, else one that frames it from azimuth 30 and elevation 20 degrees in a picture of
/// that aspect; its lights (model_lights.h), else a sky of 1 all around, the studio `neutral`; by
/// path. Domain: a model that check_model has passed. Cost: goes through all that it shows.
/// Errors: InputError as resolve_models' faults; Stopped.
Scene model_scene(const SharedModel& model, const std::string& id, double aspect,
                  const std::stop_token& stop = {});

}  // namespace tia
