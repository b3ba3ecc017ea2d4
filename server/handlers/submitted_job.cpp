#include "server/handlers/submitted_job.h"

#include <sys/random.h>

#include <algorithm>
#include <array>
#include <set>

#include "core/input/json.h"
#include "core/input/object_schema.h"
#include "core/scene/read_scene.h"
#include "core/version.h"
#include "server/contract/answers.h"
#include "server/contract/problem.h"
#include "server/contract/problem_table.h"
#include "server/handlers/bodies.h"
#include "server/jobs/job_json.h"
#include "server/jobs/job_problems.h"
#include "server/jobs/jobs.h"
#include "server/requests/preferences.h"
#include "server/requests/recipe.h"
#include "server/stores/digest.h"

namespace tia::server {
namespace {

// 128 random bits in base32 (RFC 4648, 6), in lower case.
std::string random_job_id() {
  std::array<unsigned char, 16> bytes{};
  if (getrandom(bytes.data(), bytes.size(), 0) != static_cast<ssize_t>(bytes.size()))
    throw StorageError("the system has no random bytes");
  std::string id;
  unsigned bits = 0, count = 0;
  for (const unsigned char byte : bytes) {
    bits = bits << 8U | byte, count += 8;
    for (; count >= 5; count -= 5)
      id += "abcdefghijklmnopqrstuvwxyz234567"[bits >> (count - 5) & 31];
  }
  return id + "abcdefghijklmnopqrstuvwxyz234567"[bits << (5 - count) & 31];
}

std::string key_in(const Request& request) {
  const std::string_view key = request.header("Idempotency-Key");
  for (const char c : key)
    if (c <= ' ' || c > '~' || key.size() > 255)
      throw InputError({FaultKind::out_of_range, "/Idempotency-Key", excerpt(Value(key)),
                        "1 to 255 visible characters of ASCII"});
  return std::string(key);
}

void check_job_rays(double rays, const JobTerms& terms, const Config& config) {
  const std::int64_t own = terms.max_rays.value_or(config.max_job_rays);
  const bool is_own = own <= config.max_job_rays;
  if (rays <= static_cast<double>(std::min(own, config.max_job_rays))) return;
  throw InputError({FaultKind::limit, is_own && terms.max_rays ? "/max_rays" : "",
                    Value(number_text(rays) + " rays from the eye alone"),
                    is_own && terms.max_rays ? "as many as the job takes in any case"
                                             : "at most " + std::to_string(config.max_job_rays) +
                                                   " rays of a job (option TIA_MAX_JOB_RAYS)"});
}

JobPlan planned(const JobRequest& asked, const JobHost& host, const Requester& requester) {
  try {
    return job_kind(asked.terms.kind).plan(asked, host, requester);
  } catch (const InputError& error) {
    throw by_options_of_jobs(error);
  }
}

// A key's jobs have its priority at most, and it bounds how many they are and how much they keep.
void bound_by(const KeyEntry& entry, NewJob& job) {
  job.priority = std::min(job.priority, static_cast<Priority>(entry.priority));
  job.limits = {entry.jobs, entry.kept_bytes};
}

NewJob new_job(const JobRequest& asked, JobPlan plan, std::string_view body, const Request& request,
               const Config& config, TimeMs now) {
  const JobTerms& terms = asked.terms;
  NewJob job;
  job.id = random_job_id();
  job.owner = owner_of(request.key, share_of(request.peer));
  job.key = key_in(request);
  job.digest = sha256_hex(body);
  job.kind = terms.kind;
  job.name = terms.name;
  job.priority = terms.priority;
  job.version = full_version();
  job.request = std::move(plan.request);
  job.plan = std::move(plan.plan);
  job.parts = plan.parts;
  job.joins = plan.joins;
  job.max_rays = std::min(terms.max_rays.value_or(config.max_job_rays), config.max_job_rays);
  job.result_bytes = plan.result_bytes;
  job.deadline = terms.deadline_s ? now + 1000 * TimeMs{*terms.deadline_s} : 0;
  return job;
}

// For those who draw it and have only the gallery: what it names that was sent to this server.
std::string lent_things(const std::set<std::string>& named, Service& service, TimeMs now) {
  std::string needs;
  for (const std::string& name : named) {
    const std::string id = name.substr(name.find('/') + 1);
    service.jobs.store().lend(
        name,
        [&] {
          if (name.starts_with("scenes/"))
            if (const KnownScene scene = service.rendering.kept.find(id))
              return canonical_text(*scene);
          if (const auto packed = service.models.packed(id)) return *packed;
          throw StorageError("what a job names has made room for others just now: " + name);
        },
        now);
    needs += needs.empty() ? name : ' ' + name;
  }
  return needs;
}

Job kept(const NewJob& job, const std::string& key, TimeMs now, Service& service) {
  try {
    return service.jobs.store().submit(job, now);
  } catch (const AccessRefusal& refusal) {
    service.metrics.count_refusal(key, refusal.why());
    throw;
  }
}

}  // namespace

Response submitted(const JobRequest& asked, std::string_view body, const Request& request,
                   Service& service) {
  Jobs& jobs = service.jobs;
  JobHost host = jobs.host();
  std::set<std::string> named;
  if (jobs.store().is_shared()) host.context.named = &named;
  JobPlan plan = planned(asked, host, requester_of(request));
  check_job_rays(plan.rays, asked.terms, service.config);
  service.access.check_rays(request.key, plan.rays);
  const TimeMs now = Runner::now();
  NewJob made = new_job(asked, std::move(plan), body, request, service.config, now);
  made.needs = lent_things(named, service, now);
  if (const auto entry = service.access.entry_called(request.key)) bound_by(*entry, made);
  const Job job = kept(made, request.key, now, service);
  jobs.start();
  return {
      .status = 202,
      .content_type = std::string(media::json),
      .body = to_json(job_status(job, now, jobs.store().is_durable())),
      .headers = {
          {"Location", "/jobs/" + job.id}, {"Retry-After", "1"}, {"Cache-Control", "no-store"}}};
}

bool prefers_job(const Request& request, const PictureRequest& picture) {
  return request.method == "POST" && !picture.has_budget() && preferences_of(request).respond_async;
}

std::optional<Response> submitted_picture(const PictureRequest& picture, const Request& request,
                                          Service& service) {
  const Plan plan = plan_of(picture, service.jobs.host().context, requester_of(request));
  if (told_scene_of(plan).objects.bytes > most_told_bytes) return std::nullopt;
  const Value recipe = parse_json(plan.recipe, {.values = 10'000'000, .option = ""});
  JobRequest asked;
  asked.terms.kind = "render";
  asked.request = *find(*recipe.as<Value::Object>(), "request");
  Response response = submitted(asked, plan.recipe, request, service);
  response.headers.emplace_back("Preference-Applied", "respond-async");
  return response;
}

Answer submitted_answer(std::string_view about) {
  return {202,
          about,
          {{media::json, job_status_schema}},
          {"Location", "Retry-After", "Cache-Control", "Preference-Applied"}};
}

Value job_status_schema(Definitions& named) {
  const Value problem = problem_schema(named);
  return schema_called("job", named, [&] {
    const Value text = plain_schema<std::string>(), maybe = nullable_schema(text);
    const Value count = count_schema(), number = plain_schema<double>(Spec{.min = 0});
    const Value progress = object_schema({{"parts", count_schema(1)},
                                          {"done", count},
                                          {"failed", count},
                                          {"rays", number},
                                          {"remaining_s", nullable_schema(number)}});
    const Value result = object_schema({{"href", text},
                                        {"type", text},
                                        {"bytes", number, "of one picture", false},
                                        {"etag", text, "of one picture", false}});
    return object_schema(
        {{"id", text},
         {"kind", text},
         {"name", text},
         {"state", plain_schema<JobState>()},
         {"priority", plain_schema<Priority>()},
         {"version", text, "that draws it"},
         {"durable", plain_schema<bool>(), "whether it outlives the server's process"},
         {"created", text, "RFC 3339, as all times"},
         {"started", maybe},
         {"finished", maybe},
         {"expires", maybe, "until when its results are kept"},
         {"progress", progress},
         {"result", nullable_schema(result)},
         {"problem", nullable_schema(problem), "why it has failed"}});
  });
}

}  // namespace tia::server
