// Which points of a pixel and of the lens its rays go through. A pixel's points depend on the seed
// and the pixel alone, so that a window of a picture takes the full picture's.
#pragma once

#include <vector>

#include "core/math/rng.h"
#include "core/math/strata.h"
#include "core/math/unit_lanes.h"
#include "core/math/warp.h"
#include "core/scene/view.h"

namespace tia {

/// Sampler: the rays of each pixel. Without a threshold one round of `samples`, one in each of as
/// many strata of the pixel. With one, at least 4 in the first round, and as long as the pixel's
/// mean is not settled further rounds, each of as many as all before it together, up to 16 times
/// the first.
class Sampler {
 public:
  /// Domain: samples 1 .. 65536, threshold 0 .. 1.
  Sampler(int samples, double threshold, std::int64_t seed);

  /// One ray a pixel, through its centre and the lens': nothing is random.
  bool centered() const { return !adaptive() && rounds_.front().count() == 1; }
  bool adaptive() const { return threshold_ > 0; }
  int rounds() const { return adaptive() ? 5 : 1; }
  const Strata& strata(int round) const {
    return rounds_[static_cast<std::size_t>(round == 0 ? 0 : round - 1)];
  }
  /// The number of samples before a round.
  int before(int round) const { return round == 0 ? 0 : strata(round).count(); }
  RandomKey key() const { return key_; }

  /// Whether the mean of n values is known well enough: its standard error, sqrt(variance / n) by
  /// the n values' own variance, is at most the threshold. Domain: n > 1; the sums are those of
  /// the values' deviations from any constant and of their squares.
  bool settled(double sum, double sum_of_squares, int n) const {
    const double variance = (sum_of_squares - sum * sum / n) / (n - 1);
    return variance <= threshold_ * threshold_ * n;
  }

  /// Where sample 0, 1, 2 ... of a pixel goes, all rounds counted through.
  Aim<float> aim(int x, int y, int sample) const;

 private:
  double threshold_;
  RandomKey key_;
  std::vector<Strata> rounds_;  // of the first two rounds together, the third, the fourth ...
};

/// The fewest rays that a pixel takes. Domain: as Sampler's.
inline int least_samples(int samples, double threshold) {
  return threshold > 0 && samples < 4 ? 4 : samples;
}

/// Aims: one round's rays of several pixels, one in each lane. Strata of the pixel are taken in
/// order, those of the lens shuffled, differently in each pixel, so that the two are independent.
/// Source: Cook, Porter, Carpenter, "Distributed ray tracing", 1984.
template <class Real>
class Aims {
 public:
  static constexpr std::size_t n = static_cast<std::size_t>(lanes<Real>);
  using Pixels = std::array<std::uint32_t, n>;

  Aims(const Sampler& sampler, int round, const Pixels& x, const Pixels& y, bool has_lens)
      : strata_(sampler.strata(round)),
        key_(sampler.key()),
        x_(x),
        y_(y),
        before_(static_cast<std::uint32_t>(sampler.before(round))),
        has_lens_(has_lens),
        centered_(sampler.centered()) {
    if (has_lens) shuffles_ = drawn(before_, shuffling).a;
  }

  /// The rays of the round's i-th sample. Domain: 0 <= i < the round's count. Cost: least in order.
  Aim<Real> operator()(int i) {
    if (centered_) return {Real(0), Real(0), Real(0), Real(0)};
    const auto index = static_cast<std::uint32_t>(i);
    const bool odd = draw_pair(before_ + index);
    const Strata::Cell& cell = strata_[index];
    Aim<Real> aim{};
    aim.dx = Real(cell.x - 0.5F) + units(odd ? pair_.c : pair_.a) * Real(cell.width);
    aim.dy = Real(cell.y - 0.5F) + units(odd ? pair_.d : pair_.b) * Real(cell.height);
    if (has_lens_) aim_on_lens(index, aim);
    return aim;
  }

 private:
  enum Dimension : std::uint32_t { in_pixel, on_lens, shuffling };

  RandomWords<n> drawn(std::uint32_t sample, Dimension dimension) const {
    RandomWords<n> words;
    words.a = x_;
    words.b = y_;
    words.c.fill(sample);
    words.d.fill(dimension);
    philox(words, key_);
    return words;
  }
  // Two samples share four words; the odd one has the latter two.
  bool draw_pair(std::uint32_t sample) {
    const std::uint32_t even = sample & ~1U;
    if (even != pair_of_) pair_ = drawn(pair_of_ = even, in_pixel);
    return sample != even;
  }
  static Real units(const Pixels& words) { return unit_lanes<Real>(words); }
  void aim_on_lens(std::uint32_t index, Aim<Real>& aim) const {
    const RandomWords<n> words = drawn(before_ + index, on_lens);
    std::array<LaneOf<Real>, n> u, v;
    const auto count = static_cast<std::uint32_t>(strata_.count());
    for (std::size_t i = 0; i < n; ++i) {
      const Strata::Cell& cell = strata_[shuffled(index, count, shuffles_[i])];
      u[i] = cell.x + unit_float(words.a[i]) * cell.width;
      v[i] = cell.y + unit_float(words.b[i]) * cell.height;
    }
    const DiscPoint<Real> point = square_to_disc(load<Real>(u.data()), load<Real>(v.data()));
    aim.lens_x = point.x;
    aim.lens_y = point.y;
  }

  const Strata& strata_;
  RandomKey key_;
  const Pixels &x_, &y_;
  Pixels shuffles_{};
  std::uint32_t before_;
  bool has_lens_, centered_;
  RandomWords<n> pair_;
  std::uint32_t pair_of_ = 1;  // none: its number is even
};

}  // namespace tia
