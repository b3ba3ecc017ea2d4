// Pictures of chance in rounds: that they are those of as many samples asked for at once, and that
// where pixels end by their own samples no light is lost.
#include <cstdio>
#include <set>
#include <tuple>

#include "tests/core/render/chance.h"

namespace tia {
namespace {

using test::bits_of;
using test::chance;
using test::of_room;
using test::Picture;
using test::picture;
using test::room_of_chance;
using test::sanitized;
using test::with_budget;

TEST(Rounds, APictureInRoundsIsThatOfAsManySamplesAtOnce) {
  for (const int samples : {1, 5, 16, 33, 64, 100}) {
    const Picture at_once = of_room(chance(samples)),
                  rounds = of_room(with_budget(chance(samples)));
    EXPECT_EQ(bits_of(rounds.image), bits_of(at_once.image)) << samples;
    EXPECT_EQ(rounds.rays, at_once.rays) << samples;
    ASSERT_TRUE(rounds.reached);
    EXPECT_EQ(rounds.reached->least, samples);
    EXPECT_EQ(rounds.reached->most, samples);
    EXPECT_EQ(rounds.reached->samples, samples);
  }
}

TEST(Rounds, NoiseStopsTheSamePixelsTileByTileAndOverTheWholePicture) {
  const Picture tiles = of_room(chance(256, 0.02)), whole = of_room(with_budget(chance(256, 0.02)));
  EXPECT_EQ(bits_of(tiles.image), bits_of(whole.image));
  EXPECT_EQ(tiles.rays, whole.rays);
  ASSERT_TRUE(tiles.reached && whole.reached);
  EXPECT_EQ(tiles.reached->noise, whole.reached->noise);
  EXPECT_EQ(tiles.reached->mean, whole.reached->mean);
  EXPECT_EQ(tiles.reached->least, 32);
  EXPECT_GT(tiles.reached->most, 32);
}

TEST(Rounds, ThreadsTilesLanesAndWindowsNeverChangeAByte) {
  const int width = sanitized() ? 31 : 61, height = sanitized() ? 23 : 43;
  const int samples = sanitized() ? 64 : 128;
  const Picture whole = of_room(chance(samples, 0.03), width, height);
  for (const bool budget : {false, true}) {
    for (const auto& [tile, threads, scalar] :
         {std::tuple{7, 3, Scalar::wide}, {32, 2, Scalar::narrow}, {1, 1, Scalar::wide}}) {
      RenderOptions options = chance(samples, 0.03);
      options.tile = tile;
      options.threads = threads;
      options.scalar = scalar;
      if (budget) options.budget.emplace();
      const Picture other = of_room(options, width, height);
      EXPECT_EQ(bits_of(other.image), bits_of(whole.image)) << tile << budget;
      EXPECT_EQ(other.rays, whole.rays);
      EXPECT_EQ(other.reached->mean, whole.reached->mean);
      EXPECT_EQ(other.reached->noise, whole.reached->noise);
    }
  }
  const Window window{11, 5, width - 11, height - 3};
  const Image part = picture(room_of_chance(), width, height, window, chance(samples, 0.03)).image;
  Image cut(window.width(), window.height());
  for (int y = 0; y < cut.height; ++y)
    std::copy_n(whole.image.at(window.x0, window.y0 + y), 3 * cut.width, cut.at(0, y));
  EXPECT_EQ(bits_of(part), bits_of(cut));
}

// ---- statistics -------------------------------------------------------------------------------

// What pixels that end by their own samples are off in the mean, over many seeds.
TEST(Noise, LeavesTheMeanOfManySeedsWhereItIs) {
  const int seeds = test::rounds(200, 20);
  constexpr int width = 12, height = 9;
  const World world = compile(room_of_chance());
  const View view = view_of(room_of_chance().camera, width, height);
  const auto mean_of = [&](const RenderOptions& options) {
    const Image image = picture(world, view, {0, 0, width, height}, options).image;
    double sum = 0;
    for (const float value : image.rgb) sum += static_cast<double>(value);
    return sum / static_cast<double>(image.rgb.size());
  };
  double sum = 0, squares = 0;
  RenderOptions options = chance(512, 0.02);
  for (int seed = 0; seed < seeds; ++seed) {
    options.seed = 1000 + seed;
    const double mean = mean_of(options);
    sum += mean, squares += mean * mean;
  }
  const double mean = sum / seeds;
  const double error = std::sqrt((squares / seeds - mean * mean) / (seeds - 1));
  double reference = 0;
  constexpr int references = 4;
  for (int i = 0; i < references; ++i) {
    options = chance(sanitized() ? 1024 : 8192);
    options.seed = i;
    reference += mean_of(options) / references;
  }
  EXPECT_NEAR(mean, reference, 4 * error + 1e-4 * reference);
  EXPECT_LT(error, 0.0025 * mean);
  std::printf("adaptive mean %.7f +- %.7f, reference %.7f\n", mean, error, reference);
}

TEST(Noise, IsReachedByWhatPixelsAreOff) {
  constexpr int width = 32, height = 24;
  const Image exact = of_room(chance(test::rounds(8192, 8)), width, height).image;
  for (const Tone& tone : {Tone{}, Tone{Transfer::agx, 1}}) {
    const ToneMap map(tone);
    for (const double noise : {0.04, 0.02}) {
      RenderOptions options = chance(4096, noise);
      options.tone = tone;
      options.seed = 99;
      const Picture drawn = of_room(options, width, height);
      EXPECT_LT(drawn.reached->noise, noise);
      EXPECT_GT(drawn.reached->noise, noise / 2) << "no more samples than it takes";
      double squares = 0;
      int beyond = 0;
      for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
          const auto shown = [&](const Image& image) {
            const float* p = image.at(x, y);
            return map.signal(Vec3d(Vec3f{p[0], p[1], p[2]}));
          };
          const Vec3d off = shown(drawn.image) - shown(exact);
          const double most = std::max({std::fabs(off.x), std::fabs(off.y), std::fabs(off.z)});
          squares += most * most;
          beyond += most > 3 * noise;
        }
      }
      const double rms = std::sqrt(squares / (width * height));
      std::printf("noise %.3f: reported %.4f, measured rms %.4f, mean samples %.1f\n", noise,
                  drawn.reached->noise, rms, drawn.reached->mean);
      EXPECT_LT(rms, noise);
      EXPECT_GT(rms, noise / 20);
      EXPECT_LE(beyond, 2);
    }
  }
}

}  // namespace
}  // namespace tia
