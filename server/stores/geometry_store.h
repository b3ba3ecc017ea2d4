// Compiled scenes by their content, in bounded memory: a scene whose light or camera has moved
// finds its geometry, one of whose objects have moved finds its meshes. Any thread may call.
#pragma once

#include <cstdint>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "core/accel/world/world.h"
#include "server/operation/lru_map.h"
#include "server/operation/memory_account.h"
#include "server/operation/store_counts.h"
#include "server/stores/known_scene.h"

namespace tia::server {

/// GeometryStore. A mesh is in it as long as a geometry that has it is, once however many have it.
///
/// What is built anew when objects move is the index over the objects, which costs little beside
/// the meshes', and comes out as if nothing had been there before: pictures never depend on what
/// was asked for earlier. A film changes one of its own instead (film_frames.h).
class GeometryStore {
 public:
  /// Of 0 bytes it keeps nothing.
  explicit GeometryStore(std::int64_t max_bytes, MemoryAccount* account = nullptr)
      : keeps_(max_bytes > 0), share_(max_bytes, account, MemoryAccount::geometries) {}

  /// compile(scene, workers), with what is there already of its geometry, when it is the workers'
  /// turn. Two that want the same at once both build it: none waits for another's, which may be
  /// stopped.
  /// Errors: Stopped, which leaves the store as it was.
  World compile(const KnownScene& scene, const Workers& workers);

  StoreCounts counts() const;
  /// Lets go of those that nobody has asked for longest. Returns: how many bytes.
  std::int64_t give_way(std::int64_t bytes);

 private:
  struct Kept {
    SharedGeometry geometry;
    std::vector<Digest> meshes{};  // the geometry's, each once
    std::size_t bytes = 0;         // without them
  };
  struct KeptMesh {
    SharedMesh index;
    std::size_t bytes = 0, users = 0;  // entries that have it
  };
  using Geometries = LruMap<Digest, Kept, DigestHash>;
  using MeshTable = std::unordered_map<Digest, KeptMesh, DigestHash>;
  class Meshes;  // those of one geometry that is being built

  SharedGeometry geometry_of(const KnownScene& scene, const Workers& workers);
  SharedGeometry build(const Scene& scene, const ObjectsDigest& digest, const Workers& workers);
  SharedGeometry find(const Digest& name);
  SharedMesh find_mesh(const Digest& name);
  void keep(const Digest& name, Kept made, MeshTable meshes);
  // Takes out what is too much.
  Geometries::Entries take_surplus(std::size_t most);
  void let_go(const Kept& geometry);

  const bool keeps_;
  MemoryShare share_;
  mutable std::mutex mutex_;
  Geometries geometries_;
  MeshTable meshes_;
  StoreCounts counts_;
};

}  // namespace tia::server
