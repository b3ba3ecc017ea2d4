// Eight boxes at once.
#pragma once

#include <array>

#include "core/boxes/box32.h"
#include "core/math/wide.h"

namespace tia {

/// BoxSet: up to eight boxes, as their six faces: the least x of all, the least y …, the greatest
/// z. Those that are not there are the other way round, so that no ray enters them.
struct BoxSet {
  static constexpr std::size_t size = 8;
  using Floats = std::array<float, size>;
  std::array<float, 6 * size> faces;
  unsigned count = 0;

  BoxSet() {
    for (std::size_t i = 0; i < faces.size(); ++i)
      faces[i] = i < faces.size() / 2 ? infinity : -infinity;
  }
  void add(const Box32& box) {
    const float all[] = {box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z};
    for (std::size_t i = 0; i < 6; ++i) faces[i * size + count] = all[i];
    ++count;
  }
  /// That face of all boxes.
  const float* face(std::size_t i) const { return &faces[i * size]; }
  [[gnu::always_inline]] Box32 box(std::size_t i) const {
    const auto at = [&](std::size_t k) { return faces[k * size + i]; };
    return {{at(0), at(1), at(2)}, {at(3), at(4), at(5)}};
  }
};

namespace detail {

inline constexpr std::size_t box_registers = BoxSet::size / FloatRegister::size;
/// A number for each of eight boxes.
using Eight = Registers<FloatRegister, box_registers>;

inline Eight load(const BoxSet::Floats& from) { return Eight::load_unaligned(from.data()); }
inline Eight least_of(const Eight& a, const Eight& b) {
  return Eight::map([](const auto& x, const auto& y) { return min_of(x, y); }, a, b);
}
inline Eight greatest_of(const Eight& a, const Eight& b) {
  return Eight::map([](const auto& x, const auto& y) { return max_of(x, y); }, a, b);
}
/// As bits, where one number is at most the other.
inline unsigned at_most(const Eight& a, const Eight& b) {
  const auto mask = a <= b;
  unsigned all = 0;
  for (std::size_t i = 0; i < box_registers; ++i)
    all |= bits(mask.part[i]) << (i * FloatRegister::size);
  return all;
}
/// The same of the boxes that there are.
inline unsigned at_most(const Eight& a, const Eight& b, const BoxSet& boxes) {
  return at_most(a, b) & ((1U << boxes.count) - 1);
}

}  // namespace detail

}  // namespace tia
