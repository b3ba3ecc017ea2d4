// What a ray is inside of: the objects that it has entered on its way and not yet left.
#pragma once

#include <array>

#include "core/math/lanes.h"

namespace tia {

/// Medium: what fills space. Space/units: absorption per scene unit.
template <class Real>
struct Medium {
  Real ior = Real(1);
  Vec3<Real> absorption{Real(0), Real(0), Real(0)};
};

/// Interface: a surface that a packet's rays went through on their way to where they are. The way
/// is the list of them, the last first; the frames of the recursion hold it.
template <class Real>
struct Interface {
  const Interface* before;  ///< null: none
  Mask<Real> here;          ///< the lanes that went through
  Mask<Real> entering;      ///< where they entered the object; else they left it
  Real object, instance;
  Medium<Real> inside;
};

namespace detail {

/// One lane's: the last interface that was entered and not left since, where `left` has been left
/// (or is being left) besides. Null: none.
template <class Real>
const Interface<Real>* innermost(const Interface<Real>* last, int i, bool leaving, float object,
                                 float instance) {
  struct Left {
    float object, instance;
  };
  std::array<Left, 72> left;
  std::size_t count = 0;
  if (leaving) left[count++] = {object, instance};
  for (const Interface<Real>* at = last; at != nullptr; at = at->before) {
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

/// What the lanes of `here` are in: the innermost object that they have entered and not left, the
/// object of this number not counted once where lanes are `leaving` it. Empty space elsewhere.
template <class Real>
Medium<Real> medium_around(const Interface<Real>* last, Mask<Real> here, Mask<Real> leaving,
                           const Real& object, const Real& instance) {
  constexpr auto n = static_cast<std::size_t>(lanes<Real>);
  Medium<Real> medium;
  if (last == nullptr) return medium;
  std::array<std::array<LaneOf<Real>, n>, 4> found{};
  found[0].fill(1);
  for (unsigned left = bits(here); left != 0; left &= left - 1) {
    const int i = std::countr_zero(left);
    const auto at = static_cast<std::size_t>(i);
    const auto* in = detail::innermost(last, i, (bits(leaving) >> i & 1U) != 0,
                                       static_cast<float>(lane(object, i)),
                                       static_cast<float>(lane(instance, i)));
    if (in == nullptr) continue;
    const Real* parts[] = {&in->inside.ior, &in->inside.absorption.x, &in->inside.absorption.y,
                           &in->inside.absorption.z};
    for (std::size_t k = 0; k < 4; ++k) found[k][at] = lane(*parts[k], i);
  }
  return {load<Real>(found[0].data()),
          {load<Real>(found[1].data()), load<Real>(found[2].data()), load<Real>(found[3].data())}};
}

}  // namespace tia
