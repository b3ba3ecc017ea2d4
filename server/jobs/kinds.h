// THE LIST of kinds of jobs. Each has a file of its own, which plans the parts of a request and
// puts their results together; nothing else knows one by its name.
#pragma once

#include <functional>
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "server/jobs/job_request.h"
#include "server/operation/cost_memory.h"
#include "server/requests/draw.h"
#include "server/requests/picture_request.h"

namespace tia::server {

/// JobHost: what planning and drawing need.
struct JobHost {
  RenderContext context;  ///< its limits are a job's
  CostMemory& costs;
  int window_px = 0;  ///< the side of windows; 0: as large as about a second's work
};

/// JobPlan: what a kind makes of a request, all of whose faults it has found.
struct JobPlan {
  int parts = 1;
  bool joins = false;
  std::string request, plan = {};  ///< as the job keeps them: what opens it again
  double rays = 0;                 ///< that the eye sends out in any case
  std::int64_t result_bytes = 0;   ///< that results have at least
};

/// JobParts: the parts of a job that has been opened; they may be asked for by several threads.
class JobParts {
 public:
  JobParts() = default;
  JobParts(const JobParts&) = delete;
  JobParts& operator=(const JobParts&) = delete;
  virtual ~JobParts() = default;

  /// What a part is the picture of. It lives as long as this.
  virtual PictureRequest part(int n) const = 0;
  /// Whether a part's result is codes or floats, to be put together, and no file.
  virtual bool are_pieces() const { return false; }
  /// Where it is in the whole, as a member of JSON: "window":[x0,y0,x1,y1], "frame":n.
  virtual std::string place(int n) const = 0;
  /// The picture that pieces are. Domain: a kind whose plan joins. Errors: as draw().
  using Piece = std::function<std::string(int n)>;
  virtual Picture join(const Plan& whole, const Piece& piece, const Workers& workers) const;
  virtual PictureRequest whole() const;
};

/// JobKind: a row of the list.
struct JobKind {
  std::string_view name;
  /// Errors: InputError, pointers into the job; as plan_of.
  JobPlan (*plan)(const JobRequest& asked, const JobHost& host, const Requester& requester);
  /// The parts of a job that was planned so. Errors: as plan.
  std::unique_ptr<JobParts> (*open)(const Job& job, const JobHost& host,
                                    const Requester& requester);
};

std::span<const JobKind> job_kinds();
/// The kind of that name. Errors: InputError (unknown_name) at /kind.
const JobKind& job_kind(const std::string& name);
/// A job as it was asked for, to be planned anew.
JobRequest asked_again(const Job& job);

// The kinds, in their files.
extern const JobKind render_job, batch_job, turntable_job;

/// The request of one picture at a place of the job. Errors: InputError: also for a budget, which
/// would make of it what nobody can name beforehand.
PictureRequest picture_at(const Value& request, const std::string& place, const JobHost& host,
                          const Requester& requester);

}  // namespace tia::server
