#include "tests/bench/rays/measure.h"

#include <sched.h>

#include <algorithm>
#include <ctime>

namespace tia::bench {
namespace {

constexpr double seconds_a_round = 0.03;

// Holds this thread, and those that it starts, to so many processors: neither tracer can use more
// threads than it was asked to.
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

// The processor's time that this thread has had: while others have the processor it stands still.
double seconds_of_thread() {
  timespec time{};
  clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
  return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

}  // namespace

Builds build(Indexes& indexes, const Geometry& geometry, int rounds, int threads,
             [[maybe_unused]] const std::string& isa) {
  const Processors processors(threads);
  Builds builds{threads, {}, {}};
  Pool pool(threads);
#ifdef TIA_HAS_EMBREE
  indexes.embree.reset();
  const std::shared_ptr<EmbreeDevice> device = embree_device(threads, isa);
#endif
  for (int i = 0; i < rounds; ++i) {
    indexes.tia.reset();
    indexes.tia = std::make_unique<TiaIndex>(geometry, pool);
    builds.tia_ms.push_back(indexes.tia->built().ms);
#ifdef TIA_HAS_EMBREE
    indexes.embree.reset();
    indexes.embree = std::make_unique<EmbreeIndex>(geometry, device);
    builds.embree_ms.push_back(indexes.embree->built().ms);
#endif
  }
  return builds;
}

double Tracer::measure(const RaySet& rays, double seconds) {
  const double start = seconds_of_thread();
  double took = 0;
  int passes = 0;
  do {
    trace(rays, answers);
    ++passes;
    took = seconds_of_thread() - start;
  } while (took < seconds);
  return 1e9 * took / passes / static_cast<double>(std::max<std::size_t>(rays.active, 1));
}

std::vector<Tracer> tracers_of(const Indexes& indexes) {
  std::vector<Tracer> tracers;
  const auto add = [&](const char* name, auto trace) { tracers.push_back({name, trace}); };
  const TiaIndex& tia = *indexes.tia;
  add("tia", [&](const RaySet& rays, Answers& to) { tia.trace(rays, to); });
#ifdef TIA_HAS_EMBREE
  const EmbreeIndex& embree = *indexes.embree;
  add("embree_packets", [&](const RaySet& rays, Answers& to) { embree.trace_packets(rays, to); });
  add("embree_single", [&](const RaySet& rays, Answers& to) { embree.trace_single(rays, to); });
#endif
  return tracers;
}

void measure(std::vector<Tracer>& tracers, const RaySet& rays, int rounds) {
  for (Tracer& tracer : tracers) {
    tracer.answers.assign(rays.size(), infinity);
    tracer.ns.clear();
    tracer.trace(rays, tracer.answers);  // warms up
  }
  for (int i = 0; i < rounds; ++i)
    for (Tracer& tracer : tracers) tracer.ns.push_back(tracer.measure(rays, seconds_a_round));
}

}  // namespace tia::bench
