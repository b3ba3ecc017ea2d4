// Eight boxes at once, against one ray or against all rays of a packet together.
#pragma once

#include <array>

#include "core/accel/packet.h"

namespace tia {

/// BoxSet: up to eight boxes, as their six faces: the least x of all, the least y …, the greatest
/// z.
struct BoxSet {
  static constexpr std::size_t size = 8;
  using Floats = std::array<float, size>;
  std::array<Floats, 6> faces{};
  unsigned count = 0;

  void add(const Box32& box) {
    const float all[] = {box.min.x, box.min.y, box.min.z, box.max.x, box.max.y, box.max.z};
    for (std::size_t i = 0; i < 6; ++i) faces[i][count] = all[i];
    ++count;
  }
  [[gnu::always_inline]] Box32 box(std::size_t i) const {
    return {{faces[0][i], faces[1][i], faces[2][i]}, {faces[3][i], faces[4][i], faces[5][i]}};
  }
};

namespace detail {

inline constexpr std::size_t box_registers = BoxSet::size / FloatRegister::size;
/// A number for each of eight boxes.
using Eight = Registers<FloatRegister, box_registers>;

inline Eight load(const BoxSet::Floats& from) { return Eight::load_unaligned(from.data()); }
inline Eight least_of(const Eight& a, const Eight& b) {
  return Eight::map([](const auto& x, const auto& y) { return xsimd::min(x, y); }, a, b);
}
inline Eight greatest_of(const Eight& a, const Eight& b) {
  return Eight::map([](const auto& x, const auto& y) { return xsimd::max(x, y); }, a, b);
}
/// As bits, where one number is at most the other of the boxes that there are.
inline unsigned at_most(const Eight& a, const Eight& b, const BoxSet& boxes) {
  const auto mask = a <= b;
  unsigned all = 0;
  for (std::size_t i = 0; i < box_registers; ++i)
    all |= bits(mask.part[i]) << (i * FloatRegister::size);
  return all & ((1U << boxes.count) - 1);
}

}  // namespace detail

/// The greatest of the lanes that count, rounded to float; -infinity where none does.
/// NaN never counts: a register's maximum would forget others for it.
inline float greatest(float a, bool here) { return here ? a : -infinity; }
inline float greatest(double a, bool here) { return here ? static_cast<float>(a) : -infinity; }
inline float greatest(const Wide& a, const WideMask& here) {
  const Wide counting = select(here && a == a, a, Wide(-infinity));
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

  /// Whether its rays go so many ways that it parts next to nothing.
  bool scattered() const { return axes_[0].mixed + axes_[1].mixed + axes_[2].mixed >= 2; }

  /// Returns: as bits, which boxes rays of the bundle may enter somewhere from 0 to t_max; in
  /// `near` from where on. It never misses a box that a ray of the bundle meets.
  unsigned enters(const BoxSet& boxes, float t_max, BoxSet::Floats& near) const {
    using namespace detail;
    Eight in(0), out(t_max);
    for (std::size_t i = 0; i < axes_.size(); ++i) {
      const Axis& own = axes_[i];
      if (own.mixed) continue;
      const Eight low = load(boxes.faces[i]), high = load(boxes.faces[i + 3]);
      const Eight to_near = (own.backwards ? high : low) - Eight(own.near_from);
      const Eight to_far = (own.backwards ? low : high) - Eight(own.far_from);
      in = greatest_of(least_of(to_near * Eight(own.least), to_near * Eight(own.greatest)), in);
      out = least_of(greatest_of(to_far * Eight(own.least), to_far * Eight(own.greatest)), out);
    }
    in = in * Eight(box_shrink);
    in.store_unaligned(near.data());
    return at_most(in, out * Eight(box_grow), boxes);
  }

 private:
  struct Axis {
    float near_from, far_from;  // the origins nearest to what is ahead, and farthest from it
    float least, greatest;      // of the inverse directions
    bool backwards, mixed;      // with rays both ways an axis parts nothing
  };
  std::array<Axis, 3> axes_;
};

/// LoneRay: one ray, which knows of each pair of a box's faces which it meets first.
/// Source: Wald, Benthin, Boulos, "Getting rid of packets: efficient SIMD single-ray traversal
/// using multi-branching BVHs" (2008).
class LoneRay {
 public:
  explicit LoneRay(const BoxRay<float>& ray) {
    ray.for_each_axis([&](int i, float low, float high, float inverse) {
      const auto axis = static_cast<std::size_t>(i);
      const std::size_t backwards = inverse < 0;  // no branch: nobody can foretell it
      const float from[] = {low, high};
      // Here BoxRay's room for roundings costs nothing.
      near_[axis] = {detail::Eight(from[backwards]), detail::Eight(inverse * box_shrink),
                     axis + 3 * backwards};
      far_[axis] = {detail::Eight(from[1 - backwards]), detail::Eight(inverse * box_grow),
                    axis + 3 * (1 - backwards)};
    });
  }

  /// As a bundle's.
  unsigned enters(const BoxSet& boxes, float t_max, BoxSet::Floats& near) const {
    using namespace detail;
    Eight in(0), out(t_max * box_grow);
    for (std::size_t i = 0; i < 3; ++i) {
      in = greatest_of(near_[i].distance(boxes), in);
      out = least_of(far_[i].distance(boxes), out);
    }
    in.store_unaligned(near.data());
    return at_most(in, out, boxes);
  }

 private:
  struct Slab {
    detail::Eight from, inverse;
    std::size_t face;

    detail::Eight distance(const BoxSet& boxes) const {
      return (detail::load(boxes.faces[face]) - from) * inverse;
    }
  };
  std::array<Slab, 3> near_, far_;
};

}  // namespace tia
