// `tia render SCENE -o FILE`: the same pictures without a server.
#pragma once

#include <string>
#include <vector>

#include "server/operation/config.h"
#include "server/progress.h"

namespace tia::server {

/// Draws a gallery scene or a scene file to a file (or "-", standard output). `parameters` are
/// /render's own, by name; `plain`: one ray and one thing at a time, which is slow and gives the
/// same bytes; `watching`: what is seen of it until then. Errors: InputError; std::runtime_error
/// for files.
void render_to_file(const std::string& scene, const std::string& file,
                    const std::vector<Setting>& parameters, bool plain, const Watching& watching,
                    const Config& config);

}  // namespace tia::server
