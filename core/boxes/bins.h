// Bins: how the builder of a tree finds where to split a list of boxes.
#pragma once

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

#include "core/boxes/box_set.h"

namespace tia::detail {

inline constexpr int bins = 16;

/// Extent: a box, as the least of each coordinate and of its negative: the box around two is the
/// least of both. The fourth number is a box's own, and of no meaning in sums.
struct Extent {
  static constexpr std::size_t own = 3, negative = 4;
  alignas(32) std::array<float, 8> least;

  static constexpr Extent nothing() {
    return {{infinity, infinity, infinity, 0, infinity, infinity, infinity, 0}};
  }
  static Extent of(const Box32& box, std::uint32_t number) {
    return {{box.min.x, box.min.y, box.min.z, std::bit_cast<float>(number), -box.max.x, -box.max.y,
             -box.max.z, 0}};
  }
  void take(const Extent& other) { take(load(other.least)); }
  // The point that is another's centre, or that `out_of_the_way`: there it changes nothing.
  void take_center(const Eight& other, float out_of_the_way = 0) {
    take(other - swapped(other) + Eight(out_of_the_way));
  }
  void take_center(const Extent& other) { take_center(load(other.least)); }
  // Twice the middle.
  float center(std::size_t axis) const { return least[axis] - least[axis + negative]; }
  float size(std::size_t axis) const { return -least[axis + negative] - least[axis]; }
  float half_area() const { return size(0) * size(1) + size(1) * size(2) + size(2) * size(0); }
  Box32 box() const { return {{least[0], least[1], least[2]}, {-least[4], -least[5], -least[6]}}; }
  void take(const Eight& all) { least_of(load(least), all).store_unaligned(least.data()); }
  // The second four numbers, then the first.
  static Eight swapped(const Eight& all) {
#if defined(__AVX__)
    return Eight::of(FloatRegister(_mm256_permute2f128_ps(all.part[0], all.part[0], 1)));
#else
    return Eight::of(all.part[1], all.part[0]);
#endif
  }
  std::uint32_t id() const { return std::bit_cast<std::uint32_t>(least[own]); }
};

/// Run: neighbours in the list, and what is around them and around their centres.
struct Run {
  std::size_t first = 0, count = 0;
  Extent box = Extent::nothing(), centers = Extent::nothing();
};

/// BinScale: where centres fall among the bins of an axis.
struct BinScale {
  float low = 0, bins_per_length = 0;
  bool parts = false;  // whether the centres differ

  BinScale(const Extent& centers, std::size_t axis) : low(centers.least[axis]) {
    bins_per_length = static_cast<float>(bins) / centers.size(axis);
    parts = centers.size(axis) > 0 && std::isfinite(bins_per_length) &&
            std::isfinite(centers.size(axis)) && std::isfinite(low);
  }
  std::size_t bin(float center) const {
    const auto at = static_cast<int>((center - low) * bins_per_length);
    return static_cast<std::size_t>(std::clamp(at, 0, bins - 1));
  }
};
using Scales = std::array<BinScale, 3>;
inline Scales scales_of(const Extent& centers) {
  return {BinScale(centers, 0), BinScale(centers, 1), BinScale(centers, 2)};
}

/// Bins: what falls in each bin of each axis.
struct Bins {
  std::array<std::array<Extent, bins>, 3> boxes;
  std::array<std::array<std::uint32_t, bins>, 3> counts{};

  Bins() {
    for (auto& axis : boxes) axis.fill(Extent::nothing());
  }

  void add(const Extent& each, const Scales& scales) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      if (!scales[axis].parts) continue;
      const std::size_t bin = scales[axis].bin(each.center(axis));
      boxes[axis][bin].take(each);
      ++counts[axis][bin];
    }
  }
  void add(const Bins& other) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      for (std::size_t i = 0; i < bins; ++i) {
        boxes[axis][i].take(other.boxes[axis][i]);
        counts[axis][i] += other.counts[axis][i];
      }
    }
  }
};

/// Split: of the best bins of the best axis.
struct Split {
  std::size_t axis = 0, bin = 0;  // the first of the second half
  float cost = infinity;          // infinite: none
  std::array<Extent, 2> boxes{Extent::nothing(), Extent::nothing()};  // of both halves
};

/// Costs of all splits between the bins of an axis: from the right first, then against what is left
/// of them; the least, if it is less than the best so far. Source: as build_bvh's.
inline void sweep(const Bins& all, std::size_t axis, Split& best) {
  std::array<float, bins> right{};
  Extent box = Extent::nothing();
  float count = 0;
  const auto take = [&](std::size_t i) {
    box.take(all.boxes[axis][i]);
    count += static_cast<float>(all.counts[axis][i]);
    return count > 0 ? count * box.half_area() : 0;
  };
  for (std::size_t i = bins - 1; i > 0; --i) right[i] = take(i);
  box = Extent::nothing();
  count = 0;
  for (std::size_t i = 0; i + 1 < bins; ++i) {
    const float cost = take(i) + right[i + 1];
    if (count > 0 && right[i + 1] > 0 && cost < best.cost) {
      best.axis = axis;
      best.bin = i + 1;
      best.cost = cost;
    }
  }
}

}  // namespace tia::detail
