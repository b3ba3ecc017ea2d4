#include "core/models/zip_headers.h"

#include <algorithm>
#include <initializer_list>

namespace tia {
namespace {

constexpr std::uint64_t zip_all_ones = 0xFFFFFFFF;

// An unsigned number of so many bytes, little-endian. Domain: they are there.
std::uint64_t zip_number(ModelBytes bytes, std::size_t at, std::size_t width) {
  std::uint64_t number = 0;
  for (std::size_t i = width; i-- > 0;) number = number << 8U | bytes[at + i];
  return number;
}
bool has_zip_mark(ModelBytes bytes, std::uint32_t mark) {
  return bytes.size() >= 4 && zip_number(bytes, 0, 4) == mark;
}

// ---- the end ------------------------------------------------------------------------------------

// ZIP64's record and locator, where they stand before the end and say the same: what some packers
// write before they know that they need not. Returns: whether what stands there is not that.
bool take_zip64_end(ModelBytes archive, ZipEnd& end) {
  constexpr std::size_t record_size = 56, locator_size = 20;
  constexpr std::uint32_t record_mark = 0x06064B50, locator_mark = 0x07064B50;
  if (end.at < locator_size || !has_zip_mark(archive.subspan(end.at - locator_size), locator_mark))
    return true;
  if (end.at < record_size + locator_size) return false;
  const std::size_t at = end.at - locator_size - record_size;
  const ModelBytes record = archive.subspan(at, record_size);
  if (!has_zip_mark(record, record_mark) || zip_number(record, 32, 8) != end.entries ||
      zip_number(record, 40, 8) != end.directory_size ||
      zip_number(record, 48, 8) != end.directory_at ||
      zip_number(archive, end.at - locator_size + 8, 8) != at)
    return false;
  end.at = at;
  return true;
}

// ---- headers ------------------------------------------------------------------------------------

// The extra field of that kind, or nothing in it.
ModelBytes extra_zip_field(ModelBytes extra, std::uint64_t kind) {
  while (extra.size() >= 4) {
    const std::uint64_t found = zip_number(extra, 0, 2), size = zip_number(extra, 2, 2);
    extra = extra.subspan(4);
    if (size > extra.size()) break;
    if (found == kind) return extra.first(size);
    extra = extra.subspan(size);
  }
  return {};
}

// Numbers that are all ones stand in the ZIP64 field, in this order. Returns: whether they do.
bool take_zip64_numbers(ModelBytes extra, std::initializer_list<std::uint64_t*> numbers) {
  ModelBytes field = extra_zip_field(extra, 1);
  for (std::uint64_t* number : numbers) {
    if (*number != zip_all_ones) continue;
    if (field.size() < 8) return false;
    *number = zip_number(field, 0, 8);
    field = field.subspan(8);
  }
  return true;
}

// Both headers say the same in the same order from their flags on, end with fixed bytes that
// differ, and then have name and extra field. Returns: the extra field, or nothing.
std::optional<ModelBytes> read_zip_header(ModelBytes bytes, std::size_t flags_at, std::size_t fixed,
                                          ZipHeader& header) {
  if (bytes.size() < fixed) return std::nullopt;
  const auto number = [&](std::size_t at, std::size_t width) {
    return zip_number(bytes, flags_at + at, width);
  };
  header.flags = static_cast<unsigned>(number(0, 2));
  header.method = static_cast<unsigned>(number(2, 2));
  header.crc = number(8, 4);
  header.packed = number(12, 4);
  header.unpacked = number(16, 4);
  const std::size_t name_size = number(20, 2), extra_size = number(22, 2);
  if (name_size + extra_size > bytes.size() - fixed) return std::nullopt;
  header.name = {reinterpret_cast<const char*>(bytes.data()) + fixed, name_size};
  header.size = fixed + name_size + extra_size;
  return bytes.subspan(fixed + name_size, extra_size);
}

// Whether the attributes are those of a symbolic link, for whose packer files have Unix' kinds.
bool is_zip_link(std::uint64_t made_by, std::uint64_t attributes) {
  constexpr std::uint64_t on_unix = 3, on_macos = 19, link = 10;
  const std::uint64_t system = made_by >> 8U;
  return (system == on_unix || system == on_macos) && attributes >> 28U == link;
}

}  // namespace

std::optional<ZipEnd> find_zip_end(ModelBytes archive) {
  constexpr std::size_t size = 22, longest_comment = 65'535;
  constexpr std::uint32_t mark = 0x06054B50;
  if (archive.size() < size) return std::nullopt;
  const std::size_t last = archive.size() - size;
  const std::size_t first = last - std::min(last, longest_comment);
  for (std::size_t at = last + 1; at-- > first;) {
    const ModelBytes record = archive.subspan(at);
    if (!has_zip_mark(record, mark) || zip_number(record, 20, 2) != last - at) continue;
    ZipEnd end{at, true, zip_number(record, 10, 2), zip_number(record, 12, 4),
               zip_number(record, 16, 4)};
    end.one_disk = zip_number(record, 4, 2) == 0 && zip_number(record, 6, 2) == 0 &&
                   zip_number(record, 8, 2) == end.entries;
    if (!take_zip64_end(archive, end)) return std::nullopt;
    return end;
  }
  return std::nullopt;
}

std::optional<ZipHeader> central_zip_header(ModelBytes bytes) {
  constexpr std::size_t flags_at = 8, fixed = 46;
  ZipHeader header;
  if (!has_zip_mark(bytes, 0x02014B50)) return std::nullopt;
  const auto extra = read_zip_header(bytes, flags_at, fixed, header);
  if (!extra) return std::nullopt;
  const std::size_t comment_size = zip_number(bytes, 32, 2);
  if (comment_size > bytes.size() - header.size) return std::nullopt;
  header.size += comment_size;
  header.first_disk = zip_number(bytes, 34, 2) == 0;
  header.link = is_zip_link(zip_number(bytes, 4, 2), zip_number(bytes, 38, 4));
  header.header_at = zip_number(bytes, 42, 4);
  header.has_numbers =
      take_zip64_numbers(*extra, {&header.unpacked, &header.packed, &header.header_at});
  return header;
}

std::optional<ZipHeader> local_zip_header(ModelBytes bytes) {
  constexpr std::size_t flags_at = 6, fixed = 30;
  ZipHeader header;
  if (!has_zip_mark(bytes, 0x04034B50)) return std::nullopt;
  const auto extra = read_zip_header(bytes, flags_at, fixed, header);
  if (!extra) return std::nullopt;
  header.has_numbers = take_zip64_numbers(*extra, {&header.unpacked, &header.packed});
  return header;
}

}  // namespace tia
