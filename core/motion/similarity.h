// Maps that keep shapes: they move, turn, mirror and scale alike on every axis.
#pragma once

#include <cmath>
#include <optional>

#include "core/math/transform.h"

namespace tia {

/// By how much such a map scales; none where it is no such map, to 1e-9.
inline std::optional<double> similarity_of(const Affine& map) {
  const double square = dot(map.x, map.x);
  const auto near = [&](double got, double wanted) {
    return std::abs(got - wanted) <= 1e-9 * square;
  };
  const bool same = near(dot(map.y, map.y), square) && near(dot(map.z, map.z), square) &&
                    near(dot(map.x, map.y), 0) && near(dot(map.y, map.z), 0) &&
                    near(dot(map.z, map.x), 0);
  return same ? std::optional(std::sqrt(square)) : std::nullopt;
}

}  // namespace tia
