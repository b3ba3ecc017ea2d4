// /film: parameters in, a film out, sent while it is drawn.
#include "core/version.h"
#include "server/contract/answers.h"
#include "server/contract/parameters.h"
#include "server/contract/query_parameters.h"
#include "server/handlers/bodies.h"
#include "server/handlers/handlers.h"
#include "server/handlers/live_film.h"
#include "server/handlers/mixed_parts.h"
#include "server/http/headers.h"
#include "server/requests/accept.h"
#include "server/requests/etag.h"
#include "server/requests/shooting.h"
#include "server/requests/with_memory.h"

namespace tia::server {
namespace {

/// AskedFilm: what is asked for, and whether Accept has chosen the format.
struct AskedFilm {
  FilmRequest film;
  bool accepted = false;
};

AskedFilm film_asked_in(Value parameters, const Request& request) {
  const bool accepted = choose_format(parameters, request, film_formats);
  return {read_described<FilmRequest>(parameters, {}, request.stop), accepted};
}

/// Filming: one film that is being drawn, with what it needs of its request.
class Filming {
 public:
  /// Errors: as film_plan_of.
  Filming(FilmRequest what, const Request& request, Service& by)
      : asked(std::move(what)),
        requester(requester_of(request)),
        service(by),
        film(film_plan_of(asked, by.rendering, requester)) {}

  void operator()(const SendPart& send);

  FilmRequest asked;
  const Requester requester;
  Service& service;
  const FilmPlan film;

 private:
  SharedPicture drawn(FilmFrames& frames, Plan& plan, const Shot& shot, Flow& flow);
  std::size_t pixels() const {
    return static_cast<std::size_t>(film.width) * static_cast<std::size_t>(film.height);
  }
  std::int64_t encoder_bytes() const;
};

std::int64_t Filming::encoder_bytes() const {
  const MemoryCost* const cost = row_of(asked.film_format).cost;
  return cost == nullptr ? 0 : memory_cost::encoder.bytes + memory_for(*cost, pixels());
}

// Once for all who ask for the frame later, but not together with who asks now: they may wait for
// the place that this has.
SharedPicture Filming::drawn(FilmFrames& frames, Plan& plan, const Shot& shot, Flow& flow) {
  if (!plan.takes_codes)
    if (const auto found = service.pictures.find(shot.etag)) return found->picture;
  plan.options.flow = &flow;
  if (encoder_bytes() == 0) settle_memory();
  const auto attempt = [&] {
    Picture picture = frames.draw(plan, service.rendering, requester.stop);
    service.costs.learn(plan.cost_key, plan.rays(), picture.trace_seconds, true);
    service.metrics.count(picture.rays, picture.timing);
    service.access.charge(requester.key, picture.rays.all());
    return picture;
  };
  const auto picture = std::make_shared<const Picture>(with_memory_for(attempt, requester.stop));
  if (!plan.takes_codes) service.pictures.add(shot.etag, picture);
  return picture;
}

// With one ticket for heavy work from its first frame to its last. It may take longer than others
// would wait for: threads go round by turns. What it needs beside an encoder that is large it keeps
// as well: a film that has begun does not wait for what its client asks for later.
void Filming::operator()(const SendPart& send) {
  MemoryClaim claim(service.memory, requester.client);
  const ClaimScope scope(&claim);
  const auto ticket = service.admission.enter({.seconds = 2 * Cost::most_light_seconds},
                                              requester.client, requester.stop);
  const std::int64_t foreseen = encoder_bytes();
  if (foreseen > 0)
    claim.reserve(foreseen + memory_for(memory_cost::alpha, pixels()), "the film", requester.stop);
  ForeseenMemory encoders(claim, foreseen, "the film", requester.stop);
  Flow flow{requester.number()};
  flow.is_long = true;
  const Crew crew{
      [&](FilmFrames& frames, Plan& plan, const Shot& shot) {
        return drawn(frames, plan, shot, flow);
      },
      [&](const std::function<void()>& work) {
        encoders.spend([&] { service.rendering.pool.alone(work, requester.stop, &flow); });
      },
      send.next};
  shoot(asked, film, service.rendering, requester, crew);
}

std::string frames_told(const FilmPlan& film) {
  const std::size_t drawn = film.shots.size();
  return "drawn=" + std::to_string(drawn) +
         ", shared=" + std::to_string(static_cast<std::size_t>(film.frames) - drawn) +
         (film.moves ? "" : ", still");
}

// Of what is live there is no tag: it is another one each time.
Response played(const std::shared_ptr<Filming>& filming, bool accepted, const Request& request,
                Service& service) {
  const auto show = [filming](LivePictures& pictures) {
    play(filming->asked, filming->film, filming->service.rendering, filming->requester, pictures);
  };
  Response response = live_response(show, request, service);
  if (accepted) add_vary(response.headers, "Accept");
  response.headers.emplace_back("Tia-Frames", frames_told(filming->film));
  response.unsized = request.is_head();
  if (request.is_head()) response.parts = nullptr;
  return response;
}

Response filmed(AskedFilm asked, const Request& request, Service& service) {
  const auto filming = std::make_shared<Filming>(std::move(asked.film), request, service);
  const FilmPlan& film = filming->film;
  if (row_of(filming->asked.film_format).is_live)
    return played(filming, asked.accepted, request, service);
  Response response{.content_type = "", .body = ""};
  response.headers = {
      {"ETag", film.etag},
      {"Cache-Control", filming->asked.v ? "public, max-age=31536000, immutable" : "no-cache"}};
  if (asked.accepted) add_vary(response.headers, "Accept");
  if (request.method != "POST" && has_already(request, film.etag)) {
    response.status = 304;
    return response;
  }
  response.content_type = row_of(filming->asked.film_format).media_type;
  response.headers.emplace_back("Tia-Frames", frames_told(film));
  response.headers.emplace_back("X-Accel-Buffering", "no");
  response.unsized = request.is_head();
  if (request.is_head()) return response;
  service.access.check_rays(filming->requester.key, film.rays);
  response.parts_deadline = std::chrono::milliseconds(service.config.film_deadline_ms);
  response.parts = [filming](const SendPart& send) { (*filming)(send); };
  return response;
}

Response get_film(const Request& request, const std::string&, Service& service) {
  const auto read = [&] {
    return film_asked_in(query_object<FilmRequest>(request.query()), request);
  };
  return filmed(read_query(request, service, read), request, service);
}

Response post_film(const Request& request, const std::string&, Service& service) {
  refuse_query(request);
  const auto read = [&] {
    return film_asked_in(
        body_json(request, "the parameters as a JSON object, such as {\"scene\":\"lamp-round\"}",
                  service.config.json_limits()),
        request);
  };
  return filmed(read_body(request, service, read), request, service);
}

Answer film_answer() {
  Answer answer{.about = "the film; one that is not whole ends without the last chunk"};
  for (const FilmFormatRow& row : film_formats) {
    answer.contents.push_back({row.is_live ? mixed_parts::media_type : row.media_type});
    if (!row.is_live) answer.contents.back().headers = {"ETag"};
  }
  answer.headers = {"ETag", "Cache-Control", "Tia-Frames", "X-Accel-Buffering"};
  return answer;
}

}  // namespace

std::vector<Route> film_routes() {
  return {{.method = "GET",
           .path = "/film",
           .name = "get_film",
           .about = "an animated scene as a film, sent while it is drawn; a scene that does not "
                    "move is one frame",
           .rights = {Right::render},
           .pace = Pace::in_turn,
           .handler = get_film,
           .answers = {film_answer(),
                       {304,
                        "If-None-Match names the film's tag: no ray was traced",
                        {},
                        {"ETag", "Cache-Control"}}},
           .chooses = true,
           .query = query_parameters<FilmRequest>,
           .examples = {"/film?scene=lamp-round&width=64&height=48&to=0.5"}},
          {.method = "POST",
           .path = "/film",
           .name = "post_film",
           .about = "the same, parameters as a JSON object",
           .rights = {Right::render},
           .pace = Pace::in_turn,
           .handler = post_film,
           .answers = {film_answer()},
           .chooses = true,
           .body = {{media::json,
                     schema_for<FilmRequest>,
                     {{"the first half second of a lamp that goes round", R"({
  "scene": "lamp-round", "width": 64, "height": 48, "to": 0.5})"}}}}}};
}

}  // namespace tia::server
