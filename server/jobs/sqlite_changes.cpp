// The state machine of jobs in SQLite: what each change does to the rows.
#include <algorithm>
#include <array>

#include "core/input/json.h"
#include "server/http/error.h"
#include "server/jobs/job_json.h"
#include "server/jobs/job_problems.h"
#include "server/jobs/sqlite_jobs.h"
#include "server/jobs/sqlite_text.h"

namespace tia::server {
namespace {

// Which priorities come first: every eighth time the low ones.
std::array<Priority, 3> order_of_priorities(std::int64_t claim) {
  if (claim % 8 == 7) return {Priority::low, Priority::high, Priority::normal};
  return {Priority::high, Priority::normal, Priority::low};
}

constexpr TimeMs between_progress_ms = 250;

// What there is to do of a job: parts that nobody has begun, or that came back, or to put together
// what all have given.
constexpr const char* has_work =
    " (next < job.parts OR back > 0 OR (joins = 1 AND done = job.parts AND NOT EXISTS (SELECT 1 "
    "FROM parts WHERE parts.job = id AND n = job.parts AND parts.state = 1))) ";

}  // namespace

// ---- claiming -------------------------------------------------------------------------------

// Nobody else works while a suspect is at it, or it would lose a try of its own.
std::optional<Claim> SqliteJobs::claim(const std::string& worker, TimeMs now) {
  std::optional<Claim> claimed = change([&]() -> std::optional<Claim> {
    const auto of_suspects = [&](const char* state) {
      return number_of(*database_, std::string("SELECT count(*) FROM parts JOIN jobs ON id = job "
                                               "WHERE suspect = 1 AND open = 1 AND parts.state ") +
                                       state);
    };
    if (of_suspects("= 1") > 0) return std::nullopt;
    if (of_suspects("= 0") > 0) {
      if (number_of(*database_, "SELECT count(*) FROM parts WHERE state = 1") > 0)
        return std::nullopt;
      const auto found = suspect();
      return lease(*row(found->job), found->n, worker, now);
    }
    const auto id = next_job();
    if (!id) return std::nullopt;
    const Job job = *row(*id);
    return lease(job, next_part(job), worker, now);
  });
  if (claimed) changed(claimed->job);
  return claimed;
}

std::optional<Claim> SqliteJobs::suspect() {
  auto rows = with_values(*database_,
                          "SELECT job, n FROM parts JOIN jobs ON id = job WHERE suspect = 1 AND "
                          "open = 1 AND parts.state = 0 ORDER BY tries, job, n LIMIT 1");
  if (!rows.next()) return std::nullopt;
  return Claim{rows.text(), static_cast<int>(rows.number(1)), 0};
}

// The owner that has waited longest, then its job that has.
std::optional<std::string> SqliteJobs::next_job() {
  for (const Priority priority : order_of_priorities(claims_)) {
    auto rows = with_values(
        *database_,
        std::string("SELECT id FROM jobs AS job WHERE open = 1 AND priority = ? AND ") + has_work +
            "ORDER BY (SELECT max(turn) FROM jobs WHERE open = 1 AND owner = job.owner), turn, "
            "created, id LIMIT 1",
        std::int64_t{static_cast<int>(priority)});
    if (rows.next()) return rows.text();
  }
  return std::nullopt;
}

// What came back first; after the last part what they are put together by.
int SqliteJobs::next_part(const Job& job) {
  auto back = with_values(
      *database_, "SELECT n FROM parts WHERE job = ? AND state = 0 ORDER BY n LIMIT 1", job.id);
  if (back.next()) return static_cast<int>(back.number());
  return job.parts - job.waiting;
}

// The number after the last part is in no count of parts.
Claim SqliteJobs::lease(const Job& job, int n, const std::string& worker, TimeMs now) {
  run_with(*database_,
           "INSERT INTO parts (job, n, state, tries, worker) VALUES (?, ?, 1, 1, ?) ON CONFLICT "
           "(job, n) DO UPDATE SET state = 1, tries = tries + 1, worker = excluded.worker",
           job.id, std::int64_t{n}, worker);
  const std::int64_t tries = number_of(
      *database_, "SELECT tries FROM parts WHERE job = ? AND n = ?", job.id, std::int64_t{n});
  const std::int64_t next = number_of(*database_, "SELECT next FROM jobs WHERE id = ?", job.id);
  if (n < job.parts)
    run_with(*database_,
             n == next ? "UPDATE jobs SET next = next + 1, leased = leased + 1 WHERE id = ?"
                       : "UPDATE jobs SET back = back - 1, leased = leased + 1 WHERE id = ?",
             job.id);
  run_with(*database_, "UPDATE jobs SET turn = ? WHERE id = ?", ++claims_, job.id);
  if (job.state == JobState::queued) {
    run_with(*database_, "UPDATE jobs SET state = 1, started = ? WHERE id = ?", now, job.id);
    tell(job.id, "state", R"({"state":"running"})");
  }
  return {job.id, n, static_cast<int>(tries)};
}

bool SqliteJobs::is_leased(const Claim& claim) {
  return number_of(*database_,
                   "SELECT count(*) FROM parts JOIN jobs ON id = job WHERE job = ? AND n = ? AND "
                   "tries = ? AND parts.state = 1 AND open = 1",
                   claim.job, std::int64_t{claim.n}, std::int64_t{claim.attempt}) > 0;
}

bool SqliteJobs::heartbeat(const Claim& claim, TimeMs) {
  return change([&] { return is_leased(claim); });
}

// ---- what comes of it -----------------------------------------------------------------------

bool SqliteJobs::finish(const Claim& claim, const PartResult& result, TimeMs now) {
  const bool taken = change([&] {
    if (!is_leased(claim)) return false;
    make_room(static_cast<std::int64_t>(result.bytes.size()));
    const Job job = *row(claim.job);
    put(claim, result);
    if (claim.n < job.parts) count_done(job, claim, result, now);
    const Job after = *row(claim.job);
    if (after.joins ? claim.n == after.parts : after.done == after.parts)
      close(claim.job, JobState::done, now);
    return true;
  });
  if (taken) changed(claim.job);
  return taken;
}

void SqliteJobs::put(const Claim& claim, const PartResult& result) {
  Database::Statement insert(*database_,
                             "INSERT OR REPLACE INTO results (job, n, bytes) VALUES (?, ?, ?)");
  insert.bind(1, claim.job);
  insert.bind(2, claim.n);
  insert.bind_bytes(3, result.bytes);
  insert.next();
  const auto bytes = static_cast<std::int64_t>(result.bytes.size());
  hold(claim.job, bytes);
  run_with(*database_,
           "UPDATE parts SET state = 2, suspect = 0, etag = ?, place = ?, ms = ?, rays = ?, "
           "bytes = ?, type = ? WHERE job = ? AND n = ?",
           result.etag, result.place, result.ms, result.rays.all(), bytes, result.type, claim.job,
           std::int64_t{claim.n});
}

void SqliteJobs::count_done(const Job& job, const Claim& claim, const PartResult& result,
                            TimeMs now) {
  const RayCounts& rays = result.rays;
  run_with(*database_,
           "UPDATE jobs SET leased = leased - 1, done = done + 1, primary_rays = primary_rays + ?, "
           "shadow = shadow + ?, reflection = reflection + ?, refraction = refraction + ?, "
           "cut = cut + ? WHERE id = ?",
           rays.primary, rays.shadow, rays.reflection, rays.refraction, rays.cut, job.id);
  tell(job.id, "part",
       "{\"n\":" + std::to_string(claim.n) + ",\"state\":\"done\",\"etag\":" +
           to_json(result.etag) + (result.place.empty() ? "" : "," + result.place) + "}");
  tell_progress(job.id, now, job.done + 1 == job.parts);
}

void SqliteJobs::lose(const Claim& claim, Loss loss, TimeMs now) {
  const bool lost = change([&] {
    if (!is_leased(claim)) return false;
    const Job job = *row(claim.job);
    if (loss == Loss::given_back)
      run_with(*database_, "UPDATE parts SET tries = tries - 1 WHERE job = ? AND n = ?", job.id,
               std::int64_t{claim.n});
    lose_try(job, claim.n, false, now);
    return true;
  });
  if (lost) changed(claim.job);
}

void SqliteJobs::lose_try(const Job& job, int n, bool is_suspect, TimeMs now) {
  const bool is_part = n < job.parts;
  const std::int64_t tries = number_of(
      *database_, "SELECT tries FROM parts WHERE job = ? AND n = ?", job.id, std::int64_t{n});
  const bool is_dead = tries >= limits_.tries;
  run_with(*database_,
           "UPDATE parts SET state = ?, suspect = max(suspect, ?) WHERE job = ? AND n = ?",
           std::int64_t{static_cast<int>(is_dead ? PartState::dead : PartState::waiting)},
           std::int64_t{is_suspect && !is_dead}, job.id, std::int64_t{n});
  if (is_part)
    run_with(*database_,
             is_dead ? "UPDATE jobs SET leased = leased - 1, dead = dead + 1 WHERE id = ?"
                     : "UPDATE jobs SET leased = leased - 1, back = back + 1 WHERE id = ?",
             job.id);
  if (!is_dead) return;
  tell(job.id, "part", "{\"n\":" + std::to_string(n) + ",\"state\":\"dead\"}");
  fail_with(job.id, dead_part_problem(n, job.parts, limits_.tries), now);
}

void SqliteJobs::fail(const std::string& id, const std::string& problem, TimeMs now) {
  change([&] {
    if (const auto job = row(id); job && !is_last(job->state)) fail_with(id, problem, now);
  });
  changed(id);
}

void SqliteJobs::fail_with(const std::string& id, const std::string& problem, TimeMs now) {
  run_with(*database_, "UPDATE jobs SET problem = ? WHERE id = ?", problem, id);
  close(id, JobState::failed, now);
}

// What others are still at is not waited for. Of the results those stay that are asked for.
void SqliteJobs::close(const std::string& id, JobState state, TimeMs now) {
  run_with(*database_,
           "UPDATE parts SET state = 0, tries = tries - 1, suspect = 0 WHERE job = ? AND state = 1",
           id);
  const Job job = *row(id);
  run_with(*database_,
           "UPDATE jobs SET open = 0, state = ?, finished = ?, expires = ?, back = back + leased, "
           "leased = 0 WHERE id = ?",
           std::int64_t{static_cast<int>(state)}, now, now + limits_.keep_ms, id);
  const std::int64_t first = state != JobState::done ? 1 << 30 : job.joins ? job.parts : 0;
  hold(id, -number_of(*database_,
                      "SELECT coalesce(sum(length(bytes)), 0) FROM results WHERE job = ? AND n < ?",
                      id, first));
  run_with(*database_, "DELETE FROM results WHERE job = ? AND n < ?", id, first);
  run_with(*database_,
           "UPDATE jobs SET (etag, type, bytes) = (SELECT etag, type, bytes FROM parts WHERE job = "
           "id AND n = ?) WHERE id = ? AND state = 2",
           std::int64_t{job.result()}, id);
  tell(id, "state", "{\"state\":\"" + std::string(name_of(state)) + "\"}");
}

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
}

// What it was asked for stays known for a while, so that who asks for it learns that it is gone.
void SqliteJobs::let_go(const std::string& id) {
  for (const char* of : {"results", "parts"})
    run_with(*database_, std::string("DELETE FROM ") + of + " WHERE job = ?", id);
  hold(id, -number_of(*database_, "SELECT held FROM jobs WHERE id = ?", id) + 1024);
  run_with(*database_, "UPDATE jobs SET gone = 1, request = '', plan = '', key = '' WHERE id = ?",
           id);
}

void SqliteJobs::remove(const std::string& id) {
  hold(id, -number_of(*database_, "SELECT held FROM jobs WHERE id = ?", id));
  for (const char* of : {"results", "parts", "events"})
    run_with(*database_, std::string("DELETE FROM ") + of + " WHERE job = ?", id);
  run_with(*database_, "DELETE FROM jobs WHERE id = ?", id);
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
    for (const char* of : {"results", "parts"})
      run_with(*database_, std::string("DELETE FROM ") + of + " WHERE job = ?", job.id);
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
