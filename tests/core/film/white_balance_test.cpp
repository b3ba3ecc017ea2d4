#include "core/film/white_balance.h"

#include <gtest/gtest.h>

#include "tests/core/film/tiles.h"

namespace tia {
namespace {

using test::Random;

struct White {
  double kelvin, x, y;
};

Vec3d xyz_of(const White& white) {
  return {white.x / white.y, 1, (1 - white.x - white.y) / white.y};
}
// Source: B. Lindbloom, RGB/XYZ matrices: sRGB, D65.
Vec3d srgb_of(const Vec3d& xyz) {
  return {3.2404542 * xyz.x - 1.5371385 * xyz.y - 0.4985314 * xyz.z,
          -0.9692660 * xyz.x + 1.8760108 * xyz.y + 0.0415560 * xyz.z,
          0.0556434 * xyz.x - 0.2040259 * xyz.y + 1.0572252 * xyz.z};
}
White white_at(double kelvin) {
  const Vec3d xyz = white_point(kelvin);
  const double sum = xyz.x + xyz.y + xyz.z;
  return {kelvin, xyz.x / sum, xyz.y / sum};
}

// Source: CIE 15:2004, table T.3; ISO 11664-2 for A and D65.
constexpr std::array published{White{2856, 0.44758, 0.40745}, White{5003, 0.34567, 0.35851},
                               White{5503, 0.33243, 0.34744}, White{6504, 0.31272, 0.32903},
                               White{7504, 0.29903, 0.31488}};

TEST(WhiteBalance, WhitesAreThoseOfThePublishedIlluminants) {
  for (const White& each : published) {
    const White white = white_at(each.kelvin);
    EXPECT_NEAR(white.x, each.x, 4e-4) << each.kelvin;
    EXPECT_NEAR(white.y, each.y, 4e-4) << each.kelvin;
  }
}

// Source: Kim et al., "Design of advanced color temperature control system for HDTV applications",
// J. Korean Physical Society 41 (2002).
TEST(WhiteBalance, ABlackBodysWhiteIsThatOfAnotherFit) {
  for (double t = 1667; t <= 4000; t += 61) {
    const double r = 1e3 / t, x = ((-0.2661239 * r - 0.2343589) * r + 0.8776956) * r + 0.179910;
    const double y = t < 2222 ? ((-1.1063814 * x - 1.34811020) * x + 2.18555832) * x - 0.20219683
                              : ((-0.9549476 * x - 1.37418593) * x + 2.09137015) * x - 0.16748867;
    EXPECT_NEAR(white_at(t).x, x, 1e-3) << t;
    EXPECT_NEAR(white_at(t).y, y, 1e-3) << t;
  }
}

TEST(WhiteBalance, WhitesFollowEachOtherWithoutAJump) {
  for (double t = 1000; t < 25'000; t += 1) {
    const Vec3d step = white_point(t + 1) - white_point(t);
    ASSERT_LT(std::abs(step.x), 2e-3) << t;
    ASSERT_LT(std::abs(step.z), 2e-3) << t;
  }
}

TEST(WhiteBalance, TheWhiteOfItsTemperatureBecomesNeutralAsBrightAsItWas) {
  Random random(130);
  for (int i = 0; i < 1000; ++i) {
    const double kelvin = random.in(2000, 25'000);
    const Vec3d neutral = white_balance(kelvin).vector(srgb_of(white_point(kelvin)));
    EXPECT_NEAR(neutral.x, 1, 1e-3) << kelvin;
    EXPECT_NEAR(neutral.y, 1, 1e-3) << kelvin;
    EXPECT_NEAR(neutral.z, 1, 1e-3) << kelvin;
  }
  for (const White& each : published) {
    const Vec3d neutral = white_balance(each.kelvin).vector(srgb_of(xyz_of(each)));
    EXPECT_NEAR(neutral.x, 1, 6e-3) << each.kelvin;
    EXPECT_NEAR(neutral.y, 1, 6e-3) << each.kelvin;
    EXPECT_NEAR(neutral.z, 1, 6e-3) << each.kelvin;
  }
}

TEST(WhiteBalance, OfDaylightChangesNextToNothing) {
  const Affine map = white_balance(6504);
  for (const Vec3d& color : {Vec3d{1, 1, 1}, Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}})
    EXPECT_LT(length(map.vector(color) - color), 2e-3);
}

TEST(WhiteBalance, EveryTemperatureHasGainsThatAreFiniteAndPositiveForItsWhite) {
  for (double t = 1000; t <= 25'000; t *= 1.01) {
    const Vec3d neutral = white_balance(t).vector(srgb_of(white_point(t)));
    ASSERT_NEAR(neutral.y, 1, 0.01) << t;
    ASSERT_LT(length(white_balance(t).vector(Vec3d{1, 1, 1})), 200) << t;
  }
}

Scene sheet_lit_by(const Vec3d& color) {
  Scene scene = read_scene(R"({"ambient_light": 0, "objects": [
      {"type": "plane", "point": [0, -2, 0], "normal": [0, 1, 0],
       "material": {"ambient": 0, "diffuse": 1, "specular": 0}}]})");
  scene.lights.push_back(test::point_light({0, 3, -8}, {color.x, color.y, color.z}));
  return scene;
}

// A white sheet by lamplight is grey once the picture is balanced for the lamp.
TEST(WhiteBalance, AWhiteSurfaceLitByALampIsGreyInAPictureBalancedForIt) {
  Random random(131);
  for (int i = 0; i < 5; ++i) {
    const double kelvin = random.in(2200, 12'000);
    const Scene scene = sheet_lit_by(srgb_of(white_point(kelvin)) * 0.6);
    const Image light = test::picture(scene, 64, 48).image;
    DisplayFilm film(64, 48, {FeatureDisplay::light, {Transfer::srgb, 0, kelvin}});
    for (const FilmTile& tile : test::tiles_of(light, 32)) film.put(tile);
    const auto& codes = film.image().rgb;
    for (std::size_t k = 0; k < codes.size(); k += 3) {
      ASSERT_LE(std::abs(codes[k] - codes[k + 1]), 1) << kelvin;
      ASSERT_LE(std::abs(codes[k + 2] - codes[k + 1]), 1) << kelvin;
    }
    EXPECT_GT(*std::max_element(codes.begin(), codes.end()), 150);
  }
}

}  // namespace
}  // namespace tia
