// Thinned: a list of bounded length of however many things, evenly thinned.
#pragma once

#include <cstddef>
#include <vector>

namespace tia {

/// Thinned: every k-th of the things that came, k the least power of two for which these are at
/// most `most`, and the last one. Domain: most >= 2.
template <class T>
class Thinned {
 public:
  explicit Thinned(std::size_t most) : most_(most) {}

  /// Whether the next one is kept, but for being the last.
  bool keeps_next() const { return came_ % step_ == 0; }
  /// Takes the next one where it is kept.
  void add(const T& thing) {
    last_ = thing;
    if (keeps_next()) {
      if (kept_.size() + 1 == most_) halve();
      if (keeps_next()) kept_.push_back(thing);
    }
    ++came_;
  }
  /// Passes over one that is not kept.
  void skip() { ++came_; }
  /// All that are kept, the last among them. Domain: nothing was skipped, or the last was added.
  std::vector<T> take() && {
    if (came_ > 0 && (came_ - 1) % step_ != 0) kept_.push_back(last_);
    return std::move(kept_);
  }

 private:
  void halve() {
    for (std::size_t i = 0; 2 * i < kept_.size(); ++i) kept_[i] = kept_[2 * i];
    kept_.resize((kept_.size() + 1) / 2);
    step_ *= 2;
  }

  std::size_t most_, came_ = 0, step_ = 1;
  std::vector<T> kept_;
  T last_{};
};

}  // namespace tia
