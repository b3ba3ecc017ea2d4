// /explain: one pixel or one ray in, what the ray meets out, as JSON.
#include "core/input/json.h"
#include "core/render/explain.h"
#include "core/render/explain_paths.h"
#include "core/render/sampler.h"
#include "server/contract/answers.h"
#include "server/contract/parameters.h"
#include "server/contract/query_parameters.h"
#include "server/handlers/bodies.h"
#include "server/handlers/handlers.h"
#include "server/requests/explain_request.h"

namespace tia::server {

void FreeRay::check(const Place& at, Faults& faults) const {
  if (!(length(direction) > 1e-100))
    faults.add({FaultKind::out_of_range, at.at("direction").pointer(), write_value(direction),
                "a direction of some length, 1e-100 at least"});
}

void ExplainRequest::check(const Place& at, Faults& faults) const {
  ViewRequest::check(at, faults);
  const auto coordinate = [&](const char* name, const std::optional<int>& is, int size) {
    const std::string place = at.at(name).pointer();
    const std::string range = range_text({.unit = "pixels", .min = 0, .max = size - 1.0}, true);
    if (ray && is) faults.add({FaultKind::conflict, place, write_value(*is), "x and y, or ray"});
    else if (!ray && !is)
      faults.add(
          {FaultKind::missing, place, std::nullopt, range + ", of a pixel with x and y; or a ray"});
    else if (is && *is >= size)
      faults.add({FaultKind::out_of_range, place, write_value(*is), range});
  };
  coordinate("x", x, width);
  coordinate("y", y, height);
}

namespace {

RenderOptions checked_options(const ExplainRequest& asked, const Scene& scene,
                              const Limits& limits) {
  const RenderOptions options = options_of(options_in_effect(scene.options, asked), limits);
  const bool by_paths = options.integrator == IntegratorName::path;
  if (!row_of(options.integrator).is_whitted && !by_paths)
    throw InputError({FaultKind::out_of_range, "/integrator", Value(name_of(options.integrator)),
                      explained_names() + ", whose light comes by rays that can be told"});
  if (asked.paths && !by_paths)
    throw InputError({FaultKind::conflict, "/paths", Value(*asked.paths),
                      "the integrator path; the rays of " +
                          std::string(name_of(options.integrator)) + " are a tree"});
  const int rays = least_samples(options.samples, options.threshold);
  const int most = options.threshold > 0 && !by_paths ? 16 * rays : rays;
  if (asked.sample >= most)
    throw InputError({FaultKind::out_of_range, "/sample", Value(asked.sample),
                      range_text({.min = 0, .max = most - 1.0}, true) + ", of the pixel's rays"});
  return options;
}

Value::Object explanation_in(const ExplainRequest& asked, const Scene& scene, World world,
                             const RenderOptions& options, const std::stop_token& stop) {
  const bool by_paths = options.integrator == IntegratorName::path;
  const WhichPaths which{asked.sample, asked.paths.value_or(WhichPaths{}.count)};
  if (asked.ray) {
    const Ray<double> ray{asked.ray->origin, normalize(asked.ray->direction)};
    if (by_paths)
      return value_of(explain_paths(scene, std::move(world), ray, which, options, stop));
    return value_of(explain(scene, std::move(world), ray, options, stop));
  }
  const View view = view_of(scene.camera, asked.width, asked.height);
  const int x = *asked.x, y = *asked.y;
  if (by_paths)
    return value_of(explain_paths(scene, std::move(world), view, x, y, which, options, stop));
  return value_of(explain(scene, std::move(world), view, x, y, asked.sample, options, stop));
}

std::string explanation_of(const ExplainRequest& asked, const Service& service,
                           const Requester& requester, Flow& flow) {
  const KnownScene scene = scene_of(asked, service.rendering, requester);
  const RenderOptions options = checked_options(asked, *scene, service.rendering.limits);
  Pool& pool = service.rendering.pool;
  World world = service.rendering.geometries.compile(
      scene, pool.workers(pool.threads(), requester.stop, &flow));
  std::string text;
  const auto tell = [&] {
    text = to_json(explanation_in(asked, *scene, std::move(world), options, requester.stop));
  };
  pool.alone(tell, requester.stop, &flow);
  return text;
}

ExplainRequest asked_of_body(const Request& request, Service& service) {
  return read_body(request, service, [&] {
    const char* const what = "the parameters as a JSON object, such as {\"x\":320,\"y\":240}";
    return read_described<ExplainRequest>(body_json(request, what, service.config.json_limits()),
                                          {}, request.stop);
  });
}

Response explained(const ExplainRequest& asked, const Request& request, Service& service) {
  check_size(asked.width, asked.height, service.rendering.limits);
  const Requester requester = requester_of(request);
  auto ticket = service.admission.enter({}, requester.client, requester.stop);
  Flow flow{requester.number()};
  flow.became_long = [&] { ticket.turn_heavy(); };
  return {.content_type = "application/json",
          .body = explanation_of(asked, service, requester, flow),
          .headers = {{"Cache-Control", "no-cache"}}};
}

Response get_explain(const Request& request, const std::string&, Service& service) {
  const auto read = [&] {
    return read_described<ExplainRequest>(query_object<ExplainRequest>(request.query()));
  };
  return explained(read_query(request, service, read), request, service);
}

Response post_explain(const Request& request, const std::string&, Service& service) {
  return explained(asked_of_body(request, service), request, service);
}

Answer explanation() {
  return ok(
      "the hits along the ray, and all that makes its colour: the tree of its rays, or of "
      "path the paths of its light and the ways by which it came",
      media::json, explanation_schema, {"Cache-Control"});
}

std::vector<Content> explain_body() {
  return {{media::json,
           schema_for<ExplainRequest>,
           {{"a pixel", R"({"x": 320, "y": 240, "key": "a"})"},
            {"a ray", R"({"ray": {"origin": [0, 0, 0], "direction": [0, 0, -1]}})"}}}};
}

}  // namespace

std::vector<Route> explain_routes() {
  return {{.method = "GET",
           .path = "/explain",
           .name = "get_explain",
           .about = "what the ray of a pixel, or any ray, meets",
           .pace = Pace::in_turn,
           .handler = get_explain,
           .answers = {explanation()},
           .gives = {media::json},
           .query = query_parameters<ExplainRequest>,
           .examples = {"/explain?x=320&y=240&key=a",
                        "/explain?x=320&y=240&key=a&integrator=path&samples=64&paths=4",
                        "/explain?ray.origin=0,0,0&ray.direction=0,0,-1"}},
          {.method = "POST",
           .path = "/explain",
           .name = "post_explain",
           .about = "the same, parameters as a JSON object",
           .pace = Pace::in_turn,
           .handler = post_explain,
           .answers = {explanation()},
           .gives = {media::json},
           .body = explain_body()}};
}

}  // namespace tia::server
