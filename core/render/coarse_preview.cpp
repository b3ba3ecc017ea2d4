#include "core/render/coarse_preview.h"

#include <limits>

namespace tia {

int CoarsePreview::block() const {
  constexpr std::int64_t most = 8192;
  int side = 1;
  while (tiles_.pixels() > most * side * side) side *= 2;
  return std::min(side, tiles_.side());
}

bool CoarsePreview::is_filtered() const {
  return row_of(shot_.integrator).is_chance() && tiles_.side() % block() == 0;
}

Reached CoarsePreview::show(const WindowTiles::Develop& develop) const {
  constexpr std::int64_t no_limit = std::numeric_limits<std::int64_t>::max();
  const Sampler centers(1, 0, seed_);
  const Convergence none({});
  RayMeter meter(no_limit, no_limit, stop_, spent_);
  const Instants middle = shot_.instants.subspan(shot_.instants.size() / 2, 1);
  show_blocks(
      {middle, shot_.integrator, shot_.rules, centers, none, meter, shot_.layers, is_filtered()},
      develop);
  const int of = block() * block();
  return Reached{of > 1 ? 0 : 1, 1, 1.0 / of, 1, 1};
}

void CoarsePreview::show_blocks(const Shot& shot, const WindowTiles::Develop& develop) const {
  std::vector<ShownTile> all(static_cast<std::size_t>(tiles_.count()));
  PreviewLight light(tiles_.window().width(), tiles_.window().height(), block());
  tiles_.for_each_tile([&](int i, const FilmTile& tile) {
    TilePixels pixels = tiles_.pixels_of(tile, shot.parts_light(), shot.guided);
    all[static_cast<std::size_t>(i)] = blocks_of(shot, scalar_, block(), pixels);
    if (shot.guided) light.put(tile, pixels);
  });
  const Workers workers = tiles_.share().workers();
  if (shot.guided) workers.alone([&] { light.filter(workers); });
  tiles_.hand_over(
      develop,
      [&](int i, const FilmTile&) -> const ShownTile& { return all[static_cast<std::size_t>(i)]; },
      shot.guided ? &light : nullptr);
}

}  // namespace tia
