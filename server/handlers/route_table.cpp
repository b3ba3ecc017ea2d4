// The table of routes: each row with what it takes and what it gives.
#include "server/handlers/route_table.h"

#include <algorithm>
#include <list>

#include "core/render/explain.h"
#include "server/contract/query_parameters.h"
#include "server/handlers/handlers.h"
#include "server/requests/explain_request.h"

namespace tia::server {
namespace {

constexpr std::string_view json = "application/json";
constexpr std::string_view json_schema = "application/schema+json";  // which is JSON, too
constexpr std::string_view png = "image/png";
constexpr std::string_view html = "text/html; charset=utf-8";

// ---- answers --------------------------------------------------------------------------------

Answer ok(std::string_view about, std::string_view type, MakeSchema schema,
          std::vector<std::string_view> headers = {}) {
  return {200, about, {{type, schema}}, std::move(headers)};
}
Answer unstored(std::string_view about, MakeSchema schema) {
  return ok(about, json, schema, {"Cache-Control"});
}

// What is sent with a tag, and not again to who has it.
std::vector<Answer> tagged(std::string_view about, std::vector<Content> contents) {
  return {{200, about, std::move(contents), {"ETag", "Cache-Control", "Content-Encoding"}},
          {304, "If-None-Match names its tag", {}, {"ETag", "Cache-Control"}}};
}

Answer picture() {
  Answer answer{.about = "the picture"};
  for (std::size_t i = 0; i < Names<Format>::names.size(); ++i)
    answer.contents.push_back({media_type_of(static_cast<Format>(i))});
  answer.headers = {"Server-Timing", "Tia-Rays", "Cache-Control", "ETag", "Cache-Status"};
  return answer;
}

Answer picture_not_modified() {
  return {304,
          "If-None-Match names the picture's tag: no ray was traced",
          {},
          {"ETag", "Cache-Control", "Cache-Status"}};
}

Answer verdict() {
  return ok("the verdict, and what the picture was drawn from", json, verdict_schema,
            {"Cache-Control"});
}

Answer explanation() {
  return ok("the hits along the ray and the tree of all that makes its colour", json,
            explanation_schema, {"Cache-Control"});
}

Value object_with(const char* member) {
  return Value::Object{{"type", "object"}, {"required", Value::Array{member}}};
}
Value any_schema(Definitions&) { return object_with("$schema"); }
Value any_openapi(Definitions&) { return object_with("openapi"); }

// ---- bodies of requests ---------------------------------------------------------------------

std::vector<Content> picture_body() {
  return {{json,
           schema_for<PictureRequest>,
           {{"the first picture, lit from the left", R"({"key": "a"})"},
            {"a scene of one's own", R"({"width": 320, "height": 240, "scene": {
  "background": [0.1, 0.2, 0.4],
  "objects": [{"type": "sphere", "center": [0, 0, -9], "radius": 1.5}],
  "lights": [{"type": "point", "position": [4, 6, -3]}]}})"}}},
          {png}};
}

std::vector<Content> png_body() { return {{png}}; }

std::vector<Content> explain_body() {
  return {{json,
           schema_for<ExplainRequest>,
           {{"a pixel", R"({"x": 320, "y": 240, "key": "a"})"},
            {"a ray", R"({"ray": {"origin": [0, 0, 0], "direction": [0, 0, -1]}})"}}}};
}

std::vector<Content> scene_body() {
  return {
      {json,
       schema_for<Scene>,
       {{"one ball", R"({"objects": [{"type": "sphere", "center": [0, 0, -9], "radius": 2}]})"}}}};
}

// ---- rows -----------------------------------------------------------------------------------

std::vector<Route> pictures() {
  return {{.method = "GET",
           .path = "/render",
           .name = "get_render",
           .about = "a picture; no parameter is required",
           .pace = Pace::in_turn,
           .handler = get_render,
           .answers = {picture(), picture_not_modified()},
           .chooses = true,
           .query = query_parameters<PictureRequest>,
           .examples = {"/render", "/render?key=a&width=320&height=240",
                        "/render?light=-5,12,-8&format=pfm"}},
          {.method = "POST",
           .path = "/render",
           .name = "post_render",
           .about = "the same, parameters as a JSON object; or again, from a PNG that was sent",
           .pace = Pace::in_turn,
           .handler = post_render,
           .answers = {picture()},
           .chooses = true,
           .body = picture_body()},
          {.method = "POST",
           .path = "/verify",
           .name = "post_verify",
           .about = "whether a PNG is, byte by byte, what this version draws",
           .pace = Pace::in_turn,
           .handler = post_verify,
           .answers = {verdict()},
           .gives = {json},
           .body = png_body()},
          {.method = "GET",
           .path = "/explain",
           .name = "get_explain",
           .about = "what the ray of a pixel, or any ray, meets",
           .pace = Pace::in_turn,
           .handler = get_explain,
           .answers = {explanation()},
           .gives = {json},
           .query = query_parameters<ExplainRequest>,
           .examples = {"/explain?x=320&y=240&key=a",
                        "/explain?ray.origin=0,0,0&ray.direction=0,0,-1"}},
          {.method = "POST",
           .path = "/explain",
           .name = "post_explain",
           .about = "the same, parameters as a JSON object",
           .pace = Pace::in_turn,
           .handler = post_explain,
           .answers = {explanation()},
           .gives = {json},
           .body = explain_body()}};
}

std::vector<Route> scenes() {
  return {{.method = "GET",
           .path = "/scenes",
           .name = "get_scenes",
           .about = "the gallery: names and titles",
           .handler = get_scenes,
           .answers = {ok("the scenes that come with the server", json, Gallery::listing_schema)},
           .gives = {json}},
          {.method = "POST",
           .path = "/scenes",
           .name = "post_scene",
           .about = "keeps a scene: its id is a name",
           .pace = Pace::in_turn,
           .handler = post_scene,
           .answers = {{201,
                        "the scene is kept",
                        {{json, kept_scene_schema}},
                        {"Location", "Cache-Control", "Tia-Delete-Key"}}},
           .gives = {json},
           .body = scene_body()},
          {.method = "GET",
           .path = "/scenes/{}",
           .name = "get_scene",
           .about = "one scene's canonical JSON",
           .pace = Pace::in_turn,
           .handler = get_scene,
           .answers = {ok("the scene, fields at their defaults left out (RFC 8785)", json,
                          schema_for<Scene>)},
           .gives = {json},
           .segment = {"name", "a name of the gallery, or the id of a kept scene"},
           .examples = {"/scenes/thesis"}},
          {.method = "DELETE",
           .path = "/scenes/{}",
           .name = "delete_scene",
           .about = "forgets a kept scene, once all who have kept it want that; with the header "
                    "Tia-Delete-Key that POST /scenes has answered",
           .pace = Pace::in_turn,
           .handler = delete_scene,
           .answers = {{204, "it is forgotten, as far as this client has kept it"}},
           .segment = {"name", "the id of a kept scene"}},
          {.method = "GET",
           .path = "/schema/scene.json",
           .name = "get_scene_schema",
           .about = "JSON Schema of a scene",
           .handler = get_scene_schema,
           .answers = {ok("JSON Schema 2020-12", json_schema, any_schema)},
           .gives = {json_schema, json}}};
}

std::vector<Route> operation() {
  return {{.method = "GET",
           .path = "/healthz",
           .name = "get_health",
           .about = "whether the server lives",
           .handler = get_health,
           .answers = {unstored("it does", healthy_schema)}},
          {.method = "GET",
           .path = "/readyz",
           .name = "get_ready",
           .about = "whether it takes requests: 503 when it goes down or has too much to do",
           .handler = get_ready,
           .answers =
               {unstored("it does", ready_schema),
                {503, "it does not", {{json, unready_schema}}, {"Cache-Control", "Retry-After"}}}},
          {.method = "GET",
           .path = "/version",
           .name = "get_version",
           .about = "what this build is",
           .handler = get_version,
           .answers = {ok("the build", json, version_schema)}},
          {.method = "GET",
           .path = "/metrics",
           .name = "get_metrics",
           .about = "counters and gauges, in Prometheus' text format",
           .handler = get_metrics,
           .answers = {ok("the metrics", Metrics::media_type, nullptr, {"Cache-Control"})}}};
}

std::vector<Route> documents() {
  return {{.method = "GET",
           .path = "/openapi.json",
           .name = "get_openapi",
           .about = "this interface, as an OpenAPI 3.1 document",
           .handler = get_openapi,
           .answers = tagged("the document", {{json, any_openapi}})},
          {.method = "GET",
           .path = "/docs",
           .name = "get_docs",
           .about = "this interface, as a page to read",
           .handler = get_docs,
           .answers = tagged("the page", {{html}})},
          {.method = "GET",
           .path = "/problems/{}",
           .name = "get_problem",
           .about = "what a problem's type means",
           .handler = get_problem,
           .answers = {{308, "the place on the page of documentation", {}, {"Location"}}},
           .segment = {"type", "the last part of a problem's type"},
           .examples = {"/problems/busy"}},
          {.method = "GET",
           .path = "/",
           .name = "get_page",
           .about = "the page: hold a lamp, and see why",
           .handler = get_page,
           .answers = tagged("the page", {{html}})}};
}

// The files of one folder of the page. Paths and names must outlive the table.
Route files_of(const std::string& folder) {
  static std::list<std::string> texts;
  std::string name = "get_page_file" + folder.substr(0, folder.size() - 1);
  std::ranges::replace(name, '/', '_');
  return {.method = "GET",
          .path = texts.emplace_back(folder + "{}"),
          .name = texts.emplace_back(name),
          .about = "a file of the page",
          .handler = get_page_file,
          .answers = tagged("the file", page_file_contents(folder)),
          .segment = {"file", "its name"},
          .segments = page_files(folder),
          .has = is_page_file};
}

}  // namespace

const std::vector<Route>& routes() {
  static const std::vector<Route> table = [] {
    std::vector<Route> all;
    for (const auto& group : {pictures(), scenes(), operation(), documents()})
      all.insert(all.end(), group.begin(), group.end());
    for (const std::string& folder : page_folders()) all.push_back(files_of(folder));
    return all;
  }();
  return table;
}

}  // namespace tia::server
