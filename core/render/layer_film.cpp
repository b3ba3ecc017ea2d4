#include "core/render/layer_film.h"

namespace tia {

int LayerFilm::first_plane(Layer layer) const {
  int before = 0;
  layers_.for_each([&](const LayerRow& row) {
    if (row.layer < layer) before += row.planes();
  });
  return before;
}

void LayerFilm::put(const FilmTile& tile) {
  if (layers_.has(Layer::rgba)) {
    static constexpr auto opaque = [] {
      std::array<float, std::size_t{FilmTile::size} * FilmTile::size> ones{};
      ones.fill(1);
      return ones;
    }();
    planes_.put(tile, tile.r, 0);
    planes_.put(tile, tile.g, 1);
    planes_.put(tile, tile.b, 2);
    planes_.put(tile, transparent_ ? tile.alpha : opaque, 3);
  }
  int from = 0;
  layers_.for_each([&](const LayerRow& row) {
    for (int i = 0; row.is_beside() && i < row.planes(); ++i)
      planes_.put(tile, tile.more_plane(from++), first_plane(row.layer) + i);
  });
}

void LayerFilm::put(const FilmTile& tile, const LayerRow& feature) {
  const int first = first_plane(feature.layer);
  planes_.put(tile, tile.r, first);
  if (feature.planes() == 1) return;
  planes_.put(tile, tile.g, first + 1);
  planes_.put(tile, tile.b, first + 2);
}

std::string LayerFilm::encode(ExrHead head, ExrType of_rgba, const Workers& workers) const {
  int plane = 0;
  layers_.for_each([&](const LayerRow& row) {
    const bool is_picture = row.layer == Layer::rgba;
    const ExrType type = row.whole ? ExrType::uint : is_picture ? of_rgba : ExrType::real;
    const std::string name(row.text);
    if (row.parts.empty()) head.channels.push_back({name, type, plane++});
    for (const char part : row.parts)
      head.channels.push_back({(is_picture ? "" : name + ".") + part, type, plane++});
  });
  return encode_exr(std::move(head), planes_, workers);
}

}  // namespace tia
