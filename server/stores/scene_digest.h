// SHA-256 of parts of a scene, found by walking the fields that it is described by: no text is
// written for it.
#pragma once

#include <cstdint>
#include <cstring>
#include <unordered_map>

#include "core/scene/scene.h"
#include "server/stores/digest.h"

namespace tia::server {

/// For tables: a digest is its own hash.
struct DigestHash {
  std::size_t operator()(const Digest& digest) const {
    std::size_t hash = 0;
    std::memcpy(&hash, digest.data(), sizeof hash);
    return hash;
  }
};

/// ObjectsName: what tells the objects of one scene from those of all others.
struct ObjectsName {
  Digest digest{};
  std::size_t bytes = 0;  ///< that went into it: about what they hold in memory
};

/// Of all that geometry_of(scene) depends on: objects, materials and ambient light; and of each of
/// the scene's meshes, found on the way. Models count by their ids, which tell what they show.
struct ObjectsDigest {
  ObjectsName all;
  std::unordered_map<const Mesh*, Digest> meshes;
};
ObjectsDigest digest_of_objects(const Scene& scene);
/// The same of one mesh.
Digest digest_of(const Mesh& mesh);

}  // namespace tia::server
