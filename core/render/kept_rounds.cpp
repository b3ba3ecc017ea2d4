#include "core/render/kept_rounds.h"

#include <algorithm>

namespace tia {

KeptRounds::KeptRounds(std::vector<RoundsOfTile> tiles, const Sampler& sampler)
    : tiles_(std::move(tiles)), least_(sampler.before(sampler.rounds())) {
  for (const RoundsOfTile& tile : tiles_) {
    samples_.push_back(sampler.before(tile.begun()));
    if (!tile.settled()) least_ = std::min(least_, samples_.back());
    rays_ += tile.pixels().rays;
  }
  for (std::size_t i = 0; i < tiles_.size(); ++i) {
    if (samples_[i] <= least_) tiles_[i].forget_shown();
    bytes_ += sizeof tiles_[i] + sizeof samples_[i] + tiles_[i].bytes();
  }
}

std::optional<int> KeptRounds::rounds_of(int samples, const Sampler& sampler) {
  for (int round = 0; round <= sampler.rounds(); ++round)
    if (sampler.before(round) == samples) return round;
  return std::nullopt;
}

bool KeptRounds::fits(const Sampler& sampler) const {
  return std::ranges::all_of(samples_,
                             [&](int samples) { return rounds_of(samples, sampler).has_value(); });
}

RoundsOfTile KeptRounds::tile(std::size_t number, const Sampler& sampler) const {
  RoundsOfTile tile = tiles_[number];
  tile.number_rounds(*rounds_of(samples_[number], sampler));
  return tile;
}

}  // namespace tia
