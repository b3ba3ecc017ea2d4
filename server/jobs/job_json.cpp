#include "server/jobs/job_json.h"

#include <algorithm>
#include <ctime>

#include "core/input/json.h"

namespace tia::server {
namespace {

// RFC 3339.
Value date_of(TimeMs time) {
  if (time == 0) return {};
  const std::time_t seconds = time / 1000;
  std::tm utc{};
  gmtime_r(&seconds, &utc);
  char date[40];
  std::strftime(date, sizeof date, "%Y-%m-%dT%H:%M:%SZ", &utc);
  return date;
}

// As long as the parts so far have taken, each.
Value remaining_s(const Job& job, TimeMs now) {
  if (job.state != JobState::running || job.done == 0) return {};
  const auto taken = static_cast<double>(std::max(now - job.started, TimeMs{0}));
  return taken * (job.parts - job.done) / job.done / 1000;
}

Value result_of(const Job& job) {
  if (job.state != JobState::done || job.is_gone) return {};
  const std::string href = "/jobs/" + job.id + "/result";
  if (job.kind != "render") return Value::Object{{"href", href}, {"type", "application/json"}};
  return Value::Object{{"href", href},
                       {"type", job.type},
                       {"bytes", static_cast<double>(job.bytes)},
                       {"etag", job.etag}};
}

}  // namespace

Value progress_of(const Job& job, TimeMs now) {
  return Value::Object{{"parts", job.parts},
                       {"done", job.done},
                       {"failed", job.dead},
                       {"rays", static_cast<double>(job.rays.all())},
                       {"remaining_s", remaining_s(job, now)}};
}

Value job_status(const Job& job, TimeMs now, bool is_durable) {
  Value problem;
  if (!job.problem.empty()) problem = parse_json(job.problem);
  return Value::Object{{"id", job.id},
                       {"kind", job.kind},
                       {"name", job.name},
                       {"state", name_of(job.state)},
                       {"priority", name_of(job.priority)},
                       {"version", job.version},
                       {"durable", is_durable},
                       {"created", date_of(job.created)},
                       {"started", date_of(job.started)},
                       {"finished", date_of(job.finished)},
                       {"expires", date_of(job.expires)},
                       {"progress", progress_of(job, now)},
                       {"result", result_of(job)},
                       {"problem", std::move(problem)}};
}

}  // namespace tia::server
