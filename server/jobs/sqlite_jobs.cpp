#include "server/jobs/sqlite_jobs.h"

#include <algorithm>
#include <stdexcept>

#include "core/input/json.h"
#include "server/contract/problem.h"
#include "server/jobs/job_problems.h"
#include "server/jobs/sqlite_text.h"

namespace tia::server {
namespace {

constexpr int job_file_id = 0x5469614A;  // "TiaJ", in the file's header
constexpr int job_file_layout = 1;
constexpr int job_file_timeout_ms = 500;

// What a job takes besides its request and results.
constexpr std::int64_t own_bytes = 1024;

HttpError too_many(int most) {
  return {
      "busy",
      "as many jobs are unfinished as may be: " + std::to_string(most) + " (option TIA_MAX_JOBS)",
      {{"Retry-After", "10"}}};
}

}  // namespace

SqliteJobs::SqliteJobs(const std::string& path, const JobLimits& limits, TimeMs now,
                       std::shared_ptr<Blobs> outside)
    : limits_(limits), is_durable_(!path.empty()), outside_(std::move(outside)) {
  try {
    open(path.empty() ? ":memory:" : path);
    take_up(now);
  } catch (const DatabaseError& error) {
    if (error.kind == DatabaseError::busy)
      throw InUse(path + " is another process': jobs are kept in memory alone");
    throw std::runtime_error("option TIA_DATA_DIR: " + path + ": " + error.what());
  }
}

// The lock is this process' until its end: who opens the file of a server that runs is refused.
void SqliteJobs::open(const std::string& path) {
  database_.emplace(path, job_file_timeout_ms);
  const std::string of = database_->word("PRAGMA application_id");
  const bool is_new = database_->word("SELECT count(*) FROM sqlite_schema") == "0";
  if (!is_new && (of != std::to_string(job_file_id) ||
                  database_->word("PRAGMA user_version") != std::to_string(job_file_layout)))
    throw DatabaseError(DatabaseError::other,
                        "another program, or another version of Tia, has written this file");
  if (is_new) database_->run("PRAGMA auto_vacuum = INCREMENTAL");
  if (is_durable_) {
    database_->run("PRAGMA locking_mode = EXCLUSIVE");
    static_cast<void>(database_->word("PRAGMA journal_mode = WAL"));
    database_->run("PRAGMA synchronous = FULL");  // a commit is on the disk before it is told
    database_->run("PRAGMA journal_size_limit = 8388608");
  }
  database_->run("PRAGMA temp_store = MEMORY");
  Database::Transaction all(*database_);
  std::string_view left = job_tables;
  while (!left.empty()) {
    const std::string_view one = left.substr(0, left.find(';'));
    left.remove_prefix(std::min(left.size(), one.size() + 1));
    database_->run(std::string(one));
  }
  database_->run("PRAGMA application_id = " + std::to_string(job_file_id));
  database_->run("PRAGMA user_version = " + std::to_string(job_file_layout));
  all.commit();
}

// Who was at them is no more.
void SqliteJobs::take_up(TimeMs now) {
  Database::Transaction all(*database_);
  std::vector<std::pair<std::string, int>> lost;
  {
    auto rows = with_values(*database_, "SELECT job, n FROM parts WHERE state = 1");
    while (rows.next()) lost.emplace_back(rows.text(), static_cast<int>(rows.number(1)));
  }
  for (const auto& [id, n] : lost)
    if (const auto job = row(id); job && !is_last(job->state)) lose_try(*job, n, true, now);
  claims_ = number_of(*database_, "SELECT max(turn) FROM jobs");
  all.commit();
}

void SqliteJobs::refuse(const DatabaseError& error) {
  if (error.kind == DatabaseError::full)
    throw HttpError("storage-full",
                    "the file of jobs is full (option TIA_MAX_JOBS_BYTES), or the disk is");
  throw StorageError(std::string("the file of jobs: ") + error.what());
}

std::optional<Job> SqliteJobs::row(const std::string& id) {
  auto found =
      with_values(*database_, std::string("SELECT ") + job_columns + " FROM jobs WHERE id = ?", id);
  return found.next() ? std::optional(job_in(found)) : std::nullopt;
}

Job SqliteJobs::submit(const NewJob& job, TimeMs now) {
  Job kept = change([&] {
    if (!job.key.empty()) {
      auto known = with_values(
          *database_,
          std::string("SELECT ") + job_columns + " FROM jobs WHERE owner = ? AND key = ?",
          job.owner, job.key);
      if (known.next()) {
        Job same = job_in(known);
        if (same.digest == job.digest) return same;
        throw InputError({FaultKind::conflict, "", Value("another body under the same key"),
                          "under one Idempotency-Key the same body as before"});
      }
    }
    if (number_of(*database_, "SELECT count(*) FROM jobs WHERE open = 1") >= limits_.unfinished)
      throw too_many(limits_.unfinished);
    const auto bytes = static_cast<std::int64_t>(job.request.size() + job.plan.size()) + own_bytes;
    if (job.limits.unfinished || job.limits.bytes)
      if (const auto more = beyond_limits(job, sums(account_of(job)), bytes + job.result_bytes))
        throw AccessRefusal(*more);
    make_room(bytes + job.result_bytes);
    run_with(*database_,
             "INSERT INTO jobs (id, owner, key, digest, kind, name, priority, version, request, "
             "plan, parts, joins, max_rays, result_bytes, deadline, created, held) VALUES "
             "(?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?, ?)",
             job.id, job.owner, job.key, job.digest, job.kind, job.name,
             std::int64_t{static_cast<int>(job.priority)}, job.version, job.request, job.plan,
             std::int64_t{job.parts}, std::int64_t{job.joins}, job.max_rays, job.result_bytes,
             job.deadline, now, bytes);
    run_with(*database_, "UPDATE totals SET held = held + ?", bytes);
    tell(job.id, "state", R"({"state":"queued"})");
    return *row(job.id);
  });
  changed(kept.id);
  return kept;
}

std::optional<Job> SqliteJobs::find(const std::string& id) {
  return change([&] { return row(id); });
}

std::vector<std::string> SqliteJobs::ids(int first, int most) {
  return change([&] {
    std::vector<std::string> found;
    auto rows = with_values(*database_,
                            "SELECT id FROM jobs ORDER BY open DESC, CASE open WHEN 1 THEN created "
                            "ELSE finished END DESC, id DESC LIMIT ? OFFSET ?",
                            std::int64_t{most}, std::int64_t{first});
    while (rows.next()) found.push_back(rows.text());
    return found;
  });
}

OwnerSums SqliteJobs::sums_of(const NewJob& job) {
  return change([&] { return sums(account_of(job)); });
}

OwnerSums SqliteJobs::sums(const std::string& account) {
  auto found = with_values(*database_,
                           "SELECT coalesce(sum(open), 0), coalesce(sum(held), 0) FROM jobs WHERE "
                           "CASE WHEN owner LIKE 'key %' THEN owner ELSE 'anonymous' END = ?",
                           account);
  found.next();
  return {found.number(0), found.number(1)};
}

std::vector<PartRow> SqliteJobs::parts(const std::string& id, std::optional<PartState> state,
                                       int first, int most) {
  return change([&] {
    std::vector<PartRow> found;
    const auto job = row(id);
    if (!job || job->is_gone) return found;
    auto rows = with_values(*database_,
                            std::string("SELECT ") + part_columns +
                                " FROM parts WHERE job = ? AND n >= ? AND n < ? ORDER BY n",
                            id, std::int64_t{first}, std::int64_t{job->parts});
    // Those that nobody has begun stand between and behind the others.
    bool more = rows.next();
    for (int n = first; n < job->parts && static_cast<int>(found.size()) < most; ++n) {
      PartRow part{.n = n};
      if (more && rows.number() == n) {
        part = part_in(rows);
        more = rows.next();
      }
      if (!state || part.state == *state) found.push_back(std::move(part));
    }
    return found;
  });
}

std::optional<PartRow> SqliteJobs::part(const std::string& id, int n) {
  return change([&]() -> std::optional<PartRow> {
    auto found = with_values(
        *database_, std::string("SELECT ") + part_columns + " FROM parts WHERE job = ? AND n = ?",
        id, std::int64_t{n});
    return found.next() ? std::optional(part_in(found)) : std::nullopt;
  });
}

std::vector<Job> SqliteJobs::of_other_versions(const std::string& version) {
  return change([&] {
    std::vector<Job> jobs;
    auto rows = with_values(
        *database_,
        std::string("SELECT ") + job_columns + " FROM jobs WHERE open = 1 AND version <> ?",
        version);
    while (rows.next()) jobs.push_back(job_in(rows));
    return jobs;
  });
}

std::optional<std::string> SqliteJobs::result(const std::string& id, int n) {
  std::string told;
  auto kept = change([&]() -> std::optional<std::string> {
    auto found = with_values(*database_, "SELECT bytes FROM results WHERE job = ? AND n = ?", id,
                             std::int64_t{n});
    if (found.next()) return found.bytes();
    told = told_outside(id, n);
    return std::nullopt;
  });
  return told.empty() ? std::move(kept) : outside_result(id, n, told);
}

std::vector<JobEvent> SqliteJobs::events(const std::string& id, std::int64_t after, int most) {
  return change([&] {
    std::vector<JobEvent> events;
    auto rows = with_values(*database_,
                            "SELECT id, name, data FROM events WHERE job = ? AND id > ? "
                            "ORDER BY id LIMIT ?",
                            id, after, std::int64_t{most});
    while (rows.next()) events.push_back({rows.number(), rows.text(1), rows.text(2)});
    return events;
  });
}

JobLoad SqliteJobs::load(TimeMs now) {
  return change([&] {
    JobLoad load;
    auto sums = with_values(
        *database_,
        "SELECT coalesce(sum(parts - next + back), 0), coalesce(sum(leased), 0), count(*), "
        "coalesce(min(CASE WHEN parts - next + back > 0 THEN created END), 0) "
        "FROM jobs WHERE open = 1");
    sums.next();
    load.parts_waiting = sums.number(0);
    load.parts_leased = sums.number(1);
    load.jobs_unfinished = sums.number(2);
    if (sums.number(3) > 0)
      load.oldest_wait_s =
          static_cast<double>(std::max(now - sums.number(3), std::int64_t{0})) / 1000;
    auto states = with_values(*database_, "SELECT state, count(*) FROM jobs GROUP BY state");
    while (states.next()) load.jobs[static_cast<std::size_t>(states.number(0))] = states.number(1);
    load.bytes = bytes();
    return load;
  });
}

std::int64_t SqliteJobs::bytes() { return number_of(*database_, "SELECT held FROM totals"); }

}  // namespace tia::server
