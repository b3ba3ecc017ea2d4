// ReaderAnswer: what a reader's process writes.
#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include "core/film/image.h"
#include "core/models/archive.h"
#include "core/models/zip.h"

namespace tia::server {

/// ReaderAnswer: bytes, and behind them the model's archive, what is told of its pictures, their
/// pixels, and the bytes of the files, of which nothing is copied.
struct ReaderAnswer {
  std::vector<std::uint8_t> bytes;
  std::optional<Model> model;
  std::vector<std::uint8_t> extents;
  std::vector<std::shared_ptr<const ImageRgba8>> images;  ///< null: none
  std::vector<UnpackedFile> files;

  /// Calls write(bytes) with all of it, in order.
  template <class Write>
  void each_part(Write write) const {
    write(bytes);
    if (model) write_archive(*model, write);
    write(extents);
    for (const auto& image : images)
      if (image) write(image->rgba);
    for (const UnpackedFile& file : files) write(file.bytes);
  }
};

}  // namespace tia::server
