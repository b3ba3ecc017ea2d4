// SHA-256 of a scene's objects by that of their parts, of which few have to be found again where
// few objects move. They are found by walking the fields that objects are described by.
#pragma once

#include <cstddef>
#include <unordered_map>
#include <vector>

#include "core/scene/scene.h"
#include "server/stores/digest.h"

namespace tia::server {

/// Digested: a digest, and the bytes that went into it.
struct Digested {
  Digest digest{};
  std::size_t bytes = 0;
};

using MeshDigests = std::unordered_map<const Mesh*, Digest>;

/// ObjectsParts: the digests of so many objects in a row each, and of the meshes that were found on
/// the way when all were digested.
struct ObjectsParts {
  static constexpr std::size_t objects_each = 256;
  std::vector<Digested> digests{};
  MeshDigests meshes{};
};

/// Of a scene's objects, by their parts, its materials and its ambient light. `parts` are those of
/// a scene that differs in the moved objects alone, which have ascending numbers, and become this
/// scene's; none yet: all are found.
/// Cost: that of the parts in which objects have moved.
Digested digest_by_parts(const Scene& scene, const std::vector<std::size_t>& moved,
                         ObjectsParts& parts);
Digest digest_of_mesh(const Mesh& mesh);

}  // namespace tia::server
