// /render: parameters in, picture out.
#include "core/models/multipart.h"
#include "server/contract/answers.h"
#include "server/contract/parameters.h"
#include "server/contract/query_parameters.h"
#include "server/handlers/bodies.h"
#include "server/handlers/handlers.h"
#include "server/handlers/rendered.h"
#include "server/handlers/sent_model.h"
#include "server/handlers/submitted_job.h"
#include "server/operation/timing.h"
#include "server/requests/accept.h"
#include "server/requests/drake_form.h"
#include "server/requests/recipe.h"

namespace tia::server {
namespace {

/// AskedRender: what is asked for, and whether Accept has chosen the format.
struct AskedRender {
  RenderRequest picture;
  bool accepted = false;
};

// Where no format is asked for, Accept chooses it, but for streams, which have one. The JSON tree
// is freed here, before the picture takes memory.
AskedRender asked_in(Value parameters, const Request& request) {
  const auto* object = parameters.as<Value::Object>();
  const bool is_stream = object != nullptr && find(*object, "stream") != nullptr;
  const bool accepted = !is_stream && choose_format(parameters, request, formats);
  return {read_described<RenderRequest>(parameters, {}, request.stop), accepted};
}

Response answered(AskedRender asked, const Stopwatch& watch, const Request& request,
                  Service& service) {
  if (!asked.picture.stream && prefers_job(request, asked.picture))
    if (auto job = submitted_picture(asked.picture, request, service)) return std::move(*job);
  if (asked.picture.stream == RenderStream::mjpeg)
    return shown_live(std::move(asked.picture), request, service);
  if (asked.picture.stream) {
    const bool is_told = asked.picture.stream == RenderStream::events;
    return shown_while_drawn(std::move(asked.picture), is_told ? Stream::events : Stream::multipart,
                             request, service);
  }
  return rendered({std::move(asked.picture), asked.accepted}, watch, request, service);
}

AskedRender asked_in_picture(const Request& request, Service& service) {
  refuse_query(request);
  return read_recipe_of_body(request, service, [&](Recipe recipe) {
    check_version(recipe);
    return asked_in(std::move(recipe.request), request);
  });
}

AskedRender asked_in_body(const Request& request, Service& service) {
  if (is_png(request.body)) return asked_in_picture(request, service);
  return read_body(request, service, [&] {
    return asked_in(body_json(request,
                              "the parameters as a JSON object, such as {\"key\":\"a\"}, or a PNG "
                              "that this server has sent",
                              service.config.json_limits()),
                    request);
  });
}

Response get_render(const Request& request, const std::string&, Service& service) {
  const Stopwatch watch;
  const auto read = [&] { return asked_in(query_object<RenderRequest>(request.query()), request); };
  return answered(read_query(request, service, read), watch, request, service);
}

Response post_render(const Request& request, const std::string&, Service& service) {
  const Stopwatch watch;
  if (const auto boundary = boundary_of(request.header("Content-Type")))
    return rendered_form(request, *boundary, watch, service);
  return answered(asked_in_body(request, service), watch, request, service);
}

std::vector<Content> picture_body() {
  return {{media::json,
           schema_for<RenderRequest>,
           {{"the first picture, lit from the left", R"({"key": "a"})"},
            {"a scene of one's own", R"({"width": 320, "height": 240, "scene": {
  "background": [0.1, 0.2, 0.4],
  "objects": [{"type": "sphere", "center": [0, 0, -9], "radius": 1.5}],
  "lights": [{"type": "point", "position": [4, 6, -3]}]}})"}}},
          {media::png},
          {"multipart/form-data", schema_for<DrakeForm>}};
}

}  // namespace

std::vector<Route> render_routes() {
  return {
      {.method = "GET",
       .path = "/render",
       .name = "get_render",
       .about = "a picture; no parameter is required",
       .rights = {Right::render},
       .pace = Pace::in_turn,
       .handler = get_render,
       .answers = {shown_answer(picture_answer()), picture_unchanged()},
       .chooses = true,
       .query = query_parameters<RenderRequest>,
       .examples = {"/render", "/render?key=a&width=320&height=240",
                    "/render?light=-5,12,-8&format=pfm",
                    "/render?scene=cornell-light&width=64&height=64&stream=events"}},
      {.method = "POST",
       .path = "/render",
       .name = "post_render",
       .about = "the same, parameters as a JSON object; or again, from a PNG that was sent; or, "
                "of a form with a glTF file, as Drake's RenderEngineGltfClient sees it, with "
                "which alone parameters may stand in the query",
       .rights = {Right::render},
       .pace = Pace::in_turn,
       .handler = post_render,
       .answers = {shown_answer(picture_answer()),
                   submitted_answer("with Prefer: respond-async a job draws it")},
       .chooses = true,
       .query = query_parameters<DrakeQuery>,
       .body = picture_body(),
       .form_limit = model_limit}};
}

}  // namespace tia::server
