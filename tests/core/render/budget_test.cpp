// What ends a picture before all of its samples, and that it leaves whole rounds.
#include <atomic>
#include <map>
#include <vector>

#include "tests/core/render/chance.h"

namespace tia {
namespace {

using test::bits_of;
using test::chance;
using test::of_room;
using test::Picture;
using test::sanitized;
using test::with_budget;

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

// Each sample takes a ray from the eye at least.
TEST(Budget, OfFewerRaysThanARoundHasSamplesBeginsNone) {
  const Picture first = of_room(chance(16));
  std::atomic<std::int64_t> spent = 0;
  const auto draw = [&](std::int64_t more) {
    RenderOptions options =
        with_budget(chance(256), {.max_rays = first.rays.all() + first.rays.primary + more});
    options.spent = [&](std::int64_t rays, std::int64_t) { spent = rays; };
    const Picture drawn = of_room(options);
    EXPECT_EQ(bits_of(drawn.image), bits_of(first.image));
    EXPECT_EQ(drawn.rays, first.rays);
  };
  draw(-1);
  EXPECT_EQ(spent, first.rays.all());
  draw(0);
  EXPECT_GT(spent, first.rays.all());
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
  std::map<int, std::vector<std::uint32_t>> reached;  // by samples: the picture of as many
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
      auto& bits = reached[drawn.reached->samples];
      if (bits.empty()) bits = bits_of(of_room(chance(drawn.reached->samples, 0.01)).image);
      EXPECT_EQ(bits, bits_of(drawn.image));
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

}  // namespace
}  // namespace tia
