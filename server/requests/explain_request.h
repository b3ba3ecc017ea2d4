// The parameters of /explain.
#pragma once

#include <optional>

#include "core/radio/map_question.h"
#include "core/render/render.h"
#include "server/requests/view_request.h"

namespace tia::server {

/// FreeRay: a ray that belongs to no pixel.
struct FreeRay {
  static constexpr std::string_view schema_name = "free_ray";
  Vec3d origin{}, direction{};

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("origin", &FreeRay::origin,
          Spec{.about = "where the ray starts", .min = -1e9, .max = 1e9, .required = true});
    visit("direction", &FreeRay::direction,
          Spec{.about = "where it goes", .min = -1e9, .max = 1e9, .required = true});
  }
  /// A direction too short to tell where it goes.
  void check(const Place& at, Faults& faults) const;
};

/// ExplainRequest: a pixel with x and y, or a ray.
struct ExplainRequest : TraceRequest {
  static constexpr std::string_view schema_name = "explain_request";
  std::optional<int> x, y;
  int sample = 0;
  std::optional<int> paths;
  std::optional<FreeRay> ray;
  std::optional<RadioMapQuestion> radio;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    using E = ExplainRequest;
    constexpr double most_samples = 16 * 65536 - 1, most_paths = 1024;
    TraceRequest::fields(visit);
    visit("x", &E::x, Spec{.about = "the pixel's column, from the left", .min = 0, .max = most_px});
    visit("y", &E::y, Spec{.about = "the pixel's row, from the top", .min = 0, .max = most_px});
    visit("sample", &E::sample,
          Spec{.about = "which of the pixel's rays, from 0", .min = 0, .max = most_samples});
    visit("paths", &E::paths,
          Spec{.about = "of path: how many of the pixel's paths are told one by one, from that of "
                        "sample on; else 16",
               .min = 0,
               .max = most_paths});
    visit("ray", &E::ray, Spec{.about = "a ray of its own instead of a pixel's"});
    visit(
        "radio", &E::radio,
        Spec{.about = "a map of /radio/map, without its scene: x and y are a cell's, of which the "
                      "answer is that of /radio/paths at its centre"});
  }
  /// Neither a pixel nor a ray, or both; a pixel outside the picture.
  void check(const Place& at, Faults& faults) const;
  /// Whether rays with these options can be told, and the one that is asked for is of the pixel's.
  /// Errors: InputError.
  void check_rays(const RenderOptions& options) const;
};

}  // namespace tia::server
