// A scene with what takes longer to find out than to draw many a picture.
#pragma once

#include <cstddef>
#include <memory>
#include <utility>

#include "core/scene/scene.h"
#include "server/stores/scene_digest.h"

namespace tia::server {

/// SharedScene: one that is being drawn outlives its place in a store.
using SharedScene = std::shared_ptr<const Scene>;

struct KnownScene {
  KnownScene() = default;
  KnownScene(SharedScene of, const ObjectsName& name, std::size_t bytes_of_others,
             std::size_t bytes_of_models = 0)
      : scene(std::move(of)), objects(name), others(bytes_of_others), models(bytes_of_models) {}

  SharedScene scene;
  ObjectsName objects{};   ///< digest_of_objects(scene).all
  std::size_t others = 0;  ///< bytes that all but its objects holds: lights, keys, materials, text
  std::size_t models = 0;  ///< bytes of the models that its objects show

  explicit operator bool() const { return scene != nullptr; }
  const Scene& operator*() const { return *scene; }
  const Scene* operator->() const { return scene.get(); }
};

/// Goes through the whole scene.
KnownScene known(SharedScene scene);

}  // namespace tia::server
