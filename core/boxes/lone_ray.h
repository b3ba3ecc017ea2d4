// LoneRay: one ray, tested with eight boxes.
#pragma once

#include <array>

#include "core/boxes/box_ray.h"
#include "core/boxes/box_set.h"

namespace tia {

/// LoneRay: one ray, with the index of the face that it meets first, for each axis.
/// Source: Wald, Benthin, Boulos, "Getting rid of packets: efficient SIMD single-ray traversal
/// using multi-branching BVHs" (2008).
class LoneRay {
 public:
  explicit LoneRay(const BoxRay<float>& ray) {
    ray.for_each_axis([&](int i, float low, float high, float inverse) {
      const auto axis = static_cast<std::size_t>(i);
      const std::size_t backwards = inverse < 0;  // no branch, which could not be predicted
      const float from[] = {low, high};
      // BoxRay's factors for rounding are applied here, once for each ray.
      near_[axis] = {detail::Eight(from[backwards]), detail::Eight(inverse * box_shrink),
                     axis + 3 * backwards};
      far_[axis] = {detail::Eight(from[1 - backwards]), detail::Eight(inverse * box_grow),
                    axis + 3 * (1 - backwards)};
    });
  }

  /// As a RayInterval's.
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
