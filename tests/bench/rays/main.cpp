// tia_rays: what Tia's index costs a ray, a build and a primitive, beside Embree's where that is
// installed. Tracing is by one thread and in the processor's time, builds are in the clock's.
// Writes JSON; times are the least of all rounds, and medians.
#include <algorithm>
#include <cstdio>
#include <functional>
#include <stdexcept>

#include "tests/bench/rays/measure.h"

namespace tia::bench {
namespace {

constexpr const char* usage =
    "options: --kinds spheres,triangles,tubes --sizes N,... --rounds N\n"
    "  --threads N,... of builds; --isa avx2|sse4.2|... Embree's, '' for the processor's best\n"
    "or one case for a profiler: --only KIND:SIZE:primary|shadow|mirror|diffuse --seconds S\n"
    "  --side tia|embree_packets|embree_single";

struct Options {
  std::vector<std::string> kinds{"spheres", "triangles", "tubes"};
  std::vector<int> sizes;  // none: each kind's own
  // The most first: Embree's threads, once started, run only where they might at the start.
  std::vector<int> threads{1};
  int rounds = 7;
  std::string isa{"avx2"};  // Embree's: that of Tia's packets
  std::string only, side{"tia"};
  double seconds = 5;
};

std::vector<std::string> split(const std::string& text, char at) {
  std::vector<std::string> primitives{""};
  for (const char c : text) {
    if (c == at) primitives.emplace_back();
    else primitives.back() += c;
  }
  return primitives;
}

std::vector<int> numbers(const std::string& text) {
  std::vector<int> all;
  for (const std::string& primitive : split(text, ','))
    all.push_back(std::max(1, std::stoi(primitive)));
  return all;
}

void set(Options& options, std::string_view name, const std::string& value) {
  if (name == "--kinds") options.kinds = split(value, ',');
  else if (name == "--sizes") options.sizes = numbers(value);
  else if (name == "--threads") std::ranges::sort(options.threads = numbers(value), std::greater());
  else if (name == "--rounds") options.rounds = numbers(value).front();
  else if (name == "--isa") options.isa = value;
  else if (name == "--only") options.only = value;
  else if (name == "--seconds") options.seconds = std::stod(value);
  else if (name == "--side") options.side = value;
  else throw std::invalid_argument("no option " + std::string(name));
}

const GeometryKind& kind_of(std::string_view name) {
  for (const GeometryKind& kind : geometry_kinds())
    if (kind.name == name) return kind;
  throw std::invalid_argument("no kind " + std::string(name));
}

// ---- JSON -----------------------------------------------------------------------------------

std::string times(const char* unit, std::vector<double> all) {
  std::sort(all.begin(), all.end());
  char text[100];
  std::snprintf(text, sizeof text, R"("%s": %.5g, "median_%s": %.5g)", unit, all.front(), unit,
                all[all.size() / 2]);
  return text;
}

void print_builds(const Builds& builds, const char* between) {
  std::printf(R"(%s{"threads": %d, "tia": {%s})", between, builds.threads,
              times("ms", builds.tia_ms).c_str());
  if (!builds.embree_ms.empty())
    std::printf(R"(, "embree": {%s})", times("ms", builds.embree_ms).c_str());
  std::printf("}");
}

void print_bytes(const Indexes& indexes, double primitives) {
  std::printf(R"("bytes": {"tia": %.4g)", indexes.tia->built().bytes / primitives);
#ifdef TIA_HAS_EMBREE
  std::printf(R"(, "embree": %.4g)", indexes.embree->built().bytes / primitives);
#endif
  std::printf("}");
}

void print_rays(const RaySet& rays, const std::vector<Tracer>& tracers, const char* between) {
  std::printf(R"(%s"%s": {"rays": %zu)", between,
              ray_kind_names[static_cast<std::size_t>(rays.kind)].data(), rays.active);
  for (const Tracer& tracer : tracers)
    std::printf(R"(, "%s": {%s, "differ": %.3g})", tracer.name.c_str(),
                times("ns", tracer.ns).c_str(),
                disagreement(rays, tracers.front().answers, tracer.answers));
  std::printf("}");
}

void print_case(const GeometryKind& kind, int size, const Options& options) {
  const Geometry geometry = kind.make(size);
  std::printf(R"({"kind": "%s", "primitives": %zu, "builds": [)", kind.name.data(),
              geometry.primitives());
  // A large index is built for so long that few rounds tell as much.
  const int builds = size > 200'000 ? std::min(3, options.rounds) : options.rounds;
  Indexes indexes;
  const char* between = "";
  for (const int threads : options.threads) {
    print_builds(build(indexes, geometry, builds, threads, options.isa), between);
    between = ", ";
  }
  std::printf("],\n  ");
  print_bytes(indexes, static_cast<double>(geometry.primitives()));
  std::vector<Tracer> tracers = tracers_of(indexes);
  between = ", \"rays\": {\n    ";
  for (const RaySet& rays : make_rays(indexes.tia->world())) {
    measure(tracers, rays, options.rounds);
    print_rays(rays, tracers, between);
    between = ",\n    ";
  }
  std::printf("}}");
  std::fflush(stdout);
}

void print_all(const Options& options) {
  std::printf(R"({"rounds": %d, "isa": "%s", "cases": [)", options.rounds, options.isa.c_str());
  const char* between = "\n ";
  for (const std::string& name : options.kinds) {
    const GeometryKind& kind = kind_of(name);
    for (const int size : options.sizes.empty() ? kind.sizes : options.sizes) {
      std::printf("%s", between);
      print_case(kind, size, options);
      between = ",\n ";
    }
  }
  std::printf("]}\n");
}

void print_only(const Options& options) {
  const std::vector<std::string> primitives = split(options.only, ':');
  if (primitives.size() != 3) throw std::invalid_argument("no case " + options.only);
  const Geometry geometry = kind_of(primitives[0]).make(numbers(primitives[1]).front());
  Indexes indexes;
  build(indexes, geometry, 1, options.threads.front(), options.isa);
  for (const RaySet& rays : make_rays(indexes.tia->world())) {
    if (ray_kind_names[static_cast<std::size_t>(rays.kind)] != primitives[2]) continue;
    for (Tracer& tracer : tracers_of(indexes)) {
      if (tracer.name != options.side) continue;
      tracer.answers.assign(rays.size(), infinity);
      std::printf("{\"ns\": %.5g}\n", tracer.measure(rays, options.seconds));
      return;
    }
  }
  throw std::invalid_argument("no case " + options.only + " of " + options.side);
}

}  // namespace
}  // namespace tia::bench

int main(int count, char** words) {
  using namespace tia::bench;
  try {
    Options options;
    for (int i = 1; i < count; i += 2) set(options, words[i], i + 1 < count ? words[i + 1] : "");
    if (options.only.empty()) print_all(options);
    else print_only(options);
  } catch (const std::exception& what) {
    std::fprintf(stderr, "%s\n%s\n", what.what(), usage);
    return 2;
  }
}
