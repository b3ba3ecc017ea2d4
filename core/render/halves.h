// The half buffers of pixels.
#pragma once

#include <array>
#include <vector>

#include "core/render/trace_tile.h"

namespace tia {

/// Halves: a pixel's two half buffers after some rounds, in the order of PixelPlanes.
struct Halves {
  std::array<float, PixelPlanes::count> a, b;
};
inline Halves halves_of(const Estimate& estimate, const GuidedSums& sums) {
  Halves halves{};
  const double a = sums.half_count, b = estimate.count - sums.half_count;
  const auto put = [&](std::size_t plane, double half, double all) {
    halves.a[plane] = static_cast<float>(half / a);
    halves.b[plane] = static_cast<float>((all - half) / b);
  };
  put(0, sums.half_light.x, estimate.light.x);
  put(1, sums.half_light.y, estimate.light.y);
  put(2, sums.half_light.z, estimate.light.z);
  for (std::size_t k = 0; k < Guides::numbers; ++k)
    put(PixelPlanes::albedo + k, sums.half_found[k], sums.found[k]);
  return halves;
}
inline std::vector<Halves> halves_of(const TilePixels& tile) {
  std::vector<Halves> halves(tile.guided.size());
  for (std::size_t i = 0; i < halves.size(); ++i)
    halves[i] = halves_of(tile.estimates[i], tile.guided[i]);
  return halves;
}

}  // namespace tia
