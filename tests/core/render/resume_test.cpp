// Pictures that are left and gone on with: that this changes no byte, and traces nothing again.
#include <random>

#include "core/render/kept_rounds.h"
#include "tests/core/render/chance.h"
#include "tests/sanitizer.h"

namespace tia {
namespace {

using test::bits_of;
using test::chance;
using test::of_room;
using test::Picture;
using test::with_budget;

constexpr int width = 40, height = 30;

// What a render was left with that was stopped within its tiles, once it had so many rays.
SharedRounds left_after(std::int64_t rays, RenderOptions options) {
  SharedRounds left;
  options.leave = [&](const SharedRounds& rounds) { left = rounds; };
  options.spent = [rays](std::int64_t so_far, std::int64_t) {
    if (so_far > rays) throw Stopped();
  };
  if (!options.budget) options.watch = [](const Glimpse&) {};
  EXPECT_THROW(of_room(options, width, height), Stopped);
  return left;
}

/// GoneOn: a picture that went on from there, and what it did not have to trace.
struct GoneOn {
  Image image;
  Rendered drawn;
};
GoneOn from(const SharedRounds& rounds, RenderOptions options) {
  options.from = rounds;
  const Scene scene = test::room_of_chance();
  Pool pool(options.threads);
  LinearFilm film(width, height);
  const Rendered drawn =
      render(compile(scene), view_of(scene.camera, width, height), {0, 0, width, height}, options,
             pool, {}, [&](const FilmTile& tile) { film.put(tile); });
  return {std::move(film).image(), drawn};
}

void expect_never_left(const GoneOn& gone_on, const Picture& alone) {
  EXPECT_EQ(bits_of(gone_on.image), bits_of(alone.image));
  EXPECT_EQ(gone_on.drawn.rays, alone.rays);
  if (!alone.reached) return;
  ASSERT_TRUE(gone_on.drawn.reached);
  EXPECT_EQ(gone_on.drawn.reached->samples, alone.reached->samples);
  EXPECT_EQ(gone_on.drawn.reached->mean, alone.reached->mean);
  EXPECT_EQ(gone_on.drawn.reached->noise, alone.reached->noise);
}

// Rays are counted once: as many in all as if it had not been left, of which those before are kept.
TEST(Resume, ComesToTheBytesAndRaysOfOneThatWasNeverLeft) {
  std::mt19937 random(5);
  for (const double noise : {0.0, 0.02}) {
    const Picture alone = of_room(chance(100, noise), width, height);
    const Picture more = of_room(chance(256, noise), width, height);
    for (const int threads : test::cases({1, 7})) {
      const std::int64_t least = of_room(chance(16), width, height).rays.all();
      const std::int64_t further = alone.rays.all() - least;
      const std::int64_t rays =
          least + further / 10 + static_cast<std::int64_t>(random()) % (further / 2);
      RenderOptions options = chance(100, noise);
      options.threads = threads;
      const SharedRounds left = left_after(rays, options);
      ASSERT_TRUE(left);
      EXPECT_GE(left->samples(), 16);
      EXPECT_LT(left->samples(), 100);
      EXPECT_GE(left->bytes(), width * height * sizeof(Estimate));
      EXPECT_GT(left->rays().all(), rays / 2);
      const GoneOn plain = from(left, options);
      expect_never_left(plain, alone);
      EXPECT_EQ(plain.drawn.before, left->rays());
      options.samples = 256;
      expect_never_left(from(left, options), more);
      int seen = 0;
      options.watch = [&](const Glimpse& glimpse) {
        EXPECT_FALSE(glimpse.is_preview);
        if (seen++ > 0) return;
        const Reached reached = glimpse.show([](const FilmTile&) {});
        EXPECT_EQ(reached.samples, left->samples());
      };
      const GoneOn watched = from(left, options);
      EXPECT_EQ(bits_of(watched.image), bits_of(more.image));
      EXPECT_EQ(watched.drawn.rays, more.rays);
      EXPECT_GT(seen, 0);
    }
  }
}

// Each tile of a first round, of which some pixels have no sample yet, and each of the rounds of 1,
// 2, 4 and 8 samples: of who asks soon again a scene comes to its end whose first 16 samples take
// longer than a deadline.
TEST(Resume, KeepsTheTilesOfTheFirstSamples) {
  RenderOptions options = chance(64);
  options.tile = 8;
  const Picture alone = of_room(options, width, height);
  const std::int64_t first = of_room(chance(1), width, height).rays.all();
  for (const std::int64_t rays : {first / 3, 2 * first, 6 * first}) {
    const SharedRounds left = left_after(rays, options);
    ASSERT_TRUE(left);
    EXPECT_EQ(left->samples() == 0, rays < first);
    EXPECT_GT(left->rays().all(), rays / 2);
    const GoneOn gone_on = from(left, options);
    expect_never_left(gone_on, alone);
    EXPECT_EQ(gone_on.drawn.before, left->rays());
    RenderOptions watched = options;
    int previews = 0;
    watched.watch = [&](const Glimpse& glimpse) {
      previews += glimpse.is_preview;
      glimpse.show([](const FilmTile&) {});
    };
    EXPECT_EQ(bits_of(from(left, watched).image), bits_of(alone.image));
    EXPECT_GE(previews, rays < first ? 1 : 0) << "there is nothing else to show yet";
  }
}

// Left again and again, each time a few tiles further.
TEST(Resume, MayBeLeftAgain) {
  const RenderOptions options = chance(64);
  const Picture alone = of_room(options, width, height);
  const std::int64_t all = alone.rays.all();
  RenderOptions on = options;
  for (std::int64_t rays = all / 3; rays < all; rays += all / 6) {
    const SharedRounds before = on.from;
    on.from = left_after(rays, on);
    ASSERT_TRUE(on.from);
    EXPECT_GE(on.from->rays().all(), before ? before->rays().all() : all / 4);
  }
  expect_never_left(from(on.from, options), alone);
}

// A plain picture that goes on asks for no errors, so that its sums lack what tells them: whoever
// asks for them next goes on from those that were there before.
TEST(Resume, LeavesNothingWhoseErrorsAreNotKnown) {
  const std::int64_t all = of_room(chance(64), width, height).rays.all();
  RenderOptions plain = chance(64);
  plain.from = left_after(all / 2, plain);
  ASSERT_TRUE(plain.from);
  plain.leave = [](const SharedRounds&) { ADD_FAILURE(); };
  plain.spent = [&](std::int64_t rays, std::int64_t) {
    if (rays > all / 4) throw Stopped();
  };
  EXPECT_THROW(of_room(plain, width, height), Stopped);
}

// A budget of rays ends the same round, wherever within it or before it the other was left; one
// that is smaller than what is kept does without that.
TEST(Resume, EndsABudgetsRoundsWhereTheyEnd) {
  const std::int64_t rays = of_room(chance(32), width, height).rays.all();
  for (const std::int64_t left_at : {3 * rays / 4, 4 * rays / 3, 61 * rays / 32}) {
    const SharedRounds left = left_after(left_at, with_budget(chance(256)));
    ASSERT_TRUE(left);
    for (const std::int64_t most :
         {rays / 2 + rays / 8, rays, 15 * rays / 8, 2 * rays + rays / 8}) {
      const RenderOptions options = with_budget(chance(256), {.max_rays = most});
      const GoneOn gone_on = from(left, options);
      expect_never_left(gone_on, of_room(options, width, height));
      EXPECT_EQ(gone_on.drawn.before.all(), most < left->rays().all() ? 0 : left->rays().all());
    }
  }
  // Time is what is left of it: nothing is foreseen by what another has traced.
  const SharedRounds left = left_after(3 * rays / 4, with_budget(chance(256)));
  std::vector<double> asked;
  Budget once;
  once.has_time = [&](double more) {
    if (more > 0) asked.push_back(more);
    return more == 0;
  };
  const GoneOn gone_on = from(left, with_budget(chance(256), once));
  EXPECT_EQ(gone_on.drawn.reached->samples, 32);
  EXPECT_EQ(asked.size(), 1U);
  EXPECT_GE(asked[0], 2);  // 32 more samples, after 16 at most of its own
}

TEST(Resume, PassesOverWhatIsNotOfItsRounds) {
  const std::int64_t rays = of_room(chance(64), width, height).rays.all();
  const SharedRounds left = left_after(3 * rays / 4, chance(64));
  ASSERT_TRUE(left);
  for (RenderOptions options : {chance(1), chance(16), chance(24), [] {
                                  RenderOptions clamped = chance(64);
                                  clamped.threshold = 0.1;
                                  return clamped;
                                }()}) {
    const GoneOn gone_on = from(left, options);
    EXPECT_EQ(gone_on.drawn.before.all(), 0) << options.samples;
    expect_never_left(gone_on, of_room(options, width, height));
  }
  EXPECT_EQ(left_after(0, chance(64)), nullptr) << "before any tile had a sample";
}

}  // namespace
}  // namespace tia
