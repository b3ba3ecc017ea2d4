// What the server and the process that unpacks an archive say to each other: a request of the
// archive and its limits, an answer of its files, or of faults.
#pragma once

#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "core/input/value.h"
#include "core/models/model_files.h"
#include "core/models/zip.h"
#include "server/stores/reader_answer.h"

namespace tia::server {

/// What stands before the archive's bytes in a request: a line of JSON that tells the limits.
std::string unpack_head(const ZipLimits& limits);
/// Whether a request's head is such a line.
bool asks_to_unpack(const Value& head);
/// The answer to such a request: the number of files, their paths' and their own lengths, their
/// paths, and their bytes. Errors: InputError as unpack_zip; std::runtime_error of what is no head.
ReaderAnswer unpacked_answer(const Value& head, ModelBytes archive);

/// The most bytes of an answer within these limits.
std::size_t longest_unpacked(const ZipLimits& limits);
/// The files of an answer, as views into it. It is looked at as a stranger's: their paths are clean
/// and no clutter, each is there once, and all are within the limits.
/// Errors: InputError of its faults; NoAnswer.
std::vector<ModelFile> unpacked_files(std::span<const std::uint8_t> answer,
                                      const ZipLimits& limits);

}  // namespace tia::server
