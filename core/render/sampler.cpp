#include "core/render/sampler.h"

namespace tia {

Sampler::Sampler(int samples, double threshold, std::int64_t seed)
    : threshold_(threshold), key_(seed) {
  const int first = least_samples(samples, threshold);
  rounds_.emplace_back(first);
  for (int round = 2; round < rounds(); ++round) rounds_.emplace_back(first << (round - 1));
}

Aim<float> Sampler::aim(int x, int y, int sample) const {
  int round = 0;
  while (round + 1 < rounds() && sample >= before(round + 1)) ++round;
  const std::array<std::uint32_t, 1> px{static_cast<std::uint32_t>(x)};
  const std::array<std::uint32_t, 1> py{static_cast<std::uint32_t>(y)};
  return Aims<float>(*this, round, px, py, true)(sample - before(round));
}

}  // namespace tia
