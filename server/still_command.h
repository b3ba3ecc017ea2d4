// `tia still FILE -o PICTURE`: the picture of a model's file, without a server.
#pragma once

#include <string>
#include <vector>

#include "server/operation/config.h"

namespace tia::server {

/// Draws the still of a model, whose files are as `tia model` takes them, to a file (or "-",
/// standard output), or with as=scene writes its scene there. `parameters` are /still's own, by
/// name; `plain`: one ray and one thing at a time. Errors: InputError; std::runtime_error in words.
void still_to_file(const std::vector<std::string>& names, const std::string& file,
                   const std::vector<Setting>& parameters, bool plain, const Config& config);

}  // namespace tia::server
