#include "server/stores/geometry_store.h"

#include <algorithm>
#include <functional>
#include <memory>
#include <utility>

#include "server/operation/memory_costs.h"
#include "server/stores/scene_bytes.h"

namespace tia::server {
namespace {

// An entry's own, with its places in list and tables; a mesh's in its table.
constexpr std::size_t geometry_entry_bytes = 256, mesh_bytes = 128;

void claim_for(std::size_t object_bytes, const Workers& workers) {
  reserve_memory(memory_for(memory_cost::build, object_bytes), "what the objects compile to",
                 workers.stop());
}

}  // namespace

/// Meshes: finds the meshes of a geometry in the store, or makes them; each once.
class GeometryStore::Meshes {
 public:
  Meshes(GeometryStore& store, const ObjectsDigest& digest) : store_(store), digest_(digest) {}

  SharedMesh operator()(const Mesh& mesh, const Workers& workers) {
    const auto told = digest_.meshes.find(&mesh);
    const Digest name = told != digest_.meshes.end() ? told->second : digest_of(mesh);
    if (const auto known = met_.find(name); known != met_.end()) return known->second.index;
    SharedMesh index = store_.find_mesh(name);
    if (!index) index = indexed(mesh, workers);
    met_.emplace(name, KeptMesh{index, mesh_bytes + bytes_of(*index)});
    return index;
  }
  MeshTable& met() { return met_; }

 private:
  GeometryStore& store_;
  const ObjectsDigest& digest_;
  MeshTable met_;
};

World GeometryStore::compile(const KnownScene& scene, const Workers& workers) {
  World world;
  if (!keeps_) {
    claim_for(scene.objects.bytes + scene.models, workers);
    workers.alone([&] { world = tia::compile(*scene, workers); });
  } else {
    SharedGeometry geometry = geometry_of(scene, workers);
    workers.alone([&] { world = tia::compile(*scene, std::move(geometry), workers); });
  }
  return world;
}

// Memory is reserved between turns, so that nobody waits for it while others wait for his turn.
SharedGeometry GeometryStore::geometry_of(const KnownScene& scene, const Workers& workers) {
  SharedGeometry geometry = find(scene.objects.digest);
  if (geometry) return geometry;
  claim_for(scene.objects.bytes + scene.models, workers);
  // It is known by its name already; its meshes are asked for theirs one by one.
  workers.alone([&] { geometry = build(*scene, {scene.objects, {}}, workers); });
  return geometry;
}

SharedGeometry GeometryStore::build(const Scene& scene, const ObjectsDigest& digest,
                                    const Workers& workers) {
  Meshes meshes(*this, digest);
  const auto made =
      std::make_shared<const Geometry>(tia::geometry_of(scene, workers, std::ref(meshes)));
  keep(digest.all.digest, {made, {}, geometry_entry_bytes + bytes_of(*made)},
       std::move(meshes.met()));
  return made;
}

StoreCounts GeometryStore::counts() const {
  const std::lock_guard lock(mutex_);
  StoreCounts counts = counts_;
  counts.geometries = geometries_.size();
  counts.meshes = meshes_.size();
  return counts;
}

SharedGeometry GeometryStore::find(const Digest& name) {
  const std::lock_guard lock(mutex_);
  const Kept* const known = geometries_.find(name);
  ++(known == nullptr ? counts_.geometry_misses : counts_.geometry_hits);
  return known == nullptr ? nullptr : known->geometry;
}

SharedMesh GeometryStore::find_mesh(const Digest& name) {
  const std::lock_guard lock(mutex_);
  const auto known = meshes_.find(name);
  ++(known == meshes_.end() ? counts_.mesh_misses : counts_.mesh_hits);
  return known == meshes_.end() ? nullptr : known->second.index;
}

// One that does not fit alone would only drive out the others. Whatever may fail for want of memory
// comes before the first change.
void GeometryStore::keep(const Digest& name, Kept made, MeshTable meshes) {
  for (const auto& [own, mesh] : meshes) made.meshes.push_back(own);
  made.bytes += made.meshes.capacity() * sizeof(Digest);
  std::size_t alone = made.bytes;
  for (const auto& [own, mesh] : meshes) alone += mesh.bytes;

  Geometries::Entries surplus;
  const std::lock_guard lock(mutex_);
  if (alone > share_.most()) return;
  // Somebody may have built the same meanwhile, of which one is enough.
  const auto is_second = [this](const auto& mesh) {
    const auto known = meshes_.find(mesh.first);
    return known != meshes_.end() && known->second.index != mesh.second.index;
  };
  if (geometries_.contains(name) || std::ranges::any_of(meshes, is_second)) return;
  meshes_.reserve(meshes_.size() + meshes.size());
  geometries_.add(name, made);
  meshes_.merge(meshes);
  for (const Digest& own : made.meshes) {
    KeptMesh& mesh = meshes_.find(own)->second;
    if (mesh.users++ == 0) counts_.bytes += mesh.bytes;
  }
  counts_.bytes += made.bytes;
  surplus = take_surplus(share_.most());
  share_.book(counts_.bytes);
}

std::int64_t GeometryStore::give_way(std::int64_t bytes) {
  Geometries::Entries surplus;
  const std::lock_guard lock(mutex_);
  const std::size_t before = counts_.bytes, less = static_cast<std::size_t>(bytes);
  surplus = take_surplus(before > less ? before - less : 0);
  share_.book(counts_.bytes);
  return static_cast<std::int64_t>(before - counts_.bytes);
}

GeometryStore::Geometries::Entries GeometryStore::take_surplus(std::size_t most) {
  Geometries::Entries surplus;
  while (counts_.bytes > most) {
    let_go(geometries_.last());
    geometries_.take_last(surplus);
  }
  return surplus;
}

// The geometry keeps its meshes alive until the caller destroys it.
void GeometryStore::let_go(const Kept& geometry) {
  counts_.bytes -= geometry.bytes;
  for (const Digest& name : geometry.meshes) {
    const auto kept = meshes_.find(name);
    if (--kept->second.users > 0) continue;
    counts_.bytes -= kept->second.bytes;
    meshes_.erase(kept);
  }
}

}  // namespace tia::server
