// Points: a list of points in as few bytes as hold them exactly.
#pragma once

#include <algorithm>
#include <span>

#include "core/boxes/huge_pages.h"
#include "core/math/vec3.h"

namespace tia {

/// Points: kept in float where that loses nothing, as with all that were read from a file of
/// floats, and else in double.
class Points {
 public:
  Points() = default;
  /// Of x, y, z of each, one after the other.
  explicit Points(std::span<const double> coordinates) {
    const auto is_float = [](double x) { return static_cast<double>(static_cast<float>(x)) == x; };
    if (std::ranges::all_of(coordinates, is_float)) fill(floats_, coordinates);
    else fill(doubles_, coordinates);
  }

  std::size_t size() const { return std::max(floats_.size(), doubles_.size()); }
  Vec3d operator[](std::size_t i) const {
    return doubles_.empty() ? static_cast<Vec3d>(floats_[i]) : doubles_[i];
  }
  friend std::size_t heap_bytes(const Points& points) {
    return heap_bytes(points.floats_) + heap_bytes(points.doubles_);
  }

 private:
  template <class Real>
  static void fill(HugeVector<Vec3<Real>>& list, std::span<const double> from) {
    list.reserve(from.size() / 3);
    for (std::size_t i = 0; i + 2 < from.size(); i += 3)
      list.push_back(static_cast<Vec3<Real>>(Vec3d{from[i], from[i + 1], from[i + 2]}));
  }

  HugeVector<Vec3f> floats_;
  HugeVector<Vec3d> doubles_;  // one of the two is empty
};

}  // namespace tia
