// Backend: all that stands behind the routes, made in one go: stores, threads, tickets, memory.
#pragma once

#include <memory>

#include "server/handlers/service.h"

namespace tia::server {

class Backend {
 public:
  /// `file`: where kept scenes outlive the process; null: they do not. The gallery outlives this.
  Backend(const Config& config, const Gallery& gallery, std::unique_ptr<SceneFile> file = nullptr);

  Config config;
  MemoryAccount memory;
  SceneStore kept;
  Admission admission;
  Pool pool;
  LongWork long_work{admission, pool};
  CostMemory costs;
  GeometryStore geometries;
  PressedScenes pressed;
  Metrics metrics;
  PictureStore pictures;
  Service service;
};

}  // namespace tia::server
