#include "server/jobs/runner.h"

#include <algorithm>
#include <chrono>

#include "core/version.h"
#include "server/contract/problem.h"
#include "server/jobs/job_problems.h"
#include "server/operation/log.h"
#include "server/operation/memory_costs.h"

namespace tia::server {
namespace {

constexpr std::size_t most_opened = 2;
constexpr TimeMs between_sweeps_ms = 1000;
constexpr std::chrono::milliseconds idle_wait{1000};

// What a request would be answered that failed with that.
std::string problem_document(const std::exception_ptr& failure, const std::string& id) {
  Request request;
  request.id = id;
  try {
    std::rethrow_exception(failure);
  } catch (const InputError& error) {
    return problem_response(std::make_exception_ptr(by_options_of_jobs(error)), request).body;
  } catch (...) {
    return problem_response(failure, request).body;
  }
}

}  // namespace

TimeMs Runner::now() {
  using namespace std::chrono;
  return duration_cast<milliseconds>(system_clock::now().time_since_epoch()).count();
}

Runner::Runner(const Workplace& at, int at_once) : at_(at) {
  for (int i = 0; i < at_once; ++i)
    threads_.emplace_back([this](const std::stop_token& ending) { work(ending); });
}

Runner::~Runner() { stop(); }

void Runner::stop() {
  for (std::jthread& thread : threads_) thread.request_stop();
  {
    const std::lock_guard lock(mutex_);
    for (Running& each : running_) each.stop.request_stop();
  }
  threads_.clear();
}

void Runner::look_again(const std::string& id) {
  const std::lock_guard lock(mutex_);
  ++told_;
  news_.notify_all();
  for (Running& each : running_)
    if (each.claim.job == id && !at_.store.heartbeat(each.claim, now())) each.stop.request_stop();
}

// Whatever cannot be had now, a disk or memory, may be there in a second.
void Runner::work(const std::stop_token& ending) {
  while (!ending.stop_requested()) try {
      if (!work_once(ending)) wait(ending);
    } catch (const std::exception& error) {
      log_failure("jobs", error.what());
      std::unique_lock lock(mutex_);
      news_.wait_for(lock, ending, idle_wait, [] { return false; });
    }
}

bool Runner::work_once(const std::stop_token& ending) {
  keep_order();
  const auto claim = at_.store.claim("embedded", now());
  if (!claim) return false;
  draw(*claim, ending);
  return true;
}

void Runner::wait(const std::stop_token& ending) {
  std::unique_lock lock(mutex_);
  const std::uint64_t told = told_;
  news_.wait_for(lock, ending, idle_wait, [&] { return told_ != told; });
}

void Runner::keep_order() {
  {
    const std::lock_guard lock(mutex_);
    if (now() - swept_ < between_sweeps_ms) return;
    swept_ = now();
  }
  plan_anew();
  for (const Charge& each : at_.store.take_charges()) at_.access.charge(each.key, each.rays);
  at_.store.sweep(now());
}

// What an older program has planned: no picture mixes versions.
void Runner::plan_anew() {
  for (Job& job : at_.store.of_other_versions(full_version())) try {
      const JobPlan plan = job_kind(job.kind).plan(asked_again(job), at_.host, {jobs_share, {}});
      job.version = full_version();
      job.request = plan.request, job.plan = plan.plan;
      job.parts = plan.parts, job.joins = plan.joins;
      at_.store.plan_anew(job, now());
    } catch (const InputError&) {
      at_.store.fail(job.id, problem_document(std::current_exception(), job.id), now());
    }
}

void Runner::draw(const Claim& claim, const std::stop_token& ending) {
  std::list<Running>::iterator running;
  {
    const std::lock_guard lock(mutex_);
    running = running_.insert(running_.end(), Running{claim, {}});
    if (ending.stop_requested()) running->stop.request_stop();
  }
  draw_claimed(claim, running->stop.get_token());
  const std::lock_guard lock(mutex_);
  running_.erase(running);
}

void Runner::draw_claimed(const Claim& claim, const std::stop_token& stop) {
  try {
    const auto job = at_.store.find(claim.job);
    if (!job) return;
    MemoryClaim memory(at_.memory, jobs_share);
    const ClaimScope scope(&memory);
    reserve_memory(memory_for(memory_cost::text, job->request.size()), "what the job says", stop);
    const auto parts = parts_of(*job);
    const PartResult result = draw_part(*job, *parts, claim.n, at_, stop);
    check_kept(*job, result.bytes.size());
    const bool is_taken = at_.store.finish(claim, result, now());
    const char* const came = claim.n < job->parts ? "done" : "joined";
    at_.metrics.count_part(is_taken ? came : "late", static_cast<double>(result.ms) / 1000);
  } catch (...) {
    give_up(claim, std::current_exception());
  }
}

// How much results are is known only now; of those that are put together it is foreseen.
// Errors: AccessRefusal (quota).
void Runner::check_kept(Job job, std::size_t bytes) const {
  const auto entry = at_.access.entry_called(key_of(job));
  if (job.joins || !entry || !entry->kept_bytes) return;
  job.limits.bytes = entry->kept_bytes;
  const OwnerSums sums = at_.store.sums_of(job);
  if (const auto more = beyond_limits(job, sums, static_cast<std::int64_t>(bytes)))
    throw AccessRefusal(*more);
}

// A fault of what is asked for comes again whoever draws; all else may go well another time.
void Runner::give_up(const Claim& claim, const std::exception_ptr& failure) {
  const auto pause = [&] {
    std::unique_lock lock(mutex_);
    news_.wait_for(lock, idle_wait / 10, [] { return false; });
  };
  try {
    std::rethrow_exception(failure);
  } catch (const Stopped&) {
    at_.store.lose(claim, Loss::given_back, now());
    at_.metrics.count_part("given_back", 0);
  } catch (const InputError&) {
    at_.store.fail(claim.job, problem_document(failure, claim.job), now());
    at_.metrics.count_part("fault", 0);
  } catch (const HttpError& error) {
    const bool is_fault = error.type() == "too-large" || error.type() == "quota";
    if (is_fault) at_.store.fail(claim.job, problem_document(failure, claim.job), now());
    else at_.store.lose(claim, error.type() == "busy" ? Loss::given_back : Loss::failed, now());
    at_.metrics.count_part(is_fault ? "fault" : "lost", 0);
    pause();
  } catch (const StorageAway& error) {  // which is nobody's fault who draws
    log_failure(claim.job, error.what());
    at_.store.lose(claim, Loss::given_back, now());
    at_.metrics.count_part("lost", 0);
    pause();
  } catch (const std::exception& error) {
    log_failure(claim.job, error.what());
    at_.store.lose(claim, Loss::failed, now());
    at_.metrics.count_part("lost", 0);
    pause();
  }
}

std::shared_ptr<const JobParts> Runner::parts_of(const Job& job) {
  {
    const std::lock_guard lock(mutex_);
    for (const Opened& each : opened_)
      if (each.id == job.id && each.version == job.version) return each.parts;
  }
  const std::shared_ptr<const JobParts> parts =
      job_kind(job.kind).open(job, at_.host, {jobs_share, {}});
  const std::lock_guard lock(mutex_);
  opened_.push_front({job.id, job.version, parts});
  if (opened_.size() > most_opened) opened_.pop_back();
  return parts;
}

}  // namespace tia::server
