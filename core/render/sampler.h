// Which points of a pixel and of the lens its rays go through. A pixel's points depend on the seed
// and the pixel alone, so that a window of a picture takes the full picture's.
#pragma once

#include <algorithm>
#include <vector>

#include "core/math/rng.h"
#include "core/math/sobol.h"
#include "core/math/strata.h"
#include "core/math/unit_lanes.h"
#include "core/math/warp.h"
#include "core/scene/view.h"

namespace tia {

/// Sampling: which rays the pixels are to have.
struct Sampling {
  int samples = 1;       ///< 1 .. 65536; 1 goes through the centres
  double threshold = 0;  ///< 0 .. 1; 0: none
  std::int64_t seed = 0;
  bool is_chance = false;   ///< whether what a ray finds is chance
  bool in_rounds = false;   ///< whether pixels may stop, or the picture, before all samples
  bool is_watched = false;  ///< whether somebody looks at the picture after each round
  int blur_steps = 1;       ///< strata of the open time, at most as many as samples
};

/// Sampler: the rays of each pixel, in rounds. Without a threshold there are `samples`: in rounds
/// of 16, then of as many as there are already, if they are wanted so, else in one; where chance is
/// watched, the first 16 in rounds of 1, 1, 2, 4 and 8. With a
/// threshold there are at least 4 in the first round, and further rounds, each of as many as all
/// before it together, up to 16 times the first.
///
/// Where what a ray finds is chance, its place in the pixel is one of Sobol's points, so that any
/// first rays of a pixel are those of the picture that has no others. Else each round has one ray
/// in each of as many strata of the pixel, which leaves the least error where edges are all there
/// is.
///
/// Sample s is of stratum s mod blur_steps of the open time. Strata of the pixel are then taken in
/// another order, by which those of one time lie about the pixel's centre, and not below each
/// other; they are the same as of a picture of one time, so that what stands still looks as it does
/// there. Sobol's points are in an order of their own already.
class Sampler {
 public:
  static constexpr int first_round = 16;

  explicit Sampler(const Sampling& sampling);
  Sampler(int samples, double threshold, std::int64_t seed)
      : Sampler(Sampling{samples, threshold, seed}) {}

  /// One ray a pixel, through its centre and the lens': nothing is random.
  bool centered() const { return ends_.back() == 1; }
  bool is_chance() const { return is_chance_; }
  /// Whether a picture may end after so many rounds.
  bool may_end_after(int rounds) const {
    return rounds == this->rounds() || before(rounds) >= std::max(first_round, blur_steps_);
  }
  int rounds() const { return static_cast<int>(ends_.size()); }
  /// The number of samples before a round, and of it. Domain: before() also of the one after all.
  int before(int round) const {
    return round == 0 ? 0 : ends_[static_cast<std::size_t>(round) - 1];
  }
  int count(int round) const { return before(round + 1) - before(round); }
  /// Domain: not of chance.
  const Strata& strata(int round) const {
    return strata_[static_cast<std::size_t>(round == 0 ? 0 : round - 1)];
  }
  RandomKey key() const { return key_; }
  /// Which of a round's points its i-th sample takes: each takes another.
  int point(int round, int i) const;
  /// The same, all rounds counted through.
  int point(int sample) const {
    const int round = round_of(sample);
    return before(round) + point(round, sample - before(round));
  }

  /// Where sample 0, 1, 2 ... of a pixel goes, all rounds counted through.
  Aim<float> aim(int x, int y, int sample) const;

 private:
  int round_of(int sample) const;

  RandomKey key_;
  bool is_chance_;
  int blur_steps_;
  std::vector<int> ends_;       // how many samples there are after each round
  std::vector<Strata> strata_;  // of the first two rounds together, the third, the fourth ...
};

/// The fewest rays that a pixel takes. Domain: as Sampler's.
inline int least_samples(int samples, double threshold) {
  return threshold > 0 && samples < 4 ? 4 : samples;
}

/// Aims: one round's rays of several pixels, one in each lane. Strata of the pixel are taken in
/// order; points of the lens are Sobol's, in an order of their own in each pixel, so that the two
/// are independent. Where places in the pixel are Sobol's, too, they are the first two dimensions
/// of the same points. Source: Cook, Porter, Carpenter, "Distributed ray tracing", 1984.
template <class Real>
class Aims {
 public:
  static constexpr std::size_t n = static_cast<std::size_t>(lanes<Real>);
  using Pixels = std::array<std::uint32_t, n>;

  Aims(const Sampler& sampler, int round, const Pixels& x, const Pixels& y, bool has_lens)
      : strata_(sampler.is_chance() ? nullptr : &sampler.strata(round)),
        key_(sampler.key()),
        x_(x),
        y_(y),
        before_(static_cast<std::uint32_t>(sampler.before(round))),
        has_lens_(has_lens),
        centered_(sampler.centered()) {}

  /// The rays of the round's point i. Domain: 0 <= i < the round's count. Cost: least in order.
  Aim<Real> operator()(int i) {
    if (centered_) return {Real(0), Real(0), Real(0), Real(0)};
    const auto index = static_cast<std::uint32_t>(i);
    if (strata_ == nullptr) return by_points(before_ + index);
    const bool odd = draw_pair(before_ + index);
    const Strata::Cell& cell = (*strata_)[index];
    Aim<Real> aim{};
    aim.dx = Real(cell.x - 0.5F) + units(odd ? pair_.c : pair_.a) * Real(cell.width);
    aim.dy = Real(cell.y - 0.5F) + units(odd ? pair_.d : pair_.b) * Real(cell.height);
    if (has_lens_) aim_on_lens(before_ + index, aim);
    return aim;
  }

 private:
  // Blocks of Sobol's dimensions that are no integrator's.
  static constexpr std::uint32_t of_both = 0x10000000, of_lens = 0x10000001;

  Aim<Real> by_points(std::uint32_t sample) const {
    const RandomWords<n> words = sobol_words(x_, y_, sample, of_both, key_);
    Aim<Real> aim{units(words.a) - Real(0.5F), units(words.b) - Real(0.5F), Real(0), Real(0)};
    if (has_lens_) put_on_lens(words.c, words.d, aim);
    return aim;
  }
  RandomWords<n> drawn(std::uint32_t sample) const {
    RandomWords<n> words;
    words.a = x_;
    words.b = y_;
    words.c.fill(sample);
    words.d.fill(0);
    philox(words, key_);
    return words;
  }
  // Two samples share four words; the odd one has the latter two.
  bool draw_pair(std::uint32_t sample) {
    const std::uint32_t even = sample & ~1U;
    if (even != pair_of_) pair_ = drawn(pair_of_ = even);
    return sample != even;
  }
  static Real units(const Pixels& words) { return unit_lanes<Real>(words); }
  void aim_on_lens(std::uint32_t sample, Aim<Real>& aim) const {
    const auto [u, v] = SobolPairs<n>(x_, y_, of_lens, key_)(sample);
    put_on_lens(u, v, aim);
  }
  static void put_on_lens(const Pixels& u, const Pixels& v, Aim<Real>& aim) {
    const DiscPoint<Real> point = square_to_disc(units(u), units(v));
    aim.lens_x = point.x;
    aim.lens_y = point.y;
  }

  const Strata* strata_;  // null: of chance
  RandomKey key_;
  const Pixels &x_, &y_;
  std::uint32_t before_;
  bool has_lens_, centered_;
  RandomWords<n> pair_;
  std::uint32_t pair_of_ = 1;  // none: its number is even
};

}  // namespace tia
