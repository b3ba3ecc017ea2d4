#include "core/film/denoise_tiles.h"

namespace tia {

TilePlane padded(const TileGrid& grid, const std::vector<float>& window) {
  TilePlane plane(grid.size());
  const int border = grid.border, end = grid.columns() * TileGrid::tile + border;
  for (int y = -border; y < grid.rows() * TileGrid::tile + border; ++y) {
    const int row = std::clamp(y - grid.top, 0, grid.height - 1);
    const float* from =
        window.data() + static_cast<std::size_t>(row) * static_cast<std::size_t>(grid.width);
    float* to = plane.data() + grid.at(-border, y);
    to = std::fill_n(to, border + grid.left, from[0]);
    to = std::copy_n(from, grid.width, to);
    std::fill_n(to, end - grid.left - grid.width, from[grid.width - 1]);
  }
  return plane;
}

// First along the columns, then along the rows: each sum anew, for what is added and taken off
// again would leave a rounding that depends on the window.
TilePlane blurred(const TileGrid& grid, const TilePlane& plane, int radius) {
  const auto r = static_cast<std::size_t>(radius);
  const std::size_t stride = grid.stride(), size = grid.size(), off = r * stride;
  TilePlane columns(size), mean(size);
  for (std::size_t i = off; i + off < size; ++i) columns[i] = plane[i - off];
  for (std::size_t k = 1; k <= 2 * r; ++k)
    for (std::size_t i = off; i + off < size; ++i) columns[i] += plane[i - off + k * stride];
  const float share = 1 / static_cast<float>((2 * radius + 1) * (2 * radius + 1));
  for (std::size_t i = r; i + r < size; ++i) mean[i] = columns[i - r];
  for (std::size_t k = 1; k <= 2 * r; ++k)
    for (std::size_t i = r; i + r < size; ++i) mean[i] += columns[i - r + k];
  for (float& each : mean) each *= share;
  return mean;
}

void for_each_tile(const TileGrid& grid, const Workers& workers, bool apart,
                   const std::function<void(int x, int y)>& task) {
  const int step = apart ? 2 : 1;
  for (int phase = 0; phase < step * step; ++phase) {
    // The first tile whose column and row in the picture are those of the phase.
    const auto first = [step](int column, int of) { return (of + step - column % step) % step; };
    const int x = first(grid.first_column, phase % step), y = first(grid.first_row, phase / step);
    const int columns = (grid.columns() - x + step - 1) / step;
    const int rows = (grid.rows() - y + step - 1) / step;
    workers.for_each(columns * rows, [&](int i) {
      task((x + i % columns * step) * TileGrid::tile, (y + i / columns * step) * TileGrid::tile);
    });
  }
}

}  // namespace tia
