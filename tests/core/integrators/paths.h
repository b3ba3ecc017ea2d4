// What the path tracer finds along one ray, as a mean of several seeds. It is held to four of its
// standard errors, and the standard error to a quarter of a percent; where sanitizers watch, paths
// are few.
#pragma once

#include <gtest/gtest.h>

#include "tests/core/tree.h"

namespace tia::test {

struct Mean {
  double value, error;
};

/// What comes from `to` to the eye: one pixel, so narrow that all of its paths begin at one point.
inline Mean light_from(Scene scene, const Vec3d& eye, const Vec3d& to, int samples, int max_depth,
                       int seeds = 16) {
  scene.camera = Camera{};
  scene.camera.location = eye;
  scene.camera.direction = to - eye;
  scene.camera.up = onb_around(normalize(to - eye)).u;
  scene.camera.fov_degrees = 1e-3;
  const World world = compile(scene);
  RenderOptions options;
  options.integrator = IntegratorName::path;
  options.max_depth = max_depth;
  options.samples = rounds(samples, 16);
  double sum = 0, squares = 0;
  for (int seed = 0; seed < seeds; ++seed) {
    options.seed = seed;
    const Image image = picture(world, view_of(scene.camera, 1, 1), {0, 0, 1, 1}, options).image;
    const double one = static_cast<double>(image.rgb[0]);
    sum += one, squares += one * one;
  }
  const double mean = sum / seeds;
  const double variance = std::max(0.0, squares / seeds - mean * mean) / (seeds - 1);
  return {mean, std::sqrt(variance)};
}
inline void expect_mean(const Mean& mean, double expected, double rounding = 2e-5) {
  EXPECT_NEAR(mean.value, expected, 4 * mean.error + rounding * expected);
  if (!sanitized()) {
    EXPECT_LT(mean.error, 0.0025 * expected);
  }
}

inline Finish matt(double albedo) {
  Finish finish;
  finish.color = {1, 1, 1};
  finish.diffuse = albedo;
  return finish;
}

inline Finish glowing(double emission, double albedo = 0) {
  Finish finish = matt(albedo);
  finish.emission = {emission, emission, emission};
  return finish;
}

/// Lambert's formula: half the sum over the edges of the angle that an edge fills, times the cosine
/// of the normal of the plane through it and the point.
/// Source: Lambert, "Photometria" (1760); Arvo, "Analytic methods for simulated light transport"
/// (1995), ch. 4.
inline double polygon_irradiance(const std::vector<Vec3d>& corners, const Vec3d& n) {
  double sum = 0;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const Vec3d a = normalize(corners[i]), b = normalize(corners[(i + 1) % corners.size()]);
    const Vec3d across = cross(a, b);
    sum += std::atan2(length(across), dot(a, b)) * dot(normalize(across), n);
  }
  return std::fabs(sum) / 2;
}

}  // namespace tia::test
