#include "core/render/layer_planes.h"

#include "core/film/image.h"

namespace tia {
namespace {

// The numbers of a pixel in that layer.
Vec3f numbers_of(Layer layer, const TilePixels& tile, std::size_t pixel) {
  const Estimate& estimate = tile.estimates[pixel];
  if (layer == Layer::samples) return {static_cast<float>(estimate.count), 0, 0};
  if (layer == Layer::variance) return estimate.variance();
  const PartSums& parts = tile.parts[pixel];
  const Vec3d& sum = layer == Layer::direct     ? parts.direct
                     : layer == Layer::indirect ? parts.indirect
                                                : parts.emission;
  const int n = estimate.count;
  return {static_cast<float>(sum.x / n), static_cast<float>(sum.y / n),
          static_cast<float>(sum.z / n)};
}

}  // namespace

std::vector<float> planes_of(const TilePixels& tile, LayerSet layers) {
  constexpr std::size_t plane = std::size_t{FilmTile::size} * FilmTile::size;
  std::vector<float> planes;
  layers.for_each([&](const LayerRow& row) {
    if (!row.is_beside()) return;
    const std::size_t first = planes.size();
    planes.resize(first + static_cast<std::size_t>(row.planes()) * plane);
    for (std::size_t i = 0; i < tile.estimates.size(); ++i) {
      const auto number = static_cast<int>(i);
      const std::size_t at = first + FilmTile::index(number % tile.width, number / tile.width);
      const Vec3f numbers = numbers_of(row.layer, tile, i);
      planes[at] = numbers.x;
      if (row.planes() == 1) continue;
      planes[at + plane] = numbers.y;
      planes[at + 2 * plane] = numbers.z;
    }
  });
  return planes;
}

}  // namespace tia
