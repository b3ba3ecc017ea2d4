// SkyLight: what rays see that leave the scene.
#pragma once

#include <optional>
#include <string_view>

#include "core/input/fields.h"
#include "core/math/vec3.h"

namespace tia {

/// SkyLight: replaces the background. In whitted, rays that hit nothing get its colour, those from
/// mirrors too, and it lights no surface.
struct SkyLight {
  static constexpr std::string_view type = "sky";
  static constexpr bool endless = true, background = true;

  template <class Visitor>
  static void fields(Visitor&&) {}
  bool operator==(const SkyLight&) const = default;
};

}  // namespace tia
