// What handlers share.
#pragma once

#include <atomic>
#include <functional>

#include "server/access/access.h"
#include "server/operation/admission.h"
#include "server/operation/config.h"
#include "server/operation/cost_memory.h"
#include "server/operation/live_streams.h"
#include "server/operation/memory_account.h"
#include "server/operation/metrics.h"
#include "server/requests/live_scenes.h"
#include "server/requests/render_context.h"
#include "server/stores/known_targets.h"
#include "server/stores/model_store.h"
#include "server/stores/picture_store.h"

namespace tia::server {

class Jobs;  // server/jobs/jobs.h

/// Service: what handlers share. Everything in it is const or safe to call from any thread.
struct Service {
  const Config& config;
  RenderContext rendering;
  MemoryAccount& memory;
  Admission& admission;
  CostMemory& costs;
  Metrics& metrics;
  PictureStore& pictures;
  ModelStore& models;
  Access& access;
  Jobs& jobs;
  LiveStreams& live;
  LiveScenes live_scenes{};
  KnownTargets targets{};
  std::function<int()> connections = [] { return 0; };  ///< that are open
  std::atomic<bool> draining = false;                   ///< the server goes down
};

}  // namespace tia::server
