// `tia simulate SCENE -o FILE`: a scene's motion found without a server.
#pragma once

#include <string>

#include "server/operation/config.h"

namespace tia::server {

/// Writes a gallery scene or a scene file with tracks in the place of its physics, as canonical
/// text, to a file (or "-", standard output). Errors: InputError; std::runtime_error for files, and
/// for a scene without physics.
void simulate_to_file(const std::string& scene, const std::string& file, const Config& config);

}  // namespace tia::server
