// What jobs in SQLite keep in TIA_STORE: put before it is told, and taken away once nobody needs
// it.
#include <chrono>

#include "server/contract/problem.h"
#include "server/jobs/drawing.h"
#include "server/jobs/outside.h"
#include "server/jobs/sqlite_jobs.h"
#include "server/jobs/sqlite_text.h"
#include "server/operation/log.h"

namespace tia::server {

bool SqliteJobs::finish(const Claim& claim, const PartResult& result, TimeMs now) {
  if (!outside_) return take(claim, result, "", now);
  if (!heartbeat(claim, now)) return false;
  const std::string told = put_outside(*outside_, results_folder(claim.job), result.bytes);
  bool is_taken = false;
  try {
    is_taken = take(claim, result, told, now);
  } catch (...) {
    take_away(claim.job, told);
    throw;
  }
  if (!is_taken) take_away(claim.job, told);
  return is_taken;
}

// What cannot be removed now goes with its job.
void SqliteJobs::take_away(const std::string& id, const std::string& told) {
  if (!remove_outside(*outside_, told)) change([&] { leave_outside(id); });
}

// One that is damaged is no result: while its job goes on it is drawn again.
std::optional<std::string> SqliteJobs::outside_result(const std::string& id, int n,
                                                      const std::string& told) {
  if (outside_)
    if (auto bytes = find_outside(*outside_, told)) return bytes;
  const bool is_told = change([&] {
    if (told_outside(id, n) != told) return false;
    if (const Job job = *row(id); !is_last(job.state)) undo(job, n);
    return true;
  });
  if (!is_told) return std::nullopt;
  changed(id);
  throw damaged_result(id, n);
}

std::string SqliteJobs::told_outside(const std::string& id, int n) {
  auto found = with_values(*database_, "SELECT told FROM outside WHERE job = ? AND n = ?", id,
                           std::int64_t{n});
  return found.next() ? found.text() : "";
}

void SqliteJobs::undo(const Job& job, int n) {
  auto found = with_values(*database_, "SELECT place, bytes FROM parts WHERE job = ? AND n = ?",
                           job.id, std::int64_t{n});
  found.next();
  const RayCounts rays = rays_in(found.text()).value_or(RayCounts{});
  hold(job.id, -found.number(1));
  run_with(*database_, "DELETE FROM outside WHERE job = ? AND n = ?", job.id, std::int64_t{n});
  run_with(*database_, "UPDATE parts SET state = 0, bytes = 0 WHERE job = ? AND n = ?", job.id,
           std::int64_t{n});
  run_with(*database_,
           "UPDATE jobs SET done = done - 1, back = back + 1, primary_rays = primary_rays - ?, "
           "shadow = shadow - ?, reflection = reflection - ?, refraction = refraction - ?, "
           "cut = cut - ? WHERE id = ?",
           rays.primary, rays.shadow, rays.reflection, rays.refraction, rays.cut, job.id);
}

// By a count, so that none is forgotten that was left meanwhile.
void SqliteJobs::leave_outside(const std::string& id) {
  run_with(*database_,
           "INSERT INTO dropped (job, times) VALUES (?, 1) ON CONFLICT (job) DO UPDATE SET times = "
           "times + 1",
           id);
}

// Of jobs that have ended, of which nothing is about to be a result. Where whoever comes too late
// ends before it has taken its own away, the job is told of once more when it is let go.
void SqliteJobs::sweep_dropped() {
  struct Left {
    std::string id;
    std::int64_t times = 0;
    std::vector<std::string> needed = {};
  };
  constexpr std::chrono::milliseconds longest{500};  // at a time: others wait for this thread
  const auto until = std::chrono::steady_clock::now() + longest;
  const std::vector<Left> all = change([&] {
    std::vector<Left> found;
    for (auto rows = with_values(*database_,
                                 "SELECT job, times FROM dropped WHERE NOT EXISTS (SELECT 1 FROM "
                                 "jobs WHERE id = job AND open = 1) LIMIT 100");
         rows.next();)
      found.push_back({rows.text(), rows.number(1)});
    for (Left& each : found)
      for (auto rows = with_values(*database_, "SELECT told FROM outside WHERE job = ?", each.id);
           rows.next();)
        each.needed.push_back(rows.text());
    return found;
  });
  for (const Left& each : all) {
    if (!keep_alone(*outside_, results_folder(each.id), each.needed, until)) return;
    change([&] {
      run_with(*database_, "DELETE FROM dropped WHERE job = ? AND times = ?", each.id, each.times);
    });
  }
}

}  // namespace tia::server
