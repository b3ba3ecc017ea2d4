#include "core/render/sampler.h"

#include <algorithm>
#include <bit>

namespace tia {

Sampler::Sampler(const Sampling& sampling)
    : key_(sampling.seed), is_chance_(sampling.is_chance), blur_steps_(sampling.blur_steps) {
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

// Samples go by batches of a power of two, of one or more rows of strata, or of a part of a row. A
// batch exchanges places by a mask; that of every other one is the complement of the mask before
// it, which mirrors them, and a cycle of masks has all.
int Sampler::point(int round, int i) const {
  if (blur_steps_ == 1 || is_chance_) return i;
  const auto index = static_cast<std::uint32_t>(i);
  const auto bits =
      static_cast<std::uint32_t>(std::bit_width(static_cast<unsigned>(blur_steps_ - 1)));
  const std::uint32_t batch = index >> bits, last = (1U << bits) - 1;
  const std::uint32_t turn = (batch + (batch >> bits)) & last;
  const auto point = static_cast<int>(index ^ (turn % 2 == 0 ? turn / 2 : last - turn / 2));
  return point < count(round) ? point : i;
}

int Sampler::round_of(int sample) const {
  int round = 0;
  while (round + 1 < rounds() && sample >= before(round + 1)) ++round;
  return round;
}

Aim<float> Sampler::aim(int x, int y, int sample) const {
  const int round = round_of(sample);
  const std::array<std::uint32_t, 1> px{static_cast<std::uint32_t>(x)};
  const std::array<std::uint32_t, 1> py{static_cast<std::uint32_t>(y)};
  return Aims<float>(*this, round, px, py, true)(point(sample) - before(round));
}

}  // namespace tia
