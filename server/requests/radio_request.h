// The parameters of /radio/paths.
#pragma once

#include <string>
#include <variant>

#include "core/radio/radio_paths.h"
#include "core/scene/limits.h"

namespace tia::server {

struct RadioPathsRequest : RadioQuestion {
  static constexpr std::string_view schema_name = "radio_paths_request";
  std::variant<std::string, Scene> scene;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("scene", &RadioPathsRequest::scene,
          Spec{.about = "what waves meet: a scene's name, a kept scene's id, or a whole scene; of "
                        "one that moves, the time 0",
               .required = true});
    RadioQuestion::fields(visit);
  }
};

/// What one request may take: an image counts as so many tests as it takes at least.
inline RadioLimits radio_limits(const Limits& limits) {
  constexpr std::int64_t tests_of_image = 500;
  return {limits.max_rays, limits.max_work / tests_of_image};
}

}  // namespace tia::server
