// Where jobs are kept: one interface of all stores. What happens to a job is a change of state here
// or nowhere, all of it or nothing.
#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "server/jobs/job.h"

namespace tia::server {

/// JobLimits: of a store.
struct JobLimits {
  int tries = 5;                    ///< without an end, after which a part is dead
  int unfinished = 1000;            ///< jobs
  std::int64_t bytes = 1LL << 30U;  ///< of requests and results
  TimeMs keep_ms = 86'400'000;      ///< after a job's end; as long again that it was
  static constexpr std::int64_t most_events = 1000;  ///< that are kept of a job, the newest
};

/// Loss: why a part has no result: it is given back untouched, or its try has failed.
enum class Loss { given_back, failed };

enum class Cancelled { now, removed, unknown };

/// JobStore. Any thread may call. `now` never goes back.
/// Turns: owners by turns, then each owner's jobs; high before normal before low priority, but
/// every eighth time low first.
/// Errors, of all that follows: StorageError.
class JobStore {
 public:
  JobStore() = default;
  JobStore(const JobStore&) = delete;
  JobStore& operator=(const JobStore&) = delete;
  virtual ~JobStore() = default;

  /// Keeps a job, on the disk where there is one; the one that the same owner has under the same
  /// key where there is. Errors: InputError (conflict) where that one had another body; HttpError:
  /// busy (as many are unfinished as may be), storage-full; AccessRefusal (quota), its own limits.
  virtual Job submit(const NewJob& job, TimeMs now) = 0;
  virtual std::optional<Job> find(const std::string& id) = 0;
  /// Ids, from that place on and at most so many: unfinished jobs, then those that have ended, the
  /// latest first.
  virtual std::vector<std::string> ids(int first, int most) = 0;
  /// What those of the same account come to.
  virtual OwnerSums sums_of(const NewJob& job) = 0;
  /// From `first` on, at most so many; those in that state alone, where one is named.
  virtual std::vector<PartRow> parts(const std::string& id, std::optional<PartState> state,
                                     int first, int most) = 0;
  /// One part, or what they were put together by; none where nobody has begun it.
  virtual std::optional<PartRow> part(const std::string& id, int n) = 0;
  /// What is to be done next; its try is on the disk before this returns. A try that ended with the
  /// process is made again first, and by itself: so the tries of the part that ends processes go
  /// up, and no other's.
  virtual std::optional<Claim> claim(const std::string& worker, TimeMs now) = 0;
  /// That somebody is at it. Returns: whether it is still wanted.
  virtual bool heartbeat(const Claim& claim, TimeMs now) = 0;
  /// Takes the result if there is none yet. Returns: whether it has. Errors: HttpError
  /// (storage-full).
  virtual bool finish(const Claim& claim, const PartResult& result, TimeMs now) = 0;
  /// The part waits again; after too many tries it is dead, and its job has failed.
  virtual void lose(const Claim& claim, Loss loss, TimeMs now) = 0;
  /// A fault of what is asked for ends the job with that problem document.
  virtual void fail(const std::string& id, const std::string& problem, TimeMs now) = 0;
  /// Ends a job; one that has ended is removed.
  virtual Cancelled cancel(const std::string& id, TimeMs now) = 0;
  /// Ends what is over its deadline, lets results go that were kept long enough, and then jobs.
  virtual void sweep(TimeMs now) = 0;
  /// Unfinished jobs of other versions; and such a one begun anew with other parts.
  virtual std::vector<Job> of_other_versions(const std::string& version) = 0;
  virtual void plan_anew(const Job& job, TimeMs now) = 0;

  /// The result of that number; none where there is none (any more).
  virtual std::optional<std::string> result(const std::string& id, int n) = 0;
  /// Events after that one, at most so many.
  virtual std::vector<JobEvent> events(const std::string& id, std::int64_t after, int most) = 0;
  virtual JobLoad load(TimeMs now) = 0;
  virtual bool is_durable() const = 0;

  /// Whether processes draw its parts that do not have what clients have sent to this one.
  virtual bool is_shared() const { return false; }
  /// Keeps what jobs name for those, as long as one needs it and results are kept; `bytes` is asked
  /// where it is not kept yet. Errors: HttpError (storage-full); what bytes() throws.
  virtual void lend(const std::string& /*name*/, const std::function<std::string()>& /*bytes*/,
                    TimeMs /*now*/) {}
  /// What was lent by that name, as it was; none where nothing was.
  virtual std::optional<std::string> lent(const std::string& /*name*/) { return std::nullopt; }
  /// What others have traced since this was asked last, by anybody.
  virtual std::vector<Charge> take_charges() { return {}; }

  /// Begins to tell of what others change, too, once `changed` is what it stays; and ends it: what
  /// is being told has been when hush() returns.
  virtual void listen() {}
  virtual void hush() {}

  /// Told of each job that has changed, once it has; it may call, but not wait.
  std::function<void(const std::string& id)> changed = [](const std::string&) {};
};

}  // namespace tia::server
