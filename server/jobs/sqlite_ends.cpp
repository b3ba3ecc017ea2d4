// How jobs in SQLite end, make room for others, and what is told of them.
#include "core/input/json.h"
#include "server/http/error.h"
#include "server/jobs/job_json.h"
#include "server/jobs/job_problems.h"
#include "server/jobs/sqlite_jobs.h"
#include "server/jobs/sqlite_text.h"

namespace tia::server {
namespace {

constexpr TimeMs between_progress_ms = 250;

}  // namespace

// ---- ends -----------------------------------------------------------------------------------

Cancelled SqliteJobs::cancel(const std::string& id, TimeMs now) {
  const Cancelled done = change([&] {
    const auto job = row(id);
    if (!job) return Cancelled::unknown;
    if (is_last(job->state)) {
      remove(id);
      return Cancelled::removed;
    }
    close(id, JobState::cancelled, now);
    return Cancelled::now;
  });
  if (done != Cancelled::unknown) changed(id);
  return done;
}

void SqliteJobs::sweep(TimeMs now) {
  std::vector<std::string> ids;
  change([&] {
    const auto each = [&](const std::string& where, const auto& action) {
      std::vector<std::string> found;
      for (auto rows = with_values(*database_, "SELECT id FROM jobs WHERE " + where, now);
           rows.next();)
        found.push_back(rows.text());
      for (const std::string& id : found) action(id);
      ids.insert(ids.end(), found.begin(), found.end());
    };
    each("open = 1 AND deadline > 0 AND deadline <= ?", [&](const std::string& id) {
      fail_with(id, job_problem("timeout", "the job's deadline_s is over"), now);
    });
    each("open = 0 AND gone = 0 AND expires <= ?", [&](const std::string& id) { let_go(id); });
    each("open = 0 AND gone = 1 AND expires + " + std::to_string(limits_.keep_ms) + " <= ?",
         [&](const std::string& id) { remove(id); });
    if (!ids.empty()) database_->run("PRAGMA incremental_vacuum");
  });
  for (const std::string& id : ids) changed(id);
  if (outside_) sweep_dropped();
}

// What it was asked for stays known for a while, so that who asks for it learns that it is gone.
void SqliteJobs::let_go(const std::string& id) {
  drop_results(id, beyond_parts);
  run_with(*database_, "DELETE FROM parts WHERE job = ?", id);
  hold(id, -number_of(*database_, "SELECT held FROM jobs WHERE id = ?", id) + 1024);
  run_with(*database_, "UPDATE jobs SET gone = 1, request = '', plan = '', key = '' WHERE id = ?",
           id);
}

void SqliteJobs::remove(const std::string& id) {
  hold(id, -number_of(*database_, "SELECT held FROM jobs WHERE id = ?", id));
  drop_results(id, beyond_parts);
  for (const char* of : {"parts", "events"})
    run_with(*database_, std::string("DELETE FROM ") + of + " WHERE job = ?", id);
  run_with(*database_, "DELETE FROM jobs WHERE id = ?", id);
}

// Of what is outside, the rows alone: it is taken away once its job has ended.
void SqliteJobs::drop_results(const std::string& id, std::int64_t before) {
  run_with(*database_, "DELETE FROM results WHERE job = ? AND n < ?", id, before);
  run_with(*database_, "DELETE FROM outside WHERE job = ? AND n < ?", id, before);
  if (outside_ || database_->changes() > 0) leave_outside(id);
}

void SqliteJobs::hold(const std::string& id, std::int64_t more) {
  run_with(*database_, "UPDATE jobs SET held = held + ? WHERE id = ?", more, id);
  run_with(*database_, "UPDATE totals SET held = held + ?", more);
}

// What has been finished for longest goes first.
void SqliteJobs::make_room(std::int64_t more) {
  while (bytes() + more > limits_.bytes) {
    std::string oldest;
    {
      auto rows =
          with_values(*database_,
                      "SELECT id FROM jobs WHERE open = 0 AND gone = 0 ORDER BY expires, id "
                      "LIMIT 1");
      if (rows.next()) oldest = rows.text();
    }
    if (oldest.empty())
      throw HttpError("storage-full", "jobs hold " + std::to_string(bytes()) + " bytes of " +
                                          std::to_string(limits_.bytes) +
                                          " (option TIA_MAX_JOBS_BYTES)");
    let_go(oldest);
  }
}

void SqliteJobs::plan_anew(const Job& job, TimeMs now) {
  change([&] {
    drop_results(job.id, beyond_parts);
    run_with(*database_, "DELETE FROM parts WHERE job = ?", job.id);
    hold(job.id, static_cast<std::int64_t>(job.request.size() + job.plan.size()) + 1024 -
                     number_of(*database_, "SELECT held FROM jobs WHERE id = ?", job.id));
    run_with(*database_,
             "UPDATE jobs SET version = ?, request = ?, plan = ?, parts = ?, joins = ?, next = 0, "
             "back = 0, leased = 0, done = 0, dead = 0, primary_rays = 0, shadow = 0, "
             "reflection = 0, refraction = 0, cut = 0, state = 0, started = 0 WHERE id = ?",
             job.version, job.request, job.plan, std::int64_t{job.parts}, std::int64_t{job.joins},
             job.id);
    tell(job.id, "state", R"({"state":"queued"})");
    tell_progress(job.id, now, true);
  });
  changed(job.id);
}

// ---- telling --------------------------------------------------------------------------------

void SqliteJobs::tell(const std::string& id, const char* event, const std::string& data) {
  run_with(*database_, "UPDATE jobs SET events = events + 1 WHERE id = ?", id);
  run_with(
      *database_,
      "INSERT INTO events (job, id, name, data) SELECT id, events, ?, ? FROM jobs WHERE id = ?",
      std::string(event), data, id);
  run_with(*database_,
           "DELETE FROM events WHERE job = ?1 AND id <= (SELECT events FROM jobs WHERE id = ?1) - "
           "?2",
           id, JobLimits::most_events);
}

void SqliteJobs::tell_progress(const std::string& id, TimeMs now, bool is_last) {
  const std::int64_t told = number_of(*database_, "SELECT told FROM jobs WHERE id = ?", id);
  if (!is_last && now - told < between_progress_ms) return;
  run_with(*database_, "UPDATE jobs SET told = ? WHERE id = ?", now, id);
  tell(id, "progress", to_json(progress_of(*row(id), now)));
}

}  // namespace tia::server
