// /still: a model in, its picture out.
#include "core/scene/read_scene.h"
#include "server/contract/answers.h"
#include "server/contract/parameters.h"
#include "server/contract/query_parameters.h"
#include "server/handlers/bodies.h"
#include "server/handlers/handlers.h"
#include "server/handlers/picture_response.h"
#include "server/handlers/rendered.h"
#include "server/handlers/sent_model.h"
#include "server/handlers/submitted_job.h"
#include "server/http/head.h"
#include "server/http/headers.h"
#include "server/requests/accept.h"
#include "server/requests/reached.h"
#include "server/requests/recipe.h"
#include "server/requests/still_query.h"

namespace tia::server {
namespace {

/// AskedStill: the parameters, and whether Accept has chosen the format.
template <class Query>
struct AskedStill {
  Query query;
  bool accepted = false;
};

template <class Query>
AskedStill<Query> asked_in_query(const Request& request, Service& service) {
  return read_query(request, service, [&] {
    Value parameters = query_object<Query>(request.query());
    const Value* as = find(*parameters.template as<Value::Object>(), "as");
    const bool as_scene = as != nullptr && *as == Value(name_of(StillAs::scene));
    if (as_scene) static_cast<void>(preferred_type(request, {media::json}));
    const bool is_stream = find(*parameters.template as<Value::Object>(), "stream") != nullptr;
    const bool accepted = !as_scene && !is_stream && choose_format(parameters, request, formats);
    return AskedStill<Query>{read_described<Query>(parameters, {}, request.stop), accepted};
  });
}

// It is made for each request, and took no ray.
Response scene_response(const Scene& scene, const Stopwatch& watch) {
  auto told = std::make_shared<Picture>();
  told->bytes = canonical_text(scene);
  told->media_type = media::json;
  Stopwatch since = watch;
  Response response = picture_response({told, Source::drawn, false}, since.lap_ms(), 0);
  response.headers.emplace_back("ETag", etag_of(told->bytes));
  response.headers.emplace_back("Cache-Control", "no-cache");
  return response;
}

template <class Query>
Response shown(const AskedStill<Query>& asked, const SharedModel& model, const Stopwatch& watch,
               const Request& request, Service& service) {
  const Requester requester = requester_of(request);
  Scene scene = service.rendering.go_through(
      bytes_of(*model), requester, [&] { return still_of(asked.query, model, requester.stop); });
  if (asked.query.as == StillAs::scene) return scene_response(scene, watch);
  if (asked.query.stream) {
    PictureRequest drawn = asked.query;
    drawn.scene = std::move(scene);
    drawn.along = {asked.query.id, model};
    return shown_while_drawn(std::move(drawn), *asked.query.stream, request, service);
  }
  AskedPicture picture{asked.query, asked.accepted};
  picture.picture.scene = std::move(scene);
  picture.picture.along = {asked.query.id, model};
  if (prefers_job(request, picture.picture))
    if (auto job = submitted_picture(picture.picture, request, service)) return std::move(*job);
  return rendered(picture, watch, request, service);
}

Response get_still(const Request& request, const std::string&, Service& service) {
  const Stopwatch watch;
  const auto asked = asked_in_query<StillQuery>(request, service);
  const std::string& id = asked.query.id;
  const SharedModel model = find_model(id, service.rendering, requester_of(request));
  if (!model)
    throw InputError(
        {FaultKind::missing, "/model", excerpt(Value(id)),
         "a name of the gallery's models, or the id of one that is kept; send it to POST /models"});
  return shown(asked, model, watch, request, service);
}

// Where the same is without sending the model; none where that would be too long.
void tell_address(const std::string& id, const Request& request, Response& response) {
  std::string address =
      "/still?" + query_without(request.query(), {"main", "stream"}) + "model=" + id;
  if (address.size() < longest_target)
    response.headers.emplace_back("Content-Location", std::move(address));
}

Response post_still(const Request& request, const std::string&, Service& service) {
  const Stopwatch watch;
  check_length(request.body_bytes(), model_limit(service.config));
  auto asked = asked_in_query<SentStillQuery>(request, service);
  const auto [id, kept] = keep_sent_model(request, asked.query.main, service);
  asked.query.id = id;
  Response response = shown(asked, kept.known.model, watch, request, service);
  if (!asked.query.has_budget()) tell_address(id, request, response);
  return response;
}

Answer still_answer() {
  Answer answer = shown_answer(picture_answer());
  answer.about = "the picture; with as=scene its scene";
  Content scene{media::json, schema_for<Scene>};
  scene.headers = answer.contents.front().headers;
  answer.contents.push_back(std::move(scene));
  return answer;
}

}  // namespace

std::vector<Route> still_routes() {
  return {
      {.method = "GET",
       .path = "/still",
       .name = "get_still",
       .about = "the picture of a kept model: framed, in a studio's light",
       .rights = {Right::render},
       .pace = Pace::in_turn,
       .handler = get_still,
       .answers = {still_answer(), picture_unchanged()},
       .chooses = true,
       .query = query_parameters<StillQuery>},
      {.method = "POST",
       .path = "/still",
       .name = "post_still",
       .about = "the picture of the model that the body is, which is kept as by POST /models",
       .rights = {Right::render, Right::models},
       .pace = Pace::in_turn,
       .handler = post_still,
       .answers = {still_answer(), submitted_answer("with Prefer: respond-async a job draws it")},
       .chooses = true,
       .query = query_parameters<SentStillQuery>,
       .body = model_bodies(),
       .body_limit = model_limit,
       .keeps_body = true}};
}

}  // namespace tia::server
