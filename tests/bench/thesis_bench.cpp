// The thesis' picture with key a: tracing, PNG, and both over a connection that is kept open.
// Ratios between rows of one run mean something; times alone drift with the machine.
#include <benchmark/benchmark.h>
#include <httplib.h>

#include <algorithm>
#include <chrono>
#include <functional>
#include <string>
#include <thread>
#include <vector>

#include "core/film/film.h"
#include "core/film/png.h"
#include "server/handlers/backend.h"
#include "server/handlers/dispatch.h"
#include "server/http/http_server.h"
#include "tests/bench/baseline.h"
#include "tests/bench/pool.h"
#include "tests/bench/stb_png.h"

namespace tia::bench {
namespace {

using benchmark::State;

Scene lit_scene() {
  static const server::Gallery gallery;
  return press(*gallery.find("thesis"), "a");
}

// A film with the picture on it.
template <class Film>
Film traced(int width, int height) {
  const Scene scene = lit_scene();
  const World world = compile(scene);
  const View view = view_of(scene.camera, width, height);
  Film film(width, height, DisplayRule{FeatureDisplay::light, {Transfer::linear}});
  render(world, view, {0, 0, width, height}, {.threads = 2}, pool(), {},
         [&](const FilmTile& tile) { film.put(tile); });
  return film;
}

// ---- tracing: of the baseline to linear floats, of Tia to the picture's codes ------------------

void baseline(State& state) {
  const std::vector<Ball> balls{
      {{0, 0, -20}, 4, 16, {1, 1, 1}, {}},
      {{0, -10004, -20}, 10000, 1e8F, {0.2F, 0.2F, 0.2F}, {}},
      {{-20, 20, -10}, 3, 9, {}, {1, 1, 1}},
  };
  std::vector<Vec3f> picture(std::size_t{640} * 480);
  for ([[maybe_unused]] auto _ : state) {
    render(balls, 640, 480, picture);
    benchmark::DoNotOptimize(picture.data());
  }
}
BENCHMARK(baseline)->UseRealTime();

void trace(State& state) {
  const int width = static_cast<int>(state.range(0)), height = static_cast<int>(state.range(1));
  const int threads = static_cast<int>(state.range(2));
  const Scene scene = lit_scene();
  const World world = compile(scene);
  const View view = view_of(scene.camera, width, height);
  DisplayFilm film(width, height, Transfer::linear);
  for ([[maybe_unused]] auto _ : state)
    render(world, view, {0, 0, width, height}, {.threads = threads}, pool(), {},
           [&](const FilmTile& tile) { film.put(tile); });
}
BENCHMARK(trace)
    ->ArgNames({"width", "height", "threads"})
    ->Args({640, 480, 1})
    ->Args({640, 480, 2})
    ->Args({1920, 1080, 2})
    ->UseRealTime();

// ---- PNG --------------------------------------------------------------------------------------

void png(State& state) {
  const auto film =
      traced<DisplayFilm>(static_cast<int>(state.range(0)), static_cast<int>(state.range(1)));
  std::size_t bytes = 0;
  for ([[maybe_unused]] auto _ : state) bytes = encode_png(film.image()).size();
  state.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK(png)->ArgNames({"width", "height"})->Args({640, 480})->Args({1920, 1080})->UseRealTime();

void png_in_strips(State& state) {
  const auto film = traced<ScanlineFilm>(1920, 1080);
  const int threads = static_cast<int>(state.range(0));
  const Workers workers = pool().workers(threads);
  std::size_t bytes = 0;
  for ([[maybe_unused]] auto _ : state) bytes = encode_png(film.scanlines(), workers).size();
  state.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK(png_in_strips)->ArgName("threads")->Arg(1)->Arg(2)->UseRealTime();

void png_of_stb(State& state) {
  const auto film = traced<DisplayFilm>(640, 480);
  std::size_t bytes = 0;
  for ([[maybe_unused]] auto _ : state) bytes = stb_png_bytes(film.image());
  state.counters["bytes"] = static_cast<double>(bytes);
}
BENCHMARK(png_of_stb)->UseRealTime();

// ---- key to PNG over loopback -----------------------------------------------------------------

double quantile(std::vector<double> values, double q) {
  std::sort(values.begin(), values.end());
  return values[static_cast<std::size_t>(q * static_cast<double>(values.size() - 1))];
}

// The time of a phase in a Server-Timing header, ms.
double phase(const std::string& header, const std::string& name) {
  const std::string start = name + ";dur=";
  return std::stod(header.substr(header.find(start) + start.size()));
}

// A server of our own process, asked for one key after the other by the library's client.
void key_to_png(State& state) {
  server::Config config;
  config.cache_bytes = 0;
  config.threads = pool().threads();
  const server::Gallery gallery;
  server::Backend backend(config, gallery);
  server::Service& service = backend.service;
  server::HttpServer http(
      {.host = "127.0.0.1", .port = 0},
      {.answer = [&](const server::Request& asked) { return server::answer(asked, service); },
       .refuse =
           [&](const std::exception_ptr& failure, const server::Request& asked) {
             return server::refusal(failure, asked, service);
           }});
  std::jthread running([&] { http.run(); });
  httplib::Client client("127.0.0.1", http.port());
  client.set_keep_alive(true);
  client.set_tcp_nodelay(true);

  std::vector<double> total, work;
  std::size_t next = 0;
  for ([[maybe_unused]] auto _ : state) {
    const auto start = std::chrono::steady_clock::now();
    const auto answer = client.Get(std::string("/render?key=") + "adsw"[next++ % 4]);
    const std::chrono::duration<double, std::milli> took = std::chrono::steady_clock::now() - start;
    if (!answer || answer->status != 200) return state.SkipWithError("no picture came");
    const std::string timing = answer->get_header_value("Server-Timing");
    total.push_back(took.count());
    work.push_back(phase(timing, "trace") + phase(timing, "encode"));
  }
  state.counters["median_ms"] = quantile(total, 0.5);
  state.counters["p99_ms"] = quantile(total, 0.99);
  state.counters["work_ms"] = quantile(work, 0.5);
  client.stop();
  http.stop();
}
BENCHMARK(key_to_png)->UseRealTime()->Iterations(400);

}  // namespace
}  // namespace tia::bench
