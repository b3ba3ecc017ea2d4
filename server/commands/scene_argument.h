// The scene that a command is called with.
#pragma once

#include <string>

#include "core/scene/scene.h"

namespace tia::server {

/// A gallery scene by its name, or the scene in a file, NAME.json or a path.
/// Errors: InputError; std::runtime_error naming what is not there.
Scene scene_called(const std::string& scene);

}  // namespace tia::server
