// What a farm keeps outside of its jobs' hashes: results in the store, and what clients have sent;
// and what is put right every few seconds.
#include <chrono>

#include "server/contract/problem.h"
#include "server/jobs/outside.h"
#include "server/jobs/redis_jobs.h"
#include "server/operation/log.h"

namespace tia::server {
namespace {

using OutsideClock = std::chrono::steady_clock;

constexpr TimeMs between_mends_ms = 10'000;
constexpr std::chrono::milliseconds longest_sweep{500};  // at a time: others wait for this thread

}  // namespace

// One that is damaged is no result: while its job goes on it is drawn again.
std::optional<std::string> RedisJobs::outside_result(const std::string& id, int n) {
  const std::string number = std::to_string(n);
  const RedisReply told = redis_.call({"HGET", key(id) + ":outside", number});
  if (told.kind != RedisReply::text) return std::nullopt;
  if (auto bytes = find_outside(*outside_, told.words)) return bytes;
  constexpr int has_changed = 2;
  if (run(scripts_.redo, 0, {id, number, told.words}).count == has_changed) return std::nullopt;
  throw damaged_result(id, n);
}

// Told of jobs that have ended, of which nothing is about to be a result. Where whoever comes too
// late ends before it has taken its own away, the job is told of once more when it is let go.
void RedisJobs::sweep_dropped() {
  const auto until = OutsideClock::now() + longest_sweep;
  const std::string dropped = std::string(prefix) + "dropped";
  const auto jobs = redis_.call({"ZRANGE", dropped, "0", "99", "WITHSCORES"}).items;
  for (std::size_t i = 0; i + 1 < jobs.size(); i += 2) {
    const std::string& id = jobs[i].words;
    std::vector<std::string> needed;
    for (RedisReply& told : redis_.call({"HVALS", key(id) + ":outside"}).items)
      needed.push_back(std::move(told.words));
    if (!keep_alone(*outside_, results_folder(id), needed, until)) return;
    scripts_.swept.run(redis_, prefix, {id, jobs[i + 1].words});
  }
}

void RedisJobs::lend(const std::string& name, const std::function<std::string()>& bytes,
                     TimeMs now) {
  if (!run(scripts_.lend, now, {name, "", "0"}).words.empty()) return;
  const std::string own = bytes();
  const std::string told = put_outside(*outside_, name + '/', own);
  const std::string kept = run(scripts_.lend, now, {name, told, std::to_string(own.size())}).words;
  if (kept != told) remove_outside(*outside_, told);
  if (kept == "full")
    throw HttpError("storage-full",
                    "jobs hold as much as they may: " + std::to_string(options_.limits.bytes) +
                        " bytes (option TIA_MAX_JOBS_BYTES)");
}

std::optional<std::string> RedisJobs::lent(const std::string& name) {
  const RedisReply told = redis_.call({"HGET", std::string(prefix) + "lent", name});
  if (told.kind != RedisReply::text) return std::nullopt;
  auto bytes = find_outside(*outside_, told.words);
  if (!bytes) throw StorageError(name + " is gone or damaged where a farm keeps what it needs");
  return bytes;
}

std::vector<Charge> RedisJobs::take_charges() {
  std::vector<Charge> charges;
  if (options_.role == FarmRole::draws) return charges;
  const RedisReply found = scripts_.charges.run(redis_, prefix, {});
  for (std::size_t i = 0; i + 1 < found.items.size(); i += 2)
    charges.push_back({found.items[i].words, std::stoll(found.items[i + 1].words)});
  return charges;
}

// A Redis that has taken another's place may have forgotten what it had answered.
void RedisJobs::mend(TimeMs now) {
  if (mended_ != 0 && now - mended_ < between_mends_ms) return;
  mended_ = now;
  if (const auto mended = run(scripts_.mend, now, {}).count; mended > 0)
    log_failure("jobs",
                "the farm had forgotten " + std::to_string(mended) + " parts, which wait again");
  for (const RedisReply& told : run(scripts_.unlend, now, {}).items)
    remove_outside(*outside_, told.words);
}

}  // namespace tia::server
