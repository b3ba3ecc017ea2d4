// Jobs as plain data: work that may outlast a request, and the parts that it is made of.
#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "core/input/codec.h"
#include "core/render/meter.h"

namespace tia::server {

enum class JobState { queued, running, done, failed, cancelled };
enum class PartState { waiting, leased, done, dead };
enum class Priority { low, normal, high };

constexpr bool is_last(JobState state) { return state > JobState::running; }

/// Times of jobs: of the system's clock, since 1970. Unit: ms.
using TimeMs = std::int64_t;

/// OwnerLimits: of the jobs of an owner, together; none: as many as there may be.
struct OwnerLimits {
  std::optional<std::int64_t> unfinished, bytes;
};
/// OwnerSums: what they are: how many are unfinished, and the bytes of requests and results.
struct OwnerSums {
  std::int64_t unfinished = 0, bytes = 0;
};

/// NewJob: one that is submitted, its faults checked and its parts counted.
struct NewJob {
  std::string id, owner;
  OwnerLimits limits = {};  ///< that it has to keep when it is submitted; not kept with it
  std::string key = {};     ///< Idempotency-Key; "": none
  std::string digest = {};  ///< of the body that asked for it
  std::string kind, name = {};
  Priority priority = Priority::normal;
  std::string version = {};  ///< that draws it
  std::string request = {};  ///< what its kind plans parts from
  std::string plan = {};     ///< what its kind has decided, such as the size of windows
  std::string needs = {};    ///< what it names that clients have sent: "models/ID scenes/ID"
  int parts = 1;
  bool joins = false;             ///< whether results are put together once all are there
  std::int64_t max_rays = 0;      ///< of all parts; 0: as many as the server gives
  std::int64_t result_bytes = 0;  ///< that results will have in any case
  TimeMs deadline = 0;            ///< 0: none
};

/// Who is told apart by turns: the key of those who have one, else the address.
inline std::string owner_of(std::string_view key, std::string address) {
  return key.empty() ? std::move(address) : "key " + std::string(key);
}
/// The key that pays for its rays; "" where it has none.
inline std::string key_of(const NewJob& job) {
  return job.owner.starts_with("key ") ? job.owner.substr(4) : "";
}
/// Who is counted as one: a key, or all together who have none.
inline std::string account_of(const NewJob& job) {
  return job.owner.starts_with("key ") ? job.owner : "anonymous";
}

/// Job: one that is kept. waiting + leased + done + dead = parts.
struct Job : NewJob {
  JobState state = JobState::queued;
  TimeMs created = 0, started = 0, finished = 0, expires = 0;  ///< 0: not yet
  int waiting = 0, leased = 0, done = 0, dead = 0;
  RayCounts rays{};
  std::string problem = {};  ///< of one that has failed: a problem document
  std::string etag = {}, type = {};
  std::int64_t bytes = 0;  ///< of the result, where there is one of all parts
  bool is_gone = false;    ///< its results have been let go
  std::int64_t events = 0;

  /// The number that its result goes by: it comes after the parts where they are put together.
  int result() const { return joins ? parts : 0; }
};

/// PartRow: what is known of a part. One that nobody has begun has no row of its own.
struct PartRow {
  int n = 0;
  PartState state = PartState::waiting;
  int tries = 0;
  std::string worker = {}, etag = {}, place = {};
  std::int64_t ms = 0, rays = 0, bytes = 0;
  std::string type = {};
};

/// Claim: the right to draw a part, or, by the number after the last one, to put them together.
struct Claim {
  std::string job;
  int n = 0, attempt = 0;
};

/// PartResult: what came of it.
struct PartResult {
  std::string bytes, etag = {}, type = {};
  std::string place = {};  ///< where it is in the whole, as members of JSON: "window":[0,0,8,8]
  RayCounts rays{};
  bool is_found = false;  ///< it had been drawn before: its rays are charged to nobody again
  std::int64_t ms = 0;
};

/// JobEvent: what has become of a job; numbers rise by one from 1.
struct JobEvent {
  std::int64_t id = 0;
  std::string name, data;
};

/// FarmCounts: what a farm has seen since it was begun, and the workers that it has now.
struct FarmCounts {
  std::int64_t reclaims = 0, mismatches = 0, audits = 0, workers = 0;
};

/// Charge: rays that were traced for a key's jobs where nobody counts for keys.
struct Charge {
  std::string key;
  std::int64_t rays = 0;
};

/// JobLoad: how much there is to do.
struct JobLoad {
  std::int64_t parts_waiting = 0, parts_leased = 0, jobs_unfinished = 0;
  double oldest_wait_s = 0;
  std::array<std::int64_t, 5> jobs{};  ///< by state
  std::int64_t bytes = 0;              ///< of requests and results
  std::optional<FarmCounts> farm{};    ///< none where one process does it all
};

}  // namespace tia::server

template <>
struct tia::Names<tia::server::JobState> {
  static constexpr std::array<std::string_view, 5> names{"queued", "running", "done", "failed",
                                                         "cancelled"};
};
template <>
struct tia::Names<tia::server::PartState> {
  static constexpr std::array<std::string_view, 4> names{"waiting", "leased", "done", "dead"};
};
template <>
struct tia::Names<tia::server::Priority> {
  static constexpr std::array<std::string_view, 3> names{"low", "normal", "high"};
};
