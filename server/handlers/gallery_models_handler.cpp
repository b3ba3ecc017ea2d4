// The gallery's models, and a model's file as a scene.
#include "core/scene/model_scene.h"
#include "core/scene/read_scene.h"
#include "server/contract/answers.h"
#include "server/handlers/bodies.h"
#include "server/handlers/handlers.h"
#include "server/handlers/known_model.h"
#include "server/requests/tagged_body.h"
#include "server/requests/view_request.h"
#include "server/stores/gallery_models.h"

namespace tia::server {
namespace {

Response get_models(const Request& request, const std::string&, Service&) {
  static const std::string text = gallery_models_listing();
  static const TaggedBody tagged(text);
  return tagged_response(request, tagged, media::json);
}

Response get_model_scene(const Request& request, const std::string& id, Service& service) {
  return told_of_model(request, id, service, [&](const KnownModel& known) {
    const Requester requester = requester_of(request);
    // Of the aspect that a picture has of which nothing is said.
    const ViewRequest usual;
    const double aspect = static_cast<double>(usual.width) / usual.height;
    return service.rendering.go_through(bytes_of(*known.model), requester, [&] {
      return canonical_text(model_scene(known.model, id, aspect, requester.stop));
    });
  });
}

}  // namespace

std::vector<Route> gallery_model_routes() {
  return {{.method = "GET",
           .path = "/models/{}/scene",
           .name = "get_model_scene",
           .about = "a model's file as a scene that /render draws: an object of type model, whose "
                    "own fields place and pose it, with the file's first camera and its lights, "
                    "candela and lux as W/sr and W/m^2; else a camera that frames it, and light "
                    "from all around",
           .rights = {Right::models},
           .pace = Pace::in_turn,
           .handler = get_model_scene,
           .answers = tagged("the scene, fields at their defaults left out (RFC 8785)",
                             {{media::json, schema_for<Scene>}}),
           .gives = {media::json},
           .segment = {"id", "a name of the gallery's models, or the id of a kept one"},
           .examples = {"/models/lantern/scene"}},
          {.method = "GET",
           .path = "/models",
           .name = "get_models",
           .about = "the gallery's models: names, ids and formats",
           .rights = {Right::models},
           .handler = get_models,
           .answers = tagged("the models that come with the server",
                             {{media::json, gallery_models_schema}}),
           .gives = {media::json}}};
}

}  // namespace tia::server
