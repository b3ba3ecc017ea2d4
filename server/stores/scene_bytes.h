// How much memory a scene holds, counted by walking the fields that it is described by.
#pragma once

#include <cstddef>

#include "core/scene/scene.h"

namespace tia::server {

/// Space/units: bytes, the scene's own and all that it owns on the heap.
std::size_t bytes_of(const Scene& scene);
/// The same without its objects.
std::size_t bytes_besides_objects(const Scene& scene);

}  // namespace tia::server
