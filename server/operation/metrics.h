// What is counted, in Prometheus' words; the only place that knows its library.
#pragma once

#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "core/render/meter.h"
#include "server/operation/memory_account.h"
#include "server/operation/store_counts.h"
#include "server/operation/timing.h"

namespace tia::server {

struct Exchange;

/// FarmGauges: of a farm; its counts are since it was begun, by whomever.
struct FarmGauges {
  bool is_up = false;
  std::int64_t workers = 0, reclaims = 0, mismatches = 0, audits = 0;
};

/// Gauges: what there is now, asked when the metrics are.
struct Gauges {
  int connections = 0, at_work = 0, waiting = 0;  ///< the latter two of requests
  std::size_t kept_scenes = 0, kept_scenes_bytes = 0;
  std::int64_t data_bytes = 0;  ///< of the file of kept scenes
  StoreCounts geometry{};       ///< also what was found there since the start
  PictureCounts pictures{};     ///< the same
  ModelCounts models{};
  std::vector<std::pair<std::string_view, std::int64_t>> jobs{};  ///< by state
  std::optional<FarmGauges> farm{};
  const MemoryAccount* memory = nullptr;  ///< the account
};

/// ModelReading: what became of a model that was read.
enum class ModelReading { read, refused, died };

/// Metrics: counters since the start. Any thread may call.
class Metrics {
 public:
  Metrics();
  ~Metrics();

  /// Counts a request by its route and status, and the bytes of its bodies.
  void count(const Exchange& exchange, std::string_view route);
  /// Counts a picture's rays and where its time went.
  void count(const RayCounts& rays, const Timing& ms);
  /// Counts a picture that was shown before it was done.
  void count_shown();
  /// Counts a picture whose drawing went on from where another one was left.
  void count_resumed();
  /// Counts a model of that format that was read, or was not.
  void count(std::string_view format, ModelReading result, double seconds);
  /// Counts a part of a job, by what came of it, and the seconds of one that is done.
  void count_part(std::string_view result, double seconds);
  /// Counts a request that was refused to a key, "" = none, for that reason.
  void count_refusal(std::string_view key, std::string_view why);
  /// Counts rays that were traced for a key.
  void count_rays_of(std::string_view key, std::int64_t rays);
  /// Prometheus' text format 0.0.4.
  std::string text(const Gauges& gauges);
  static constexpr std::string_view media_type = "text/plain; version=0.0.4; charset=utf-8";

 private:
  struct Families;
  std::unique_ptr<Families> families_;
};

}  // namespace tia::server
