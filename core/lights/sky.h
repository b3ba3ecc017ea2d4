// SkyLight: what rays see that leave the scene.
#pragma once

#include <optional>
#include <string_view>

#include "core/input/fields.h"
#include "core/math/vec3.h"

namespace tia {

/// SkyLight: takes the background's place. In whitted it is seen and mirrored, and lights nothing.
struct SkyLight {
  static constexpr std::string_view type = "sky";
  static constexpr bool endless = true, background = true;

  template <class Visitor>
  static void fields(Visitor&&) {}
  bool operator==(const SkyLight&) const = default;
};

}  // namespace tia
