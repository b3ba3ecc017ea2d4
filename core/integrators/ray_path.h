// The way of a packet's rays from the eye.
#pragma once

#include <array>
#include <cstdint>

#include "core/integrators/media.h"
#include "core/math/rng.h"

namespace tia {

/// SamplerState: which pixels' rays these are, and which of the pixels' samples: what is drawn at
/// random depends on that alone, and on where along the path it is drawn.
template <class Real>
struct SamplerState {
  static constexpr auto n = static_cast<std::size_t>(lanes<Real>);
  std::array<std::uint32_t, n> x{}, y{};
  std::uint32_t sample = 0;
  RandomKey key{0};
};

/// RayKind: what rays count as.
enum class RayKind { primary, reflection, refraction };

/// RayPath: how rays came to be.
template <class Real>
struct RayPath {
  const SamplerState<Real>& sampler_state;
  RayKind kind = RayKind::primary;
  int depth = 0;                             ///< how many reflections and refractions it took
  std::uint32_t node = 1;                    ///< which branch of the tree of rays
  const Interface<Real>* through = nullptr;  ///< the last surface that they went through
  Vec3<Real> absorption{};                   ///< of what they are in

  RayPath mirrored() const {
    return {sampler_state, RayKind::reflection, depth + 1, branch(0x9E3779B1), through, absorption};
  }
  RayPath refracted(const Interface<Real>& at, const Medium<Real>& behind) const {
    return {sampler_state, RayKind::refraction, depth + 1, branch(0x85EBCA77),
            &at,           behind.absorption};
  }

 private:
  std::uint32_t branch(std::uint32_t turn) const { return (node ^ node >> 15U) * turn + 1; }
};

}  // namespace tia
