// What the server and the process that reads a model say to each other: a request of files and
// limits, an answer of a model's flat form and its pictures, or of faults.
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/models/formats.h"
#include "core/models/kept_model.h"
#include "server/stores/exchange_parts.h"
#include "server/stores/reader_answer.h"

namespace tia::server {

/// What stands before the files' bytes in a request: a line of JSON that tells their paths and
/// sizes, which is the main one, and the limits.
std::string request_head(const ModelFiles& files, const ModelLimits& limits);

/// How long a request is that begins so, as its head tells; 0: as yet, or of an archive, unknown.
/// Errors: std::runtime_error of what is no request.
std::size_t request_length(std::span<const std::uint8_t> begin);

/// The answer to a whole request, which only the server writes: of a model its archive and what its
/// pictures hold, of an archive its files, else the faults. Errors: std::runtime_error of what is
/// no request; std::bad_alloc. Cost: a model's pictures in memory, and its archive.
ReaderAnswer answer_to(std::span<const std::uint8_t> request);

/// The model of an answer, which is looked at as a stranger's: without the files of its pictures,
/// but with what they hold. Errors: InputError of its faults; NoAnswer.
KeptModel model_of(std::span<const std::uint8_t> answer, const ModelLimits& limits);

}  // namespace tia::server
