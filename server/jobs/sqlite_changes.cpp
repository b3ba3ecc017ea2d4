// The state machine of jobs in SQLite: what each change does to the rows.
#include <array>

#include "core/input/json.h"
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

bool SqliteJobs::take(const Claim& claim, const PartResult& result, const std::string& told,
                      TimeMs now) {
  const bool taken = change([&] {
    if (!is_leased(claim)) return false;
    make_room(static_cast<std::int64_t>(result.bytes.size()));
    const Job job = *row(claim.job);
    put(claim, result, told);
    if (claim.n < job.parts) count_done(job, claim, result, now);
    const Job after = *row(claim.job);
    if (after.joins ? claim.n == after.parts : after.done == after.parts)
      close(claim.job, JobState::done, now);
    return true;
  });
  if (taken) changed(claim.job);
  return taken;
}

void SqliteJobs::put(const Claim& claim, const PartResult& result, const std::string& told) {
  Database::Statement insert(
      *database_, told.empty() ? "INSERT OR REPLACE INTO results (job, n, bytes) VALUES (?, ?, ?)"
                               : "INSERT OR REPLACE INTO outside (job, n, told) VALUES (?, ?, ?)");
  insert.bind(1, claim.job);
  insert.bind(2, claim.n);
  if (told.empty()) insert.bind_bytes(3, result.bytes);
  else insert.bind(3, told);
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
  const std::int64_t first = state != JobState::done ? beyond_parts : job.joins ? job.parts : 0;
  hold(id,
       -number_of(*database_, "SELECT coalesce(sum(bytes), 0) FROM parts WHERE job = ? AND n < ?",
                  id, first));
  drop_results(id, first);
  run_with(*database_,
           "UPDATE jobs SET (etag, type, bytes) = (SELECT etag, type, bytes FROM parts WHERE job = "
           "id AND n = ?) WHERE id = ? AND state = 2",
           std::int64_t{job.result()}, id);
  tell(id, "state", "{\"state\":\"" + std::string(name_of(state)) + "\"}");
}

}  // namespace tia::server
