// /explain: one pixel or one ray in, what the ray meets out, as JSON.
#include "core/input/json.h"
#include "server/handlers.h"
#include "server/parameters.h"

namespace tia::server {
namespace {

/// FreeRay: a ray that belongs to no pixel.
struct FreeRay {
  Vec3d origin{}, direction{};

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("origin", &FreeRay::origin,
          Spec{.about = "where the ray starts", .min = -1e9, .max = 1e9, .required = true});
    visit("direction", &FreeRay::direction,
          Spec{.about = "where it goes", .min = -1e9, .max = 1e9, .required = true});
  }
  /// A direction too short to tell where it goes.
  void check(const Place& at, Faults& faults) const {
    if (!(length(direction) > 1e-100))
      faults.add({FaultKind::out_of_range, at.at("direction").pointer(), write_value(direction),
                  "a direction of some length, 1e-100 at least"});
  }
};

/// ExplainRequest: the parameters of /explain.
struct ExplainRequest : ViewRequest {
  std::optional<int> x, y;
  std::optional<FreeRay> ray;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    using E = ExplainRequest;
    ViewRequest::fields(visit);
    visit("x", &E::x, Spec{.about = "the pixel's column, from the left", .min = 0, .max = most_px});
    visit("y", &E::y, Spec{.about = "the pixel's row, from the top", .min = 0, .max = most_px});
    visit("ray", &E::ray, Spec{.about = "a ray of its own instead of a pixel's"});
  }

  /// Neither a pixel nor a ray, or both; a pixel outside the picture.
  void check(const Place& at, Faults& faults) const {
    ViewRequest::check(at, faults);
    const auto coordinate = [&](const char* name, const std::optional<int>& is, int size) {
      const std::string place = at.at(name).pointer();
      const std::string range = range_text({.unit = "pixels", .min = 0, .max = size - 1.0}, true);
      if (ray && is) faults.add({FaultKind::conflict, place, write_value(*is), "x and y, or ray"});
      else if (!ray && !is)
        faults.add({FaultKind::missing, place, std::nullopt,
                    range + ", of a pixel with x and y; or a ray"});
      else if (is && *is >= size)
        faults.add({FaultKind::out_of_range, place, write_value(*is), range});
    };
    coordinate("x", x, width);
    coordinate("y", y, height);
  }
};

Ray<double> ray_of(const ExplainRequest& asked, const Scene& scene) {
  if (asked.ray) return {asked.ray->origin, normalize(asked.ray->direction)};
  const View view = view_of(scene.camera, asked.width, asked.height);
  return view.ray<double>(*asked.x, *asked.y);
}

Response explained(const Value& parameters, const Service& service) {
  const auto asked = read_described<ExplainRequest>(parameters);
  check_size(asked.width, asked.height, service.studio.limits);
  const SharedScene scene = scene_of(asked, service.studio);
  Value::Object answer = value_of(explain(*scene, ray_of(asked, *scene)));
  if (!asked.ray) {
    answer.emplace_back("pixel", Value::Array{*asked.x, *asked.y});
    answer.emplace_back("sample", 0);
  }
  return {.content_type = "application/json",
          .body = to_json(answer),
          .headers = {{"Cache-Control", "no-cache"}}};
}

}  // namespace

Response get_explain(const Request& request, const std::string&, Service& service) {
  return explained(query_object<ExplainRequest>(request.query()), service);
}

Response post_explain(const Request& request, const std::string&, Service& service) {
  const char* const what = "the parameters as a JSON object, such as {\"x\":320,\"y\":240}";
  return explained(body_json(request, what), service);
}

}  // namespace tia::server
