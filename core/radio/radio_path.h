// RadioPath: one way from a transmitter to a receiver, by its points; what it carries is in
// path_field.h.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/input/fields.h"
#include "core/math/vec3.h"
#include "core/radio/complex.h"

namespace tia {

enum class RadioKind { reflection, transmission, diffraction };
template <>
struct Names<RadioKind> {
  static constexpr std::array<std::string_view, 3> names{"reflection", "transmission",
                                                         "diffraction"};
};

/// RadioInteraction: what happens at an inner point of a path.
struct RadioInteraction {
  RadioKind kind = RadioKind::reflection;
  int body = 0, element = 0;
  Vec3d point{}, normal{};  ///< the normal unit and outwards
  double cosine = 1;        ///< of the angle between the path and the normal, or the edge, >= 0
  double inside = 0;        ///< how long the path is in a body that it goes into or out of there
  int edge = -1;            ///< of a diffraction: which of the bodies' edges
};

/// PathGain: by receiver port and transmitter port.
using PathGain = std::array<std::array<Complex, 2>, 2>;

/// RadioPath. Space/units: scene units, but for `gain`.
struct RadioPath {
  Vec3d from{}, to{};
  std::vector<RadioInteraction> interactions;
  double length = 0;
  double tube = 0;   ///< the root of its tube's area over its solid angle; 0: the length
  int caustics = 0;  ///< that the tube passes
  PathGain gain{};

  /// The first and the last point but the ends themselves.
  const Vec3d& second() const { return interactions.empty() ? to : interactions.front().point; }
  const Vec3d& last_but_one() const {
    return interactions.empty() ? from : interactions.back().point;
  }
};

/// By length, then by the sequence of (body, element).
bool comes_before(const RadioPath& a, const RadioPath& b);

}  // namespace tia
