#include "server/jobs/jobs.h"

#include <algorithm>
#include <stdexcept>

#include "server/contract/problem.h"
#include "server/jobs/farm.h"
#include "server/jobs/sqlite_jobs.h"
#include "server/operation/log.h"

namespace tia::server {
namespace {

// Of a job, not of a request: as many rays, and as many tests for each of them.
RenderContext with_limits_of_jobs(const RenderContext& context, const Config& config) {
  RenderContext own = context;
  const double more =
      static_cast<double>(config.max_job_rays) / static_cast<double>(config.max_rays);
  own.limits.max_rays = config.max_job_rays;
  own.limits.max_work = static_cast<std::int64_t>(
      std::min(9e18, static_cast<double>(config.max_work) * std::max(more, 1.0)));
  return own;
}

bool has_jobs(JobStore& store) try {
  const JobLoad load = store.load(Runner::now());
  return std::any_of(load.jobs.begin(), load.jobs.end(), [](auto jobs) { return jobs > 0; });
} catch (const StorageError& error) {
  throw std::runtime_error(std::string("option TIA_DATA_DIR: ") + error.what());
}

}  // namespace

Jobs::Jobs(std::unique_ptr<JobStore> store, const Config& config, const RenderContext& context,
           CostMemory& costs, PictureStore& pictures, Access& access, Metrics& metrics,
           MemoryAccount& memory)
    : store_(std::move(store)),
      host_{with_limits_of_jobs(context, config), costs},
      memory_(memory),
      at_once_(std::max(1, config.renders / 2)),
      board_(std::max(1, config.connections / 2)),
      workplace_{host_, access, *store_, pictures, metrics, memory} {
  if (store_->is_shared()) host_.context.elsewhere = &elsewhere_;
  store_->changed = [this](const std::string& id) { has_changed(id); };
  store_->listen();
  if (!config.farm.empty()) {  // whose jobs may come from anybody
    start();
    return;
  }
  if (has_jobs(*store_)) start();  // to go on with them, and to forget them in time
}

Jobs::~Jobs() {
  store_->hush();
  if (runner_) runner_->stop();  // which has changes told
}

void Jobs::start() {
  const std::lock_guard lock(mutex_);
  if (!runner_) runner_ = std::make_unique<Runner>(workplace_, at_once_);
}

void Jobs::has_changed(const std::string& id) {
  board_.has_changed(id);
  const std::lock_guard lock(mutex_);
  if (runner_) runner_->look_again(id);
  if (store_->is_durable()) return;
  const std::int64_t bytes = store_->load(0).bytes;
  memory_.add(MemoryAccount::jobs, bytes - booked_);
  booked_ = bytes;
}

JobLimits job_limits(const Config& config, bool is_durable) {
  JobLimits limits;
  limits.tries = config.job_tries;
  limits.unfinished = config.max_jobs;
  limits.bytes =
      is_durable ? config.max_jobs_bytes : std::min(config.max_jobs_bytes, config.memory_bytes / 8);
  limits.keep_ms = config.job_keep_s * 1000;
  return limits;
}

std::unique_ptr<JobStore> job_store_in_memory(const Config& config) {
  return std::make_unique<SqliteJobs>("", job_limits(config, false), Runner::now());
}

std::unique_ptr<JobStore> job_store(const Config& config) {
  if (!config.farm.empty())
    return farm_jobs(config, job_limits(config, true), FarmRole::joins, own_worker_name());
  if (config.data_dir.empty()) {
    if (!config.store.empty())
      throw std::invalid_argument(
          "option TIA_STORE: needed: TIA_FARM or TIA_DATA_DIR, whose jobs' results it keeps");
    return job_store_in_memory(config);
  }
  try {
    return std::make_unique<SqliteJobs>(config.data_dir + "/" + SqliteJobs::name,
                                        job_limits(config, true), Runner::now(),
                                        result_store(config));
  } catch (const SqliteJobs::InUse& error) {
    log_failure("jobs", error.what());
    return job_store_in_memory(config);
  }
}

}  // namespace tia::server
