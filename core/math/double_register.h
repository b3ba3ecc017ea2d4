// DoubleRegister as a scalar of formulas: one register, for things of which few are weighed at
// once.
#pragma once

#include "core/math/lanes.h"

namespace tia {

template <>
struct ScalarTraits<DoubleRegister> {
  using Mask = DoubleRegister::batch_bool_type;
  using Precise = DoubleRegister;
  static constexpr int lanes = static_cast<int>(DoubleRegister::size);
};

[[gnu::always_inline]] inline DoubleRegister select(const Mask<DoubleRegister>& mask,
                                                    const DoubleRegister& a,
                                                    const DoubleRegister& b) {
  return xsimd::select(mask, a, b);
}
[[gnu::always_inline]] inline bool any(const Mask<DoubleRegister>& mask) {
  return xsimd::any(mask);
}

}  // namespace tia
