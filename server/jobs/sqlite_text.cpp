#include "server/jobs/sqlite_text.h"

namespace tia::server {

// A part has a row from its first try on. `held`: bytes of the request and of results. `turn`: when
// a job had its last turn, in claims. Of a job that is open, that of its owner is the latest one.
// `told`: of a result in TIA_STORE, by which it is found. `dropped`: jobs that may have left some.
const char* const job_tables = R"sql(
CREATE TABLE IF NOT EXISTS jobs (id TEXT PRIMARY KEY NOT NULL, owner TEXT NOT NULL,
  key TEXT NOT NULL, digest TEXT NOT NULL, kind TEXT NOT NULL, name TEXT NOT NULL,
  priority INTEGER NOT NULL, version TEXT NOT NULL, request TEXT NOT NULL, plan TEXT NOT NULL,
  parts INTEGER NOT NULL, joins INTEGER NOT NULL, max_rays INTEGER NOT NULL,
  result_bytes INTEGER NOT NULL, deadline INTEGER NOT NULL, state INTEGER NOT NULL DEFAULT 0,
  created INTEGER NOT NULL, started INTEGER NOT NULL DEFAULT 0,
  finished INTEGER NOT NULL DEFAULT 0, expires INTEGER NOT NULL DEFAULT 0,
  next INTEGER NOT NULL DEFAULT 0, back INTEGER NOT NULL DEFAULT 0,
  leased INTEGER NOT NULL DEFAULT 0, done INTEGER NOT NULL DEFAULT 0,
  dead INTEGER NOT NULL DEFAULT 0, primary_rays INTEGER NOT NULL DEFAULT 0,
  shadow INTEGER NOT NULL DEFAULT 0, reflection INTEGER NOT NULL DEFAULT 0,
  refraction INTEGER NOT NULL DEFAULT 0, cut INTEGER NOT NULL DEFAULT 0,
  problem TEXT NOT NULL DEFAULT '', etag TEXT NOT NULL DEFAULT '',
  type TEXT NOT NULL DEFAULT '', bytes INTEGER NOT NULL DEFAULT 0,
  gone INTEGER NOT NULL DEFAULT 0, events INTEGER NOT NULL DEFAULT 0,
  told INTEGER NOT NULL DEFAULT 0, held INTEGER NOT NULL DEFAULT 0,
  turn INTEGER NOT NULL DEFAULT 0, open INTEGER NOT NULL DEFAULT 1);
CREATE UNIQUE INDEX IF NOT EXISTS jobs_by_key ON jobs (owner, key) WHERE key <> '';
CREATE INDEX IF NOT EXISTS jobs_by_turn ON jobs (open, owner, turn);
CREATE INDEX IF NOT EXISTS jobs_by_end ON jobs (open, gone, expires);
CREATE INDEX IF NOT EXISTS jobs_by_state ON jobs (state);
CREATE TABLE IF NOT EXISTS parts (job TEXT NOT NULL, n INTEGER NOT NULL, state INTEGER NOT NULL,
  tries INTEGER NOT NULL, suspect INTEGER NOT NULL DEFAULT 0, worker TEXT NOT NULL DEFAULT '',
  etag TEXT NOT NULL DEFAULT '', place TEXT NOT NULL DEFAULT '', ms INTEGER NOT NULL DEFAULT 0,
  rays INTEGER NOT NULL DEFAULT 0, bytes INTEGER NOT NULL DEFAULT 0, type TEXT NOT NULL DEFAULT '',
  PRIMARY KEY (job, n)) WITHOUT ROWID;
CREATE INDEX IF NOT EXISTS parts_back ON parts (job, n) WHERE state = 0;
CREATE INDEX IF NOT EXISTS parts_leased ON parts (job, n) WHERE state = 1;
CREATE INDEX IF NOT EXISTS parts_suspect ON parts (job, n) WHERE suspect = 1;
CREATE TABLE IF NOT EXISTS results (job TEXT NOT NULL, n INTEGER NOT NULL, bytes BLOB NOT NULL,
  PRIMARY KEY (job, n));
CREATE TABLE IF NOT EXISTS outside (job TEXT NOT NULL, n INTEGER NOT NULL, told TEXT NOT NULL,
  PRIMARY KEY (job, n)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS dropped (job TEXT PRIMARY KEY NOT NULL, times INTEGER NOT NULL)
  WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS events (job TEXT NOT NULL, id INTEGER NOT NULL, name TEXT NOT NULL,
  data TEXT NOT NULL, PRIMARY KEY (job, id)) WITHOUT ROWID;
CREATE TABLE IF NOT EXISTS totals (held INTEGER NOT NULL);
INSERT INTO totals SELECT 0 WHERE NOT EXISTS (SELECT 1 FROM totals)
)sql";

const char* const job_columns =
    "id, owner, key, digest, kind, name, priority, version, request, plan, parts, joins, max_rays, "
    "result_bytes, deadline, state, created, started, finished, expires, "
    "parts - next + back, leased, done, dead, primary_rays, shadow, reflection, refraction, cut, "
    "problem, etag, type, bytes, gone, events";

Job job_in(const Database::Statement& row) {
  int column = 0;
  const auto text = [&] { return row.text(column++); };
  const auto number = [&] { return row.number(column++); };
  const auto count = [&] { return static_cast<int>(number()); };
  Job job;
  for (std::string* each : {&job.id, &job.owner, &job.key, &job.digest, &job.kind, &job.name})
    *each = text();
  job.priority = static_cast<Priority>(count());
  for (std::string* each : {&job.version, &job.request, &job.plan}) *each = text();
  job.parts = count();
  job.joins = number() != 0;
  for (std::int64_t* each : {&job.max_rays, &job.result_bytes, &job.deadline}) *each = number();
  job.state = static_cast<JobState>(count());
  for (TimeMs* each : {&job.created, &job.started, &job.finished, &job.expires}) *each = number();
  for (int* each : {&job.waiting, &job.leased, &job.done, &job.dead}) *each = count();
  RayCounts& rays = job.rays;
  for (std::int64_t* each :
       {&rays.primary, &rays.shadow, &rays.reflection, &rays.refraction, &rays.cut})
    *each = number();
  for (std::string* each : {&job.problem, &job.etag, &job.type}) *each = text();
  job.bytes = number();
  job.is_gone = number() != 0;
  job.events = number();
  return job;
}

const char* const part_columns = "n, state, tries, worker, etag, place, ms, rays, bytes, type";

PartRow part_in(const Database::Statement& row) {
  return {static_cast<int>(row.number(0)),
          static_cast<PartState>(row.number(1)),
          static_cast<int>(row.number(2)),
          row.text(3),
          row.text(4),
          row.text(5),
          row.number(6),
          row.number(7),
          row.number(8),
          row.text(9)};
}

}  // namespace tia::server
