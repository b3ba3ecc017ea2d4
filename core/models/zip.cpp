#include "core/models/zip.h"

#include <libdeflate.h>

#include <memory>
#include <new>
#include <utility>

#include "core/models/zip_directory.h"
#include "core/parallel/stopped.h"

namespace tia {
namespace {

using ZipDecompressor =
    std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor*)>;

ZipDecompressor zip_decompressor() {
  ZipDecompressor made(libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
  if (made == nullptr) throw std::bad_alloc();
  return made;
}

void check_zip_limits(const std::vector<ZipEntry>& entries, const ZipLimits& limits,
                      Faults& faults) {
  constexpr std::uint64_t free_of_ratio = 64 << 10;
  std::uint64_t left = limits.bytes;
  double together = 0;
  bool fits = true;
  for (const ZipEntry& entry : entries) {
    together += static_cast<double>(entry.unpacked);
    fits = fits && entry.unpacked <= left;
    if (fits) left -= entry.unpacked;
    // unpacked > ratio * packed, without the product.
    if (entry.unpacked > free_of_ratio &&
        (entry.unpacked - 1) / limits.ratio >= entry.packed.size())
      faults.add({FaultKind::limit, Place().at(entry.path).pointer(),
                  Value(static_cast<double>(entry.unpacked)),
                  "at most " + std::to_string(limits.ratio) + " bytes for each packed byte"});
  }
  if (!fits)
    faults.add({FaultKind::limit, "", Value(together),
                "at most " + std::to_string(limits.bytes) +
                    " bytes of all files together, unpacked (four times the option "
                    "TIA_MAX_MODEL_BYTES)"});
  if (entries.size() > limits.files)
    faults.add({FaultKind::limit, "", Value(static_cast<double>(entries.size())),
                "at most " + std::to_string(limits.files) + " files"});
}

// Whether the bytes are exactly those that the entry says.
bool inflate_zip(const ZipEntry& entry, libdeflate_decompressor* decompressor,
                 std::vector<std::uint8_t>& bytes) {
  std::uint8_t nothing = 0;  // libdeflate takes no null, which an empty vector may have
  std::uint8_t* const out = bytes.empty() ? &nothing : bytes.data();
  std::size_t read = 0;
  return libdeflate_deflate_decompress_ex(decompressor, entry.packed.data(), entry.packed.size(),
                                          out, bytes.size(), &read,
                                          nullptr) == LIBDEFLATE_SUCCESS &&
         read == entry.packed.size();
}

std::vector<std::uint8_t> unpack_zip_entry(const ZipEntry& entry,
                                           libdeflate_decompressor* decompressor, Faults& faults) {
  const auto refuse = [&](const char* came, const char* allowed) {
    faults.add({FaultKind::malformed, Place().at(entry.path).pointer(), Value(came), allowed});
    return std::vector<std::uint8_t>();
  };
  std::vector<std::uint8_t> bytes;
  if (!entry.deflated) {
    bytes.assign(entry.packed.begin(), entry.packed.end());
  } else {
    bytes.resize(entry.unpacked);
    if (!inflate_zip(entry, decompressor, bytes))
      return refuse("bytes that do not unpack to its size", "a deflated file");
  }
  if (libdeflate_crc32(0, bytes.data(), bytes.size()) != entry.crc)
    return refuse("bytes of another CRC-32", "the bytes that were packed");
  return bytes;
}

}  // namespace

bool is_zip(ModelBytes file) {
  return file.size() >= 4 && file[0] == 'P' && file[1] == 'K' && file[2] == 3 && file[3] == 4;
}

std::vector<UnpackedFile> unpack_zip(ModelBytes archive, const ZipLimits& limits, Faults& faults) {
  const std::size_t before = faults.count();
  std::vector<ZipEntry> entries = zip_entries(archive, faults);
  if (faults.count() == before) check_zip_limits(entries, limits, faults);
  if (faults.count() != before) return {};
  const ZipDecompressor decompressor = zip_decompressor();
  std::vector<UnpackedFile> files;
  files.reserve(entries.size());
  for (ZipEntry& entry : entries) {
    end_if_asked(faults.stop());
    auto bytes = unpack_zip_entry(entry, decompressor.get(), faults);
    if (faults.count() != before) return {};
    files.push_back({std::move(entry.path), std::move(bytes)});
  }
  return files;
}

}  // namespace tia
