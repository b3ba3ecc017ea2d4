// Films that keep alpha.
#include <gtest/gtest.h>

#include "core/film/film.h"
#include "tests/core/film/tiles.h"

namespace tia {
namespace {

using test::Random;
using test::tiles_of;

// Light that is multiplied by alpha comes out as that of the object alone, with alpha beside it.
TEST(AlphaFilm, HoldsTheDisplayFilmsCodesOfLightOverAlpha) {
  Random random(2230);
  Image light(45, 37), multiplied(45, 37);
  std::vector<float> alphas;
  for (std::size_t i = 0; i < light.rgb.size(); ++i) {
    if (i % 3 == 0) alphas.push_back(i % 5 == 0 ? 0 : static_cast<float>(random.below(17)) / 16);
    light.rgb[i] = static_cast<float>(random.in(-0.1, 1.2));
    multiplied.rgb[i] = light.rgb[i] * alphas.back();
  }
  const DisplayRule rule{FeatureDisplay::light, {Transfer::srgb, 0.5}};
  DisplayFilm whole(45, 37, rule);
  for (const FilmTile& tile : tiles_of(light, 32)) whole.put(tile);
  for (const int side : {32, 9}) {
    AlphaFilm film(45, 37, rule);
    for (FilmTile& tile : tiles_of(multiplied, side)) {
      for (int y = 0; y < tile.height; ++y)
        for (int x = 0; x < tile.width; ++x)
          tile.alpha[FilmTile::index(x, y)] =
              alphas[static_cast<std::size_t>((tile.y + y) * 45 + tile.x + x)];
      film.put(tile);
    }
    const ImageRgba8& image = film.image();
    ASSERT_EQ(image.rgba.size(), 4 * alphas.size());
    for (std::size_t i = 0; i < alphas.size(); ++i) {
      EXPECT_EQ(image.rgba[4 * i + 3], std::lround(alphas[i] * 255));
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(image.rgba[4 * i + k], alphas[i] > 0 ? whole.image().rgb[3 * i + k] : 0, 1);
    }
  }
}

}  // namespace
}  // namespace tia
