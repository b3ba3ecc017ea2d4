// Answers of a reader's process that are still to come.
#pragma once

#include "core/models/byte_source.h"
#include "core/models/kept_model.h"
#include "core/models/model_files.h"

namespace tia::server {

/// As model_of() of an answer that is there (model_exchange.h): its bytes go into the model's own
/// lists, piece by piece, and are nowhere else. Errors: the same, and those of reading them.
KeptModel model_of(ByteSource& answer, const ModelLimits& limits);

}  // namespace tia::server
