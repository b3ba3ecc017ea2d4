// tia_rays: what Tia's index costs a ray, a build and a primitive, beside Embree's where that is
// installed. One thread traces; the tracers take turns, round by round, so that what slows the
// machine down slows all of them. Writes JSON.
#include <sched.h>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <cstdlib>
#include <functional>
#include <stdexcept>

#include "tests/bench/rays/tracers.h"

namespace tia::bench {
namespace {

using Clock = std::chrono::steady_clock;
double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// ---- what the command line says -----------------------------------------------------------------

struct Options {
  std::vector<std::string> kinds{"spheres", "triangles", "tubes"};
  std::vector<int> sizes;         // none: each kind's own
  std::string only, side{"tia"};  // KIND:SIZE:RAYS, which one tracer traces for some seconds
  double seconds = 5;
  int rounds = 7, threads = 1;
};

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> parts{""};
  for (const char c : text) {
    if (c == at) parts.emplace_back();
    else parts.back() += c;
  }
  return parts;
}

Options options_of(int count, char** words) {
  Options options;
  const std::vector<std::pair<std::string_view, std::function<void(const std::string&)>>> all{
      {"--kinds", [&](const std::string& v) { options.kinds = split(v, ','); }},
      {"--sizes",
       [&](const std::string& v) {
         for (const std::string& size : split(v, ',')) options.sizes.push_back(std::stoi(size));
       }},
      {"--rounds", [&](const std::string& v) { options.rounds = std::max(1, std::stoi(v)); }},
      {"--threads", [&](const std::string& v) { options.threads = std::max(1, std::stoi(v)); }},
      {"--only", [&](const std::string& v) { options.only = v; }},
      {"--seconds", [&](const std::string& v) { options.seconds = std::stod(v); }},
      {"--side", [&](const std::string& v) { options.side = v; }},
  };
  for (int i = 1; i < count; i += 2) {
    const auto at = std::find_if(all.begin(), all.end(),
                                 [&](const auto& option) { return option.first == words[i]; });
    if (at == all.end() || i + 1 == count)
      throw std::invalid_argument(
          "options: --kinds spheres,triangles,tubes --sizes N,... --rounds N --threads N (of a "
          "build)\nor --only KIND:SIZE:primary|shadow|mirror|diffuse --seconds S --side "
          "tia|embree_packets|embree_single");
    at->second(words[i + 1]);
  }
  return options;
}

const GeometryKind& kind_of(std::string_view name) {
  for (const GeometryKind& kind : geometry_kinds())
    if (kind.name == name) return kind;
  throw std::invalid_argument("no kind " + std::string(name));
}

// ---- measuring ----------------------------------------------------------------------------------

// Holds the builds of both to as many processors, however many threads each would start.
class Processors {
 public:
  explicit Processors(int count) {
    sched_getaffinity(0, sizeof before_, &before_);
    cpu_set_t fewer;
    CPU_ZERO(&fewer);
    for (int i = 0; i < CPU_SETSIZE && CPU_COUNT(&fewer) < count; ++i)
      if (CPU_ISSET(i, &before_)) CPU_SET(i, &fewer);
    sched_setaffinity(0, sizeof fewer, &fewer);
  }
  ~Processors() { sched_setaffinity(0, sizeof before_, &before_); }
  Processors(const Processors&) = delete;
  Processors& operator=(const Processors&) = delete;

 private:
  cpu_set_t before_;
};

// The indexes of one geometry, each built as often as there are rounds.
struct Indexes {
  std::unique_ptr<TiaIndex> tia;
  std::vector<double> tia_ms, embree_ms;
#ifdef TIA_HAS_EMBREE
  std::unique_ptr<EmbreeIndex> embree;
#endif

  Indexes(const Geometry& geometry, int rounds, int threads) {
    const Processors processors(threads);
    for (int i = 0; i < rounds; ++i) {
      tia.reset();
      tia = std::make_unique<TiaIndex>(geometry);
      tia_ms.push_back(tia->built().ms);
#ifdef TIA_HAS_EMBREE
      embree.reset();
      embree = std::make_unique<EmbreeIndex>(geometry, threads);
      embree_ms.push_back(embree->built().ms);
#endif
    }
  }
};

struct Tracer {
  std::string name;
  std::function<void(const RaySet&, Answers&)> trace;
  Answers answers;
  std::vector<double> ns;  // a ray, one a round

  Tracer(std::string of, std::function<void(const RaySet&, Answers&)> by)
      : name(std::move(of)), trace(std::move(by)) {}
  // The mean of as many passes as fill the time.
  double measure(const RaySet& rays, double seconds) {
    const Clock::time_point start = Clock::now();
    int passes = 0;
    double took = 0;
    do {
      trace(rays, answers);
      ++passes;
      took = seconds_since(start);
    } while (took < seconds);
    return 1e9 * took / passes / static_cast<double>(std::max<std::size_t>(rays.active, 1));
  }
};

std::vector<Tracer> tracers_of(const Indexes& indexes) {
  std::vector<Tracer> tracers;
  const auto add = [&](const char* name, auto trace) { tracers.emplace_back(name, trace); };
  add("tia", [&](const RaySet& rays, Answers& to) { indexes.tia->trace(rays, to); });
#ifdef TIA_HAS_EMBREE
  const EmbreeIndex& embree = *indexes.embree;
  add("embree_packets", [&](const RaySet& rays, Answers& to) { embree.trace_packets(rays, to); });
  add("embree_single", [&](const RaySet& rays, Answers& to) { embree.trace_single(rays, to); });
#endif
  return tracers;
}

// ---- words --------------------------------------------------------------------------------------

double least(const std::vector<double>& v) { return *std::min_element(v.begin(), v.end()); }
double median(std::vector<double> v) {
  std::sort(v.begin(), v.end());
  return v[v.size() / 2];
}

void print_built(const char* name, const std::vector<double>& ms, const Built& built,
                 std::size_t primitives) {
  std::printf(R"(, "%s": {"build_ms": %.4g, "median_ms": %.4g, "bytes": %.4g})", name, least(ms),
              median(ms), built.bytes / static_cast<double>(primitives));
}

void print_rays(const RaySet& rays, std::vector<Tracer>& tracers, int rounds) {
  for (Tracer& tracer : tracers) {
    tracer.answers.assign(rays.size(), infinity);
    tracer.trace(rays, tracer.answers);  // warms up
    tracer.ns.clear();
  }
  for (int i = 0; i < rounds; ++i)
    for (Tracer& tracer : tracers) tracer.ns.push_back(tracer.measure(rays, 0.03));
  std::printf("\"%s\": {\"rays\": %zu", ray_kind_names[static_cast<std::size_t>(rays.kind)].data(),
              rays.active);
  for (const Tracer& tracer : tracers)
    std::printf(R"(, "%s": {"ns": %.5g, "median_ns": %.5g, "differ": %.3g})", tracer.name.c_str(),
                least(tracer.ns), median(tracer.ns),
                disagreement(rays, tracers.front().answers, tracer.answers));
  std::printf("}");
}

void print_case(const GeometryKind& kind, int size, const Options& options) {
  const Geometry geometry = kind.make(size);
  // A large index is built for so long that few rounds tell as much.
  const int builds = size > 200'000 ? std::min(3, options.rounds) : options.rounds;
  const Indexes indexes(geometry, builds, options.threads);
  std::printf(R"({"kind": "%s", "primitives": %zu)", kind.name.data(), geometry.primitives());
  print_built("tia", indexes.tia_ms, indexes.tia->built(), geometry.primitives());
#ifdef TIA_HAS_EMBREE
  print_built("embree", indexes.embree_ms, indexes.embree->built(), geometry.primitives());
#endif
  std::printf(",\n  \"rays\": {");
  std::vector<Tracer> tracers = tracers_of(indexes);
  const char* between = "";
  for (const RaySet& rays : make_rays(indexes.tia->world())) {
    std::printf("%s", between);
    print_rays(rays, tracers, options.rounds);
    between = ",\n    ";
  }
  std::printf("}}");
}

void print_all(const Options& options) {
  std::printf("{\"threads\": %d, \"rounds\": %d, \"cases\": [", options.threads, options.rounds);
  const char* between = "\n ";
  for (const std::string& name : options.kinds) {
    const GeometryKind& kind = kind_of(name);
    for (const int size : options.sizes.empty() ? kind.sizes : options.sizes) {
      std::printf("%s", between);
      print_case(kind, size, options);
      std::fflush(stdout);
      between = ",\n ";
    }
  }
  std::printf("]}\n");
}

// One case for a profiler.
void print_only(const Options& options) {
  const std::vector<std::string> parts = split(options.only, ':');
  if (parts.size() != 3) throw std::invalid_argument("--only KIND:SIZE:RAYS");
  const Geometry geometry = kind_of(parts[0]).make(std::stoi(parts[1]));
  const Indexes indexes(geometry, 1, options.threads);
  for (const RaySet& rays : make_rays(indexes.tia->world()))
    for (Tracer& tracer : tracers_of(indexes)) {
      if (ray_kind_names[static_cast<std::size_t>(rays.kind)] != parts[2]) continue;
      if (tracer.name != options.side) continue;
      tracer.answers.assign(rays.size(), infinity);
      std::printf("{\"ns\": %.5g}\n", tracer.measure(rays, options.seconds));
      return;
    }
  throw std::invalid_argument("no such rays, or no such side");
}

}  // namespace
}  // namespace tia::bench

int main(int count, char** words) {
  try {
    const tia::bench::Options options = tia::bench::options_of(count, words);
    if (options.only.empty()) tia::bench::print_all(options);
    else tia::bench::print_only(options);
  } catch (const std::exception& what) {
    std::fprintf(stderr, "%s\n", what.what());
    return 2;
  }
}
