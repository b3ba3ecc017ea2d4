#include "core/radio/map_cells.h"

#include <algorithm>
#include <atomic>
#include <functional>
#include <limits>

#include "core/radio/seen_cells.h"

namespace tia {
namespace {

constexpr int tile = 8;  // cells side by side that are tried together

/// Tile: cells of a map, but those in bodies.
struct Tile {
  std::vector<std::size_t> numbers;
  std::vector<Vec3d> centers;
};

class Tiles {
 public:
  Tiles(const MapGrid& grid, int size)
      : grid_(grid), size_(size), across_((grid.width + size - 1) / size) {}

  int count() const { return across_ * ((grid_.height + size_ - 1) / size_); }
  Tile at(int number, const std::vector<std::uint8_t>& inside) const {
    Tile cells;
    const int x0 = number % across_ * size_, y0 = number / across_ * size_;
    for (int y = y0; y < std::min(y0 + size_, grid_.height); ++y)
      for (int x = x0; x < std::min(x0 + size_, grid_.width); ++x) {
        const std::size_t i = static_cast<std::size_t>(y) * static_cast<std::size_t>(grid_.width) +
                              static_cast<std::size_t>(x);
        if (inside[i] != 0) continue;
        cells.numbers.push_back(i);
        cells.centers.push_back(grid_.center(x, y));
      }
    return cells;
  }

 private:
  const MapGrid& grid_;
  const int size_, across_;
};

/// CellTotals: from the paths to a tile's cells to what they come to.
class CellTotals {
 public:
  CellTotals(const MapSearch& search, const Antenna& sender) : search_(search), sender_(sender) {
    const double none = std::numeric_limits<double>::quiet_NaN();
    all_.gain_db.assign(search.inside.size(), none);
    all_.delay_spread_s.assign(search.inside.size(), none);
    receiver_.polarization = sender.polarization;
  }

  void settle(const Tile& cells, std::vector<std::vector<RadioPath>>& paths) {
    for (std::size_t i = 0; i < cells.numbers.size(); ++i) {
      Antenna receiver = receiver_;
      receiver.position = cells.centers[i];
      const RadioTotal total =
          settle_paths(paths[i], search_.world, search_.question, sender_, receiver);
      const bool waves = search_.question.combine == MapCombine::coherent;
      const auto& gain = waves ? total.coherent_db : total.incoherent_db;
      if (gain) all_.gain_db[cells.numbers[i]] = *gain;
      if (total.delay_spread_s) all_.delay_spread_s[cells.numbers[i]] = *total.delay_spread_s;
    }
  }
  SenderCells take() { return std::move(all_); }

 private:
  const MapSearch& search_;
  const Antenna& sender_;
  Antenna receiver_;
  SenderCells all_;
};

// Where paths are straight between flat faces, sequences of them are found once for all cells.
void by_sequences(const MapSearch& search, const PathSearch& from, const Workers& workers,
                  PathCounts& counts, CellTotals& totals) {
  const MirrorSequences sequences(search.world, from, search.question, workers);
  counts += sequences.counts();
  std::atomic<std::int64_t> images{counts.images};
  const Tiles tiles(search.grid, tile);
  workers.for_each(tiles.count(), [&](int number) {
    workers.end_if_asked();
    const Tile cells = tiles.at(number, search.inside);
    if (cells.numbers.empty()) return;
    auto paths = sequences.paths_to(cells.centers, images, search.limits.max_images);
    totals.settle(cells, paths);
  });
  counts.images = images;
}

// Else each is one of so many receivers, whose rays are shot once for all of them.
void by_rays(const MapSearch& search, const PathSearch& from, const Workers& workers,
             PathCounts& counts, CellTotals& totals) {
  constexpr int large = 16;
  const Tiles tiles(search.grid, large);
  std::vector<PathCounts> parts(static_cast<std::size_t>(tiles.count()));
  workers.for_each(tiles.count(), [&](int number) {
    const Tile cells = tiles.at(number, search.inside);
    if (cells.numbers.empty()) return;
    PathSearch own = from;
    own.to = cells.centers;
    PathsTo found = paths_from(search.world, search.question, own, Workers(workers.stop()));
    parts[static_cast<std::size_t>(number)] = found.counts;
    totals.settle(cells, found.by_receiver);
  });
  for (const PathCounts& each : parts) counts += each;
}

}  // namespace

std::vector<std::uint8_t> cells_inside(const RadioWorld& world, const MapGrid& grid,
                                       const Workers& workers) {
  std::vector<std::uint8_t> inside(static_cast<std::size_t>(grid.cells()));
  const auto width = static_cast<std::size_t>(grid.width);
  workers.for_each(grid.height, [&](int row) {
    workers.end_if_asked();
    for (int column = 0; column < grid.width; ++column)
      inside[static_cast<std::size_t>(row) * width + static_cast<std::size_t>(column)] =
          world.body_around(grid.center(column, row)) >= 0 ? 1 : 0;
  });
  return inside;
}

std::vector<std::array<double, 4>> walls_in(const RadioWorld& world, const MapGrid& grid) {
  std::vector<std::array<double, 4>> walls;
  const Vec3d up = unit(cross(grid.down, grid.across));
  const double square = grid.cell * grid.cell;
  for (const FacetPiece& piece : world.all().pieces) {
    std::vector<double> ends;
    for (std::size_t i = 0; i < piece.sides; ++i) {
      const Vec3d a = piece.corners[i] - grid.origin;
      const Vec3d b = piece.corners[(i + 1) % piece.sides] - grid.origin;
      const double at_a = dot(up, a), at_b = dot(up, b);
      if ((at_a < 0) == (at_b < 0)) continue;
      const Vec3d p = a + (b - a) * (at_a / (at_a - at_b));
      ends.push_back(dot(p, grid.across) / square);
      ends.push_back(dot(p, grid.down) / square);
    }
    if (ends.size() == 4) walls.push_back({ends[0], ends[1], ends[2], ends[3]});
  }
  return walls;
}

SenderCells received_of(const Antenna& sender, const MapSearch& search, const Workers& workers,
                        PathCounts& counts) {
  PathSearch from = search_of(search.question);
  from.from = sender.position;
  from.most_images = search.limits.max_images - counts.images;
  CellTotals totals(search, sender);
  const bool flat = search.world.curved().empty() && search.question.method != RadioMethod::sbr;
  if (flat) by_sequences(search, from, workers, counts, totals);
  else by_rays(search, from, workers, counts, totals);
  return totals.take();
}

}  // namespace tia
