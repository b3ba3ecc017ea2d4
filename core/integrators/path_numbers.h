// The numbers at random of a path: blocks of four of Sobol's dimensions, of their own for each
// vertex and purpose.
#pragma once

#include "core/integrators/ray_path.h"
#include "core/math/sobol.h"
#include "core/math/unit_lanes.h"

namespace tia {

/// PathNumbers: those of a packet's paths, in [0, 1).
template <class Real>
class PathNumbers {
 public:
  explicit PathNumbers(const SamplerState<Real>& state) : state_(state) {}

  struct AtVertex {
    Real light, light_u, light_v, lobe, u, v, roulette, flight;
  };
  AtVertex at_vertex(int depth) const {
    const auto first = block(of_vertices, depth, 0), second = block(of_vertices, depth, 1);
    return {first[2], first[0], first[1], first[3], second[0], second[1], second[2], second[3]};
  }
  struct InFog {
    Real choice, distance, u, v;
  };
  InFog in_fog(int depth) const {
    const auto words = block(of_fog, depth, 0);
    return {words[2], words[3], words[0], words[1]};
  }
  /// For what is passed on the way to a vertex.
  Real passing(int depth) const { return block(of_passing, depth, 0)[0]; }
  Real wave() const { return block(of_waves, 0, 0)[0]; }

 private:
  // No other integrator's.
  static constexpr std::uint32_t of_waves = 0x1FFFFFFF, of_vertices = 0x20000000,
                                 of_fog = 0x28000000, of_passing = 0x30000000;

  std::array<Real, 4> block(std::uint32_t purpose, int depth, std::uint32_t second) const {
    const std::uint32_t of = purpose + 2 * static_cast<std::uint32_t>(depth) + second;
    const auto words = sobol_words(state_.x, state_.y, state_.sample, of, state_.key);
    return {unit_lanes<Real>(words.a), unit_lanes<Real>(words.b), unit_lanes<Real>(words.c),
            unit_lanes<Real>(words.d)};
  }

  const SamplerState<Real>& state_;
};

}  // namespace tia
