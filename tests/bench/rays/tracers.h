// The two tracers, each of which builds its index of a geometry and sends rays through it.
#pragma once

#include <memory>
#include <string>

#include "core/accel/world/world.h"
#include "core/parallel/pool.h"
#include "tests/bench/rays/geometry.h"
#include "tests/bench/rays/ray_set.h"

namespace tia::bench {

/// Built: what an index has cost.
struct Built {
  double ms = 0;
  double bytes = 0;  ///< that stay allocated for it, with the positions and indices that it needs
};

/// TiaIndex: Tia's, traced as its own tracer traces it: by packets of as many rays as Wide holds.
class TiaIndex {
 public:
  TiaIndex(const Geometry& geometry, Pool& pool);
  const Built& built() const { return built_; }
  const World& world() const { return *world_; }
  void trace(const RaySet& rays, Answers& answers) const;

 private:
  std::unique_ptr<World> world_;
  Built built_;
};

#ifdef TIA_HAS_EMBREE
/// EmbreeDevice: Embree's threads, which are started once and build many indexes. There may be one
/// at a time, for all of a process share the most threads that any asks for.
struct EmbreeDevice;
/// isa: an instruction set as Embree calls it; "": the best that the processor has.
std::shared_ptr<EmbreeDevice> embree_device(int threads, const std::string& isa);

/// EmbreeIndex: Embree's at its defaults but for the instruction set, with denormals taken for zero
/// as its manual asks for, and only while it works.
/// Domain: the geometry outlives it, for Embree shares its lists.
class EmbreeIndex {
 public:
  EmbreeIndex(const Geometry& geometry, std::shared_ptr<EmbreeDevice> device);
  ~EmbreeIndex();
  EmbreeIndex(const EmbreeIndex&) = delete;
  EmbreeIndex& operator=(const EmbreeIndex&) = delete;
  const Built& built() const { return built_; }
  void trace_packets(const RaySet& rays, Answers& answers) const;
  void trace_single(const RaySet& rays, Answers& answers) const;

 private:
  struct Handles;
  std::shared_ptr<EmbreeDevice> device_;
  std::unique_ptr<Handles> handles_;
  Built built_;
};
#endif

}  // namespace tia::bench
