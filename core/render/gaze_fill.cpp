#include "core/render/gaze_fill.h"

#include "core/math/lanes.h"
#include "core/math/quad.h"

namespace tia {
namespace {

// Of two equal ones it is the same bits.
Quad mix(const Quad& from, const Quad& to, float share) {
  return from + Quad(static_cast<double>(share)) * (to - from);
}

Quad at_slot(const std::vector<GazeSample>& samples, std::int64_t slot) {
  return Quad::load_unaligned(samples[static_cast<std::size_t>(slot)].numbers.data());
}
Quad between_rays(const std::vector<GazeSample>& samples, const GazeCell& cell) {
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

}  // namespace

void fill_from_rings(const GazeFilling& from, int x0, int y0, FilmTile& tile) {
  std::array<float, FilmTile::size> dx{};
  for (int x = 0; x < FilmTile::size; ++x)
    dx[static_cast<std::size_t>(x)] = static_cast<float>(x0 + tile.x + x + 0.5 - from.frame.x());
  const bool near = overlap(from.fovea.box(), {x0 + tile.x, y0 + tile.y, x0 + tile.x + tile.width,
                                               y0 + tile.y + tile.height});
  PolarRow row;
  GazeRings::Search search(from.rings);
  for (int y = 0; y < tile.height; ++y) {
    const int picture_y = y0 + tile.y + y;
    row.place(from.frame, dx, static_cast<float>(picture_y + 0.5 - from.frame.y()));
    for (int x = 0; x < tile.width; ++x) {
      if (near && from.fovea.has(x0 + tile.x + x, picture_y, from.slope)) continue;
      const auto i = static_cast<std::size_t>(x);
      const GazeCell& cell = search({row.eccentricity[i], row.turn[i]});
      const auto filled = doubles_of(from.nearest ? at_slot(from.samples, nearest_ray(cell))
                                                  : between_rays(from.samples, cell));
      const std::size_t at = FilmTile::index(x, y);
      tile.r[at] = static_cast<float>(filled[0]);
      tile.g[at] = static_cast<float>(filled[1]);
      tile.b[at] = static_cast<float>(filled[2]);
      tile.alpha[at] = static_cast<float>(filled[3]);
    }
  }
}

}  // namespace tia
