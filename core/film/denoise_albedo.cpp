#include "core/film/denoise_albedo.h"

#include <cmath>

namespace tia {

std::array<TilePlane, 3> over_albedo(const TileGrid& grid, const PixelPlanes& pixels,
                                     TilePlane& inside, const Workers& workers) {
  std::array<TilePlane, 3> light;
  workers.for_each(3, [&](int channel) {
    const auto c = static_cast<std::size_t>(channel);
    light[c] = padded(grid, pixels.planes[PixelPlanes::light + c]);
    const TilePlane albedo = padded(grid, pixels.planes[PixelPlanes::albedo + c]);
    for (std::size_t i = 0; i < light[c].size(); ++i) light[c][i] /= divisor_of(albedo[i]);
  });
  for (TilePlane& plane : light)
    for (std::size_t i = 0; i < plane.size(); ++i)
      if (!std::isfinite(plane[i])) plane[i] = inside[i] = 0;
  return light;
}

TilePlane window_of(const TileGrid& grid) {
  TilePlane inside(grid.size());
  for (int y = grid.top; y < grid.top + grid.height; ++y) {
    float* row = inside.data() + grid.at(grid.left, y);
    std::fill(row, row + grid.width, 1.0F);
  }
  return inside;
}

}  // namespace tia
