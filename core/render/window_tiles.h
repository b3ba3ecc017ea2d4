// A window cut into tiles, and who works on them.
#pragma once

#include <algorithm>
#include <functional>
#include <stop_token>

#include "core/accel/world/world.h"
#include "core/parallel/pool.h"
#include "core/render/preview_light.h"
#include "core/render/rounds.h"
#include "core/render/window.h"

namespace tia {

/// PoolShare: who works on a picture. Its turns come even where there is but one tile.
struct PoolShare {
  Pool& pool;
  int threads;
  const std::stop_token& stop;
  Flow* flow;

  void for_each(int count, const std::function<void(int)>& task) const {
    pool.for_each(count, threads, stop, task, flow);
  }
  Workers workers() const { return pool.workers(threads, stop, flow); }
};

/// WindowTiles: of one picture, row by row.
class WindowTiles {
 public:
  using Develop = std::function<void(const FilmTile&)>;

  /// `side`: of tiles, in pixels, at most FilmTile::size. The world and what `share` names must
  /// outlive it.
  WindowTiles(const World& world, const Window& window, IntegratorName integrator, int side,
              const PoolShare& share)
      : world_(world), window_(window), integrator_(integrator), side_(side), share_(share) {}

  const Window& window() const { return window_; }
  std::int64_t pixels() const { return std::int64_t{window_.width()} * window_.height(); }
  int count() const { return columns() * ((window_.height() + side_ - 1) / side_); }
  FilmTile& place(int i, FilmTile& tile) const {
    tile.x = i % columns() * side_;
    tile.y = i / columns() * side_;
    tile.width = std::min(side_, window_.width() - tile.x);
    tile.height = std::min(side_, window_.height() - tile.y);
    return tile;
  }
  /// Its pixels before the first sample. `parts`, `guided`: what is summed beside the light.
  TilePixels pixels_of(const FilmTile& tile, bool parts, bool guided) const {
    return {window_.x0 + tile.x, window_.y0 + tile.y, tile.width, tile.height, parts, guided};
  }

  int side() const { return side_; }
  const PoolShare& share() const { return share_; }
  /// Calls task(number, tile) for all tiles, from several threads at once.
  template <class Task>
  void for_each_tile(const Task& task) const {
    share_.for_each(count(), [&](int i) {
      FilmTile tile;
      task(i, place(i, tile));
    });
  }

  /// Hands over all tiles, as pixels(number, tile) says that they are shown; of filtered light, if
  /// there is.
  template <class Pixels>
  void hand_over(const Develop& develop, const Pixels& pixels, const PreviewLight* light) const {
    for_each_tile([&](int i, FilmTile& tile) {
      fill(tile, pixels(i, tile));
      if (light != nullptr) light->light(tile);
      hand_over(develop, tile);
    });
  }
  /// A finished tile, with the colour of a backdrop that shadows fall on under it.
  void hand_over(const Develop& develop, FilmTile& tile) const {
    if (world_.ground && !world_.backdrop->is_transparent() && gathers_light(integrator_))
      lay_under(lift<float>(rgb_of(*world_.backdrop->color)), tile);
    develop(tile);
  }

 private:
  int columns() const { return (window_.width() + side_ - 1) / side_; }

  const World& world_;
  const Window window_;
  const IntegratorName integrator_;
  const int side_;
  const PoolShare share_;
};

}  // namespace tia
