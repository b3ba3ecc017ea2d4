// ReaderAnswer: what a reader's process writes.
#pragma once

#include <cstdint>
#include <memory>
#include <vector>

#include "core/film/image.h"
#include "core/models/zip.h"

namespace tia::server {

/// ReaderAnswer: bytes, and behind them the pixels of the pictures and the bytes of the files,
/// which are not copied.
struct ReaderAnswer {
  std::vector<std::uint8_t> bytes;
  std::vector<std::shared_ptr<const ImageRgba8>> images;  ///< null: none
  std::vector<UnpackedFile> files;

  /// Calls write(bytes) with all of it, in order.
  template <class Write>
  void each_part(Write write) const {
    write(bytes);
    for (const auto& image : images)
      if (image) write(image->rgba);
    for (const UnpackedFile& file : files) write(file.bytes);
  }
};

}  // namespace tia::server
