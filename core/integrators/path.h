// The way of a packet's rays from the eye.
#pragma once

#include <array>
#include <cstdint>

#include "core/integrators/media.h"
#include "core/math/rng.h"

namespace tia {

/// Draws: which pixels' rays these are, and which of the pixels' samples: what is drawn at random
/// depends on that alone, and on where along the path it is drawn.
template <class Real>
struct Draws {
  static constexpr auto n = static_cast<std::size_t>(lanes<Real>);
  std::array<std::uint32_t, n> x{}, y{};
  std::uint32_t sample = 0;
  RandomKey key{0};
};

/// RayKind: what rays count as.
enum class RayKind { primary, reflection, refraction };

/// Path: how rays came to be.
template <class Real>
struct Path {
  const Draws<Real>& draws;
  RayKind kind = RayKind::primary;
  int depth = 0;                             ///< how many reflections and refractions it took
  std::uint32_t node = 1;                    ///< which branch of the tree of rays
  const Interface<Real>* through = nullptr;  ///< the last surface that they went through
  Vec3<Real> absorption{};                   ///< of what they are in

  Path mirrored() const {
    return {draws, RayKind::reflection, depth + 1, branch(0x9E3779B1), through, absorption};
  }
  Path refracted(const Interface<Real>& at, const Medium<Real>& behind) const {
    return {draws, RayKind::refraction, depth + 1, branch(0x85EBCA77), &at, behind.absorption};
  }

 private:
  std::uint32_t branch(std::uint32_t turn) const { return (node ^ node >> 15U) * turn + 1; }
};

}  // namespace tia
