// Motion blur: pictures whose samples are of several times.
#include <numeric>

#include "core/render/explain.h"
#include "core/render/explain_paths.h"
#include "core/render/kept_rounds.h"
#include "core/render/sampler.h"
#include "tests/core/render/chance.h"
#include "tests/core/tree.h"

namespace tia::test {
namespace {

/// Exposed: the worlds of some scenes, one a stratum of time, and their views.
struct Exposed {
  std::vector<Scene> scenes;
  std::vector<World> worlds = {};
  std::vector<Instant> instants = {};

  Exposed(std::vector<Scene> of, int width, int height) : scenes(std::move(of)) {
    for (const Scene& each : scenes) worlds.push_back(compile(each));
    for (std::size_t i = 0; i < scenes.size(); ++i)
      instants.push_back({worlds[i], view_of(scenes[i].camera, width, height)});
  }
  Exposed(const Exposed&) = delete;
};

Picture blurred(const Exposed& exposed, RenderOptions options) {
  options.blur_steps = static_cast<int>(exposed.instants.size());
  const View& view = exposed.instants.front().view;
  Pool pool(options.threads);
  LinearFilm film(view.width, view.height);
  const Rendered drawn = render(exposed.instants, {0, 0, view.width, view.height}, options, pool,
                                {}, [&](const FilmTile& tile) { film.put(tile); });
  return {film.image(), drawn.rays, drawn.reached};
}
RenderOptions by(IntegratorName integrator, int samples) {
  RenderOptions options;
  options.integrator = integrator;
  options.samples = samples;
  return options;
}

// A bar that ends at x, in pixels from the left, before black: a pixel is a unit wide.
Scene bar_to(double x, int width, int height) {
  Scene scene;
  scene.camera.projection = Projection::orthographic;
  scene.camera.height = height;
  const double left = -width / 2.0;
  const Box bar{{left - 9, -height * 1.0, -6}, {left + x, height * 1.0, -5}};
  scene.objects.push_back({"", bar, {}, MaterialRef(matte({1, 1, 1}, {1, 1, 1}))});
  return scene;
}
std::vector<Scene> bars(double from, double speed, int steps, int width, int height) {
  std::vector<Scene> scenes;
  for (int i = 0; i < steps; ++i)
    scenes.push_back(bar_to(from + speed * (i + 0.5) / steps, width, height));
  return scenes;
}

// What moves, what it shines on, and what mirrors it.
Scene moment_of_balls(double t) {
  Scene scene;
  scene.background = {0.1, 0.2, 0.3 + 0.1 * t};
  scene.objects.push_back(ball({-1.5 + t, 0.3, -6}, 0.8, matte({1, 0.4, 0.2})));
  scene.objects.push_back(ball({1.4, 0.2 * t, -7}, 1, {mirror(0.6)}));
  scene.objects.push_back(ball({0, -101, -7}, 100, matte({0.6, 0.6, 0.6})));
  scene.lights.push_back(sphere_light({-3 + 2 * t, 5, -4}, 0.7, {4, 4, 4}));
  return scene;
}
std::vector<Scene> moments_of_balls(int steps) {
  std::vector<Scene> scenes;
  for (int i = 0; i < steps; ++i) scenes.push_back(moment_of_balls((i + 0.5) / steps));
  return scenes;
}

// ---- which samples are of which time ------------------------------------------------------------

TEST(BlurSampler, EveryPointOfARoundIsTakenOnce) {
  Random random(1);
  for (int round = 0; round < rounds(60); ++round) {
    const int n = 1 + random.below(300), steps = 1 + random.below(n);
    const Sampler sampler(
        Sampling{.samples = n, .threshold = round % 2 * 0.1, .blur_steps = steps});
    for (int r = 0; r < sampler.rounds(); ++r) {
      std::vector<int> points;
      for (int i = 0; i < sampler.count(r); ++i) points.push_back(sampler.point(r, i));
      std::ranges::sort(points);
      std::vector<int> all(points.size());
      std::iota(all.begin(), all.end(), 0);
      EXPECT_EQ(points, all) << n << " samples in " << steps;
    }
  }
}

// Of n x n samples in n times those of a time are in all rows and in all columns of the pixel.
TEST(BlurSampler, SamplesOfATimeAreAllOverThePixel) {
  for (const int n : {2, 4, 8, 16}) {
    const Sampler sampler(Sampling{.samples = n * n, .blur_steps = n});
    for (int time = 0; time < n; ++time) {
      std::vector<int> rows, columns;
      for (int s = time; s < n * n; s += n) {
        const Strata::Cell& cell =
            sampler.strata(0)[static_cast<std::uint32_t>(sampler.point(0, s))];
        rows.push_back(static_cast<int>(cell.y * static_cast<float>(n) + 0.5F));
        columns.push_back(static_cast<int>(cell.x * static_cast<float>(n) + 0.5F));
      }
      std::vector<int> all(static_cast<std::size_t>(n));
      std::iota(all.begin(), all.end(), 0);
      for (std::vector<int>* each : {&rows, &columns}) {
        std::ranges::sort(*each);
        EXPECT_EQ(*each, all);
      }
    }
  }
}

TEST(BlurSampler, NoPictureEndsBeforeAllTimesHaveSamples) {
  const Sampler sampler(
      Sampling{.samples = 256, .is_chance = true, .in_rounds = true, .blur_steps = 64});
  for (int round = 0; round <= sampler.rounds(); ++round)
    EXPECT_EQ(sampler.may_end_after(round), sampler.before(round) >= 64);
}

// ---- what stands still --------------------------------------------------------------------------

// The same samples, which Strata take in another order.
TEST(Blur, OfWhatStandsStillIsThePictureOfOneTime) {
  constexpr int width = 32, height = 24;
  const Scene scene = moment_of_balls(0.3);
  const Exposed exposed(std::vector<Scene>(8, scene), width, height);
  for (const IntegratorName name : {IntegratorName::whitted, IntegratorName::normal,
                                    IntegratorName::path, IntegratorName::ambient_occlusion}) {
    const RenderOptions options = by(name, 16);
    const Picture still = picture(scene, width, height, options), blur = blurred(exposed, options);
    EXPECT_EQ(blur.rays, still.rays);
    if (row_of(name).is_chance()) EXPECT_EQ(bits_of(blur.image), bits_of(still.image));
    for (std::size_t i = 0; i < still.image.rgb.size(); ++i)
      EXPECT_NEAR(blur.image.rgb[i], still.image.rgb[i], 2e-7);
  }
}

// ---- closed forms -------------------------------------------------------------------------------

// A bar that moves by 8 pixels, of which each of 8 steps ends between pixels: 1 to the left of
// them, 0 to the right, between a ramp.
TEST(Blur, OfABarAtConstantSpeedIsALinearRampAsWideAsItsWay) {
  constexpr int width = 24, height = 4, way = 8;
  constexpr double from = 7.5;
  const Exposed exposed(bars(from, way, 8, width, height), width, height);
  for (const IntegratorName name : {IntegratorName::whitted, IntegratorName::thesis,
                                    IntegratorName::albedo, IntegratorName::path}) {
    const Image image = blurred(exposed, by(name, 64)).image;
    for (int y = 0; y < height; ++y)
      for (int x = 0; x < width; ++x) {
        const double passed = std::clamp((from + way - (x + 0.5)) / way, 0.0, 1.0);
        EXPECT_EQ(image.at(x, y)[1], static_cast<float>(passed)) << name_of(name) << " at " << x;
      }
  }
}

// By any way, to any place: the mean of what each step covers of the pixel, for its samples of that
// step are in all columns of it. Rows are samples of their own.
TEST(Blur, OfABarIsTheMeanOfWhatItsStepsCover) {
  constexpr int width = 16, height = 32;
  Random random(2);
  for (const auto& [name, samples] :
       {std::pair{IntegratorName::whitted, 64}, std::pair{IntegratorName::path, 64},
        std::pair{IntegratorName::whitted, 256}}) {
    const double from = 3 + 4 * random.unit(), way = 1 + 6 * random.unit();
    const Exposed exposed(bars(from, way, 8, width, height), width, height);
    const Image image = blurred(exposed, by(name, samples)).image;
    for (int x = 0; x < width; ++x) {
      double expected = 0, mean = 0;
      for (int i = 0; i < 8; ++i)
        expected += std::clamp(from + way * (i + 0.5) / 8 - x, 0.0, 1.0) / 8;
      for (int y = 0; y < height; ++y) mean += static_cast<double>(image.at(x, y)[1]) / height;
      EXPECT_NEAR(mean, expected, 0.02) << "column " << x << " of " << name_of(name);
    }
  }
}

// ---- sample by sample, and as a whole -----------------------------------------------------------

// What /explain tells of each sample in the world of its time adds up to the picture, bit for bit.
TEST(Blur, IsTheMeanOfItsSamplesAsTheyAreExplained) {
  constexpr int width = 16, height = 12, steps = 5, samples = 12;
  const Exposed exposed(moments_of_balls(steps), width, height);
  RenderOptions options = by(IntegratorName::whitted, samples);
  options.blur_steps = steps;
  const Image image = blurred(exposed, options).image;
  for (const auto& [x, y] : {std::pair{5, 5}, std::pair{8, 6}, std::pair{11, 7}}) {
    Vec3d sum{};
    for (int s = 0; s < samples; ++s) {
      const auto i = static_cast<std::size_t>(s % steps);
      const Explanation told =
          explain(exposed.scenes[i], exposed.worlds[i], exposed.instants[i].view, x, y, s, options);
      sum = sum + static_cast<Vec3d>(told.tree->color);
    }
    const float* pixel = image.at(x, y);
    EXPECT_EQ(pixel[0], static_cast<float>(sum.x / samples));
    EXPECT_EQ(pixel[1], static_cast<float>(sum.y / samples));
    EXPECT_EQ(pixel[2], static_cast<float>(sum.z / samples));
  }
}

TEST(Blur, IsTheMeanOfThePathsThatAreExplained) {
  constexpr int width = 16, height = 12, steps = 5;
  const Exposed exposed(moments_of_balls(steps), width, height);
  RenderOptions options = by(IntegratorName::path, 12);
  options.blur_steps = steps;
  const Image image = blurred(exposed, options).image;
  for (const auto& [x, y] : {std::pair{5, 5}, std::pair{8, 6}, std::pair{11, 7}}) {
    SeenWorlds seen{exposed.worlds, {}};
    for (const Instant& at : exposed.instants) seen.views.push_back(at.view);
    const PathExplanation told =
        explain_paths(exposed.scenes.front(), seen, x, y, {0, 12}, options);
    EXPECT_EQ(told.mean.x, image.at(x, y)[0]);
    EXPECT_EQ(told.mean.z, image.at(x, y)[2]);
    Vec3d sum{};
    for (const ExplainedPath& each : told.paths) sum = sum + static_cast<Vec3d>(each.path.color);
    EXPECT_EQ(image.at(x, y)[1], static_cast<float>(sum.y / 12));
  }
}

// Each still has as many samples as the picture; what is left is the edges' noise.
TEST(Blur, IsTheMeanOfStills) {
  constexpr int width = 20, height = 15, steps = 4, samples = 256;
  const Exposed exposed(moments_of_balls(steps), width, height);
  const RenderOptions options = by(IntegratorName::whitted, samples);
  const Image blur = blurred(exposed, options).image;
  std::vector<double> mean(blur.rgb.size());
  for (const Scene& scene : exposed.scenes) {
    const Image still = picture(scene, width, height, options).image;
    for (std::size_t i = 0; i < mean.size(); ++i)
      mean[i] += static_cast<double>(still.rgb[i]) / steps;
  }
  double all = 0;
  for (std::size_t i = 0; i < mean.size(); ++i) {
    const double off = std::fabs(static_cast<double>(blur.rgb[i]) - mean[i]);
    EXPECT_LT(off, 0.05) << "number " << i;
    all += off / static_cast<double>(mean.size());
  }
  EXPECT_LT(all, 0.004);
}

// ---- the same bytes -----------------------------------------------------------------------------

TEST(Blur, IsTheSameForAllThreadsTilesAndLanes) {
  constexpr int width = 41, height = 35;
  const Exposed exposed(moments_of_balls(8), width, height);
  for (const IntegratorName name : {IntegratorName::whitted, IntegratorName::path}) {
    for (const double threshold : {0.0, 0.1}) {
      RenderOptions options = by(name, 8);
      options.threshold = threshold;
      const Picture one = blurred(exposed, options);
      options.threads = 7;
      options.tile = 16;
      const Picture many = blurred(exposed, options);
      EXPECT_EQ(bits_of(many.image), bits_of(one.image));
      EXPECT_EQ(many.rays, one.rays);
      options.scalar = Scalar::narrow;
      EXPECT_EQ(bits_of(blurred(exposed, options).image), bits_of(one.image));
    }
  }
}

// By noise, watched, and gone on with where it was left.
TEST(Blur, IsTheSameByRounds) {
  constexpr int width = 20, height = 15;
  const Exposed exposed(moments_of_balls(8), width, height);
  RenderOptions options = by(IntegratorName::path, 128);
  options.noise = 0.03;
  const Picture alone = blurred(exposed, options);
  SharedRounds left;
  options.watch = [](const Glimpse& glimpse) { glimpse.show([](const FilmTile&) {}); };
  EXPECT_EQ(bits_of(blurred(exposed, options).image), bits_of(alone.image));
  options.leave = [&](const SharedRounds& rounds) { left = rounds; };
  options.spent = [&](std::int64_t rays, std::int64_t) {
    if (rays > alone.rays.all() / 2) throw Stopped();
  };
  EXPECT_THROW(blurred(exposed, options), Stopped);
  ASSERT_TRUE(left);
  EXPECT_GE(left->samples(), 16);
  options.spent = {};
  options.from = left;
  const Picture gone_on = blurred(exposed, options);
  EXPECT_EQ(bits_of(gone_on.image), bits_of(alone.image));
  EXPECT_EQ(gone_on.rays, alone.rays);
}

}  // namespace
}  // namespace tia::test
