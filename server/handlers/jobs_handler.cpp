// /jobs: work that may outlast a request.
#include <charconv>

#include "core/input/json.h"
#include "core/input/object_schema.h"
#include "server/contract/answers.h"
#include "server/contract/parameters.h"
#include "server/contract/query_parameters.h"
#include "server/handlers/bodies.h"
#include "server/handlers/handlers.h"
#include "server/handlers/job_results.h"
#include "server/handlers/known_job.h"
#include "server/handlers/submitted_job.h"
#include "server/jobs/event_stream.h"
#include "server/jobs/job_json.h"
#include "server/jobs/job_queries.h"
#include "server/jobs/jobs.h"
#include "server/requests/preferences.h"

namespace tia::server {
namespace {

Response post_job(const Request& request, const std::string&, Service& service) {
  refuse_query(request);
  const JobRequest asked = read_body(request, service, [&] {
    return read_job_request(
        body_json(request, "a job as a JSON object, such as {\"kind\":\"render\",\"request\":{}}",
                  service.config.json_limits()),
        request.stop);
  });
  return submitted(asked, request.body, request, service);
}

Response job_response(const Job& job, Service& service) {
  return {.content_type = std::string(media::json),
          .body = to_json(job_status(job, Runner::now(), service.jobs.store().is_durable())),
          .headers = {{"Cache-Control", "no-store"}}};
}

Response get_job(const Request& request, const std::string& id, Service& service) {
  const Job job = known_job(id, request, service);
  const Preferences preferences = preferences_of(request);
  Response response = job_response(job, service);
  if (!preferences.wait_s || is_last(job.state) || request.is_head()) return response;
  response.headers.emplace_back("Preference-Applied",
                                "wait=" + std::to_string(*preferences.wait_s));
  response.body.clear();
  response.feed = status_feed(job, *preferences.wait_s, service.jobs.store(), service.jobs.board());
  return response;
}

Response get_events(const Request& request, const std::string& id, Service& service) {
  const Job job = known_job(id, request, service);
  std::int64_t after = 0;
  const std::string_view last = request.header("Last-Event-ID");
  std::from_chars(last.data(), last.data() + last.size(), after);
  // Who comes back for more than there will ever be is told not to (WHATWG HTML, 9.2).
  if (is_last(job.state) && after >= job.events)
    return {.status = 204, .content_type = "", .body = ""};
  Response response{.content_type = "text/event-stream", .body = ""};
  response.headers = {{"Cache-Control", "no-store"}, {"X-Accel-Buffering", "no"}};
  response.unsized = request.is_head();
  if (!request.is_head())
    response.feed = event_feed(id, after, service.jobs.store(), service.jobs.board());
  return response;
}

Response delete_job(const Request& request, const std::string& id, Service& service) {
  static_cast<void>(known_job(id, request, service));
  service.jobs.store().cancel(id, Runner::now());
  return {.status = 204, .content_type = "", .body = ""};
}

Response get_jobs(const Request& request, const std::string&, Service& service) {
  const auto asked = read_described<JobsQuery>(query_object<JobsQuery>(request.query()));
  JobStore& store = service.jobs.store();
  Value::Array jobs;
  for (const std::string& id : store.ids(asked.first, JobsQuery::page))
    if (const auto job = store.find(id))
      jobs.push_back(Value::Object{{"owner", job->owner},
                                   {"job", job_status(*job, Runner::now(), store.is_durable())}});
  return {.content_type = std::string(media::json),
          .body = to_json(Value::Object{{"jobs", std::move(jobs)}}),
          .headers = {{"Cache-Control", "no-store"}}};
}

Value jobs_schema(Definitions& named) {
  const Value owner = plain_schema<std::string>();
  return object_schema(
      {{"jobs", list_schema(object_schema({{"owner", owner, "key ID, or an address"},
                                           {"job", job_status_schema(named)}}))}});
}

Response get_load(const Request&, const std::string&, Service& service) {
  const JobLoad load = service.jobs.store().load(Runner::now());
  const auto number = [](std::int64_t n) { return static_cast<double>(n); };
  return {.content_type = std::string(media::json),
          .body = to_json(Value::Object{
              {"parts_waiting", number(load.parts_waiting)},
              {"parts_leased", number(load.parts_leased)},
              {"jobs_unfinished", number(load.jobs_unfinished)},
              {"workers", load.farm ? number(load.farm->workers) : service.jobs.workers()},
              {"oldest_wait_s", load.oldest_wait_s}}),
          .headers = {{"Cache-Control", "no-store"}}};
}

Value load_schema(Definitions& named) {
  return schema_called("job_load", named, [] {
    const Value count = count_schema();
    return object_schema(
        {{"parts_waiting", count},
         {"parts_leased", count, "that are being drawn"},
         {"jobs_unfinished", count},
         {"workers", count, "parts that may be drawn at once; of a farm its workers"},
         {"oldest_wait_s", plain_schema<double>(Spec{.min = 0}),
          "of the oldest job that has parts left to begin"}});
  });
}

Value job_request_schema(Definitions& named) {
  static_cast<void>(schema_of<JobTerms>({}, named));
  const Value any = Value::Object{{"type", "object"}};
  const auto spec = [](double min, double max) { return Spec{.min = min, .max = max}; };
  return object_schema(
      {{"kind", plain_schema<std::string>(),
        "render: one picture, drawn in windows; batch: pictures; turntable: those of a model that "
        "is turned"},
       {"request", any, "what POST /render takes; of a turntable what /still takes", false},
       {"requests", list_schema(any), "of a batch: what POST /render takes, each", false},
       {"grid", any,
        "of a batch, with request: JSON Pointers into that, and lists of what is put there, in all "
        "combinations, the last list fastest",
        false},
       {"views", plain_schema<int>(spec(1, 3600)), "of a turntable, at equal azimuths", false},
       {"name", plain_schema<std::string>(), "to know it by", false},
       {"priority", plain_schema<Priority>(), "else normal", false},
       {"max_rays", plain_schema<std::int64_t>(spec(1, 9007199254740991)),
        "of all its pictures together", false},
       {"deadline_s", plain_schema<int>(spec(1, 31'536'000)), "from now on", false}});
}

std::vector<Content> job_body() {
  return {{media::json,
           job_request_schema,
           {{"a picture, lit from the left", R"({"kind": "render", "request": {"key": "a"}})"},
            {"six pictures of a grid", R"({"kind": "batch", "request": {"width": 32, "height": 24},
  "grid": {"/light": [[4, 5, 6], [-4, 5, 6], [0, 9, 0]], "/samples": [1, 4]}})"}}}};
}

}  // namespace

std::vector<Route> job_routes() {
  const Segment id{"id", "the job's id, as POST /jobs has answered it"};
  std::vector<Route> routes{
      {.method = "GET",
       .path = "/jobs",
       .name = "get_jobs",
       .about = "all jobs that are kept, of whomever: the unfinished ones, then those that have "
                "ended, the latest first, 100 at a time",
       .rights = {Right::admin},
       .pace = Pace::in_turn,
       .handler = get_jobs,
       .answers = {unstored("the jobs", jobs_schema)},
       .gives = {media::json},
       .query = query_parameters<JobsQuery>},
      {.method = "POST",
       .path = "/jobs",
       .name = "post_job",
       .about = "keeps a job, to be drawn by and by; one Idempotency-Key is one job",
       .rights = {Right::jobs},
       .pace = Pace::in_turn,
       .handler = post_job,
       .answers = {submitted_answer("the job is kept")},
       .gives = {media::json},
       .body = job_body()},
      {.method = "GET",
       .path = "/jobs/load",
       .name = "get_job_load",
       .about = "how much there is to draw",
       .rights = {Right::jobs},
       .pace = Pace::in_turn,
       .handler = get_load,
       .answers = {unstored("the load", load_schema)},
       .gives = {media::json}},
      {.method = "GET",
       .path = "/jobs/{}",
       .name = "get_job",
       .about = "a job's status; with Prefer: wait=N not before it changes, within N s",
       .rights = {Right::jobs},
       .pace = Pace::in_turn,
       .handler = get_job,
       .answers = {ok("the status", media::json, job_status_schema,
                      {"Cache-Control", "Preference-Applied"})},
       .gives = {media::json},
       .prefers = true,
       .segment = id},
      {.method = "DELETE",
       .path = "/jobs/{}",
       .name = "delete_job",
       .about = "cancels a job; of one that has ended nothing is kept any more",
       .rights = {Right::jobs},
       .pace = Pace::in_turn,
       .handler = delete_job,
       .answers = {{204, "it is cancelled, or gone"}},
       .segment = id},
      {.method = "GET",
       .path = "/jobs/{}/events",
       .name = "get_job_events",
       .about = "what becomes of a job, as server-sent events; Last-Event-ID goes on",
       .rights = {Right::jobs},
       .pace = Pace::in_turn,
       .handler = get_events,
       .answers = {{200,
                    "the events until the job has ended",
                    {{"text/event-stream"}},
                    {"Cache-Control", "X-Accel-Buffering"}},
                   {204, "there will be none after Last-Event-ID"}},
       .segment = id}};
  for (Route& route : job_result_routes(id)) routes.push_back(std::move(route));
  return routes;
}

}  // namespace tia::server
