// ZIP archives of files that are not compressed, written while they come.
#pragma once

#include <cstdint>
#include <string>
#include <string_view>
#include <vector>

namespace tia {

/// StoredZip. Same files, same bytes: all are of 1980-01-01, the format's first day.
/// Source: PKWARE, ".ZIP File Format Specification" 6.3.10 (APPNOTE), sections 4.3 and 4.5.
class StoredZip {
 public:
  /// `before`: bytes that have been written before it, and count as its own.
  explicit StoredZip(std::uint64_t before = 0) : written_(before) {}

  /// The next piece: a file. Domain: names of ASCII, each once; files below 4 GiB.
  std::string file(std::string_view name, std::string_view bytes);
  /// The last piece: the directory; in ZIP64's form where it begins beyond 4 GiB or has more than
  /// 65 534 files.
  std::string end() const;

 private:
  struct Entry {
    std::string name;
    std::uint32_t crc, size;
    std::uint64_t at;  // from where on it stands
  };
  std::string directory() const;

  std::vector<Entry> entries_;
  std::uint64_t written_;
};

}  // namespace tia
