// What operators ask: /healthz, /readyz, /version, /metrics.
#include "core/input/object_schema.h"
#include "core/math/wide.h"
#include "core/version.h"
#include "server/contract/answers.h"
#include "server/contract/problem.h"
#include "server/handlers/handlers.h"
#include "server/jobs/jobs.h"
#include "server/requests/film_request.h"

namespace tia::server {
namespace {

#if defined(__clang__)
constexpr std::string_view compiler = "clang " __clang_version__;
#else
constexpr std::string_view compiler = "gcc " __VERSION__;
#endif

Response status_of(const char* word, int status) {
  Response response{.status = status,
                    .content_type = "application/json",
                    .body = to_json(Value::Object{{"status", word}}),
                    .headers = {{"Cache-Control", "no-store"}}};
  if (status == 503) response.headers.emplace_back("Retry-After", "1");
  return response;
}

template <class... Words>
Value status_schema(const Words&... words) {
  return object_schema({{"status", Value::Object{{"enum", Value::Array{words...}}}}});
}

Value healthy_schema(Definitions&) { return status_schema("ok"); }
Value ready_schema(Definitions&) { return status_schema("ready"); }
Value unready_schema(Definitions&) { return status_schema("draining", "overloaded"); }

Response get_health(const Request&, const std::string&, Service&) { return status_of("ok", 200); }

Response get_ready(const Request&, const std::string&, Service& service) {
  if (service.draining) return status_of("draining", 503);
  if (service.admission.waiting() >= service.config.queue && service.config.queue > 0)
    return status_of("overloaded", 503);
  return status_of("ready", 200);
}

// A farm that is away has no jobs to tell of.
std::optional<JobLoad> load_of(JobStore& jobs) {
  try {
    return jobs.load(Runner::now());
  } catch (const StorageAway&) {
    return std::nullopt;
  }
}

std::vector<std::pair<std::string_view, std::int64_t>> jobs_by_state(const JobLoad& load) {
  std::vector<std::pair<std::string_view, std::int64_t>> counts;
  for (std::size_t i = 0; i < load.jobs.size(); ++i)
    counts.emplace_back(name_of(static_cast<JobState>(i)), load.jobs[i]);
  return counts;
}

std::optional<FarmGauges> farm_gauges(const std::optional<JobLoad>& load, const Config& config) {
  if (config.farm.empty()) return std::nullopt;
  if (!load || !load->farm) return FarmGauges{};
  const FarmCounts& farm = *load->farm;
  return FarmGauges{true, farm.workers, farm.reclaims, farm.mismatches, farm.audits};
}

Response get_metrics(const Request&, const std::string&, Service& service) {
  const Admission& admission = service.admission;
  const SceneStore& kept = service.rendering.kept;
  const std::optional<JobLoad> load = load_of(service.jobs.store());
  const Gauges gauges{.connections = service.connections(),
                      .at_work = admission.at_work(),
                      .waiting = admission.waiting(),
                      .kept_scenes = kept.count(),
                      .kept_scenes_bytes = kept.bytes(),
                      .data_bytes = kept.file_bytes(),
                      .geometry = service.rendering.geometries.counts(),
                      .pictures = service.pictures.counts(),
                      .models = service.models.counts(),
                      .jobs = jobs_by_state(load.value_or(JobLoad{})),
                      .farm = farm_gauges(load, service.config),
                      .memory = &service.memory};
  return {.content_type = std::string(Metrics::media_type),
          .body = service.metrics.text(gauges),
          .headers = {{"Cache-Control", "no-store"}}};
}

// mp4 takes a program that not every server has.
Value::Array film_formats_of(const Service& service) {
  Value::Array names;
  for (const FilmFormatRow& row : film_formats)
    if (row.format != FilmFormat::mp4 || !service.rendering.ffmpeg.program.empty())
      names.emplace_back(row.name);
  return names;
}

Response get_version(const Request&, const std::string&, Service& service) {
  const Value::Object build{{"name", "tia"},           {"version", version()},
                            {"bytes", full_version()}, {"compiler", compiler},
                            {"lanes", lanes<Wide>},    {"films", film_formats_of(service)}};
  return {.content_type = "application/json", .body = to_json(build)};
}

Value version_schema(Definitions& named) {
  return schema_called("build", named, [] {
    const Value text = plain_schema<std::string>();
    return object_schema(
        {{"name", text},
         {"version", text},
         {"bytes", text, "the same bytes come from builds of which this is equal"},
         {"compiler", text},
         {"lanes", count_schema(1), "rays that are traced at once"},
         {"films", plain_schema<std::vector<std::string>>(), "the formats that /film gives here"}});
  });
}

}  // namespace

std::vector<Route> operation_routes() {
  return {{.method = "GET",
           .path = "/healthz",
           .name = "get_health",
           .about = "whether the server lives",
           .handler = get_health,
           .answers = {unstored("it does", healthy_schema)}},
          {.method = "GET",
           .path = "/readyz",
           .name = "get_ready",
           .about = "whether it takes requests: 503 when it goes down or has too much to do",
           .handler = get_ready,
           .answers = {unstored("it does", ready_schema),
                       {503,
                        "it does not",
                        {{media::json, unready_schema}},
                        {"Cache-Control", "Retry-After"}}}},
          {.method = "GET",
           .path = "/version",
           .name = "get_version",
           .about = "what this build is",
           .handler = get_version,
           .answers = {ok("the build", media::json, version_schema)}},
          {.method = "GET",
           .path = "/metrics",
           .name = "get_metrics",
           .about = "counters and gauges, in Prometheus' text format",
           .rights = {Right::metrics},
           .handler = get_metrics,
           .answers = {ok("the metrics", Metrics::media_type, nullptr, {"Cache-Control"})}}};
}

}  // namespace tia::server
