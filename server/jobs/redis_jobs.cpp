#include "server/jobs/redis_jobs.h"

#include <algorithm>
#include <array>
#include <chrono>

#include "core/input/json.h"
#include "server/contract/problem.h"
#include "server/jobs/job_problems.h"
#include "server/jobs/outside.h"
#include "server/jobs/redis_fields.h"
#include "server/stores/digest.h"

namespace tia::server {
namespace {

// What a job takes besides its request and results.
constexpr std::int64_t own_job_bytes = 1024;
// Longer results are blobs: a script's arguments are copied while all others wait.
constexpr std::size_t longest_inside = 8 << 20;

const char* word_of(FarmRole role) {
  return std::array{"all", "draws", "joins"}[static_cast<std::size_t>(role)];
}

std::int64_t kept_bytes(const NewJob& job) {
  return static_cast<std::int64_t>(job.request.size() + job.plan.size()) + own_job_bytes;
}

std::string limit_text(const std::optional<std::int64_t>& limit) {
  return limit ? std::to_string(*limit) : "";
}

HttpError farm_full(const JobLimits& limits) {
  return {"storage-full", "jobs hold as much as they may: " + std::to_string(limits.bytes) +
                              " bytes (option TIA_MAX_JOBS_BYTES)"};
}

std::string number_of_part(const Claim& claim) { return std::to_string(claim.n); }
std::string attempt_text(const Claim& claim) { return std::to_string(claim.attempt); }

}  // namespace

RedisJobs::RedisJobs(FarmOptions options)
    : options_(std::move(options)),
      redis_(options_.redis),
      outside_(options_.store ? options_.store
                              : blobs_in_redis(redis_, std::string(prefix) + "blob:")),
      keeper_([this](const std::stop_token& stop) { keep_alive(stop); }) {}
RedisJobs::~RedisJobs() { hush(); }

void RedisJobs::listen() {
  const auto heard = [this](const std::string& id) {
    try {
      changed(id);
    } catch (const std::exception&) {  // it is asked again when something else happens
    }
  };
  const char* const channel = options_.role == FarmRole::draws ? "work" : "changed";
  is_telling_ = true;
  channel_ = std::make_unique<RedisChannel>(redis_, std::string(prefix) + channel, heard,
                                            [this] { tell_all(); });
}

void RedisJobs::hush() {
  channel_.reset();
  const std::lock_guard lock(telling_);
  is_telling_ = false;
}

std::string RedisJobs::key(const std::string& id) const {
  return std::string(prefix) + "job:" + id;
}

// The arguments that all scripts have come first.
RedisReply RedisJobs::run(RedisScript& script, TimeMs now, const std::vector<std::string>& own) {
  const JobLimits& limits = options_.limits;
  std::vector<std::string> arguments{
      std::to_string(now),
      std::to_string(limits.keep_ms),
      std::to_string(limits.tries),
      std::to_string(limits.bytes),
      std::to_string(limits.unfinished),
      options_.version,
      options_.name,
      std::to_string(options_.lease_ms),
      job_problem("internal", "@PART@ has ended without a result " + std::to_string(limits.tries) +
                                  " times (option TIA_JOB_TRIES)"),
      word_of(options_.role)};
  arguments.insert(arguments.end(), own.begin(), own.end());
  return script.run(redis_, prefix, arguments);
}

// ---- changes --------------------------------------------------------------------------------

Job RedisJobs::submit(const NewJob& job, TimeMs now) {
  const std::string key_digest = job.key.empty() ? "" : sha256_hex(job.owner + '\n' + job.key);
  std::vector<std::string> own{job.id,
                               key_digest,
                               job.digest,
                               std::to_string(kept_bytes(job)),
                               std::to_string(job.result_bytes),
                               limit_text(job.limits.unfinished),
                               limit_text(job.limits.bytes)};
  const auto fields = redis_fields(job);
  own.insert(own.end(), fields.begin(), fields.end());
  if (options_.store) own.insert(own.end(), {"outside", "1"});
  const RedisReply reply = run(scripts_.submit, now, own);
  const std::string word = reply.items.empty() ? "" : reply.items[0].words;
  if (word == "conflict")
    throw InputError({FaultKind::conflict, "", Value("another body under the same key"),
                      "under one Idempotency-Key the same body as before"});
  if (word == "busy")
    throw HttpError("busy",
                    "as many jobs are unfinished as may be: " +
                        std::to_string(options_.limits.unfinished) + " (option TIA_MAX_JOBS)",
                    {{"Retry-After", "10"}});
  if (word == "quota")
    if (const auto more = beyond_limits(job, {reply.items[1].count, reply.items[2].count},
                                        kept_bytes(job) + job.result_bytes))
      throw AccessRefusal(*more);
  if (word == "full") throw farm_full(options_.limits);
  auto kept = reply.items.size() == 2 ? find(reply.items[1].words) : std::nullopt;
  if (!kept) throw StorageError("Redis has lost a job that it has just kept");
  return *std::move(kept);
}

std::optional<Claim> RedisJobs::claim(const std::string&, TimeMs now) {
  if (is_resting_) return std::nullopt;
  const RedisReply reply = run(scripts_.claim, now, {});
  if (reply.items.size() == 1) {
    is_banned_ = true;
    throw StorageError(
        "this worker has drawn other bytes than another one, and is out of the farm");
  }
  if (reply.items.size() != 3) return std::nullopt;
  const Claim claim{reply.items[0].words, static_cast<int>(reply.items[1].count),
                    static_cast<int>(reply.items[2].count)};
  hold(claim);
  return claim;
}

bool RedisJobs::heartbeat(const Claim& claim, TimeMs now) {
  return run(scripts_.heartbeat, now, {claim.job, number_of_part(claim), attempt_text(claim)})
             .count == 1;
}

// What has been drawn is not thrown away because Redis is away, as long as it is nobody else's.
template <class Ask>
auto RedisJobs::insist(const Ask& ask) -> decltype(ask()) {
  constexpr std::chrono::milliseconds between{100};
  const auto until =
      std::chrono::steady_clock::now() + std::chrono::milliseconds(options_.lease_ms);
  for (;;) try {
      return ask();
    } catch (const StorageAway&) {
      if (is_resting_ || std::chrono::steady_clock::now() > until) throw;
      std::this_thread::sleep_for(between);
    }
}

bool RedisJobs::finish(const Claim& claim, const PartResult& result, TimeMs now) {
  const RayCounts& rays = result.rays;
  const std::size_t bytes = result.bytes.size();
  const std::string outside =
      options_.store || bytes > longest_inside
          ? insist([&] { return put_outside(*outside_, results_folder(claim.job), result.bytes); })
          : "";
  std::vector<std::string> own{claim.job,
                               number_of_part(claim),
                               attempt_text(claim),
                               outside.empty() ? result.bytes : "",
                               sha256_hex(result.bytes),
                               result.etag,
                               result.type,
                               result.place,
                               std::to_string(result.ms),
                               std::to_string(rays.all())};
  for (const std::int64_t count :
       {rays.primary, rays.shadow, rays.reflection, rays.refraction, rays.cut})
    own.push_back(std::to_string(count));
  own.emplace_back(is_audited(claim) ? "1" : "0");
  own.push_back(job_problem("internal", "part @PART@ was drawn with other bytes by " +
                                            options_.name + " than by @OTHER@"));
  own.push_back("{\"n\":" + number_of_part(claim) + ",\"state\":\"done\",\"etag\":" +
                to_json(result.etag) + (result.place.empty() ? "" : "," + result.place) + "}");
  own.push_back(outside);
  own.push_back(std::to_string(bytes));
  own.push_back(std::to_string(result.is_found ? 0 : rays.all()));
  const std::string word = insist([&] { return run(scripts_.finish, now, own).words; });
  if (word != "done" && !outside.empty()) remove_outside(*outside_, outside);
  if (word == "full") throw farm_full(options_.limits);
  release(claim);
  if (word == "mismatch") is_banned_ = true;
  return word == "done" || word == "audited";
}

// By its name, so that who draws does not choose.
bool RedisJobs::is_audited(const Claim& claim) const {
  constexpr int digits = 8;
  const std::string digest = sha256_hex(claim.job + '/' + number_of_part(claim));
  return static_cast<double>(std::stoul(digest.substr(0, digits), nullptr, 16)) <
         options_.audit * 4294967296.0;
}

void RedisJobs::lose(const Claim& claim, Loss loss, TimeMs now) {
  release(claim);  // whatever comes of this, its lease is not kept alive any longer
  const std::string is_given_back = loss == Loss::given_back ? "1" : "0";
  insist([&] {
    return run(scripts_.lose, now,
               {claim.job, number_of_part(claim), attempt_text(claim), is_given_back});
  });
}

void RedisJobs::fail(const std::string& id, const std::string& problem, TimeMs now) {
  run(scripts_.fail, now, {id, problem});
}

Cancelled RedisJobs::cancel(const std::string& id, TimeMs now) {
  const std::string word = run(scripts_.cancel, now, {id}).words;
  return word == "now"       ? Cancelled::now
         : word == "removed" ? Cancelled::removed
                             : Cancelled::unknown;
}

void RedisJobs::sweep(TimeMs now) {
  const std::string problem = job_problem("timeout", "the job's deadline_s is over");
  while (run(scripts_.sweep, now, {problem}).count > 0) {
  }
  if (options_.role == FarmRole::draws) return;
  if (options_.store) sweep_dropped();
  mend(now);
}

void RedisJobs::plan_anew(const Job& job, TimeMs now) {
  std::vector<std::string> own{job.id, std::to_string(kept_bytes(job))};
  const auto fields = redis_plan_fields(job);
  own.insert(own.end(), fields.begin(), fields.end());
  run(scripts_.plan_anew, now, own);
}

// ---- what this process is at ----------------------------------------------------------------

void RedisJobs::hold(const Claim& claim) {
  const std::lock_guard lock(mutex_);
  held_.push_back(claim);
}

std::size_t RedisJobs::held() {
  const std::lock_guard lock(mutex_);
  return held_.size();
}

void RedisJobs::release(const Claim& claim) {
  const std::lock_guard lock(mutex_);
  std::erase_if(held_, [&](const Claim& each) {
    return each.job == claim.job && each.n == claim.n && each.attempt == claim.attempt;
  });
}

// A heartbeat each third of a lease. Who is told that a part is no longer wanted stops drawing it.
void RedisJobs::keep_alive(const std::stop_token& stop) {
  const std::chrono::milliseconds between(std::max(options_.lease_ms / 3, 1));
  std::unique_lock lock(mutex_);
  while (!ending_.wait_for(lock, stop, between, [] { return false; }) && !stop.stop_requested()) {
    const std::vector<Claim> held = held_;
    lock.unlock();
    for (const Claim& claim : held) try {
        if (heartbeat(claim, 0)) continue;
        release(claim);
        const std::lock_guard telling(telling_);
        if (is_telling_) changed(claim.job);
      } catch (const std::exception&) {  // as long as Redis is away, nobody else can claim it
      }
    lock.lock();
  }
}

// What has changed while nobody listened is not known: any job may.
void RedisJobs::tell_all() {
  try {
    for (const char* set : {"open", "closed"})
      for (const RedisReply& id :
           redis_.call({"ZRANGE", std::string(prefix) + set, "0", "-1"}).items)
        changed(id.words);
  } catch (const std::exception&) {  // it is told once Redis is there again
  }
}

}  // namespace tia::server
