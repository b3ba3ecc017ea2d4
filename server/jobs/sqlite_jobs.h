// Jobs of one process: in a file of SQLite's, or in memory alone.
#pragma once

#include <memory>
#include <mutex>
#include <stdexcept>
#include <type_traits>

#include "server/jobs/store.h"
#include "server/stores/blobs.h"
#include "server/stores/database.h"

namespace tia::server {

/// SqliteJobs: in memory without a path; else what a call has changed is on the disk when it
/// returns. The file is one process' own.
class SqliteJobs : public JobStore {
 public:
  static constexpr const char* name = "jobs.sqlite";

  /// InUse: another process has the file.
  struct InUse : std::runtime_error {
    using std::runtime_error::runtime_error;
  };
  /// Opens the file, or begins it. Parts that were being drawn when its last process ended without
  /// giving them back have lost a try. `outside`: where results are kept instead; null: here.
  /// Errors: std::runtime_error where that cannot be; InUse.
  SqliteJobs(const std::string& path, const JobLimits& limits, TimeMs now,
             std::shared_ptr<Blobs> outside = nullptr);

  Job submit(const NewJob& job, TimeMs now) override;
  std::optional<Job> find(const std::string& id) override;
  std::vector<std::string> ids(int first, int most) override;
  OwnerSums sums_of(const NewJob& job) override;
  std::vector<PartRow> parts(const std::string& id, std::optional<PartState> state, int first,
                             int most) override;
  std::optional<PartRow> part(const std::string& id, int n) override;
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
  bool is_durable() const override { return is_durable_; }

 private:
  void open(const std::string& path);
  void take_up(TimeMs now);
  /// Does it, all or nothing.
  template <class Change>
  auto change(const Change& does) -> decltype(does()) {
    try {
      const std::lock_guard lock(mutex_);
      Database::Transaction all(*database_);
      if constexpr (std::is_void_v<decltype(does())>) {
        does();
        all.commit();
      } else {
        auto made = does();
        all.commit();
        return made;
      }
    } catch (const DatabaseError& error) {
      refuse(error);
    }
  }
  [[noreturn]] static void refuse(const DatabaseError& error);
  /// Its result, or what tells of it outside.
  bool take(const Claim& claim, const PartResult& result, const std::string& told, TimeMs now);
  void take_away(const std::string& id, const std::string& told);
  std::optional<std::string> outside_result(const std::string& id, int n, const std::string& told);
  void sweep_dropped();

  // All below are called while the store is locked, within a transaction where they change it.
  std::optional<Job> row(const std::string& id);
  OwnerSums sums(const std::string& account);
  std::optional<Claim> suspect();
  std::optional<std::string> next_job();
  int next_part(const Job& job);
  Claim lease(const Job& job, int n, const std::string& worker, TimeMs now);
  bool is_leased(const Claim& claim);
  void count_done(const Job& job, const Claim& claim, const PartResult& result, TimeMs now);
  void put(const Claim& claim, const PartResult& result, const std::string& told);
  std::string told_outside(const std::string& id, int n);
  void undo(const Job& job, int n);
  void leave_outside(const std::string& id);
  void drop_results(const std::string& id, std::int64_t before);
  void lose_try(const Job& job, int n, bool is_suspect, TimeMs now);
  void close(const std::string& id, JobState state, TimeMs now);
  void fail_with(const std::string& id, const std::string& problem, TimeMs now);
  void let_go(const std::string& id);
  void remove(const std::string& id);
  std::int64_t bytes();
  void hold(const std::string& id, std::int64_t bytes);
  void make_room(std::int64_t bytes);
  void tell(const std::string& id, const char* event, const std::string& data);
  void tell_progress(const std::string& id, TimeMs now, bool is_last);

  std::mutex mutex_;
  std::optional<Database> database_;  // there, once this is made
  const JobLimits limits_;
  const bool is_durable_;
  const std::shared_ptr<Blobs> outside_;
  std::int64_t claims_ = 0;
};

}  // namespace tia::server
