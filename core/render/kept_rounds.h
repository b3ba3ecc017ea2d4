// Rounds of a picture whose render was left, for another one to go on from.
#pragma once

#include <cstddef>
#include <optional>
#include <vector>

#include "core/render/rounds.h"

namespace tia {

/// KeptRounds: the sums of all pixels, bit for bit, tile by tile. Some tiles may be a round ahead.
class KeptRounds {
 public:
  /// `sampler`: whose rounds they are.
  KeptRounds(std::vector<RoundsOfTile> tiles, const Sampler& sampler);

  /// How many samples each pixel has had that is not settled, at least.
  int samples() const { return least_; }
  std::size_t bytes() const { return bytes_; }
  const RayCounts& rays() const { return rays_; }
  std::size_t tiles() const { return tiles_.size(); }

  /// Whether they are among that sampler's.
  bool fits(const Sampler& sampler) const;
  /// A tile, with its rounds numbered as that sampler's. Domain: fits(sampler).
  RoundsOfTile tile(std::size_t number, const Sampler& sampler) const;

 private:
  static std::optional<int> rounds_of(int samples, const Sampler& sampler);

  std::vector<RoundsOfTile> tiles_;
  std::vector<int> samples_;  // of each tile
  int least_ = 0;
  std::size_t bytes_ = 0;
  RayCounts rays_;
};

}  // namespace tia
