// How pictures are looked up: texels, what stands between and beyond them, and from afar.
#include <gtest/gtest.h>

#include <limits>

#include "tests/core/materials/texture_maps.h"

namespace tia {
namespace {

using namespace test;

TEST(TextureMap, NearestIsEachTexelWithinIt) {
  Random random(2201);
  const ImageRgba8 image = random_rgba(random, 7, 5);
  TextureMap map = texture_map(image);
  map.nearest = true;
  for (int y = 0; y < 5; ++y)
    for (int x = 0; x < 7; ++x) {
      const double u = (x + random.in(0.01, 0.99)) / 7, v = (y + random.in(0.01, 0.99)) / 5;
      expect_rgba(rgba_at(map, texture_point(u, v, 100)), codes_at(image, x, y), 1e-15);
    }
}

TEST(TextureMap, SrgbIsTheStandardsCurveAndAlphaIsLinear) {
  ImageRgba8 image{256, 1, {}};
  for (int i = 0; i < 256; ++i)
    for (int k = 0; k < 4; ++k) image.rgba.push_back(static_cast<std::uint8_t>(i));
  TextureMap map = texture_map(image, Encoding::srgb);
  map.nearest = true;
  for (int i = 0; i < 256; ++i) {
    const double code = i / 255.0, light = srgb_light(code);
    expect_rgba(rgba_at(map, texture_point((i + 0.5) / 256, 0.5)), {light, light, light, code},
                1e-12);
  }
}

// By GL's definition, on whole numbers.
int wrapped_texel(int i, int n, Wrap wrap) {
  if (wrap == Wrap::clamp_to_edge) return std::min(std::max(i, 0), n - 1);
  int rest = i;
  while (rest < 0) rest += 2 * n;
  rest %= 2 * n;
  if (wrap == Wrap::repeat) return rest % n;
  return rest < n ? rest : 2 * n - 1 - rest;
}
constexpr Wrap all_wraps[] = {Wrap::repeat, Wrap::mirrored_repeat, Wrap::clamp_to_edge};

TEST(TextureMap, BeyondThePictureItIsWrappedAlongEachAxis) {
  Random random(2202);
  const ImageRgba8 image = random_rgba(random, 5, 4);
  TextureMap map = texture_map(image);
  map.nearest = true;
  for (const Wrap along_u : all_wraps)
    for (const Wrap along_v : all_wraps) {
      map.wrap_u = along_u, map.wrap_v = along_v;
      for (int y = -9; y < 13; ++y)
        for (int x = -11; x < 16; ++x)
          expect_rgba(rgba_at(map, texture_point((x + 0.5) / 5, (y + 0.5) / 4)),
                      codes_at(image, wrapped_texel(x, 5, along_u), wrapped_texel(y, 4, along_v)),
                      1e-15);
    }
}

TEST(TextureMap, BilinearWeighsFourTexelsByArea) {
  Random random(2203);
  const ImageRgba8 image = random_rgba(random, 6, 3);
  TextureMap map = texture_map(image);
  for (int trial = 0; trial < 200; ++trial) {
    map.wrap_u = all_wraps[random.below(3)], map.wrap_v = all_wraps[random.below(3)];
    const int x = random.whole(-8, 13), y = random.whole(-5, 7);
    const double s = random.unit(), t = random.unit();
    const auto corner = [&](int i, int j) {
      return codes_at(image, wrapped_texel(x + i, 6, map.wrap_u),
                      wrapped_texel(y + j, 3, map.wrap_v));
    };
    Rgba expected{};
    for (std::size_t k = 0; k < 4; ++k)
      expected[k] = (1 - s) * (1 - t) * corner(0, 0)[k] + s * (1 - t) * corner(1, 0)[k] +
                    (1 - s) * t * corner(0, 1)[k] + s * t * corner(1, 1)[k];
    expect_rgba(rgba_at(map, texture_point((x + 0.5 + s) / 6, (y + 0.5 + t) / 3)), expected, 1e-9);
  }
}

// (u, v) is scaled, then turned about the origin from +u away from +v, which points down, then
// moved: by a quarter, (0.5, 0.25) becomes (0.25, -0.5).
TEST(TextureMap, TransformScalesTurnsAndMoves) {
  const double quarter = std::acos(-1.0) / 2;
  TextureMap map;
  map.transform({0.1, 0.2}, {1, 1}, quarter);
  Vec2d place = place_in(map, {0.5, 0.75});
  EXPECT_NEAR(place.u, 0.1 + 0.25, 1e-12);
  EXPECT_NEAR(place.v, 0.2 - 0.5, 1e-12);
  map.transform({0, 0}, {2, 4}, quarter / 3);
  place = place_in(map, {0.5, 0.75});
  EXPECT_NEAR(place.u, 1 * std::cos(quarter / 3) + 1 * std::sin(quarter / 3), 1e-12);
  EXPECT_NEAR(place.v, -1 * std::sin(quarter / 3) + 1 * std::cos(quarter / 3), 1e-12);
}

TEST(TextureMap, CoordinatesThatAreNoneAreTheCorner) {
  Random random(2204);
  const ImageRgba8 image = random_rgba(random, 3, 3);
  TextureMap map = texture_map(image);
  map.nearest = true;
  for (const double bad :
       {1e300, -1e300, static_cast<double>(infinity), std::numeric_limits<double>::quiet_NaN()})
    expect_rgba(rgba_at(map, texture_point(bad, bad)), codes_at(image, 0, 0), 1e-15);
}

TEST(TextureMap, TheSecondSetOfCoordinatesIsItsOwn) {
  Random random(2205);
  const ImageRgba8 image = random_rgba(random, 4, 4);
  TextureMap map = texture_map(image);
  map.nearest = true;
  TexturePoint at = texture_point(0.1, 0.1);
  at.uv[1] = {0.9, 0.1};
  expect_rgba(rgba_at(map, at), codes_at(image, 0, 0), 1e-15);
  map.uv_set = 1;
  expect_rgba(rgba_at(map, at), codes_at(image, 3, 3), 1e-15);
}

// ---- levels -------------------------------------------------------------------------------------

Rgba level_mean(const MipPyramid& pyramid, int level) {
  Rgba sum{};
  const int w = pyramid.width(level), h = pyramid.height(level);
  for (int y = 0; y < h; ++y)
    for (int x = 0; x < w; ++x)
      for (std::size_t k = 0; k < 4; ++k) sum[k] += pyramid.texel(level, x, y)[k] / (w * h);
  return sum;
}

TEST(MipPyramid, EveryLevelHasThePicturesMeanInLinearLight) {
  Random random(2206);
  for (int trial = 0; trial < 20; ++trial) {
    const ImageRgba8 image = random_rgba(random, random.whole(1, 23), random.whole(1, 23));
    for (const Encoding encoding : {Encoding::srgb, Encoding::linear}) {
      const MipPyramid pyramid(std::make_shared<const ImageRgba8>(image), encoding);
      Rgba mean{};
      for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
          Rgba one = codes_at(image, x, y);
          for (std::size_t k = 0; k < 3 && encoding == Encoding::srgb; ++k)
            one[k] = srgb_light(one[k]);
          for (std::size_t k = 0; k < 4; ++k) mean[k] += one[k] / (image.width * image.height);
        }
      for (int level = 0; level < pyramid.levels(); ++level)
        expect_rgba(level_mean(pyramid, level), mean, level * 0.5 / 65535 + 1e-9);
    }
  }
}

TEST(MipPyramid, SidesAreHalvesDownToOne) {
  const MipPyramid pyramid(std::make_shared<const ImageRgba8>(even_rgba(13, 3, {9, 9, 9, 9})),
                           Encoding::linear);
  ASSERT_EQ(pyramid.levels(), 4);
  const int widths[] = {13, 6, 3, 1}, heights[] = {3, 1, 1, 1};
  for (int level = 0; level < 4; ++level) {
    EXPECT_EQ(pyramid.width(level), widths[level]);
    EXPECT_EQ(pyramid.height(level), heights[level]);
  }
}

// A texel of an odd side's half covers 2 + 1/m texels: of five, 2 1/2.
TEST(MipPyramid, OddSidesAreWeighedByArea) {
  ImageRgba8 image{5, 1, {}};
  for (const int code : {10, 50, 90, 200, 250})
    for (int k = 0; k < 4; ++k) image.rgba.push_back(static_cast<std::uint8_t>(code));
  const MipPyramid pyramid(std::make_shared<const ImageRgba8>(image), Encoding::linear);
  EXPECT_NEAR(pyramid.texel(1, 0, 0)[0], (10 + 50 + 0.5 * 90) / 2.5 / 255, 1e-5);
  EXPECT_NEAR(pyramid.texel(1, 1, 0)[0], (0.5 * 90 + 200 + 250) / 2.5 / 255, 1e-5);
}

TEST(MipPyramid, TellsItsMemory) {
  const auto image = std::make_shared<const ImageRgba8>(even_rgba(64, 48, {1, 2, 3, 4}));
  const MipPyramid whole(image, Encoding::linear), level(image, Encoding::linear, false);
  EXPECT_EQ(level.levels(), 1);
  EXPECT_GE(heap_bytes(level), image->rgba.size());
  const std::size_t halves = heap_bytes(whole) - heap_bytes(level);
  EXPECT_GE(halves, bytes_of_halves(64, 48));
  EXPECT_LE(halves, bytes_of_halves(64, 48) + 1024);
  EXPECT_NEAR(static_cast<double>(bytes_of_halves(1024, 1024)), 8.0 * 1024 * 1024 / 3, 1e3);
}

// What is as wide as 2^k texels is level k, and 2^(k + s) that and the next by the share s.
TEST(TextureMap, FootprintChoosesBetweenTwoLevels) {
  Random random(2207);
  const ImageRgba8 image = random_rgba(random, 16, 16);
  TextureMap map = texture_map(image);
  for (int k = 0; k < 4; ++k) {
    const int n = 16 >> k;
    const int x = random.below(n / 2), y = random.below(n / 2);
    // A texel's centre that is one of the next level's, too: of clamped corners.
    map.wrap_u = map.wrap_v = Wrap::clamp_to_edge;
    const double u = (2 * x + 1.0) / n, v = (2 * y + 1.0) / n;
    const TexturePoint at = texture_point(u, v, std::exp2(k) / 16);
    Rgba own{};
    for (int i = 0; i < 2; ++i)
      for (int j = 0; j < 2; ++j)
        for (std::size_t c = 0; c < 4; ++c)
          own[c] += map.pyramid->texel(k, 2 * x + i, 2 * y + j)[c] / 4;
    expect_rgba(rgba_at(map, at), own, 1e-9);
    const double share = random.unit();
    Rgba mixed{};
    for (std::size_t c = 0; c < 4; ++c)
      mixed[c] = own[c] * (1 - share) + map.pyramid->texel(k + 1, x, y)[c] * share;
    expect_rgba(rgba_at(map, texture_point(u, v, std::exp2(k + share) / 16)), mixed, 1e-9);
  }
  for (const double far : {1.0, 50.0, 1e12, static_cast<double>(infinity)})
    expect_rgba(rgba_at(map, texture_point(0.3, 0.8, far)), map.pyramid->texel(4, 0, 0), 1e-12);
}

// A picture that is repeated more often is seen smaller.
TEST(TextureMap, TransformsCountInTheFootprint) {
  Random random(2208);
  TextureMap map = texture_map(random_rgba(random, 16, 16));
  const Rgba once = rgba_at(map, texture_point(0.6, 0.7, 0.25));
  map.transform({}, {4, 4}, 0);
  expect_rgba(rgba_at(map, texture_point(0.15, 0.175, 0.0625)), once, 1e-9);
}

TEST(MipPyramid, CodesOfHalvesAreTheirQuotientsToTheBit) {
  for (int code = 0; code < 65536; code += 4) {
    std::array<std::uint16_t, 4> codes;
    for (std::size_t k = 0; k < 4; ++k) codes[k] = static_cast<std::uint16_t>(code + int(k));
    const Rgba light = doubles_of(light_of_half(codes.data()));
    for (std::size_t k = 0; k < 4; ++k) ASSERT_EQ(light[k], codes[k] / 65535.0);
  }
}

}  // namespace
}  // namespace tia
