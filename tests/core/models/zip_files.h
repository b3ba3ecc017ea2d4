// ZIP archives put together record by record, with zlib, which the product does not use: whatever
// a record says can be made a lie.
#pragma once

#include <zlib.h>

#include <cstdint>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace tia::test {

/// The number's bytes, little-endian.
inline std::string zip_bytes(std::uint64_t number, int width) {
  std::string bytes;
  for (int i = 0; i < width; ++i) bytes += static_cast<char>(number >> (8 * i) & 0xFFU);
  return bytes;
}

/// The text as a raw deflate stream (RFC 1951).
inline std::string zip_deflated(std::string_view text, int level = 9) {
  z_stream stream{};
  if (deflateInit2(&stream, level, Z_DEFLATED, -MAX_WBITS, 8, Z_DEFAULT_STRATEGY) != Z_OK)
    throw std::runtime_error("no deflate");
  std::string source(text), out(deflateBound(&stream, text.size()) + 16, '\0');
  stream.next_in = reinterpret_cast<Bytef*>(source.data());
  stream.avail_in = static_cast<uInt>(source.size());
  stream.next_out = reinterpret_cast<Bytef*>(out.data());
  stream.avail_out = static_cast<uInt>(out.size());
  if (deflate(&stream, Z_FINISH) != Z_STREAM_END) throw std::runtime_error("no end");
  out.resize(stream.total_out);
  deflateEnd(&stream);
  return out;
}

/// What a header says of a file. Each of the two headers has its own.
struct ZipWords {
  unsigned flags = 0, method = 0;
  std::uint64_t crc = 0, packed = 0, unpacked = 0;
  std::string name, extra;

  std::string text() const {
    return zip_bytes(flags, 2) + zip_bytes(method, 2) + zip_bytes(0x58221883, 4) +
           zip_bytes(crc, 4) + zip_bytes(packed, 4) + zip_bytes(unpacked, 4) +
           zip_bytes(name.size(), 2) + zip_bytes(extra.size(), 2);
  }
};

/// A file of an archive. What is not set stands as it is true.
struct ZipItem {
  ZipWords local, central;
  std::string data;           ///< as packed
  std::string behind;         ///< after it: a data descriptor
  unsigned made_by = 0x031E;  ///< Unix
  std::uint64_t attributes = std::uint64_t{0100644} << 16U;
  unsigned disk = 0;
  std::string comment;
  std::optional<std::uint64_t> at;  ///< where the directory says it is
};

inline ZipItem zip_item(const std::string& name, const std::string& text, bool deflated = true) {
  ZipItem item;
  item.data = deflated ? zip_deflated(text) : text;
  ZipWords& words = item.central;
  words.method = deflated ? 8 : 0;
  words.crc = crc32(0, reinterpret_cast<const Bytef*>(text.data()), static_cast<uInt>(text.size()));
  words.packed = item.data.size();
  words.unpacked = text.size();
  words.name = name;
  item.local = words;
  return item;
}

/// The records around the files. What is not set stands as it is true.
struct ZipShape {
  std::string comment, before_end;
  std::optional<std::uint64_t> entries, here, size, at, comment_size;
  unsigned disk = 0, directory_disk = 0;
};

inline std::string zip_of(const std::vector<ZipItem>& items, const ZipShape& shape = {}) {
  std::string files, directory;
  for (const ZipItem& item : items) {
    const std::uint64_t at = item.at.value_or(files.size());
    files += zip_bytes(0x04034B50, 4) + zip_bytes(20, 2) + item.local.text() + item.local.name +
             item.local.extra + item.data + item.behind;
    directory += zip_bytes(0x02014B50, 4) + zip_bytes(item.made_by, 2) + zip_bytes(20, 2) +
                 item.central.text() + zip_bytes(item.comment.size(), 2) + zip_bytes(item.disk, 2) +
                 zip_bytes(0, 2) + zip_bytes(item.attributes, 4) + zip_bytes(at, 4) +
                 item.central.name + item.central.extra + item.comment;
  }
  const std::uint64_t entries = shape.entries.value_or(items.size());
  return files + directory + shape.before_end + zip_bytes(0x06054B50, 4) +
         zip_bytes(shape.disk, 2) + zip_bytes(shape.directory_disk, 2) +
         zip_bytes(shape.here.value_or(entries), 2) + zip_bytes(entries, 2) +
         zip_bytes(shape.size.value_or(directory.size()), 4) +
         zip_bytes(shape.at.value_or(files.size()), 4) +
         zip_bytes(shape.comment_size.value_or(shape.comment.size()), 2) + shape.comment;
}

}  // namespace tia::test
