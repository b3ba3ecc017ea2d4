#include "core/render/sampler.h"

#include <algorithm>
#include <cmath>

namespace tia {

Strata::Strata(int n) {
  cells_.reserve(static_cast<std::size_t>(n));
  const auto rows = static_cast<int>(std::lround(std::sqrt(static_cast<double>(n))));
  const auto first_of = [&](int row) { return static_cast<int>(std::int64_t{row} * n / rows); };
  for (int row = 0; row < rows; ++row) {
    const int first = first_of(row), count = first_of(row + 1) - first;
    const float y = static_cast<float>(first) / static_cast<float>(n);
    const float height = static_cast<float>(count) / static_cast<float>(n);
    const float width = 1 / static_cast<float>(count);
    for (int i = 0; i < count; ++i)
      cells_.push_back({static_cast<float>(i) / static_cast<float>(count), y, width, height});
  }
}

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
