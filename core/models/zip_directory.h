// What is in a ZIP archive, as its central directory and the headers before its files agree on it.
// No file is unpacked here, and no limit kept: see zip.h.
#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "core/input/errors.h"
#include "core/models/model_files.h"

namespace tia {

/// ZipEntry: a file of an archive, still packed.
struct ZipEntry {
  std::string path;  ///< clean
  ModelBytes packed;
  bool deflated = false;       ///< else as it is
  std::uint64_t unpacked = 0;  ///< how many bytes it says that it has
  std::uint32_t crc = 0;       ///< CRC-32 of those
};

/// The files but folders and clutter, in the directory's order.
/// Returns: something of no meaning where there is a fault.
/// Errors: faults as unpack_zip() has them. Cost: n log n in the archive's files.
std::vector<ZipEntry> zip_entries(ModelBytes archive, Faults& faults);

}  // namespace tia
