#include "core/video/stored_zip.h"

#include <libdeflate.h>

#include <algorithm>

namespace tia {
namespace {

constexpr std::uint64_t no_room = 0xFFFFFFFF;  // four bytes that say: it stands elsewhere
constexpr std::uint64_t no_number = 0xFFFF;    // the same of two
constexpr std::uint32_t first_day = 0x0021;    // 1980-01-01, in 16 bits

/// Record: its numbers, the lowest byte first.
class Record {
 public:
  explicit Record(std::uint32_t signature) { add(signature, 4); }
  Record& add(std::uint64_t value, int bytes) {
    for (int i = 0; i < bytes; ++i) text_ += static_cast<char>(value >> 8 * i & 0xFFU);
    return *this;
  }
  Record& add(std::string_view text) {
    text_ += text;
    return *this;
  }
  std::string text() && { return std::move(text_); }

 private:
  std::string text_;
};

// What a file's header and its entry of the directory have in common, from the flags on: no
// compression, the first day's first second.
void describe(Record& record, std::uint32_t crc, std::uint32_t size, std::string_view name,
              std::size_t extra) {
  record.add(0, 2).add(0, 2).add(0, 2).add(first_day, 2).add(crc, 4).add(size, 4).add(size, 4);
  record.add(name.size(), 2).add(extra, 2);
}

}  // namespace

std::string StoredZip::file(std::string_view name, std::string_view bytes) {
  const auto size = static_cast<std::uint32_t>(bytes.size());
  const Entry entry{std::string(name), libdeflate_crc32(0, bytes.data(), bytes.size()), size,
                    written_};
  Record header(0x04034B50);
  header.add(10, 2);  // the version that is needed: 1.0
  describe(header, entry.crc, size, name, 0);
  std::string piece = std::move(header.add(name)).text();
  piece.append(bytes);
  entries_.push_back(entry);
  written_ += piece.size();
  return piece;
}

std::string StoredZip::directory() const {
  std::string all;
  for (const Entry& entry : entries_) {
    const bool is_far = entry.at >= no_room;
    Record header(0x02014B50);
    header.add(is_far ? 45 : 10, 2).add(is_far ? 45 : 10, 2);
    describe(header, entry.crc, entry.size, entry.name, is_far ? 12 : 0);
    header.add(0, 2).add(0, 2).add(0, 2).add(0, 4).add(std::min(entry.at, no_room), 4);
    header.add(entry.name);
    if (is_far) header.add(1, 2).add(8, 2).add(entry.at, 8);  // 4.5.3
    all += std::move(header).text();
  }
  return all;
}

std::string StoredZip::end() const {
  std::string piece = directory();
  const std::uint64_t size = piece.size(), count = entries_.size(), at = written_;
  if (at >= no_room || count >= no_number) {
    Record end(0x06064B50);  // 4.3.14
    end.add(44, 8).add(45, 2).add(45, 2).add(0, 4).add(0, 4).add(count, 8).add(count, 8);
    piece += std::move(end.add(size, 8).add(at, 8)).text();
    piece += std::move(Record(0x07064B50).add(0, 4).add(at + size, 8).add(1, 4)).text();
  }
  Record end(0x06054B50);
  const std::uint64_t told = std::min(count, no_number);
  end.add(0, 2).add(0, 2).add(told, 2).add(told, 2).add(size, 4).add(std::min(at, no_room), 4);
  return piece += std::move(end.add(0, 2)).text();
}

}  // namespace tia
