// `tia film SCENE -o FILE`: the same films without a server.
#pragma once

#include <string>
#include <vector>

#include "server/operation/config.h"

namespace tia::server {

/// "NAME.apng, NAME.zip" and so on: the files whose ending names their format.
std::string film_files();

/// Draws a gallery scene or a scene file as a film to a file (or "-", standard output), which is
/// there once it is whole. `parameters` are /film's own, by name; `shows_progress`: frames, rate
/// and the time left on standard error. Errors: InputError; std::invalid_argument where the
/// file's name says another format; std::runtime_error for files.
void film_to_file(const std::string& scene, const std::string& file,
                  const std::vector<Setting>& parameters, bool shows_progress,
                  const Config& config);

}  // namespace tia::server
