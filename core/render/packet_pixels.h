// PacketPixels: which pixels are traced together.
#pragma once

#include <algorithm>
#include <array>

#include "core/film/image.h"
#include "core/integrators/ray_path.h"
#include "core/math/lanes.h"

namespace tia {

/// PacketPixels: the pixels of one packet, as near to a square as its lanes allow: rays that stay
/// together meet fewer boxes.
template <class Real>
struct PacketPixels {
  static constexpr int width = lanes<Real> >= 4 ? 4 : 1, height = lanes<Real> / width;
  static_assert(FilmTile::size % width == 0 && FilmTile::size % height == 0);

  /// Each lane's column and row.
  static Real column() {
    return by_lane([](int lane) { return lane % width; });
  }
  static Real row() {
    return by_lane([](int lane) { return lane / width; });
  }
  /// Tells the sampler state each lane's pixel; (x, y) is the first one's.
  static void number(int x, int y, SamplerState<Real>& sampler_state) {
    for (int i = 0; i < lanes<Real>; ++i) {
      sampler_state.x[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(x + i % width);
      sampler_state.y[static_cast<std::size_t>(i)] = static_cast<std::uint32_t>(y + i / width);
    }
  }
  /// Stores the lanes where a plane of the tile has their pixels; `corner` is the first one's.
  static void store(const Real& value, float* corner) {
    std::array<float, lanes<Real>> each;
    tia::store(value, each.data());
    for (std::size_t y = 0; y < height; ++y)
      std::copy_n(&each[y * width], width, corner + y * FilmTile::size);
  }

 private:
  template <class F>
  static Real by_lane(F value) {
    std::array<LaneOf<Real>, lanes<Real>> each;
    for (int i = 0; i < lanes<Real>; ++i)
      each[static_cast<std::size_t>(i)] = static_cast<LaneOf<Real>>(value(i));
    return load<Real>(each.data());
  }
};

}  // namespace tia
