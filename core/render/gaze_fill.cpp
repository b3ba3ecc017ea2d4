#include "core/render/gaze_fill.h"

#include "core/math/lanes.h"

namespace tia {
namespace {

// Of two equal ones it is the same bits.
GazeSample mix(const GazeSample& from, const GazeSample& to, float share) {
  GazeSample mixed;
  for (std::size_t c = 0; c < mixed.numbers.size(); ++c)
    mixed.numbers[c] = from.numbers[c] + share * (to.numbers[c] - from.numbers[c]);
  return mixed;
}

const GazeSample& at_slot(const GazeSample* samples, std::int64_t slot) { return samples[slot]; }
GazeSample between_rays(const GazeSample* samples, const GazeCell& cell) {
  const auto on_ring = [&](const GazeCell::Between& rays) {
    return mix(at_slot(samples, rays.from), at_slot(samples, rays.to), rays.share);
  };
  return mix(on_ring(cell.inner), on_ring(cell.outer), cell.share);
}

// Rings are as far apart as their rays.
std::int64_t nearest_ray(const GazeCell& cell) {
  std::int64_t nearest = cell.inner.from;
  float least = 9;
  const auto consider = [&](std::int64_t slot, float across, float along) {
    const float square = across * across + along * along;
    if (square < least) least = square, nearest = slot;
  };
  const auto consider_ring = [&](const GazeCell::Between& rays, float across) {
    consider(rays.from, across, rays.share);
    consider(rays.to, across, 1 - rays.share);
  };
  consider_ring(cell.inner, cell.share);
  consider_ring(cell.outer, 1 - cell.share);
  return nearest;
}

/// PolarRow: where a row's pixels are.
struct PolarRow {
  std::array<float, FilmTile::size> eccentricity, turn;

  // Many of them at once.
  void place(const GazeFrame& frame, const std::array<float, FilmTile::size>& dx, float dy) {
    constexpr auto lanes_each = static_cast<std::size_t>(lanes<Wide>);
    static_assert(FilmTile::size % lanes_each == 0);
    for (std::size_t x = 0; x < dx.size(); x += lanes_each) {
      const Polar<Wide> at = frame.polar(load<Wide>(&dx[x]), Wide(dy));
      store(at.eccentricity, &eccentricity[x]);
      store(at.turn, &turn[x]);
    }
  }
};

/// FilledRow: a row's pixels, channel by channel in each, on their way to the tile's planes.
using FilledRow = std::array<GazeSample, FilmTile::size>;
void put(const FilledRow& row, int y, FilmTile& tile) {
  const std::size_t at = FilmTile::index(0, y);
  for (std::size_t x = 0; x < row.size(); ++x) {
    tile.r[at + x] = row[x].numbers[0];
    tile.g[at + x] = row[x].numbers[1];
    tile.b[at + x] = row[x].numbers[2];
    tile.alpha[at + x] = row[x].numbers[3];
  }
}

}  // namespace

void fill_from_rings(const GazeFilling& from, int x0, int y0, FilmTile& tile) {
  std::array<float, FilmTile::size> dx{};
  for (int x = 0; x < FilmTile::size; ++x)
    dx[static_cast<std::size_t>(x)] = static_cast<float>(x0 + tile.x + x + 0.5 - from.frame.x());
  const bool near = overlap(from.fovea.box(), {x0 + tile.x, y0 + tile.y, x0 + tile.x + tile.width,
                                               y0 + tile.y + tile.height});
  const GazeSample* const samples = from.samples.data();
  const bool nearest = from.nearest;
  PolarRow row;
  FilledRow filled{};  // what is of the fovea is traced later
  GazeRings::Search search(from.rings);
  for (int y = 0; y < tile.height; ++y) {
    const int picture_y = y0 + tile.y + y;
    row.place(from.frame, dx, static_cast<float>(picture_y + 0.5 - from.frame.y()));
    for (int x = 0; x < tile.width; ++x) {
      if (near && from.fovea.has(x0 + tile.x + x, picture_y, from.slope)) continue;
      const auto i = static_cast<std::size_t>(x);
      const GazeCell& cell = search({row.eccentricity[i], row.turn[i]});
      filled[i] = nearest ? at_slot(samples, nearest_ray(cell)) : between_rays(samples, cell);
    }
    put(filled, y, tile);
  }
}

}  // namespace tia
