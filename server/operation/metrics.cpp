#include "server/operation/metrics.h"

#include <prometheus/counter.h>
#include <prometheus/gauge.h>
#include <prometheus/histogram.h>
#include <prometheus/registry.h>
#include <prometheus/text_serializer.h>

#include <algorithm>
#include <array>
#include <mutex>
#include <set>

#include "core/version.h"
#include "server/http/application.h"

namespace tia::server {
namespace {

using prometheus::Counter;
using prometheus::Gauge;
using prometheus::Histogram;

template <class Builder>
auto& family(Builder builder, const char* name, const char* help, prometheus::Registry& registry) {
  return builder.Name(name).Help(help).Register(registry);
}

}  // namespace

struct Metrics::Families {
  prometheus::Registry registry;
  prometheus::Family<Counter>& requests =
      family(prometheus::BuildCounter(), "tia_requests_total",
             "Requests by route and status; 499: the client left before its answer.", registry);
  prometheus::Family<Counter>& bytes = family(prometheus::BuildCounter(), "tia_body_bytes_total",
                                              "Bytes of requests' and answers' bodies.", registry);
  prometheus::Family<Counter>& rays =
      family(prometheus::BuildCounter(), "tia_rays_total", "Rays traced, by kind.", registry);
  Counter& shown = family(prometheus::BuildCounter(), "tia_shown_pictures_total",
                          "Pictures that streams were shown before they were done.", registry)
                       .Add({});
  Counter& resumed =
      family(prometheus::BuildCounter(), "tia_resumed_pictures_total",
             "Pictures whose drawing went on from rounds of one that was left.", registry)
          .Add({});
  prometheus::Family<Histogram>& seconds =
      family(prometheus::BuildHistogram(), "tia_picture_phase_seconds",
             "Where pictures' time went, by phase.", registry);
  prometheus::Family<Gauge>& connections =
      family(prometheus::BuildGauge(), "tia_connections", "Connections that are open.", registry);
  prometheus::Family<Gauge>& at_work = family(prometheus::BuildGauge(), "tia_requests_at_work",
                                              "Requests that hold a ticket.", registry);
  prometheus::Family<Gauge>& waiting = family(prometheus::BuildGauge(), "tia_requests_waiting",
                                              "Requests in the queue for a ticket.", registry);
  prometheus::Family<Gauge>& kept = family(prometheus::BuildGauge(), "tia_kept_scenes",
                                           "Kept scenes that are in memory.", registry);
  prometheus::Family<Gauge>& kept_bytes =
      family(prometheus::BuildGauge(), "tia_kept_scenes_bytes",
             "Memory of the kept scenes that are in it.", registry);
  prometheus::Family<Gauge>& data_bytes = family(prometheus::BuildGauge(), "tia_data_bytes",
                                                 "What the file of kept scenes holds.", registry);
  prometheus::Family<Counter>& lookups =
      family(prometheus::BuildCounter(), "tia_geometry_lookups_total",
             "Compiled scenes and meshes that were looked for, by result; a miss compiles its own. "
             "Nothing is looked for where none are kept.",
             registry);
  prometheus::Family<Gauge>& geometry_bytes =
      family(prometheus::BuildGauge(), "tia_geometry_bytes",
             "Memory of the compiled scenes that pictures share.", registry);
  prometheus::Family<Counter>& pictures =
      family(prometheus::BuildCounter(), "tia_cache_lookups_total",
             "Pictures that were asked for, by where they came from: hit: from the cache; miss: "
             "they were drawn; joined: from another request's drawing that was under way.",
             registry);
  prometheus::Family<Gauge>& cached =
      family(prometheus::BuildGauge(), "tia_cache_pictures", "Pictures in the cache.", registry);
  prometheus::Family<Gauge>& cached_rounds =
      family(prometheus::BuildGauge(), "tia_cache_rounds",
             "Pictures of which the cache keeps the rounds that they were left with.", registry);
  prometheus::Family<Gauge>& cached_bytes =
      family(prometheus::BuildGauge(), "tia_cache_bytes", "Memory of the cache.", registry);
  prometheus::Family<Gauge>& memory =
      family(prometheus::BuildGauge(), "tia_memory_bytes",
             "Memory of the account (TIA_MEMORY_BYTES), by what it is booked for.", registry);
  prometheus::Family<Gauge>& memory_limit = family(
      prometheus::BuildGauge(), "tia_memory_limit_bytes", "What the account has in all.", registry);
  prometheus::Family<Counter>& claims =
      family(prometheus::BuildCounter(), "tia_memory_claims_total",
             "Claims that had to wait for memory, or were refused.", registry);
  prometheus::Family<Gauge>& models =
      family(prometheus::BuildGauge(), "tia_models",
             "Models, by state: kept: their files; read: in memory as well.", registry);
  prometheus::Family<Counter>& model_reads = family(
      prometheus::BuildCounter(), "tia_model_reads_total",
      "Models that were read, by format and by what came of it: read; refused: there is a fault in "
      "it; died: the reader did.",
      registry);
  prometheus::Family<Histogram>& model_seconds =
      family(prometheus::BuildHistogram(), "tia_model_read_seconds",
             "How long it took to read a model, its pictures included.", registry);
  prometheus::Family<Counter>& reader_deaths =
      family(prometheus::BuildCounter(), "tia_model_reader_deaths_total",
             "Readers of models that were killed, or answered what nobody can read.", registry);
  prometheus::Family<Gauge>& jobs =
      family(prometheus::BuildGauge(), "tia_jobs", "Jobs that are kept, by state.", registry);
  prometheus::Family<Counter>& job_parts =
      family(prometheus::BuildCounter(), "tia_job_parts_total",
             "Parts of jobs, by what came of them: done; joined: all of a job's, to one; late: "
             "their result was there already, or "
             "not wanted any more; lost: they are tried again; given_back: nobody wanted them any "
             "more; fault: of what was asked for.",
             registry);
  Histogram& job_part_seconds = family(prometheus::BuildHistogram(), "tia_job_part_seconds",
                                       "How long parts of jobs took that are done.", registry)
                                    .Add({}, Histogram::BucketBoundaries{0.01, 0.1, 1, 10, 100});
  static constexpr std::size_t most_keys = 100;  // that have a label of their own
  prometheus::Family<Counter>& key_requests =
      family(prometheus::BuildCounter(), "tia_key_requests_total",
             "Requests by the id of their key; anonymous: without one; other: of the keys beyond "
             "the first hundred.",
             registry);
  prometheus::Family<Counter>& key_rays =
      family(prometheus::BuildCounter(), "tia_key_rays_total", "Rays traced, by key.", registry);
  prometheus::Family<Counter>& key_refusals =
      family(prometheus::BuildCounter(), "tia_key_refusals_total",
             "Requests that a key's rights or quotas did not allow, by key.", registry);
  prometheus::Family<Counter>& refused =
      family(prometheus::BuildCounter(), "tia_keys_refused_total",
             "The same and requests whose key or signature does not hold, by reason.", registry);
  std::mutex naming;
  std::set<std::string, std::less<>> keys;  // that have a label

  std::string label_of(std::string_view key) {
    if (key.empty()) return "anonymous";
    const std::lock_guard lock(naming);
    if (keys.find(key) == keys.end() && keys.size() < most_keys) keys.emplace(key);
    return keys.find(key) != keys.end() ? std::string(key) : "other";
  }
  Counter& of_key(prometheus::Family<Counter>& counters, std::string_view key) {
    return counters.Add({{"key", label_of(key)}});
  }

  prometheus::Family<Gauge>& farm_up =
      family(prometheus::BuildGauge(), "tia_farm_up",
             "Whether the farm's Redis answers; without a farm there is no line.", registry);
  prometheus::Family<Gauge>& farm_workers =
      family(prometheus::BuildGauge(), "tia_farm_workers",
             "Workers that were heard of within a lease's time.", registry);
  prometheus::Family<Counter>& reclaims =
      family(prometheus::BuildCounter(), "tia_farm_reclaims_total",
             "Parts whose worker was no longer heard of, in all the farm.", registry);
  prometheus::Family<Counter>& mismatches =
      family(prometheus::BuildCounter(), "tia_farm_mismatches_total",
             "Parts of which two workers drew different bytes, in all the farm.", registry);
  prometheus::Family<Counter>& audits =
      family(prometheus::BuildCounter(), "tia_farm_audits_total",
             "Parts that two workers drew to compare (TIA_FARM_AUDIT), in all the farm.", registry);
  prometheus::Family<Gauge>& build =
      family(prometheus::BuildGauge(), "tia_build_info", "Always 1; what this build is.", registry);

  Counter& received = bytes.Add({{"direction", "received"}});
  Counter& sent = bytes.Add({{"direction", "sent"}});

  std::mutex raising;  // between a counter's value and its increment
  /// Raises a counter to what was counted elsewhere, unless who asked later has raised it further.
  static void raise(Counter& counter, std::int64_t count) {
    counter.Increment(std::max(0.0, static_cast<double>(count) - counter.Value()));
  }
  void tell(const FarmGauges& farm) {
    farm_up.Add({}).Set(farm.is_up ? 1 : 0);
    farm_workers.Add({}).Set(static_cast<double>(farm.workers));
    const std::lock_guard lock(raising);
    raise(reclaims.Add({}), farm.reclaims);
    raise(mismatches.Add({}), farm.mismatches);
    raise(audits.Add({}), farm.audits);
  }
  void raise(const Gauges& now) {
    const std::lock_guard lock(raising);
    const StoreCounts& found = now.geometry;
    raise(lookups.Add({{"of", "scene"}, {"result", "hit"}}), found.geometry_hits);
    raise(lookups.Add({{"of", "scene"}, {"result", "miss"}}), found.geometry_misses);
    raise(lookups.Add({{"of", "mesh"}, {"result", "hit"}}), found.mesh_hits);
    raise(lookups.Add({{"of", "mesh"}, {"result", "miss"}}), found.mesh_misses);
    raise(pictures.Add({{"result", "hit"}}), now.pictures.stored);
    raise(pictures.Add({{"result", "miss"}}), now.pictures.drawn);
    raise(pictures.Add({{"result", "joined"}}), now.pictures.joined);
  }

  void tell(const MemoryAccount& account) {
    for (std::size_t i = 0; i < account.holders.size(); ++i)
      memory.Add({{"for", std::string(account.holders[i])}})
          .Set(static_cast<double>(account.held(static_cast<MemoryAccount::Holder>(i))));
    memory_limit.Add({}).Set(static_cast<double>(account.limit()));
    const std::lock_guard lock(raising);
    raise(claims.Add({{"result", "waited"}}), account.waits());
    raise(claims.Add({{"result", "refused"}}), account.refusals());
  }

  Counter& reads_of(std::string_view format, ModelReading result) {
    constexpr std::array results{"read", "refused", "died"};
    return model_reads.Add(
        {{"format", std::string(format)}, {"result", results[static_cast<std::size_t>(result)]}});
  }
  Histogram& model_read() {
    return model_seconds.Add({}, Histogram::BucketBoundaries{0.001, 0.01, 0.1, 1, 10});
  }
  Histogram& phase(const char* name) {
    return seconds.Add({{"phase", name}},
                       Histogram::BucketBoundaries{0.0001, 0.001, 0.01, 0.1, 1, 10});
  }
};

Metrics::Metrics() : families_(std::make_unique<Families>()) {
  families_->build.Add({{"version", version()}, {"bytes", full_version()}}).Set(1);
  families_->requests.Add({{"route", "/render"}, {"status", "200"}});
  for (const char* kind : {"primary", "shadow", "reflection", "refraction"})
    families_->rays.Add({{"kind", kind}});
  for (const char* name : {"queue", "wait", "parse", "build", "trace", "encode"})
    families_->phase(name);
  for (const char* format : {"gltf", "obj", "ply", "stl"})
    families_->reads_of(format, ModelReading::read);
  families_->model_read();
  families_->reader_deaths.Add({});
  for (auto* each : {&families_->key_requests, &families_->key_rays, &families_->key_refusals})
    families_->of_key(*each, "");
  families_->refused.Add({{"why", "none"}});
}
Metrics::~Metrics() = default;

void Metrics::count(const Exchange& exchange, std::string_view route) {
  families_->requests
      .Add({{"route", std::string(route)}, {"status", std::to_string(exchange.response.status)}})
      .Increment();
  families_->received.Increment(static_cast<double>(exchange.request.body_bytes()));
  families_->sent.Increment(static_cast<double>(exchange.body_bytes));
  families_->of_key(families_->key_requests, exchange.request.key).Increment();
}

void Metrics::count(const RayCounts& rays, const Timing& ms) {
  const auto add = [&](const char* kind, std::int64_t count) {
    families_->rays.Add({{"kind", kind}}).Increment(static_cast<double>(count));
  };
  add("primary", rays.primary);
  add("shadow", rays.shadow);
  add("reflection", rays.reflection);
  add("refraction", rays.refraction);
  families_->phase("queue").Observe(ms.queue / 1000);
  families_->phase("wait").Observe(ms.wait / 1000);
  families_->phase("parse").Observe(ms.parse / 1000);
  families_->phase("build").Observe(ms.build / 1000);
  families_->phase("trace").Observe(ms.trace / 1000);
  families_->phase("encode").Observe(ms.encode / 1000);
}

void Metrics::count_part(std::string_view result, double seconds) {
  families_->job_parts.Add({{"result", std::string(result)}}).Increment();
  if (result == "done") families_->job_part_seconds.Observe(seconds);
}

void Metrics::count_shown() { families_->shown.Increment(); }
void Metrics::count_resumed() { families_->resumed.Increment(); }

void Metrics::count(std::string_view format, ModelReading result, double seconds) {
  families_->reads_of(format, result).Increment();
  families_->model_read().Observe(seconds);
  if (result == ModelReading::died) families_->reader_deaths.Add({}).Increment();
}

void Metrics::count_refusal(std::string_view key, std::string_view why) {
  families_->of_key(families_->key_refusals, key).Increment();
  families_->refused.Add({{"why", std::string(why)}}).Increment();
}

void Metrics::count_rays_of(std::string_view key, std::int64_t rays) {
  families_->of_key(families_->key_rays, key).Increment(static_cast<double>(rays));
}

std::string Metrics::text(const Gauges& gauges) {
  const auto set = [](prometheus::Family<Gauge>& gauge, auto value) {
    gauge.Add({}).Set(static_cast<double>(value));
  };
  set(families_->connections, gauges.connections);
  set(families_->at_work, gauges.at_work);
  set(families_->waiting, gauges.waiting);
  set(families_->kept, gauges.kept_scenes);
  set(families_->kept_bytes, gauges.kept_scenes_bytes);
  set(families_->data_bytes, gauges.data_bytes);
  set(families_->geometry_bytes, gauges.geometry.bytes);
  set(families_->cached, gauges.pictures.pictures);
  set(families_->cached_rounds, gauges.pictures.rounds);
  set(families_->cached_bytes, gauges.pictures.bytes);
  families_->models.Add({{"state", "kept"}}).Set(static_cast<double>(gauges.models.kept));
  families_->models.Add({{"state", "read"}}).Set(static_cast<double>(gauges.models.read));
  for (const auto& [state, count] : gauges.jobs)
    families_->jobs.Add({{"state", std::string(state)}}).Set(static_cast<double>(count));
  if (gauges.farm) families_->tell(*gauges.farm);
  if (gauges.memory != nullptr) families_->tell(*gauges.memory);
  families_->raise(gauges);
  return prometheus::TextSerializer().Serialize(families_->registry.Collect());
}

}  // namespace tia::server
