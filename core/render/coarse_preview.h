// What is shown of a picture before its first round.
#pragma once

#include <cstdint>
#include <stop_token>

#include "core/render/trace_tile.h"
#include "core/render/window_tiles.h"

namespace tia {

/// CoarsePreview: blocks of pixels, each as a ray through its middle says, in the middle of the
/// open time; they are few, whatever the size of the picture. What it is made of must outlive it.
class CoarsePreview {
 public:
  /// `shot`: the picture's. `spent`, `stop`: as of RayMeter.
  CoarsePreview(const WindowTiles& tiles, const Shot& shot, Scalar scalar, std::int64_t seed,
                const Spent& spent, const std::stop_token& stop)
      : tiles_(tiles), shot_(shot), scalar_(scalar), seed_(seed), spent_(spent), stop_(stop) {}

  /// The side of the blocks.
  int block() const;
  /// Whether noise is taken off it. A block's light must not be in two tiles.
  bool is_filtered() const;
  /// Traces it. Its rays count nowhere.
  Reached show(const WindowTiles::Develop& develop) const;

 private:
  void show_blocks(const Shot& shot, const WindowTiles::Develop& develop) const;

  const WindowTiles& tiles_;
  const Shot& shot_;
  const Scalar scalar_;
  const std::int64_t seed_;
  const Spent& spent_;
  const std::stop_token& stop_;
};

}  // namespace tia
