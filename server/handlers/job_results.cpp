#include "server/handlers/job_results.h"

#include <algorithm>
#include <charconv>
#include <memory>

#include "core/input/json.h"
#include "core/input/object_schema.h"
#include "core/video/stored_zip.h"
#include "server/contract/answers.h"
#include "server/contract/parameters.h"
#include "server/contract/query_parameters.h"
#include "server/handlers/bodies.h"
#include "server/handlers/known_job.h"
#include "server/handlers/picture_response.h"
#include "server/handlers/rendered.h"
#include "server/jobs/job_problems.h"
#include "server/jobs/job_queries.h"
#include "server/jobs/jobs.h"
#include "server/requests/etag.h"

namespace tia::server {
namespace {

HttpError gone_results() {
  return {"gone", "the job was cancelled, or its results have been kept as long as they are"};
}

// Of a job that has ended well; else why there is none. Errors: HttpError.
std::optional<Response> refusal_of(const Job& job) {
  if (job.state == JobState::failed) {
    Response response{.content_type = "application/problem+json", .body = job.problem};
    const Value problem = parse_json(job.problem);
    response.status = static_cast<int>(*find(*problem.as<Value::Object>(), "status")->as<double>());
    response.headers = {{"Cache-Control", "no-store"}};
    if (response.status == 503 || response.status == 429)
      response.headers.emplace_back("Retry-After", "1");
    return response;
  }
  if (job.state == JobState::cancelled || job.is_gone) throw gone_results();
  return std::nullopt;
}
HttpError not_ready() { return {"not-ready", "it is not drawn yet", {{"Retry-After", "1"}}}; }

// As the picture's own answer has it.
Response result_response(const PartRow& row, const RayCounts& rays, const Request& request,
                         const std::string& id, Service& service) {
  const Headers validators{{"ETag", row.etag}, {"Cache-Control", "no-cache"}};
  if (has_already(request, row.etag)) {
    Response response{.status = 304, .content_type = "", .body = ""};
    response.headers = validators;
    response.headers.emplace_back("Cache-Status", "Tia; hit; detail=not-modified");
    return response;
  }
  reserve_memory(row.bytes, "the result", request.stop);
  auto bytes = service.jobs.store().result(id, row.n);
  if (!bytes) throw gone_results();
  const auto picture = std::make_shared<Picture>();
  picture->bytes = std::move(*bytes);
  for (const FormatRow& format : formats)
    if (format.media_type == row.type) picture->media_type = format.media_type;
  picture->rays = rays;
  picture->reached = reached_in(row.place);
  picture->tells_reached = picture->reached.has_value();
  Response response = picture_response({picture, Source::stored, true}, 0, 0);
  response.headers.insert(response.headers.end(), validators.begin(), validators.end());
  return response;
}

PartRow part_of_job(const Job& job, int n, Service& service) {
  auto row = service.jobs.store().part(job.id, n);
  if (!row || row->state != PartState::done) throw not_ready();
  return std::move(*row);
}

// ---- lists ----------------------------------------------------------------------------------

constexpr int page_of_parts = 1000;

Value told_part(const PartRow& row, const std::string& place) {
  Value told = parse_json("{" + place + "}");
  auto& members = *told.as<Value::Object>();
  members.emplace_back("n", row.n);
  members.emplace_back("state", name_of(row.state));
  members.emplace_back("tries", row.tries);
  if (!row.etag.empty()) members.emplace_back("etag", row.etag);
  if (!row.worker.empty()) members.emplace_back("worker", row.worker);
  if (row.state == PartState::done) {
    members.emplace_back("ms", static_cast<double>(row.ms));
    members.emplace_back("rays", static_cast<double>(row.rays));
  }
  return told;
}

Response get_parts(const Request& request, const std::string& name, Service& service) {
  const auto asked = read_described<PartsQuery>(query_object<PartsQuery>(request.query()));
  const Job job = known_job(name, request, service);
  Value::Array parts;
  for (const PartRow& row :
       service.jobs.store().parts(job.id, asked.state, asked.first, page_of_parts))
    parts.push_back(told_part(row, row.place));
  return {.content_type = std::string(media::json),
          .body = to_json(Value::Object{{"parts", std::move(parts)}}),
          .headers = {{"Cache-Control", "no-store"}}};
}

std::string name_in_zip(const PartRow& row) {
  std::string number = std::to_string(row.n);
  number.insert(0, std::size_t{5} - std::min(number.size(), std::size_t{5}), '0');
  for (const FormatRow& format : formats)
    if (format.media_type == row.type) return number.append(".").append(format.name);
  return number;
}

// Page by page, in the order of the numbers. Errors: HttpError (gone) where it ends.
template <class Each>
void for_each_part(const Job& job, JobStore& store, const Each& each) {
  for (int first = 0; first < job.parts; first += page_of_parts) {
    const auto rows = store.parts(job.id, PartState::done, first, page_of_parts);
    if (rows.empty()) throw gone_results();
    for (const PartRow& row : rows) each(row);
  }
}

void send_zip(const Job& job, JobStore& store, const SendPart& send) {
  StoredZip zip;
  for_each_part(job, store, [&](const PartRow& row) {
    const auto bytes = store.result(job.id, row.n);
    if (!bytes) throw gone_results();
    send(zip.file(name_in_zip(row), *bytes));
  });
  send(zip.end());
}

void send_list(const Job& job, JobStore& store, const SendPart& send) {
  std::string text = R"({"results":[)";
  for_each_part(job, store, [&](const PartRow& row) {
    if (row.n > 0) text += ',';
    text += to_json(Value::Object{
        {"n", row.n},
        {"href", "/jobs/" + job.id + "/results/" + std::to_string(row.n)},
        {"type", row.type},
        {"bytes", static_cast<double>(row.bytes)},
        {"etag", row.etag},
    });
    if (text.size() < 64 << 10) return;
    send(text);
    text.clear();
  });
  send(text + "]}");
}

Response list_response(const Job& job, bool as_zip, const Request& request, Service& service) {
  Response response{.content_type = as_zip ? "application/zip" : std::string(media::json),
                    .body = ""};
  response.headers = {{"Cache-Control", "no-cache"}};
  response.unsized = request.is_head();
  if (request.is_head()) return response;
  response.parts_deadline = std::chrono::milliseconds(service.config.film_deadline_ms);
  response.parts = [job, as_zip, &store = service.jobs.store()](const SendPart& send) {
    if (as_zip) send_zip(job, store, send);
    else send_list(job, store, send);
  };
  return response;
}

// ---- results --------------------------------------------------------------------------------

Response get_result(const Request& request, const std::string& id, Service& service) {
  const auto asked = read_described<ResultQuery>(query_object<ResultQuery>(request.query()));
  const Job job = known_job(id, request, service);
  const bool is_one = job.kind == "render";
  if (asked.format && is_one)
    throw InputError({FaultKind::conflict, "/format", write_value(*asked.format),
                      "a job of several pictures; this one's result is one"});
  if (auto refused = refusal_of(job)) return std::move(*refused);
  if (!is_last(job.state)) throw not_ready();
  if (!is_one) return list_response(job, asked.format.has_value(), request, service);
  return result_response(part_of_job(job, job.result(), service), job.rays, request, id, service);
}

// The path's name is "ID/results/N".
Response get_nth_result(const Request& request, const std::string& name, Service& service) {
  const Job job = known_job(name.substr(0, name.find('/')), request, service);
  const std::string_view number = std::string_view(name).substr(name.rfind('/') + 1);
  int n = -1;
  const auto read = std::from_chars(number.data(), number.data() + number.size(), n);
  const int count = job.kind == "render" ? 1 : job.parts;
  if (read.ec != std::errc() || read.ptr != number.data() + number.size() || n < 0 || n >= count)
    throw HttpError("not-found", "the job has results from 0 to " + std::to_string(count - 1));
  if (auto refused = refusal_of(job)) return std::move(*refused);
  const bool is_one = job.kind == "render";
  if (is_one && !is_last(job.state)) throw not_ready();
  const PartRow row = part_of_job(job, is_one ? job.result() : n, service);
  RayCounts rays;
  rays.primary = row.rays;
  return result_response(row, is_one ? job.rays : rays_in(row.place).value_or(rays), request,
                         job.id, service);
}

Value parts_schema(Definitions&) {
  const Value text = plain_schema<std::string>(), count = count_schema();
  const Value part = object_schema(
      {{"n", count},
       {"state", plain_schema<PartState>()},
       {"tries", count},
       {"window", list_schema(count), "x0, y0, x1, y1 in the picture", false},
       {"frame", count, "the number of its picture", false},
       {"etag", text, "of what its recipe draws", false},
       {"worker", text, "who has drawn it last", false},
       {"ms", count, "that it took", false},
       {"rays", count, "of all kinds", false},
       {"counted", list_schema(count), "primary, shadow, reflection, refraction and cut", false},
       {"reached", list_schema(plain_schema<double>()),
        "fewest, most and mean samples of a pixel, the largest error, rounds", false}});
  return object_schema({{"parts", list_schema(part)}});
}

Value results_schema(Definitions&) {
  const Value text = plain_schema<std::string>(), count = count_schema();
  return object_schema(
      {{"results",
        list_schema(object_schema(
            {{"n", count}, {"href", text}, {"type", text}, {"bytes", count}, {"etag", text}}))}});
}

}  // namespace

std::vector<Route> job_result_routes(const Segment& id) {
  Answer picture = picture_answer();
  Answer result = picture;
  result.about = "the picture; of several pictures their list, or with format=zip an archive";
  for (Content& each : result.contents)  // an archive may be of several pictures
    if (each.type != "application/zip")
      each.headers = {"Server-Timing", "Tia-Rays", "ETag", "Cache-Status"};
  result.contents.push_back({media::json, results_schema});
  return {{.method = "GET",
           .path = "/jobs/{}/result",
           .name = "get_job_result",
           .about = "what a job has come to, with its ETag; of a failed one its problem",
           .rights = {Right::jobs},
           .pace = Pace::in_turn,
           .handler = get_result,
           .answers = {result, picture_unchanged()},
           .tells_result = true,
           .query = query_parameters<ResultQuery>,
           .segment = id},
          {.method = "GET",
           .path = "/jobs/{}/results/{}",
           .name = "get_job_result_n",
           .about = "one picture of several, as soon as it is drawn",
           .rights = {Right::jobs},
           .pace = Pace::in_turn,
           .handler = get_nth_result,
           .answers = {picture, picture_unchanged()},
           .tells_result = true,
           .segment = id,
           .last_segment = {"n", "its number, from 0"}},
          {.method = "GET",
           .path = "/jobs/{}/parts",
           .name = "get_job_parts",
           .about = "a job's parts, 1000 at a time",
           .rights = {Right::jobs},
           .pace = Pace::in_turn,
           .handler = get_parts,
           .answers = {unstored("the parts", parts_schema)},
           .gives = {media::json},
           .query = query_parameters<PartsQuery>,
           .segment = id}};
}

}  // namespace tia::server
