#include "core/film/tone.h"

#include <gtest/gtest.h>

#include "tests/core/support.h"

namespace tia {
namespace {

using test::Long;
using test::Random;
using Triple = std::array<Long, 3>;

constexpr std::array transfers{Transfer::srgb, Transfer::linear, Transfer::aces, Transfer::agx};

// ---- the curves again, in long double and by the C library's functions ------------------------

Triple times(const std::array<Triple, 3>& rows, const Triple& v) {
  Triple made{};
  for (std::size_t i = 0; i < 3; ++i)
    for (std::size_t k = 0; k < 3; ++k) made[i] += rows[i][k] * v[k];
  return made;
}
Long unit(Long x) { return std::clamp<Long>(x, 0, 1); }
Long srgb_of(Long x) {
  return x <= 0.0031308L ? 12.92L * x : 1.055L * std::pow(x, 1 / 2.4L) - 0.055L;
}

// Stephen Hill's fit, as BakingLab's ACES.hlsl states it.
Triple aces_of(const Triple& light) {
  Triple v = times({{{0.59719L, 0.35458L, 0.04823L},
                     {0.07600L, 0.90834L, 0.01566L},
                     {0.02840L, 0.13383L, 0.83777L}}},
                   light);
  for (Long& x : v) {
    const Long a = x * x + 0.0245786L * x - 0.000090537L;
    const Long b = 0.983729L * x * x + 0.4329510L * x + 0.238081L;
    x = a / b;
  }
  v = times({{{1.60475L, -0.53108L, -0.07367L},
              {-0.10208L, 1.10813L, -0.00605L},
              {-0.00327L, -0.07276L, 1.07602L}}},
            v);
  return {srgb_of(unit(v[0])), srgb_of(unit(v[1])), srgb_of(unit(v[2]))};
}

// Wrensch's minimal AgX, its polynomial power by power.
Triple agx_of(const Triple& light) {
  Triple v = times({{{0.842479062253094L, 0.0784335999999992L, 0.0792237451477643L},
                     {0.0423282422610123L, 0.878468636469772L, 0.0791661274605434L},
                     {0.0423756549057051L, 0.0784336L, 0.879142973793104L}}},
                   light);
  for (Long& x : v) {
    x = unit((std::log2(std::max(x, 1e-10L)) + 12.47393L) / (4.026069L + 12.47393L));
    x = 15.5L * std::pow(x, 6.0L) - 40.14L * std::pow(x, 5.0L) + 31.96L * std::pow(x, 4.0L) -
        6.868L * std::pow(x, 3.0L) + 0.4298L * x * x + 0.1191L * x - 0.00232L;
  }
  v = times({{{1.19687900512017L, -0.0980208811401368L, -0.0990297440797205L},
              {-0.0528968517574562L, 1.15190312990417L, -0.0989611768448433L},
              {-0.0529716355144438L, -0.0980434501171241L, 1.15107367264116L}}},
            v);
  return {unit(v[0]), unit(v[1]), unit(v[2])};
}

Triple shown(Transfer transfer, const Triple& light) {
  if (transfer == Transfer::aces) return aces_of(light);
  if (transfer == Transfer::agx) return agx_of(light);
  const auto encode = [&](Long x) {
    return transfer == Transfer::srgb ? srgb_of(unit(x)) : unit(x);
  };
  return {encode(light[0]), encode(light[1]), encode(light[2])};
}

// ---- tiles of light ---------------------------------------------------------------------------

FilmTile random_tile(Random& random) {
  FilmTile tile;
  tile.width = tile.height = FilmTile::size;
  for (auto* plane : {&tile.r, &tile.g, &tile.b})
    for (float& x : *plane) x = static_cast<float>(std::exp(random.in(-9, 4)));
  return tile;
}
Image8 codes_of(const FilmTile& tile, const Tone& tone) {
  DisplayFilm film(tile.width, tile.height, {FeatureDisplay::light, tone});
  film.put(tile);
  return film.image();
}
template <class F>
FilmTile with_light(FilmTile tile, F f) {
  for (auto* plane : {&tile.r, &tile.g, &tile.b})
    for (float& x : *plane) x = f(x);
  return tile;
}

TEST(Tone, ExposureIsLightTimesAPowerOfTwo) {
  Random random(120);
  for (const Transfer transfer : transfers) {
    for (const int stops : {-32, -3, -1, 1, 2, 5, 32}) {
      const FilmTile tile = random_tile(random);
      const FilmTile scaled = with_light(tile, [&](float x) { return std::ldexp(x, stops); });
      EXPECT_EQ(codes_of(tile, {transfer, static_cast<double>(stops)}).rgb,
                codes_of(scaled, {transfer}).rgb)
          << static_cast<int>(transfer) << " " << stops;
    }
  }
}

TEST(Tone, EachCodeIsNearestToWhatTheCurveShows) {
  Random random(121);
  for (const Transfer transfer : transfers) {
    for (int n = 0; n < test::rounds(8, 1); ++n) {
      const double stops = random.in(-4, 4);
      const FilmTile tile = random_tile(random);
      const Image8 codes = codes_of(tile, {transfer, stops});
      const auto scaled = [&](float x) { return x * std::exp2(Long{stops}); };
      for (std::size_t i = 0; i < tile.r.size(); ++i) {
        const Triple expected =
            shown(transfer, {scaled(tile.r[i]), scaled(tile.g[i]), scaled(tile.b[i])});
        for (std::size_t c = 0; c < 3; ++c)
          ASSERT_LE(std::abs(255 * expected[c] - codes.rgb[3 * i + c]), 0.5L + 1e-4L)
              << static_cast<int>(transfer);
      }
    }
  }
}

TEST(Tone, TheSignalIsTheCurveBeforeItIsRounded) {
  Random random(122);
  for (const Transfer transfer : transfers) {
    for (int n = 0; n < 20'000; ++n) {
      Vec3d light{};
      for (double* x : {&light.x, &light.y, &light.z}) *x = std::exp(random.in(-12, 6));
      const Triple expected = shown(transfer, {light.x, light.y, light.z});
      const Vec3d signal = ToneMap({transfer}).signal(light);
      ASSERT_NEAR(signal.x, static_cast<double>(expected[0]), 1e-13);
      ASSERT_NEAR(signal.y, static_cast<double>(expected[1]), 1e-13);
      ASSERT_NEAR(signal.z, static_cast<double>(expected[2]), 1e-13);
    }
  }
}

TEST(Tone, MoreGreyLightIsNeverDarker) {
  for (const Transfer transfer : transfers) {
    const ToneMap tone({transfer});
    Vec3d before{0, 0, 0};
    for (double light = 1e-7; light < 1e4; light *= 1.002) {
      const Vec3d signal = tone.signal({light, light, light});
      ASSERT_GE(signal.x, before.x) << light;
      ASSERT_GE(signal.y, before.y) << light;
      ASSERT_GE(signal.z, before.z) << light;
      before = signal;
    }
  }
}

TEST(Tone, NoLightIsBlackAndAnyAmountAtMostWhite) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  for (const Transfer transfer : transfers) {
    for (const double stops : {0.0, 32.0}) {
      const ToneMap tone({transfer, stops, 3000});
      for (const double none : {0.0, -1.0, -1e30, nan})
        EXPECT_EQ(tone.signal({none, none, none}), (Vec3d{0, 0, 0})) << none;
      for (const double much : {1e9, 1e38, HUGE_VAL}) {
        const FilmTile tile =
            with_light(FilmTile{.width = 1, .height = 1, .r = {}, .g = {}, .b = {}, .alpha = {}},
                       [&](float) { return static_cast<float>(much); });
        EXPECT_EQ(codes_of(tile, {transfer, stops}).rgb, (std::vector<std::uint8_t>{255, 255, 255}))
            << much;
      }
    }
  }
}

// The Academy's transforms show a middle grey of 0.18 as 4.8 of 48 cd/m^2; AgX
// turns about one half there (Sobotka's y_pivot).
TEST(Tone, MiddleGreyIsWhereTheCurvesHaveIt) {
  const Vec3d grey{0.18, 0.18, 0.18};
  EXPECT_NEAR(ToneMap({Transfer::aces}).developed(grey).x, 0.1, 0.01);
  EXPECT_NEAR(ToneMap({Transfer::agx}).signal(grey).x, 0.5, 0.005);
}

}  // namespace
}  // namespace tia
