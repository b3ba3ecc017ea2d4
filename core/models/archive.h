// A model's flat form as bytes, from one process to another of the same program on the same
// machine: every value in the order of its struct's members, lists after their lengths.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>

#include "core/models/model.h"
#include "core/models/model_files.h"

namespace tia {

/// How many bytes a model's archive has: about as many as its own lists.
std::uint64_t archive_size(const Model& model);

/// Calls write(bytes) with a model's archive, piece by piece: long lists are not copied.
void write_archive(const Model& model, const std::function<void(ModelBytes)>& write);

/// The model that such bytes hold, which anybody may have written: its lists are as long as they
/// say, and check_model has still to say whether they fit together. None: the bytes end too early
/// or too late. Cost: memory of at most some ten times the bytes, and none before they are there.
std::optional<Model> unarchived(ModelBytes bytes);

}  // namespace tia
