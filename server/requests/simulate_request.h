// The parameters of /simulate.
#pragma once

#include <string>
#include <variant>

#include "core/scene/scene.h"

namespace tia::server {

struct SimulateRequest {
  static constexpr std::string_view schema_name = "simulate_request";
  std::variant<std::string, Scene> scene;

  template <class Visitor>
  static void fields(Visitor&& visit) {
    visit("scene", &SimulateRequest::scene,
          Spec{.about = "a scene with physics: its name, a kept scene's id, or a whole scene",
               .required = true});
  }
};

}  // namespace tia::server
