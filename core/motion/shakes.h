// Shakes: which contacts bounce so often that they are to rest.
//
// A ball that bounces freely with a restitution of e comes back after e times as long each time.
// Of bounces within 1e-3 s, down to those within 1e-6 s that rest, e to the power of their number
// is at least 1e-3, whatever e is. Where balls in a heap strike each other again and again it falls
// below that, and has no end: such a contact rests as soon as its next bounce would come within
// 1e-3 s, as long as it is touched so often.
// Source of the idea that a contact's restitution depends on the time since it was last there:
// Luding, McNamara, "How to handle the inelastic collapse of a dissipative hard-sphere gas with the
// TC model", Granular Matter 1 (1998).
#pragma once

#include <algorithm>
#include <cstddef>
#include <vector>

namespace tia {

/// Shakes: of one ball, by whom it touches.
class Shakes {
 public:
  bool contains(std::size_t other, double now, bool was_held) const {
    const auto each = find(rows_.begin(), rows_.end(), other);
    return each != rows_.end() && each->left < least_left &&
           (was_held || now - each->last <= window);
  }
  /// A contact at a time at which it bounced with what leaves that share of speed, or 1.
  void note(std::size_t other, double now, double left, bool shook) {
    auto each = find(rows_.begin(), rows_.end(), other);
    if (each == rows_.end()) {
      if (left == 1) return;
      std::erase_if(rows_, [&](const Row& row) { return now - row.last > window; });
      each = rows_.insert(rows_.end(), {other, now, now, 1});
    }
    if (!shook && now - each->first > window) each->first = now, each->left = 1;
    each->last = now;
    each->left *= left;
  }

 private:
  static constexpr double window = 1e-3;  // seconds
  static constexpr double least_left = 1e-4;
  struct Row {
    std::size_t other;
    double first, last, left;
  };
  template <class Iterator>
  static Iterator find(Iterator begin, Iterator end, std::size_t other) {
    return std::find_if(begin, end, [&](const Row& row) { return row.other == other; });
  }
  std::vector<Row> rows_;
};

}  // namespace tia
