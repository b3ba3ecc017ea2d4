// `tia radio paths|map SCENE QUESTION -o FILE`: radio waves followed without a server.
#pragma once

#include <string>

#include "server/operation/config.h"

namespace tia::server {

/// Writes what POST /radio/paths answers of a gallery scene or a scene file and a file with the
/// other parameters, as JSON, to a file (or "-", standard output).
/// Errors: InputError; std::runtime_error for files.
void radio_paths_to_file(const std::string& scene, const std::string& question,
                         const std::string& file, const Config& config);

/// The same of POST /radio/map: a PNG, or what the file's ending or the question's format says.
void radio_map_to_file(const std::string& scene, const std::string& question,
                       const std::string& file, const Config& config);

}  // namespace tia::server
