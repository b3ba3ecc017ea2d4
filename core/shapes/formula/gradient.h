// From a gradient to a normal, for one point or for eight.
#pragma once

#include <array>
#include <limits>

#include "core/math/octet.h"
#include "core/math/vec3.h"

namespace tia {

/// The gradient's direction; where it is 0, at a singular point, or too great for a double: +y.
template <class Real>
Vec3<Real> direction_of(const std::array<Real, 3>& gradient) {
  const auto& [x, y, z] = gradient;
  const Real sum = abs_of(x) + abs_of(y) + abs_of(z);  // NaN where one is
  const Real most = max_of(max_of(abs_of(x), abs_of(y)), abs_of(z));
  const auto steep = sum > Real(0.0) && sum < Real(std::numeric_limits<double>::infinity());
  const Vec3<Real> n = normalize(Vec3<Real>{x / most, y / most, z / most});
  return {select(steep, n.x, Real(0.0)), select(steep, n.y, Real(1.0)),
          select(steep, n.z, Real(0.0))};
}

}  // namespace tia
