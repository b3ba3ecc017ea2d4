#include "server/stores/scene_digest.h"

#include <utility>

#include "server/stores/objects_parts.h"

namespace tia::server {

Digest digest_of(const Mesh& mesh) { return digest_of_mesh(mesh); }

ObjectsDigest digest_of_objects(const Scene& scene) {
  ObjectsParts parts;
  const auto [digest, bytes] = digest_by_parts(scene, {}, parts);
  return {{digest, bytes}, std::move(parts.meshes)};
}

}  // namespace tia::server
