// What the pixels of a picture are after some rounds.
#pragma once

#include <algorithm>
#include <array>
#include <limits>
#include <mutex>
#include <utility>
#include <vector>

#include "core/parallel/stopped.h"
#include "core/render/halves.h"
#include "core/render/layer_planes.h"
#include "core/render/preview_light.h"
#include "core/render/reached.h"
#include "core/render/trace_tile.h"

namespace tia {

/// Shown: what a pixel is after some rounds.
struct Shown {
  Vec3f light{};
  int count = 0;
  float alpha = 0;
};
inline Shown shown_of(const Estimate& estimate) {
  return {estimate.mean(), estimate.count, estimate.alpha()};
}

/// ShownTile: its pixels, and the planes of layers as FilmTile has them.
struct ShownTile {
  std::vector<Shown> pixels;
  std::vector<float> more;
  RayCounts rays = {};
  float error = 1;  ///< the largest of its pixels
};

/// Tally: sums up how far pixels have come. Any thread may add.
class Tally {
 public:
  void add(const ShownTile& tile) {
    const std::lock_guard lock(mutex_);
    for (const Shown& pixel : tile.pixels) {
      least_ = std::min(least_, pixel.count);
      most_ = std::max(most_, pixel.count);
      all_ += pixel.count;
    }
    error_ = std::max(error_, tile.error);
    pixels_ += static_cast<std::int64_t>(tile.pixels.size());
  }
  Reached reached(int samples) const {
    const double mean = static_cast<double>(all_) / static_cast<double>(pixels_);
    return {least_, most_, mean, static_cast<double>(error_), samples};
  }

 private:
  std::mutex mutex_;
  int least_ = std::numeric_limits<int>::max(), most_ = 0;
  std::int64_t all_ = 0, pixels_ = 0;
  float error_ = 0;
};

inline ShownTile shown_of(const TilePixels& tile, LayerSet layers) {
  ShownTile shown;
  shown.pixels.resize(tile.estimates.size());
  std::ranges::transform(tile.estimates, shown.pixels.begin(),
                         [](const Estimate& each) { return shown_of(each); });
  shown.more = planes_of(tile, layers);
  shown.rays = tile.rays;
  shown.error = tile.error;
  return shown;
}

/// Fills a tile with its pixels.
inline void fill(FilmTile& tile, ShownTile shown) {
  const std::vector<Shown>& pixels = shown.pixels;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const auto number = static_cast<int>(i);
    const std::size_t at = FilmTile::index(number % tile.width, number / tile.width);
    tile.r[at] = pixels[i].light.x;
    tile.g[at] = pixels[i].light.y;
    tile.b[at] = pixels[i].light.z;
    tile.alpha[at] = pixels[i].alpha;
  }
  tile.more = std::move(shown.more);
}

/// Lays a colour under all that a tile's pixels show.
inline void lay_under(const Vec3f& color, FilmTile& tile) {
  for (int y = 0; y < tile.height; ++y)
    for (int x = 0; x < tile.width; ++x) {
      const std::size_t i = FilmTile::index(x, y);
      const float free = 1 - tile.alpha[i];
      tile.r[i] += color.x * free, tile.g[i] += color.y * free, tile.b[i] += color.z * free;
    }
}

/// What the tile's pixels are where one ray through the middle of each block of them tells all, but
/// for layers, which are 0. The tile's other pixels are spent. Domain: a centred sampler.
inline ShownTile blocks_of(const Shot& shot, Scalar scalar, int side, TilePixels& pixels) {
  const auto middle_of = [&](int pixel) { return middle_of_block(pixels, side, pixel); };
  pixels.begin();
  std::erase_if(pixels.unsettled, [&](int pixel) { return pixel != middle_of(pixel); });
  trace_rounds(shot, scalar, 0, 1, pixels);
  ShownTile shown;
  for (int i = 0; i < pixels.width * pixels.height; ++i)
    shown.pixels.push_back(shown_of(pixels.estimates[static_cast<std::size_t>(middle_of(i))]));
  shown.more = planes_of(TilePixels{}, shot.layers);
  return shown;
}

/// RoundsOfTile: a tile while rounds go over the whole picture.
class RoundsOfTile {
 public:
  explicit RoundsOfTile(TilePixels&& pixels) : pixels_(std::move(pixels)) {}
  bool settled() const { return begun_ > 0 && pixels_.unsettled.empty(); }
  std::int64_t unsettled() const {
    if (begun_ == 0) return std::int64_t{pixels_.width} * pixels_.height;
    return static_cast<std::int64_t>(pixels_.unsettled.size());
  }

  // A round that does not come to its end must not be seen: what the ones before it have come to is
  // kept.
  void trace(const Shot& shot, Scalar scalar, int round) {
    keep(round, shot.layers);
    begun_ = round + 1;
    trace_rounds(shot, scalar, round, round + 1, pixels_);
  }
  /// The same, and where it is stopped within, the tile is as it was.
  void trace_or_leave(const Shot& shot, Scalar scalar, int round) {
    TilePixels before = pixels_;
    try {
      trace(shot, scalar, round);
    } catch (const Stopped&) {
      pixels_ = std::move(before);
      begun_ = round;
      throw;
    }
  }
  const ShownTile& after(int rounds, LayerSet layers) {
    keep(rounds, layers);
    return shown_;
  }
  /// Domain: as after(), called before; of pixels with guides.
  const std::vector<Halves>& halves() const { return halves_; }
  /// Puts what its pixels have come to, after all rounds that have begun. The same domain.
  void put(const FilmTile& place, PreviewLight& light) const { light.put(place, pixels_); }
  /// Begins to sum guides, and ends. Domain: before the first round; after it.
  void guide() { pixels_.has_guides = true; }
  void unguide() {
    pixels_.has_guides = false;
    pixels_.guided = {};
  }

  RayCounts rays_after(int rounds) const { return begun_ > rounds ? shown_.rays : pixels_.rays; }

  /// How many rounds it has begun, all of them whole where none is under way.
  int begun() const { return begun_; }
  void number_rounds(int begun) { begun_ = begun; }
  const TilePixels& pixels() const& { return pixels_; }
  TilePixels pixels() && { return std::move(pixels_); }
  /// Lets go of what can be made again where no round before the last one is asked for.
  void forget_shown() { shown_ = {}; }
  /// What its pixels take. Domain: not to be denoised.
  std::size_t bytes() const {
    const auto of = [](const auto& list) { return list.capacity() * sizeof list.front(); };
    return of(pixels_.estimates) + of(pixels_.parts) + of(pixels_.unsettled) + of(shown_.pixels) +
           of(shown_.more);
  }

 private:
  void keep(int rounds, LayerSet layers) {
    if (begun_ > rounds) return;
    shown_ = shown_of(pixels_, layers);
    halves_ = halves_of(pixels_);
  }

  TilePixels pixels_;
  ShownTile shown_;
  std::vector<Halves> halves_;
  int begun_ = 0;  // how many rounds
};

/// OpenTiles: those that a round is for, and how many of their pixels need more samples.
struct OpenTiles {
  std::vector<RoundsOfTile*> tiles;
  std::int64_t pixels = 0;
};
/// Those of a round. Domain: all those before it are whole.
inline OpenTiles open_for(int round, std::vector<RoundsOfTile>& all) {
  OpenTiles open;
  for (RoundsOfTile& tile : all) {
    if (tile.settled() || tile.begun() > round) continue;
    open.tiles.push_back(&tile);
    open.pixels += tile.unsettled();
  }
  return open;
}
/// How many rounds all tiles have had that need them; `most` where none does.
inline int whole_rounds(const std::vector<RoundsOfTile>& all, int most) {
  for (const RoundsOfTile& tile : all)
    if (!tile.settled()) most = std::min(most, tile.begun());
  return most;
}
inline RayCounts rays_after(int rounds, const std::vector<RoundsOfTile>& all) {
  RayCounts rays;
  for (const RoundsOfTile& tile : all) rays += tile.rays_after(rounds);
  return rays;
}

}  // namespace tia
