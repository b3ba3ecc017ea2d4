// The records of a ZIP archive, as they stand in it. What they say is not believed here.
// Source: PKWARE, ".ZIP File Format Specification" 6.3.10 (APPNOTE), sections 4.3.7, 4.3.12,
// 4.3.14 to 4.3.16 and 4.5.3.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string_view>

#include "core/models/model_files.h"

namespace tia {

/// ZipEnd: the end of central directory record.
struct ZipEnd {
  std::size_t at = 0;  ///< where it begins, or the ZIP64 records that belong to it
  bool one_disk = true;
  std::uint64_t entries = 0, directory_size = 0, directory_at = 0;
};

/// The record whose comment ends where the archive does: the last one. ZIP64's records before it
/// count where they repeat it. Returns: nothing where there is none, or where it needs theirs.
std::optional<ZipEnd> find_zip_end(ModelBytes archive);

/// ZipHeader: what stands before a file's bytes, and about it in the central directory.
struct ZipHeader {
  static constexpr unsigned encrypted = 0x2041;     ///< flags: bits 0, 6 and 13
  static constexpr unsigned sizes_follow = 0x0008;  ///< bit 3: sizes and CRC stand after the data

  unsigned flags = 0, method = 0;
  std::uint64_t crc = 0, packed = 0, unpacked = 0;
  std::string_view name;
  std::size_t size = 0;  ///< of all of it, bytes
  bool has_numbers =
      true;  ///< whether those that are too large for 32 bits stand in the ZIP64 field
  // In the central directory only:
  bool first_disk = true, link = false;
  std::uint64_t header_at = 0;
};

/// The header at the front of some bytes. Returns: nothing where it is none, or breaks off.
std::optional<ZipHeader> central_zip_header(ModelBytes bytes);
std::optional<ZipHeader> local_zip_header(ModelBytes bytes);

}  // namespace tia
