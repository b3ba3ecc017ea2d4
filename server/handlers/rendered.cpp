// Pictures as answers: tags, caches, what is said of them.
#include "server/handlers/rendered.h"

#include "core/scene/left_out.h"
#include "server/handlers/bodies.h"
#include "server/handlers/handlers.h"
#include "server/handlers/picture_response.h"
#include "server/handlers/stream_response.h"
#include "server/http/headers.h"
#include "server/requests/draw.h"
#include "server/requests/etag.h"
#include "server/requests/gaze_request.h"
#include "server/requests/reached.h"
#include "server/requests/recipe.h"
#include "server/requests/view_texts.h"

namespace tia::server {
namespace {

/// What is said of a picture, whether it is sent or not.
Headers validators(const std::string& etag, const AskedPicture& asked) {
  const bool for_good = asked.picture.v.has_value() && !asked.picture.has_budget();
  Headers headers{{"ETag", etag},
                  {"Cache-Control", for_good ? "public, max-age=31536000, immutable" : "no-cache"}};
  if (asked.accepted) add_vary(headers, "Accept");
  return headers;
}

/// What is said of a picture that is sent, or would be, and not of how it was drawn.
Headers told_of(const Plan& plan) {
  Headers headers;
  if (plan.in_effect.clamp) headers.emplace_back("Tia-Biased", "clamp");
  if (std::string as = disposition_of(plan); !as.empty())
    headers.emplace_back("Content-Disposition", std::move(as));
  std::string ignored;
  for (const LeftOut& each : left_out_by(plan.in_effect.integrator, *plan.scene))
    ignored.append(ignored.empty() ? "" : ", ").append(each.pointer);
  if (!ignored.empty()) headers.emplace_back("Tia-Ignored", ignored);
  if (plan.gaze) headers.emplace_back("Tia-Gaze", gaze_told(plan));
  return headers;
}

Response not_modified() {
  return {.status = 304,
          .content_type = "",
          .body = "",
          .headers = {{"Cache-Status", "Tia; hit; detail=not-modified"}}};
}

Response with(Response response, const Headers& headers) {
  response.headers.insert(response.headers.end(), headers.begin(), headers.end());
  return response;
}

// What a picture with a budget goes by while it is drawn.
std::string wish_of(const PictureRequest& asked, const Plan& plan) {
  return etag_of(plan.recipe + " " + std::to_string(asked.budget_ms.value_or(0)) + " " +
                 std::to_string(asked.max_rays.value_or(0)));
}

// What a picture with a budget is called is known once it is there.
Response rendered_within(const AskedPicture& asked, Plan& plan, double parse_ms, Stopwatch watch,
                         const Request& request, Service& service) {
  const std::string type(media_type_of(plan.format));
  const Headers beside = told_of(plan);
  if (request.is_head()) {
    Response response{.content_type = type, .body = "", .headers = beside, .unsized = true};
    response.headers.emplace_back("Cache-Control", "no-cache");
    if (asked.accepted) add_vary(response.headers, "Accept");
    return response;
  }
  const auto found = picture_of(plan, wish_of(asked.picture, plan), requester_of(request), service);
  Headers headers = validators(found.picture->etag, asked);
  if (std::string to = address_of_reached(request, found.picture->reached->samples); !to.empty())
    headers.emplace_back("Content-Location", std::move(to));
  if (request.method != "POST" && has_already(request, found.picture->etag))
    return with(not_modified(), headers);
  return with(with(picture_response(found, parse_ms, watch.lap_ms()), headers), beside);
}

// The same with as many rays as there is time for, which is another number the next time: so
// nobody may keep it by this name.
AskedPicture in_time(const AskedPicture& asked, const Request& request, Service& service) {
  AskedPicture timed = asked;
  timed.picture.frame_ms = std::nullopt;
  timed.picture.v = std::nullopt;
  check_frame_ms(asked.picture);
  const Plan plan = plan_of(timed.picture, service.rendering, requester_of(request));
  const std::int64_t rays = rays_in_time(*asked.picture.frame_ms, plan, service.costs);
  timed.picture.gaze_rays = std::min(rays, asked.picture.gaze_rays.value_or(rays));
  return timed;
}

Response rendered_as(const AskedPicture& asked, bool may_be_known, Stopwatch watch,
                     const Request& request, Service& service) {
  const Requester requester = requester_of(request);
  Plan plan = plan_of(asked.picture, service.rendering, requester);
  const std::string etag = etag_of(plan.recipe);
  const double parse_ms = watch.lap_ms();
  if (asked.picture.has_budget())
    return rendered_within(asked, plan, parse_ms, watch, request, service);
  const Headers headers = validators(etag, asked), beside = told_of(plan);
  const std::string type(media_type_of(plan.format));
  if (request.method != "POST") {
    const auto* name = std::get_if<std::string>(&asked.picture.scene);
    if (name != nullptr && may_be_known)
      service.targets.keep(KnownTargets::name_of(request), {etag, *name, type, headers, beside});
    if (has_already(request, etag)) return with(not_modified(), headers);
  }
  if (request.is_head())
    return with({.content_type = type, .body = "", .headers = beside, .unsized = true}, headers);
  const auto found = picture_of(plan, etag, requester, service);
  return with(with(picture_response(found, parse_ms, watch.lap_ms()), headers), beside);
}

}  // namespace

// HEAD and If-None-Match need no ray: what the picture is called is known.
Response rendered(const AskedPicture& asked, Stopwatch watch, const Request& request,
                  Service& service) {
  if (!asked.picture.frame_ms) return rendered_as(asked, true, watch, request, service);
  const AskedPicture timed = in_time(asked, request, service);
  Response response = rendered_as(timed, false, watch, request, service);
  const std::string to = address_of_timed(request, *timed.picture.gaze_rays);
  if (!to.empty()) response.headers.emplace_back("Content-Location", to);
  return response;
}

std::optional<Response> known_picture(const Request& request, Service& service) {
  if ((request.method != "GET" && !request.is_head()) || request.path() != "/render")
    return std::nullopt;
  const auto known = service.targets.find(KnownTargets::name_of(request));
  if (!known || !is_at_hand(known->scene, service.rendering)) return std::nullopt;
  if (has_already(request, known->etag)) return with(not_modified(), known->validators);
  if (request.is_head())
    return with({.content_type = known->content_type,
                 .body = "",
                 .headers = known->beside,
                 .unsized = true},
                known->validators);
  const auto found = service.pictures.find(known->etag);
  if (!found) return std::nullopt;
  return with(with(picture_response(*found, 0, 0), known->validators), known->beside);
}

Response shown_while_drawn(PictureRequest asked, Stream stream, const Request& request,
                           Service& service) {
  check_stream(name_of(stream), request, asked.format);
  if (asked.gaze)
    throw InputError({FaultKind::conflict, "/stream", write_value(stream),
                      "no gaze: its picture is there at once, or not at all"});
  /// Kept: what the drawing needs of its request, which has been read.
  struct Kept {
    PictureRequest asked;
    Plan plan;
  };
  const Requester requester = requester_of(request);
  const auto kept = std::make_shared<Kept>(Kept{std::move(asked), {}});
  kept->plan = plan_of(kept->asked, service.rendering, requester);
  const std::string tag = etag_of(kept->plan.recipe);
  const std::string wish = kept->asked.has_budget() ? wish_of(kept->asked, kept->plan) : tag;
  const auto drawing = [kept, wish, requester, &service](const Showing::See& see) {
    return picture_of(kept->plan, wish, requester, service, see);
  };
  return with(streamed(stream, tag, drawing, request, service), told_of(kept->plan));
}

Answer picture_answer() {
  Answer answer{.about = "the picture"};
  for (const FormatRow& row : formats) answer.contents.push_back({row.media_type});
  answer.headers = {"Server-Timing", "Tia-Rays",         "Cache-Control",       "ETag",
                    "Cache-Status",  "Content-Location", "Tia-Samples",         "Tia-Noise",
                    "Tia-Biased",    "Tia-Ignored",      "Content-Disposition", "Tia-Gaze"};
  return answer;
}

Answer shown_answer(Answer answer) {
  for (Content& each : answer.contents)
    each.headers = {"Server-Timing", "Tia-Rays", "ETag", "Cache-Status"};
  for (Content& each : stream_contents()) answer.contents.push_back(std::move(each));
  answer.headers.push_back("X-Accel-Buffering");
  return answer;
}

Answer picture_unchanged() {
  return {304,
          "If-None-Match names the picture's tag: no ray was traced",
          {},
          {"ETag", "Cache-Control", "Cache-Status", "Content-Location"}};
}

}  // namespace tia::server
