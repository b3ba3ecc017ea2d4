// `tia model`: what is told of a model's file, without a server.
#pragma once

#include <string>
#include <vector>

namespace tia::server {

/// Writes the description of a model to standard output, as GET /models/{id} tells it. The first
/// name is the model's file; the others come with it, and so do those that it names and that stand
/// in its folder or below. Errors: std::runtime_error in words.
void describe_model(const std::vector<std::string>& names);

}  // namespace tia::server
