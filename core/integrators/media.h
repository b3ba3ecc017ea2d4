// The medium that a ray is in: that of the last object that it has entered and not yet left.
#pragma once

#include <array>

#include "core/math/powers.h"

namespace tia {

/// Medium: what fills space. Space/units: absorption, and the density of fog, per scene unit.
template <class Real>
struct Medium {
  Real ior = Real(1);
  Vec3<Real> absorption{Real(0), Real(0), Real(0)};
  Real density = Real(0);
};

template <class Real>
Medium<Real> select(const Mask<Real>& mask, const Medium<Real>& a, const Medium<Real>& b) {
  return {select(mask, a.ior, b.ior), select(mask, a.absorption, b.absorption),
          select(mask, a.density, b.density)};
}

/// MediumTransition: a surface of a transmitting object that a packet's rays have passed through.
/// The transitions of a path are a linked list, the last first, whose elements lie on the stack, in
/// the calls that trace the rays.
template <class Real>
struct MediumTransition {
  const MediumTransition* previous;  ///< the one before it on the path; null: none
  Mask<Real> here;                   ///< the lanes whose rays have passed through
  Mask<Real> entering;               ///< where they entered the object; elsewhere they left it
  Real object, instance;
  Medium<Real> inside;
};

namespace detail {

/// Of one lane: the last transition into an object that the ray has not left since. If it is
/// `leaving`, then that object of that instance counts as left. Null: none.
template <class Real>
const MediumTransition<Real>* innermost(const MediumTransition<Real>* last, int i, bool leaving,
                                        float object, float instance) {
  struct Left {
    float object, instance;
  };
  std::array<Left, 72> left;
  std::size_t count = 0;
  if (leaving) left[count++] = {object, instance};
  for (const MediumTransition<Real>* at = last; at != nullptr; at = at->previous) {
    if ((bits(at->here) >> i & 1U) == 0) continue;
    const Left own{static_cast<float>(lane(at->object, i)),
                   static_cast<float>(lane(at->instance, i))};
    if ((bits(at->entering) >> i & 1U) == 0) {
      if (count < left.size()) left[count++] = own;
      continue;
    }
    std::size_t k = 0;
    while (k < count && !(left[k].object == own.object && left[k].instance == own.instance)) ++k;
    if (k == count) return at;
    left[k] = left[--count];
  }
  return nullptr;
}

}  // namespace detail

/// The medium around the lanes of `here`: that of the last object that they have entered and not
/// left. Where lanes are `leaving` the object of this number, it counts as left. In other lanes,
/// and outside of all objects, it is that of space, which is the same in all lanes.
template <class Real>
Medium<Real> medium_around(const MediumTransition<Real>* last, Mask<Real> here, Mask<Real> leaving,
                           const Real& object, const Real& instance,
                           const Medium<Real>& space = {}) {
  constexpr auto n = static_cast<std::size_t>(lanes<Real>);
  if (last == nullptr) return space;
  const auto parts = [](const Medium<Real>& of) {
    return std::array{&of.ior, &of.absorption.x, &of.absorption.y, &of.absorption.z, &of.density};
  };
  std::array<std::array<LaneOf<Real>, n>, 5> found;
  for (std::size_t k = 0; k < found.size(); ++k) found[k].fill(lane(*parts(space)[k], 0));
  for (unsigned left = bits(here); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const auto at = static_cast<std::size_t>(i);
    const auto* in = detail::innermost(last, i, (bits(leaving) >> i & 1U) != 0,
                                       static_cast<float>(lane(object, i)),
                                       static_cast<float>(lane(instance, i)));
    if (in == nullptr) continue;
    for (std::size_t k = 0; k < found.size(); ++k) found[k][at] = lane(*parts(in->inside)[k], i);
  }
  return {load<Real>(found[0].data()),
          {load<Real>(found[1].data()), load<Real>(found[2].data()), load<Real>(found[3].data())},
          load<Real>(found[4].data())};
}

/// The share of light that a medium lets pass along t. Source: the law of Beer and Lambert.
template <class Real>
Vec3<Real> transmittance_of(const Vec3<Real>& absorption, const Real& t) {
  const auto passed = [&](const Real& a) {
    const Mask<Real> absorbs = a > Real(0);
    return any(absorbs) ? select(absorbs, exp_of(-a * t), Real(1)) : Real(1);
  };
  return {passed(absorption.x), passed(absorption.y), passed(absorption.z)};
}

}  // namespace tia
