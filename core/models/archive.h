// A model's flat form as bytes, from one process to another of the same program on the same
// machine: every value in the order of its struct's members, lists after their lengths.
#pragma once

#include <cstdint>
#include <optional>
#include <vector>

#include "core/models/model.h"
#include "core/models/model_files.h"

namespace tia {

/// Appends a model's bytes, about as many as its own lists have.
void append_archive(const Model& model, std::vector<std::uint8_t>& bytes);

/// The model that such bytes hold, which anybody may have written: its lists are as long as they
/// say, and check_model has still to say whether they fit together. None: the bytes end too early
/// or too late. Cost: memory of at most some ten times the bytes, and none before they are there.
std::optional<Model> unarchived(ModelBytes bytes);

}  // namespace tia
