// Backend: all that stands behind the routes, made in one go: stores, threads, tickets, memory.
#pragma once

#include <memory>

#include "server/handlers/service.h"
#include "server/jobs/jobs.h"

namespace tia::server {

/// DataFiles: where what is kept outlives the process; null: it does not.
struct DataFiles {
  std::unique_ptr<SceneFile> scenes;
  std::unique_ptr<ModelFolder> models;
  std::unique_ptr<JobStore> jobs = nullptr;  ///< null: in memory
  std::unique_ptr<Quotas> quotas = std::make_unique<OwnQuotas>();
};

class Backend {
 public:
  /// The gallery outlives this. `reader`: the program that reads models, this one unless told.
  Backend(const Config& config, const Gallery& gallery, DataFiles files = {},
          const std::string& reader = "/proc/self/exe");

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
  ModelStore models;
  Access access;
  Jobs jobs;
  LiveStreams live;
  Service service;
};

}  // namespace tia::server
