#include "core/render/sampler.h"

#include <algorithm>

namespace tia {

Sampler::Sampler(const Sampling& sampling) : key_(sampling.seed), is_chance_(sampling.is_chance) {
  const bool adaptive = sampling.threshold > 0;
  const int all =
      adaptive ? 16 * least_samples(sampling.samples, sampling.threshold) : sampling.samples;
  const int first = adaptive                                    ? all / 16
                    : sampling.is_watched && sampling.is_chance ? 1
                    : sampling.in_rounds                        ? std::min(first_round, all)
                                                                : all;
  for (int end = first; ends_.empty() || ends_.back() < all; end *= 2)
    ends_.push_back(std::min(end, all));
  if (is_chance_) return;
  strata_.emplace_back(first);
  for (int round = 2; round < rounds(); ++round) strata_.emplace_back(count(round));
}

Aim<float> Sampler::aim(int x, int y, int sample) const {
  int round = 0;
  while (round + 1 < rounds() && sample >= before(round + 1)) ++round;
  const std::array<std::uint32_t, 1> px{static_cast<std::uint32_t>(x)};
  const std::array<std::uint32_t, 1> py{static_cast<std::uint32_t>(y)};
  return Aims<float>(*this, round, px, py, true)(sample - before(round));
}

}  // namespace tia
