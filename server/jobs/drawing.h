// One part of a job, drawn.
#pragma once

#include <memory>
#include <stop_token>

#include "server/access/access.h"
#include "server/jobs/kinds.h"
#include "server/jobs/store.h"
#include "server/operation/metrics.h"
#include "server/stores/picture_store.h"

namespace tia::server {

/// Workplace: where parts are drawn.
struct Workplace {
  const JobHost& host;
  Access& access;
  JobStore& store;
  PictureStore& pictures;
  Metrics& metrics;
  MemoryAccount& memory;
};

/// By whom threads and memory that all jobs together take are shared.
constexpr const char* jobs_share = "jobs";

/// The result of a part, or of all put together; a picture is kept for /render, too, and not drawn
/// if that has it. Errors: InputError, a fault of what is asked for; Stopped; HttpError (busy,
/// too-large); whatever else it is, it may go well another time.
PartResult draw_part(const Job& job, const JobParts& parts, int n, const Workplace& at,
                     const std::stop_token& stop);

/// "reached":[…] of a part or a result whose samples are counted; "" of others.
std::string reached_text(const Picture& picture);
/// "counted":[…] of its rays of each kind.
std::string counted_text(const RayCounts& rays);
/// What such members of JSON tell, or none.
std::optional<RayCounts> rays_in(const std::string& place);
std::optional<Reached> reached_in(const std::string& place);

}  // namespace tia::server
