// SeenAngle: how much a projection by angles is to see.
#pragma once

#include <optional>

namespace tia {

/// SeenAngle: of a picture of that size, in pixels. `tall`: a cylinder's height at distance 1, else
/// that by which pixels are squares on the horizon.
struct SeenAngle {
  double radians = 0;
  std::optional<double> tall{};
  double width = 1, height = 1;
};

}  // namespace tia
