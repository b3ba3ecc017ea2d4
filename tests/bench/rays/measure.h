// Measuring in turns: round by round each tracer has its own, so that what slows the machine down
// slows all of them.
#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "tests/bench/rays/tracers.h"

namespace tia::bench {

/// Builds: ms of each build of one geometry by as many threads, held to as many processors.
struct Builds {
  int threads = 1;
  std::vector<double> tia_ms, embree_ms;
};

/// Indexes: those of one geometry. Domain: it outlives them.
struct Indexes {
  std::unique_ptr<TiaIndex> tia;
#ifdef TIA_HAS_EMBREE
  std::unique_ptr<EmbreeIndex> embree;
#endif
};

/// Builds the indexes as often as there are rounds, and keeps the last. isa: Embree's.
Builds build(Indexes& indexes, const Geometry& geometry, int rounds, int threads,
             const std::string& isa);

/// Tracer: one way to trace, and what it took.
struct Tracer {
  std::string name;
  std::function<void(const RaySet&, Answers&)> trace;
  Answers answers{};
  std::vector<double> ns{};  ///< of the processor's time a ray, one a round

  /// Returns: ns a ray, the mean of as many passes as take so many seconds of the processor's.
  double measure(const RaySet& rays, double seconds);
};
/// tia, embree_packets, embree_single; the indexes outlive them.
std::vector<Tracer> tracers_of(const Indexes& indexes);

/// Fills the tracers' answers and times.
void measure(std::vector<Tracer>& tracers, const RaySet& rays, int rounds);

}  // namespace tia::bench
