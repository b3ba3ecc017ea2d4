#include "server/stores/known_scene.h"

#include "server/stores/scene_bytes.h"

namespace tia::server {

KnownScene known(SharedScene scene) {
  const ObjectsName objects = digest_of_objects(*scene).all;
  const std::size_t others = bytes_besides_objects(*scene);
  return {std::move(scene), objects, others};
}

}  // namespace tia::server
