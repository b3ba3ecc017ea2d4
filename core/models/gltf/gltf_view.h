// GltfView: a glTF buffer view.
#pragma once

#include <cstdint>
#include <optional>

#include "core/models/model_files.h"

namespace tia::gltf {

/// GltfView: a part of a buffer. `there`: whether its bytes are; else a fault says why not.
struct GltfView {
  std::optional<std::uint64_t> length;  ///< as it says, where that is good
  std::uint64_t offset = 0;
  std::optional<std::uint64_t> stride;
  ModelBytes bytes;
  bool there = false;
};

}  // namespace tia::gltf
