// Pictures of chance in rounds: what settles a pixel, what ends a picture, and that neither makes
// another picture of it than as many samples do that are asked for at once.
#include <gtest/gtest.h>

#include <atomic>
#include <cstdio>
#include <set>
#include <tuple>

#include "tests/core/support.h"

namespace tia {
namespace {

using test::bits_of;
using test::Picture;
using test::picture;
using test::Random;

// A ball and a lamp above a floor: penumbra, light from wall to wall, edges.
Scene room() {
  return read_scene(R"({
      "camera": {"location": [0, 1.2, 4], "look_at": [0, 0.6, 0], "fov_degrees": 40},
      "background": [0.05, 0.07, 0.1],
      "objects": [
        {"type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0],
         "material": {"color": [0.7, 0.7, 0.7], "diffuse": 1, "specular": 0}},
        {"type": "sphere", "center": [0, 0.6, 0], "radius": 0.6,
         "material": {"color": [0.8, 0.3, 0.2], "diffuse": 1, "specular": 0}}],
      "lights": [{"type": "sphere", "position": [1.5, 3, 1], "radius": 0.5, "intensity": 40}]})");
}

RenderOptions chance(int samples, double noise = 0) {
  RenderOptions options;
  options.integrator = IntegratorName::path;
  options.max_depth = 4;
  options.samples = samples;
  options.noise = noise;
  options.seed = 7;
  return options;
}
RenderOptions with_budget(RenderOptions options, Budget budget = {}) {
  options.budget = std::move(budget);
  return options;
}
Picture of_room(const RenderOptions& options, int width = sanitized() ? 20 : 40,
                int height = sanitized() ? 15 : 30) {
  return picture(room(), width, height, options);
}

// ---- the same pictures ------------------------------------------------------------------------

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
  const Image part = picture(room(), width, height, window, chance(samples, 0.03)).image;
  Image cut(window.width(), window.height());
  for (int y = 0; y < cut.height; ++y)
    std::copy_n(whole.image.at(window.x0, window.y0 + y), 3 * cut.width, cut.at(0, y));
  EXPECT_EQ(bits_of(part), bits_of(cut));
}

// ---- budgets ----------------------------------------------------------------------------------

TEST(Budget, OfRaysKeepsTheLastWholeRoundWithinIt) {
  for (const double noise : {0.0, 0.005}) {
    std::int64_t before = 0;
    for (const int samples : {16, 32, 64, 128}) {
      const Picture full = of_room(chance(samples, noise));
      const std::int64_t rays = full.rays.all();
      // With as many rays as the round takes it is there, with one less the one before it.
      for (const std::int64_t max_rays : {rays, rays + 100}) {
        const Picture drawn = of_room(with_budget(chance(256, noise), {.max_rays = max_rays}));
        EXPECT_EQ(drawn.reached->samples, samples);
        EXPECT_EQ(bits_of(drawn.image), bits_of(full.image));
        EXPECT_EQ(drawn.rays, full.rays);
      }
      if (before > 0) {
        const Picture drawn = of_room(with_budget(chance(256, noise), {.max_rays = rays - 1}));
        EXPECT_EQ(drawn.reached->samples, samples / 2);
        EXPECT_EQ(drawn.rays.all(), before);
      }
      before = rays;
    }
  }
}

TEST(Budget, WithoutARoundWithinItIsRefused) {
  const std::int64_t rays = of_room(chance(16)).rays.all();
  try {
    of_room(with_budget(chance(256), {.max_rays = rays - 1}));
    ADD_FAILURE();
  } catch (const BudgetSpent& spent) {
    EXPECT_EQ(spent.of(), BudgetSpent::Of::rays);
  }
  try {
    of_room(with_budget(chance(256), {.has_time = [](double) { return false; }}));
    ADD_FAILURE();
  } catch (const BudgetSpent& spent) {
    EXPECT_EQ(spent.of(), BudgetSpent::Of::time);
  }
}

// Time may end within a round, between tiles or in one, on any thread.
TEST(Budget, OfTimeThatEndsWithinARoundLeavesTheOneBefore) {
  std::set<int> reached;
  for (const int threads : {1, 3}) {
    for (int asked_at_most = 8; asked_at_most < 200; asked_at_most += 17) {
      std::atomic<int> asked = 0;
      RenderOptions options = with_budget(
          chance(256, 0.01), {.has_time = [&](double) { return ++asked <= asked_at_most; }});
      options.threads = threads;
      options.tile = sanitized() ? 4 : 8;  // as many tiles
      const Picture drawn = [&]() -> Picture {
        try {
          return of_room(options);
        } catch (const BudgetSpent&) {
          return {};
        }
      }();
      if (!drawn.reached) continue;
      reached.insert(drawn.reached->samples);
      EXPECT_EQ(bits_of(of_room(chance(drawn.reached->samples, 0.01)).image), bits_of(drawn.image));
    }
  }
  EXPECT_GE(reached.size(), 3U);
}

TEST(Budget, IsAskedForAsMuchMoreAsTheNextRoundTakes) {
  std::vector<double> asked;
  of_room(with_budget(chance(100), {.has_time = [&](double more) {
                        if (more > 0) asked.push_back(more);
                        return true;
                      }}));
  EXPECT_EQ(asked, (std::vector<double>{1, 1, 36.0 / 64}));
}

TEST(Budget, StopsAtTheHostsLimitInsteadOfFailing) {
  RenderOptions options = with_budget(chance(256));
  options.max_rays = of_room(chance(64)).rays.all();
  EXPECT_EQ(of_room(options).reached->samples, 64);
  options.max_rays = of_room(chance(16)).rays.all() - 1;
  EXPECT_THROW(of_room(options), InputError);
}

// ---- when a pixel is settled ------------------------------------------------------------------

// Of samples of one channel, the others 0.
Estimate of_values(const std::vector<double>& values) {
  Estimate estimate;
  for (const double value : values) {
    estimate.light.x += value;
    estimate.deviations.x += value - values[0];
    estimate.squares.x += (value - values[0]) * (value - values[0]);
    ++estimate.count;
  }
  return estimate;
}

TEST(Convergence, ByThresholdIsTheStandardErrorOfTheMean) {
  // Values 0, 0, 0, 1: mean 1/4, variance (3/16 + 9/16) / 3 = 1/4, standard error sqrt(1/16).
  Estimate values = of_values({0, 0, 0, 1}), turned = of_values({1, 0, 0, 0});
  const auto settled = [](double threshold, Estimate& estimate) {
    return Convergence({.threshold = threshold}).settle(estimate);
  };
  for (Estimate* each : {&values, &turned}) {
    EXPECT_TRUE(settled(0.2501, *each));
    EXPECT_FALSE(settled(0.2499, *each));
  }
  Estimate equal = of_values({0.5, 0.5, 0.5, 0.5});
  EXPECT_TRUE(settled(1e-9, equal));
}

TEST(Convergence, ByNoiseIsTheLargerChangeThatTheStandardErrorMakesOfWhatIsShown) {
  Random random(140);
  for (const Tone& tone : {Tone{Transfer::linear}, Tone{Transfer::srgb}, Tone{Transfer::srgb, 2}}) {
    for (int i = 0; i < 100; ++i) {
      std::vector<double> values(40);
      const double most = random.in(0.05, 1.5);
      double sum = 0, squares = 0;
      for (double& value : values) {
        value = random.in(0, most);
        sum += value, squares += value * value;
      }
      const double n = 40, mean = sum / n;
      const double error = std::sqrt((squares - n * mean * mean) / (n - 1) / n);
      const auto shown = [&](double light) {
        const double x = std::clamp(light * std::exp2(tone.exposure), 0.0, 1.0);
        if (tone.transfer == Transfer::linear) return x;
        return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
      };
      const double expected =
          std::max(shown(mean + error) - shown(mean), shown(mean) - shown(mean - error));
      Estimate estimate = of_values(values);
      const bool settled = Convergence({.noise = 0.02, .tone = tone}).settle(estimate);
      ASSERT_NEAR(estimate.error, expected, 1e-6);
      ASSERT_EQ(settled, expected < 0.02);
    }
  }
}

TEST(Convergence, ByNoiseTakes32SamplesAndMoreWhereOneIsWhite) {
  const Convergence convergence({.noise = 0.1});
  Estimate few = of_values(std::vector<double>(31, 0.5)),
           enough = of_values(std::vector<double>(32, 0.5));
  EXPECT_FALSE(convergence.settle(few));
  EXPECT_TRUE(convergence.settle(enough));
  // What is shown is white as a mean, and would be dark without the one.
  std::vector<double> one(64, 0);
  one[40] = 1000;
  Estimate spark = of_values(one);
  EXPECT_FALSE(convergence.settle(spark));
  EXPECT_GT(spark.error, 0.9F);
}

// Curves that mix channels: what samples of one colour, brighter and darker, do to what is shown is
// never more than the error.
TEST(Convergence, BoundsTheChangeOfColoursThatRiseAndFallTogether) {
  Random random(141);
  for (const Transfer transfer : {Transfer::aces, Transfer::agx}) {
    const Tone tone{transfer, 0.5, 4300};
    for (int i = 0; i < 200; ++i) {
      Vec3d color = random.point(1);
      color = {std::fabs(color.x), std::fabs(color.y), std::fabs(color.z)};
      Estimate e;
      for (int n = 0; n < 64; ++n) {
        const Vec3d light = color * random.unit(),
                    deviation = light - (e.count == 0 ? light : Vec3d(e.first));
        if (e.count == 0) e.first = Vec3f(light);
        e.light = e.light + light;
        e.deviations = e.deviations + deviation;
        e.squares = e.squares + deviation * deviation;
        ++e.count;
      }
      Convergence({.noise = 0.01, .tone = tone}).settle(e);
      const Vec3d mean = e.light * (1.0 / 64);
      const auto se = [&](double sum, double squares) {
        return std::sqrt((squares - sum * sum / 64) / 63 / 64);
      };
      const Vec3d by{se(e.deviations.x, e.squares.x), se(e.deviations.y, e.squares.y),
                     se(e.deviations.z, e.squares.z)};
      const ToneMap map(tone);
      for (const Vec3d& way : {by, -by}) {
        const Vec3d moved = map.signal(mean + way) - map.signal(mean);
        for (const double each : {moved.x, moved.y, moved.z})
          ASSERT_LE(std::fabs(each), 1.1 * static_cast<double>(e.error) + 1e-6);
      }
    }
  }
}

// ---- statistics -------------------------------------------------------------------------------

// What pixels that end by their own samples are off in the mean, over many seeds.
TEST(Noise, LeavesTheMeanOfManySeedsWhereItIs) {
  const int seeds = test::rounds(200, 20);
  constexpr int width = 12, height = 9;
  const World world = compile(room());
  const View view = view_of(room().camera, width, height);
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
