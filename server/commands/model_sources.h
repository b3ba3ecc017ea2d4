// The files of a model on this machine, for the command line.
#pragma once

#include <functional>
#include <string>
#include <vector>

#include "core/models/model_files.h"

namespace tia::server {

/// Calls read() with a model's files: the first name is the model's, the others come with it, and
/// so do those that it names and that stand in its folder or below: read() is called again with
/// what its faults miss. Errors: std::runtime_error in words; whatever else read() throws.
void read_model_files(const std::vector<std::string>& names,
                      const std::function<void(const ModelFiles&)>& read);

}  // namespace tia::server
