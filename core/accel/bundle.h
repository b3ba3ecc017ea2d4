// Eight boxes at once against all rays of a packet at once.
#pragma once

#include <array>
#include <bit>

#include "core/accel/packet.h"

namespace tia {

/// BoxSet: up to eight boxes, axis by axis.
struct BoxSet {
  static constexpr std::size_t size = 8;
  using Floats = std::array<float, size>;
  alignas(32) std::array<Floats, 3> min{}, max{};
  unsigned count = 0;

  void add(const Box32& box) {
    min[0][count] = box.min.x, min[1][count] = box.min.y, min[2][count] = box.min.z;
    max[0][count] = box.max.x, max[1][count] = box.max.y, max[2][count] = box.max.z;
    ++count;
  }
  [[gnu::always_inline]] Box32 box(std::size_t i) const {
    return {{min[0][i], min[1][i], min[2][i]}, {max[0][i], max[1][i], max[2][i]}};
  }
};

/// The greatest of the lanes that count, rounded to float; -infinity where none does.
inline float greatest(float a, bool here) { return here ? a : -infinity; }
inline float greatest(double a, bool here) { return here ? static_cast<float>(a) : -infinity; }
inline float greatest(const Wide& a, const WideMask& here) {
  const Wide counting = select(here, a, Wide(-infinity));
  return greatest_lane(xsimd::max(counting.part[0], counting.part[1]));
}
template <class Real>
float least(const Real& a, const Mask<Real>& here) {
  return -greatest(-a, here);
}

/// Bundle: the intervals that a packet's rays leave from and go in, so that one test tells what all
/// of them miss; of a single ray it is that ray.
/// Source: Boulos, Wald, Shirley, "Geometric and arithmetic culling methods for entire ray
/// packets" (2006).
class Bundle {
 public:
  template <class Real>
  Bundle(const BoxRay<Real>& ray, const Mask<Real>& active) {
    ray.for_each_axis([&](int axis, const Real& low, const Real& high, const Real& inverse) {
      Axis& own = axes_[static_cast<std::size_t>(axis)];
      own.least = least(inverse, active);
      own.greatest = greatest(inverse, active);
      own.mixed = own.least < 0 && own.greatest > 0;
      own.backwards = own.greatest < 0;
      own.near_from = own.backwards ? least(high, active) : greatest(low, active);
      own.far_from = own.backwards ? greatest(low, active) : least(high, active);
    });
  }

  /// Returns: as bits, which boxes rays of the bundle may enter somewhere from 0 to t_max; in
  /// `near` from where on. It never misses a box that a ray of the bundle meets.
  unsigned enters(const BoxSet& boxes, float t_max, BoxSet::Floats& near) const {
    // As BoxRay's.
    constexpr float shrink = 1 - 0x1p-20F, grow = 1 + 0x1p-20F;
    Eight in(0), out(t_max);
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      const Axis& own = axes_[i];
      if (own.mixed) continue;
      const Eight low = Eight::load_unaligned(boxes.min[i].data());
      const Eight high = Eight::load_unaligned(boxes.max[i].data());
      const Eight to_near = (own.backwards ? high : low) - Eight(own.near_from);
      const Eight to_far = (own.backwards ? low : high) - Eight(own.far_from);
      in = max_of(min_of(to_near * Eight(own.least), to_near * Eight(own.greatest)), in);
      out = min_of(max_of(to_far * Eight(own.least), to_far * Eight(own.greatest)), out);
    }
    in = in * Eight(shrink);
    in.store_unaligned(near.data());
    return mask_of(in <= out * Eight(grow)) & ((1U << boxes.count) - 1);
  }

 private:
  static constexpr std::size_t registers = BoxSet::size / FloatRegister::size;
  using Eight = Registers<FloatRegister, registers>;
  static Eight min_of(const Eight& a, const Eight& b) {
    return Eight::map([](const auto& x, const auto& y) { return xsimd::min(x, y); }, a, b);
  }
  static Eight max_of(const Eight& a, const Eight& b) {
    return Eight::map([](const auto& x, const auto& y) { return xsimd::max(x, y); }, a, b);
  }
  template <class M>
  static unsigned mask_of(const M& mask) {
    unsigned all = 0;
    for (std::size_t i = 0; i < registers; ++i)
      all |= bits(mask.part[i]) << (i * FloatRegister::size);
    return all;
  }

  struct Axis {
    float near_from, far_from;  // the origins nearest to what is ahead, and farthest from it
    float least, greatest;      // of the inverse directions
    bool backwards, mixed;      // with rays both ways an axis parts nothing
  };
  std::array<Axis, 3> axes_;
};

}  // namespace tia
