// Pictures whose rays are chance, of one small room.
#pragma once

#include <gtest/gtest.h>

#include "tests/core/support.h"

namespace tia::test {

// A ball and a lamp above a floor: penumbra, light from wall to wall, edges.
inline Scene room_of_chance() {
  return read_scene(R"({
      "camera": {"location": [0, 1.2, 4], "look_at": [0, 0.6, 0], "fov_degrees": 40},
      "background": [0.05, 0.07, 0.1],
      "objects": [
        {"type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0],
         "material": {"color": [0.7, 0.7, 0.7], "diffuse": 1, "specular": 0}},
        {"type": "sphere", "center": [0, 0.6, 0], "radius": 0.6,
         "material": {"color": [0.8, 0.3, 0.2], "diffuse": 1, "specular": 0}}],
      "lights": [{"type": "sphere", "position": [1.5, 3, 1], "radius": 0.5, "intensity": 40}]})");
}

inline RenderOptions chance(int samples, double noise = 0) {
  RenderOptions options;
  options.integrator = IntegratorName::path;
  options.max_depth = 4;
  options.samples = samples;
  options.noise = noise;
  options.seed = 7;
  return options;
}
inline RenderOptions denoised(RenderOptions options) {
  options.denoise = true;
  return options;
}
inline RenderOptions with_budget(RenderOptions options, Budget budget = {}) {
  options.budget = std::move(budget);
  return options;
}
inline Picture of_room(const RenderOptions& options, int width = sanitized() ? 20 : 40,
                       int height = sanitized() ? 15 : 30) {
  return picture(room_of_chance(), width, height, options);
}

// The mean over all numbers.
inline double square_between(const Image& a, const Image& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i)
    sum += std::pow(static_cast<double>(a.rgb[i]) - static_cast<double>(b.rgb[i]), 2);
  return sum / static_cast<double>(a.rgb.size());
}

}  // namespace tia::test
