// /compare: two pictures in, how far they are from each other out.
#include "core/input/json.h"
#include "server/contract/answers.h"
#include "server/contract/parameters.h"
#include "server/handlers/bodies.h"
#include "server/handlers/handlers.h"
#include "server/requests/compare_request.h"
#include "server/requests/draw.h"
#include "server/requests/with_memory.h"

namespace tia::server {
namespace {

CompareRequest asked_comparison(const Request& request, Service& service) {
  refuse_query(request);
  return read_body(request, service, [&] {
    const char* const what = R"(two pictures as a JSON object, such as {"a":{},"b":{"key":"a"}})";
    return read_described<CompareRequest>(body_json(request, what, service.config.json_limits()),
                                          {}, request.stop);
  });
}

void check_same_size(const Plan& a, const Plan& b) {
  const auto size_of = [](const Plan& plan) {
    return std::to_string(plan.window.width()) + " x " + std::to_string(plan.window.height());
  };
  if (a.window.width() == b.window.width() && a.window.height() == b.window.height()) return;
  throw InputError({FaultKind::conflict, "/b/width", Value(size_of(b)),
                    size_of(a) + ", the size of the picture a"});
}

/// Comparing: what both pictures are drawn with.
struct Comparing {
  Service& service;
  const Requester& requester;
  Flow& flow;

  Workers workers() const {
    Pool& pool = service.rendering.pool;
    return pool.workers(pool.threads(), requester.stop, &flow);
  }
  Image drawn(Plan& plan, const char* pointer) const {
    plan.options.flow = &flow;
    settle_memory();
    const auto attempt = [&] { return draw(plan, service.rendering, requester.stop); };
    Picture picture = at_pointer(pointer, [&] { return with_memory_for(attempt, requester.stop); });
    service.costs.learn(plan.cost_key, plan.rays(), picture.trace_seconds, true);
    service.metrics.count(picture.rays, picture.timing);
    service.access.charge(requester.key, picture.rays.all());
    return shown_signals(plan, std::move(picture), workers());
  }
};

// With one ticket for heavy work for both pictures and what they come to.
Response post_compare(const Request& request, const std::string&, Service& service) {
  const CompareRequest asked = asked_comparison(request, service);
  const Requester requester = requester_of(request);
  Plan a = light_plan_of(*asked.a, "/a", service.rendering, requester);
  Plan b = light_plan_of(*asked.b, "/b", service.rendering, requester);
  check_same_size(a, b);
  service.access.check_rays(requester.key, a.rays() + b.rays());
  const auto ticket = service.admission.enter({.seconds = 2 * Cost::most_light_seconds},
                                              requester.client, requester.stop);
  Flow flow{requester.number()};
  const Comparing by{service, requester, flow};
  const Image of_a = by.drawn(a, "/a"), of_b = by.drawn(b, "/b");
  std::string text;
  by.workers().alone([&] { text = to_json(compared(asked, a, of_a, of_b, requester.stop)); });
  return {.content_type = "application/json",
          .body = std::move(text),
          .headers = {{"Cache-Control", "no-cache"}}};
}

std::vector<Content> compare_body() {
  return {{media::json,
           schema_for<CompareRequest>,
           {{"a picture for a gaze, and the full one",
             R"({"a": {"scene": "whitted", "width": 320, "height": 240},
  "b": {"scene": "whitted", "width": 320, "height": 240, "gaze": [160, 120]}})"}}}};
}

}  // namespace

std::vector<Route> compare_routes() {
  return {{.method = "POST",
           .path = "/compare",
           .name = "post_compare",
           .about = "how far two pictures are from each other as they are shown: squared error, "
                    "PSNR, SSIM, of the whole and by the angle from a gaze",
           .rights = {Right::render},
           .pace = Pace::in_turn,
           .handler = post_compare,
           .answers = {ok("how far", media::json, comparison_schema, {"Cache-Control"})},
           .gives = {media::json},
           .body = compare_body()}};
}

}  // namespace tia::server
