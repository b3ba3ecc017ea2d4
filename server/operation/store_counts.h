// What stores count, for the metrics.
#pragma once

#include <cstddef>
#include <cstdint>

namespace tia::server {

/// Of compiled scenes: how often they were found in the store, how often they had to be made, and
/// what is in it now.
struct StoreCounts {
  std::int64_t geometry_hits = 0, geometry_misses = 0;
  std::int64_t mesh_hits = 0, mesh_misses = 0;
  std::size_t geometries = 0, meshes = 0, bytes = 0;
};

/// How often pictures came from where, and what the store holds now: pictures, rounds of others
/// that were left, and what they take.
struct PictureCounts {
  std::int64_t stored = 0, drawn = 0, joined = 0;
  std::size_t pictures = 0, rounds = 0, bytes = 0;
};

/// How many models there are now: kept, and read in memory.
struct ModelCounts {
  std::size_t kept = 0, read = 0;
};

}  // namespace tia::server
