// The exact solver of balls: events a second, in a room that they fill to a sixth. A frame of n
// balls of which some move: the plain scene of its time, and what its objects compile to.
#include <benchmark/benchmark.h>

#include "core/accel/world/refit_geometry.h"
#include "core/input/described.h"
#include "core/input/json.h"
#include "core/motion/exact.h"
#include "core/scene/at_time.h"
#include "core/scene/moments.h"

namespace tia::bench {
namespace {

ExactWorld balls_in_room(std::size_t n, bool fall) {
  ExactWorld world;
  if (fall) world.gravity = {0, -9.81, 0};
  std::size_t along = 1;
  while (along * along * along < n) ++along;
  const double pitch = 1.5, side = pitch * static_cast<double>(along);
  world.fixed.push_back(FixedBox{{}, {Vec3d{side, 0, 0}, Vec3d{0, side, 0}, Vec3d{0, 0, side}}});
  std::uint64_t state = 1;
  const auto speed = [&] {  // in [-5, 5): Knuth's MMIX generator, its upper bits
    state = state * 6364136223846793005U + 1442695040888963407U;
    return static_cast<double>(state >> 11U) * 0x1p-53 * 10 - 5;
  };
  const auto middle = [&](std::size_t i) { return (static_cast<double>(i) + 0.5) * pitch; };
  for (std::size_t i = 0; i < n; ++i) {
    const double x = speed(), y = speed();
    world.balls.push_back(
        {{middle(i % along), middle(i / along % along), middle(i / along / along)},
         {x, y, speed()},
         0.5});
  }
  world.duration = 2e3 / static_cast<double>(n);
  return world;
}

void exact_events(benchmark::State& state) {
  const ExactWorld world =
      balls_in_room(static_cast<std::size_t>(state.range(0)), state.range(1) != 0);
  std::size_t events = 0;
  for ([[maybe_unused]] auto _ : state) events += solve_exact(world, 10'000'000).events;
  state.counters["events_a_second"] =
      benchmark::Counter(static_cast<double>(events), benchmark::Counter::kIsRate);
}
BENCHMARK(exact_events)
    ->ArgNames({"balls", "fall"})
    ->ArgsProduct({{8, 100, 1000, 10'000}, {0, 1}})
    ->Unit(benchmark::kMillisecond);

// n balls, of which every n/movers-th goes up and down.
Scene moving_balls(std::int64_t n, std::int64_t movers) {
  std::string objects, tracks;
  const auto number = [](std::int64_t i) { return std::to_string(i); };
  for (std::int64_t i = 0; i < n; ++i)
    objects += std::string(i > 0 ? "," : "") + R"({"type":"sphere","radius":0.4,"center":[)" +
               number(i % 100) + ',' + number(i / 100 % 100) + ',' + number(i / 10'000) + "]}";
  for (std::int64_t i = 0; i < movers; ++i)
    tracks += std::string(i > 0 ? "," : "") + R"({"target":"/objects/)" + number(i * (n / movers)) +
              R"x(/center/1","formula":"sin(t)"})x";
  JsonLimits limits;
  limits.values = 1 << 30;
  return read_described<Scene>(
      parse_json(R"({"objects":[)" + objects + R"(],"animation":{"duration":9,"tracks":[)" +
                     tracks + "]}}",
                 limits),
      {});
}

void moving_moment(benchmark::State& state) {
  const Scene moving = moving_balls(state.range(0), state.range(1));
  double seconds = 0;
  for ([[maybe_unused]] auto _ : state)
    benchmark::DoNotOptimize(at_time(moving, seconds += 1e-3, {}, {}));
}
BENCHMARK(moving_moment)
    ->ArgNames({"balls", "movers"})
    ->ArgsProduct({{100'000}, {1, 100, 1000, 10'000, 100'000}})
    ->Unit(benchmark::kMillisecond);

void moving_index(benchmark::State& state) {
  const Scene plain = at_time(moving_balls(state.range(0), state.range(0)), 1, {}, {});
  for ([[maybe_unused]] auto _ : state) benchmark::DoNotOptimize(geometry_of(plain));
}
BENCHMARK(moving_index)
    ->ArgName("balls")
    ->RangeMultiplier(10)
    ->Range(100, 100'000)
    ->Unit(benchmark::kMillisecond);

// Of 10^5 balls few: the moment, and what the moment before compiled to changed into its own.
void moving_refit(benchmark::State& state) {
  const Scene moving = moving_balls(100'000, state.range(0));
  Moments moments(moving);
  tia::Geometry geometry = geometry_of(moving);
  double seconds = 0;
  for ([[maybe_unused]] auto _ : state)
    if (!refit(geometry, moments.at(seconds += 1e-3, {}, {}), moments.moved()))
      state.SkipWithError("has to be built anew");
}
BENCHMARK(moving_refit)
    ->ArgName("movers")
    ->RangeMultiplier(10)
    ->Range(1, 1000)
    ->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace tia::bench
