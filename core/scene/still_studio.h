// The light of a still: studios around a model that turn with the camera.
#pragma once

#include <array>
#include <string_view>
#include <vector>

#include "core/lights/light.h"
#include "core/scene/integrators.h"
#include "core/scene/still_framing.h"

namespace tia {

enum class Studio { soft, neutral, sun, dark, headlight, none };
template <>
struct Names<Studio> {
  static constexpr std::array<std::string_view, 6> names{"soft", "neutral",   "sun",
                                                         "dark", "headlight", "none"};
};

/// StudioStand: where a studio stands, and how its light counts.
struct StudioStand {
  StillBall ball{};            ///< around what is lit
  double azimuth_degrees = 0;  ///< the camera's
  Vec3d view{0, 0, -1};        ///< the way that it looks
  IntegratorName integrator = IntegratorName::path;
};

/// StudioLight: what a studio gives a scene.
struct StudioLight {
  std::vector<Light> lights;
  Color ambient_light{};
};

/// The lights by what they give the ball's centre of irradiance where nothing is in the way, on
/// what faces them: panels are squares of two radii a side that face it. The sky is of a radiance.
///
/// path gets them so: a square of half the side a at the distance h and of radiance L gives
///   E = 4 L q atan(q), q = a / sqrt(a^2 + h^2).
/// Source: Howell, "A catalog of radiation heat transfer configuration factors", the element
/// parallel to a rectangle, below its corner, four times.
/// In whitted what a light gives a white surface that faces it is its colour: it is E / pi, so that
/// the surface is as bright by both. A sky gives nothing there; its colour is ambient_light, which
/// finishes send back that have ambient 1. Others light as whitted does.
StudioLight studio_light(Studio studio, const StudioStand& stand);

}  // namespace tia
