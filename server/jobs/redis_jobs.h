// Jobs of a farm: in Redis, for any number of processes that submit, draw and put together.
#pragma once

#include <condition_variable>
#include <map>
#include <memory>
#include <mutex>
#include <thread>

#include "server/jobs/redis_scripts.h"
#include "server/jobs/store.h"
#include "server/stores/blobs.h"

namespace tia::server {

/// FarmRole: what a process claims. Workers draw parts; who serves puts them together.
enum class FarmRole { all, draws, joins };

/// FarmOptions: a farm, and this process' place in it.
struct FarmOptions {
  RedisOptions redis = {};
  JobLimits limits = {};
  std::string version = {};  ///< of the program: it claims jobs of this one alone
  std::string name = {};     ///< of the process, as others are told: letters, digits, '.', '-', '_'
  FarmRole role = FarmRole::all;
  int lease_ms = 15'000;  ///< after which a part is another's, if nothing is heard of who draws it
  double audit = 0;       ///< share of the parts that two workers draw
  std::shared_ptr<Blobs> store = nullptr;  ///< of results and what is lent; null: Redis
};

/// RedisJobs: claims of this process are kept alive by a thread of its own until they are finished
/// or lost. What `changed` tells may come from that thread, or from the one that listens.
class RedisJobs : public JobStore {
 public:
  /// All its keys and channels begin so: one slot of a cluster, and the layout's number.
  static constexpr std::string_view prefix = farm_prefix;

  /// Asks for nothing yet: Redis may come later.
  explicit RedisJobs(FarmOptions options);
  ~RedisJobs() override;

  Job submit(const NewJob& job, TimeMs now) override;
  std::optional<Job> find(const std::string& id) override;
  std::vector<std::string> ids(int first, int most) override;
  OwnerSums sums_of(const NewJob& job) override;
  std::vector<PartRow> parts(const std::string& id, std::optional<PartState> state, int first,
                             int most) override;
  std::optional<PartRow> part(const std::string& id, int n) override;
  /// Errors: also StorageError for a worker that has drawn other bytes than another one.
  std::optional<Claim> claim(const std::string& worker, TimeMs now) override;
  bool heartbeat(const Claim& claim, TimeMs now) override;
  bool finish(const Claim& claim, const PartResult& result, TimeMs now) override;
  void lose(const Claim& claim, Loss loss, TimeMs now) override;
  void fail(const std::string& id, const std::string& problem, TimeMs now) override;
  Cancelled cancel(const std::string& id, TimeMs now) override;
  void sweep(TimeMs now) override;
  std::vector<Job> of_other_versions(const std::string& version) override;
  void plan_anew(const Job& job, TimeMs now) override;
  std::optional<std::string> result(const std::string& id, int n) override;
  std::vector<JobEvent> events(const std::string& id, std::int64_t after, int most) override;
  JobLoad load(TimeMs now) override;
  void listen() override;
  void hush() override;
  /// By what a farm's Redis has to be: one that syncs before it answers.
  bool is_durable() const override { return true; }

  bool is_shared() const override { return true; }
  void lend(const std::string& name, const std::function<std::string()>& bytes,
            TimeMs now) override;
  std::optional<std::string> lent(const std::string& name) override;
  std::vector<Charge> take_charges() override;

  /// Claims nothing any more.
  void rest() { is_resting_ = true; }
  /// Parts that this process is at.
  std::size_t held();
  bool is_up() const { return redis_.is_up(); }
  /// Whether this process has been told to leave the farm.
  bool is_banned() const { return is_banned_; }

 private:
  std::string key(const std::string& id) const;
  RedisReply run(RedisScript& script, TimeMs now, const std::vector<std::string>& own);
  template <class Ask>
  auto insist(const Ask& ask) -> decltype(ask());
  bool is_audited(const Claim& claim) const;
  std::optional<std::string> outside_result(const std::string& id, int n);
  void sweep_dropped();
  void mend(TimeMs now);
  void hold(const Claim& claim);
  void release(const Claim& claim);
  void keep_alive(const std::stop_token& stop);
  void tell_all();

  const FarmOptions options_;
  Redis redis_;
  const std::shared_ptr<Blobs> outside_;  // the store, or Redis itself
  RedisScripts scripts_;
  std::atomic<TimeMs> mended_ = 0;
  std::atomic<bool> is_banned_ = false, is_resting_ = false, is_telling_ = false;
  std::mutex telling_;  // while the keeper tells
  std::mutex mutex_;
  std::condition_variable_any ending_;
  std::vector<Claim> held_;
  std::unique_ptr<RedisChannel> channel_;
  std::jthread keeper_;
};

}  // namespace tia::server
