// ZIP archives: the files in them, unpacked into memory.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/input/errors.h"
#include "core/models/model_files.h"

namespace tia {

/// UnpackedFile: a file of an archive, by its clean path.
struct UnpackedFile {
  std::string path;
  std::vector<std::uint8_t> bytes;
};

/// ZipLimits: the most that is unpacked of an archive.
struct ZipLimits {
  std::uint64_t bytes = std::uint64_t{256} << 20U;  ///< of all files together
  std::uint64_t files = 1024;
  /// Of a file bytes unpacked for each byte packed; from 1 on. Files of at most 64 KiB are free.
  std::uint64_t ratio = 100;
};

/// Whether a file begins as archives do that hold a file.
bool is_zip(ModelBytes file);

/// The files, in the order of the archive's directory: stored or deflated, ZIP64 or not. Folders
/// and clutter (is_clutter()) are passed over. What readers could take in two ways is refused: the
/// directory, the headers before the files and their bytes must agree and lie apart.
/// Returns: none where there is a fault.
/// Errors: faults, `malformed`, `conflict` (a path twice) and `limit`, at "/PATH" where one file is
/// meant. Stopped, between two files.
/// Cost: memory for what is unpacked, taken file by file after all limits are seen to be kept.
/// Source: PKWARE, ".ZIP File Format Specification" 6.3.10 (APPNOTE), sections 4.3 to 4.5; Fifield,
/// "A better zip bomb" (WOOT 2019), for files that overlap.
std::vector<UnpackedFile> unpack_zip(ModelBytes archive, const ZipLimits& limits, Faults& faults);

}  // namespace tia
