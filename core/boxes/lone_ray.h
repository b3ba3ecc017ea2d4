// LoneRay: one ray, tested with eight boxes.
#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <type_traits>

#include "core/boxes/box_ray.h"
#include "core/boxes/box_set.h"

namespace tia {

namespace detail {

/// FacesMet: of a BoxSet, those that rays of an octant meet first and last, for each axis: where
/// their numbers begin among all.
struct FacesMet {
  std::array<std::uint32_t, 3> first, last;
};
/// By octant: bit k is set where a ray goes backwards along axis k.
inline constexpr std::array<FacesMet, 8> faces_met = [] {
  std::array<FacesMet, 8> all{};
  for (std::uint32_t octant = 0; octant < 8; ++octant) {
    for (std::uint32_t axis = 0; axis < 3; ++axis) {
      const std::uint32_t backwards = octant >> axis & 1;
      all[octant].first[axis] = (axis + 3 * backwards) * std::uint32_t{BoxSet::size};
      all[octant].last[axis] = (axis + 3 * (1 - backwards)) * std::uint32_t{BoxSet::size};
    }
  }
  return all;
}();

}  // namespace detail

/// LoneRay: one ray, with the faces that it meets first, for each axis. `exact`: whether its origin
/// is, which most are; then there is less to compute.
/// Source: Wald, Benthin, Boulos, "Getting rid of packets: efficient SIMD single-ray traversal
/// using multi-branching BVHs" (2008).
template <bool exact>
class LoneRay {
 public:
  /// One of a packet's rays.
  template <class Real>
  LoneRay(const BoxRay<Real>& ray, int lane) {
    std::uint32_t octant = 0;
    ray.for_each_axis([&](int i, const Real& low, const Real& high, const Real& inverse) {
      const auto axis = static_cast<std::size_t>(i);
      const float factor = tia::lane(inverse, lane);
      const std::uint32_t backwards = std::bit_cast<std::uint32_t>(factor) >> 31U;
      octant |= backwards << axis;
      minus_inverse_[axis] = -factor;
      near_from_[axis] = tia::lane(low, lane);
      if constexpr (!exact) {
        const float from[] = {tia::lane(low, lane), tia::lane(high, lane)};
        near_from_[axis] = from[backwards];
        far_from_[axis] = from[1 - backwards];
      }
    });
    faces_ = detail::faces_met[octant];
  }

  /// What is to be said as a limit for boxes that the ray may meet up to t_max.
  static float limit(float t_max) { return t_max * slack; }
  /// Returns: as bits, which boxes the ray enters somewhere from 0 to limit(t_max); in `near` from
  /// where on, never below 0. It never misses a box that the ray meets up to t_max.
  [[gnu::always_inline]] unsigned enters(const BoxSet& boxes, float limit,
                                         BoxSet::Floats& near) const {
    using namespace detail;
    // The face is the second operand, which may lie in memory.
    const auto distance = [&](std::size_t axis, float from, std::size_t face)
        __attribute__((always_inline)) {
      const Eight to = Eight::load_unaligned(&boxes.faces[face]);
      return (Eight(from) - to) * Eight(minus_inverse_[axis]);
    };
    const auto in = [&](std::size_t axis) __attribute__((always_inline)) {
      return distance(axis, near_from_[axis], faces_.first[axis]);
    };
    const auto out = [&](std::size_t axis) __attribute__((always_inline)) {
      if constexpr (exact) return distance(axis, near_from_[axis], faces_.last[axis]);
      else return distance(axis, far_from_[axis], faces_.last[axis]);
    };
    const Eight first = greatest_of(greatest_of(in(0), in(1)), greatest_of(in(2), Eight(0)));
    const Eight last = least_of(least_of(out(0), out(1)), out(2)) * Eight(slack);
    first.store_unaligned(near.data());
    // Of a ray of nothing `last` is nothing: the second operand, so that it enters no box at all,
    // and none of those that are not there.
    return at_most(first, least_of(Eight(limit), last));
  }

 private:
  static constexpr float slack = box_grow / box_shrink;  // BoxRay's factors, on one side
  detail::FacesMet faces_;
  std::array<float, 3> minus_inverse_, near_from_;
  struct None {};
  [[no_unique_address]] std::conditional_t<exact, None, std::array<float, 3>> far_from_;
};

/// Calls f with one of a packet's rays.
template <class Real, class F>
void with_lone_ray(const BoxRay<Real>& ray, int lane, F f) {
  if (ray.is_exact()) f(LoneRay<true>(ray, lane));
  else f(LoneRay<false>(ray, lane));
}

}  // namespace tia
