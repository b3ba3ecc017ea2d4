// /models: models that clients send to be kept, and by name those of the gallery.
#include "core/input/object_schema.h"
#include "server/contract/answers.h"
#include "server/contract/parameters.h"
#include "server/contract/query_parameters.h"
#include "server/handlers/bodies.h"
#include "server/handlers/handlers.h"
#include "server/handlers/known_model.h"
#include "server/handlers/sent_model.h"
#include "server/requests/model_body.h"

namespace tia::server {
namespace {

Response post_model(const Request& request, const std::string&, Service& service) {
  check_length(request.body_bytes(), model_limit(service.config));
  const auto query = read_described<ModelQuery>(query_object<ModelQuery>(request.query()));
  const auto [id, kept] = keep_sent_model(request, query.main, service);
  return {.status = kept.is_new ? 201 : 200,
          .content_type = "application/json",
          .body = *kept.known.text,
          .headers = {{"Location", "/models/" + id}, {"Cache-Control", "no-store"}}};
}

Response get_model(const Request& request, const std::string& id, Service& service) {
  return told_of_model(request, id, service, [](const KnownModel& known) { return *known.text; });
}

Response delete_model(const Request& request, const std::string& id, Service& service) {
  refuse_query(request);
  if (!service.models.remove(id))
    throw HttpError("not-found", "no model has been sent that has this id; the gallery's stay");
  return {.status = 204, .content_type = "", .body = ""};
}

// ---- as the documents have it -------------------------------------------------------------------

Value any_object() { return Value::Object{{"type", "object"}}; }
Value objects() { return list_schema(any_object()); }

Value point_schema() { return list_schema(plain_schema<double>()); }
Value bounds_schema() {
  return nullable_schema(object_schema({{"min", point_schema()}, {"max", point_schema()}}));
}
Value file_schema() {
  return object_schema(
      {{"bytes", count_schema()},
       {"path", plain_schema<std::string>(), "none of one that came alone", false}});
}
Value warning_schema() {
  const Value text = plain_schema<std::string>();
  return object_schema({{"text", text, "what of the file is not taken"},
                        {"pointer", text, "where in a JSON file", false},
                        {"line", count_schema(1), "where in a file of lines", false}});
}

Value model_schema(Definitions& named) {
  return schema_called("model_description", named, [] {
    const Value text = plain_schema<std::string>(), count = count_schema();
    return object_schema(
        {{"id", text, "SHA-256 of the file; of several, of their names and hashes"},
         {"bytes", count, "of all files"},
         {"files", list_schema(file_schema())},
         {"format", text},
         {"generator", text, "the program that wrote it", false},
         {"copyright", text, "", false},
         {"up", text, "the axis that is up: y or z"},
         {"bounds", bounds_schema(), "of what it shows, before any animation"},
         {"vertices", count, "in the file, however often they are shown"},
         {"triangles", count},
         {"points", count},
         {"nodes", count},
         {"materials", objects(), "in the words of principled"},
         {"textures", count},
         {"cameras", objects()},
         {"lights", objects()},
         {"animations", objects(), "names and seconds"},
         {"variants", list_schema(text)},
         {"extensions", list_schema(text)},
         {"warnings", list_schema(warning_schema()), "what of it is not taken, the first 20"}});
  });
}

Answer told(int status, std::string_view about) {
  return {status, about, {{media::json, model_schema}}, {"Location", "Cache-Control"}};
}

}  // namespace

std::vector<Route> model_routes() {
  return {
      {.method = "POST",
       .path = "/models",
       .name = "post_model",
       .about = "keeps a model: GLB, glTF, OBJ, PLY or STL, or a ZIP archive or form of one and "
                "the files that it names",
       .rights = {Right::models},
       .pace = Pace::in_turn,
       .handler = post_model,
       .answers = {told(200, "it was kept already"), told(201, "it is kept")},
       .gives = {media::json},
       .query = query_parameters<ModelQuery>,
       .body = model_bodies(),
       .body_limit = model_limit,
       .keeps_body = true},
      {.method = "GET",
       .path = "/models/{}",
       .name = "get_model",
       .about = "what is in a model; HEAD says whether it is there",
       .rights = {Right::models},
       .pace = Pace::in_turn,
       .handler = get_model,
       .answers = tagged("the model in words and numbers", {{media::json, model_schema}}),
       .gives = {media::json},
       .segment = {"id", "a name of the gallery's models, or the id of a kept one"},
       .examples = {"/models/chess"}},
      {.method = "DELETE",
       .path = "/models/{}",
       .name = "delete_model",
       .about = "takes away a model that was sent; scenes that show it are drawn no more",
       .rights = {Right::admin},
       .pace = Pace::in_turn,
       .handler = delete_model,
       .answers = {{204, "it is gone"}},
       .segment = {"id", "the id of a kept model"}}};
}

}  // namespace tia::server
