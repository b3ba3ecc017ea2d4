#include "core/models/zip_directory.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "core/models/paths.h"
#include "core/models/zip_headers.h"

namespace tia {
namespace {

constexpr unsigned zip_stored = 0, zip_deflated = 8;

// Whether the header before a file says what the directory says. Where sizes follow the data, it
// may leave them and the CRC open: as 0, or the sizes as all ones.
bool zip_headers_agree(const ZipHeader& local, const ZipHeader& central) {
  const bool open = (local.flags & ZipHeader::sizes_follow) != 0;
  const auto same = [&](std::uint64_t number, std::uint64_t wanted) {
    return number == wanted || (open && (number == 0 || number == 0xFFFFFFFF));
  };
  return local.name == central.name && local.method == central.method &&
         (local.flags & ZipHeader::encrypted) == 0 && (local.has_numbers || open) &&
         same(local.crc, central.crc) && same(local.packed, central.packed) &&
         same(local.unpacked, central.unpacked);
}

// Folders have a '/' at their names' end, or what some packers of Windows write for it.
bool is_zip_folder(std::string_view name) { return name.ends_with('/') || name.ends_with('\\'); }

class ZipDirectory {
 public:
  ZipDirectory(ModelBytes archive, Faults& faults) : archive_(archive), faults_(faults) {}

  std::vector<ZipEntry> read() {
    const auto end = find_zip_end(archive_);
    if (!end) broken("no end record that is a ZIP archive's last and says all without ZIP64");
    else if (!end->one_disk) broken("a part of an archive on several disks");
    else if (end->directory_at > end->at || end->directory_size != end->at - end->directory_at)
      broken("an end record that gives the directory another place than before it");
    else read_entries(*end);
    return std::move(entries_);
  }

 private:
  void read_entries(const ZipEnd& end) {
    files_ = archive_.first(end.directory_at);
    ModelBytes left = archive_.subspan(end.directory_at, end.directory_size);
    for (std::uint64_t i = 0; i < end.entries; ++i) {
      if (faults_.full()) return;
      const auto header = central_zip_header(left);
      if (!header) return broken("a directory that breaks off in its entry " + std::to_string(i));
      left = left.subspan(header->size);
      take(*header);
    }
    if (!left.empty()) return broken("a directory with more in it than it counts");
    refuse_overlaps();
    refuse_repeated();
  }

  // One file: faults of its own do not hinder reading the others.
  void take(const ZipHeader& header) {
    if (const std::string_view wanted = refusal(header); !wanted.empty())
      return refuse(header.name, FaultKind::malformed, std::string(wanted));
    const auto packed = bytes_of(header);
    if (!packed)
      return refuse(header.name, FaultKind::malformed,
                    "a header before its bytes that says what the directory says, and the bytes");
    if (is_zip_folder(header.name)) return;
    auto path = clean_path(header.name, faults_);
    if (!path || is_clutter(*path)) return;
    entries_.push_back({std::move(*path), *packed, header.method == zip_deflated, header.unpacked,
                        static_cast<std::uint32_t>(header.crc)});
  }
  // What a file has to be that it is not, or "".
  static std::string_view refusal(const ZipHeader& header) {
    if ((header.flags & ZipHeader::encrypted) != 0) return "a file that is not encrypted";
    if (header.method != zip_stored && header.method != zip_deflated)
      return "a file that is stored or deflated (methods 0 and 8)";
    if (header.link) return "a file, not a symbolic link";
    if (!header.first_disk) return "a file on the first disk";
    if (!header.has_numbers) return "a ZIP64 field with the numbers that 32 bits do not hold";
    if (header.method == zip_stored && header.packed != header.unpacked)
      return "a stored file with one size";
    return "";
  }
  std::optional<ModelBytes> bytes_of(const ZipHeader& central) {
    if (central.header_at > files_.size()) return std::nullopt;
    const ModelBytes from = files_.subspan(central.header_at);
    const auto local = local_zip_header(from);
    if (!local || !zip_headers_agree(*local, central) || central.packed > from.size() - local->size)
      return std::nullopt;
    ranges_.push_back({central.header_at, local->size + central.packed, central.name});
    return from.subspan(local->size, central.packed);
  }

  // Files that share bytes make much of little, and are what no packer writes.
  void refuse_overlaps() {
    std::ranges::sort(ranges_, {}, &Range::begin);
    for (std::size_t i = 1; i < ranges_.size() && !faults_.full(); ++i)
      if (ranges_[i].begin - ranges_[i - 1].begin < ranges_[i - 1].size)
        refuse(ranges_[i].name, FaultKind::malformed, "a file that shares no bytes with another");
  }
  void refuse_repeated() {
    std::vector<std::string_view> paths;
    for (const ZipEntry& entry : entries_) paths.push_back(entry.path);
    std::ranges::sort(paths);
    for (std::size_t i = 1; i < paths.size() && !faults_.full(); ++i)
      if (paths[i] == paths[i - 1]) refuse(paths[i], FaultKind::conflict, "each path once");
  }

  void refuse(std::string_view name, FaultKind kind, std::string allowed) {
    faults_.add({kind, Place().at(name).pointer(), Value(name), std::move(allowed)});
  }
  void broken(std::string what) {
    faults_.add({FaultKind::malformed, "", Value(std::move(what)), "a whole ZIP archive"});
  }

  // A file's header and bytes in the archive.
  struct Range {
    std::uint64_t begin, size;
    std::string_view name;
  };

  ModelBytes archive_, files_;  // all, and what stands before the directory
  Faults& faults_;
  std::vector<ZipEntry> entries_;
  std::vector<Range> ranges_;
};

}  // namespace

std::vector<ZipEntry> zip_entries(ModelBytes archive, Faults& faults) {
  return ZipDirectory(archive, faults).read();
}

}  // namespace tia
