#include "server/requests/mixture.h"

#include <algorithm>

namespace tia::server {
namespace {

// A share of 0 takes nothing of what is infinite, as depths may be.
float share_of(const Vec3f& row, const Vec3f& light) {
  const auto part = [](float share, float of) { return share == 0 ? 0 : share * of; };
  return part(row.x, light.x) + part(row.y, light.y) + part(row.z, light.z);
}

}  // namespace

Mixture::Mixture(const Window& window, bool alpha)
    : sum_(window.width(), window.height()),
      alpha_(alpha ? static_cast<std::size_t>(window.width()) *
                         static_cast<std::size_t>(window.height())
                   : 0) {}

FilmTile Mixture::with(const FilmTile& tile, const Mix& mix) const {
  FilmTile mixed = tile;
  for (int y = 0; y < tile.height; ++y)
    for (int x = 0; x < tile.width; ++x) {
      const std::size_t i = FilmTile::index(x, y);
      const Vec3f light{tile.r[i], tile.g[i], tile.b[i]};
      const float* sum = sum_.at(tile.x + x, tile.y + y);
      mixed.r[i] = sum[0] + share_of(mix[0], light);
      mixed.g[i] = sum[1] + share_of(mix[1], light);
      mixed.b[i] = sum[2] + share_of(mix[2], light);
      if (!alpha_.empty())
        mixed.alpha[i] =
            std::max(tile.alpha[i], alpha_[static_cast<std::size_t>(sum - sum_.rgb.data()) / 3]);
    }
  return mixed;
}

void Mixture::add(const FilmTile& tile, const Mix& mix) {
  const FilmTile mixed = with(tile, mix);
  for (int y = 0; y < tile.height; ++y)
    for (int x = 0; x < tile.width; ++x) {
      const std::size_t i = FilmTile::index(x, y);
      float* const sum = sum_.at(tile.x + x, tile.y + y);
      sum[0] = mixed.r[i], sum[1] = mixed.g[i], sum[2] = mixed.b[i];
      if (!alpha_.empty())
        alpha_[static_cast<std::size_t>(sum - sum_.rgb.data()) / 3] = mixed.alpha[i];
    }
}

}  // namespace tia::server
