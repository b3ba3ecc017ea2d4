// Pictures of a scene that is changed while they are looked at: /render?stream=mjpeg shows them,
// POST /streams/{id} changes it.
#include <algorithm>

#include "core/film/jpeg.h"
#include "core/input/json.h"
#include "server/contract/answers.h"
#include "server/contract/parameters.h"
#include "server/handlers/bodies.h"
#include "server/handlers/handlers.h"
#include "server/handlers/live_pictures.h"
#include "server/handlers/rendered.h"
#include "server/handlers/stream_response.h"
#include "server/http/error.h"
#include "server/requests/draw.h"
#include "server/requests/stream_change.h"

namespace tia::server {
namespace {

// Errors: as plan_of; InputError (conflict) where a JPEG cannot be of it.
Plan live_plan_of(const RenderRequest& asked, const Requester& requester, Service& service) {
  Plan plan = plan_of(asked, service.rendering, requester);
  plan.takes_codes = true;
  const auto refuse = [](const char* allowed) {
    throw InputError({FaultKind::conflict, "/stream", Value("mjpeg"), allowed});
  };
  if (is_transparent(*plan.scene, plan.options.integrator))
    refuse("events or multipart, whose pictures have alpha, or a backdrop that is a colour");
  if (std::max(plan.window.width(), plan.window.height()) > longest_jpeg_side)
    refuse("sides of at most 65500 pixels");
  return plan;
}

using OpenedScene = std::shared_ptr<const LiveScenes::Opened>;

// The newest is drawn, whatever has come before it meanwhile.
void show_newest(const OpenedScene& opened, LivePictures& pictures, const Requester& requester,
                 Service& service) {
  constexpr std::chrono::milliseconds look{500};
  LiveScene& scene = *opened->scene;
  for (int shown = -1;;) {
    const auto next = scene.newer_than(shown, Clock::now() + look, requester.stop);
    end_if_asked(requester.stop);
    if (scene.is_retired())
      throw HttpError("busy", "a newer live stream of this client has taken this one's place",
                      {{"Retry-After", "1"}});
    pictures.look_round();
    if (!next) continue;
    Plan plan = live_plan_of(*next->request, requester, service);
    const auto jpeg = pictures.draw(plan);
    if (!jpeg) continue;
    pictures.show(*jpeg,
                  {{"Tia-Stream", opened->id}, {"Tia-Change", std::to_string(next->change)}});
    shown = next->change;
  }
}

Response post_stream(const Request& request, const std::string& id, Service& service) {
  refuse_query(request);
  const auto scene = service.live_scenes.find(id);
  if (!scene) throw HttpError("not-found", "no live stream has this id; it ends with its client");
  const StreamChange change = read_body(request, service, [&] {
    const char* const what = "what is to change as a JSON object, such as {\"key\":\"a\"}";
    return read_described<StreamChange>(body_json(request, what, service.config.json_limits()), {},
                                        request.stop);
  });
  const Requester requester = requester_of(request);
  const int number = scene->change([&](const RenderRequest& now) {
    RenderRequest next = changed_by(change, now, service.rendering, requester);
    static_cast<void>(live_plan_of(next, requester, service));  // what is wrong is told here
    return next;
  });
  return {.content_type = "application/json",
          .body = to_json(Value::Object{{"change", static_cast<double>(number)}}),
          .headers = {{"Cache-Control", "no-store"}}};
}

/// StreamChanged: what POST /streams/{id} answers.
struct StreamChanged {
  static constexpr std::string_view schema_name = "stream_changed";
  int change = 1;
  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("change", &StreamChanged::change,
          Spec{.about = "the change's number: the parts whose Tia-Change is that or more show it",
               .min = 1,
               .required = true});
  }
};

}  // namespace

Response shown_live(RenderRequest asked, const Request& request, Service& service) {
  check_stream("mjpeg", request, asked.format);
  const Requester requester = requester_of(request);
  static_cast<void>(live_plan_of(asked, requester, service));
  const auto opened = service.live_scenes.open(requester.client, std::move(asked));
  const auto show = [opened, requester, &service](LivePictures& pictures) {
    show_newest(opened, pictures, requester, service);
  };
  return live_response(show, request, service);
}

std::vector<Route> live_routes() {
  return {{.method = "POST",
           .path = "/streams/{}",
           .name = "change_stream",
           .about = "changes what a live stream of /render shows: its next picture is of all that "
                    "has come by then",
           .rights = {Right::render},
           .pace = Pace::in_turn,
           .handler = post_stream,
           .answers = {unstored("the change's number", schema_for<StreamChanged>)},
           .gives = {media::json},
           .body = {{media::json,
                     schema_for<StreamChange>,
                     {{"another light", R"({"light": [5, 12, -8]})"}}}},
           .segment = {"id", "the Tia-Stream of the stream's first part"}}};
}

}  // namespace tia::server
