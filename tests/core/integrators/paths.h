// What path and ambient_occlusion find along one ray, as a mean of many independent estimates. It
// is held to four of its standard errors, by the estimates' own variance, and the standard error to
// a quarter of a percent; where sanitizers watch, paths are few.
#pragma once

#include <gtest/gtest.h>

#include "tests/core/film/files.h"
#include "tests/core/tree.h"

namespace tia::test {

struct Mean {
  double value, error;
};

/// The mean of independent estimates, and its standard error.
struct Estimates {
  double sum = 0, squares = 0;
  int count = 0;
  void add(double one) { sum += one, squares += one * one, ++count; }
  double mean() const { return sum / count; }
  double variance() const {
    return std::max(0.0, squares / count - mean() * mean()) * count / (count - 1);
  }
  operator Mean() const { return {mean(), std::sqrt(variance() / count)}; }
};

/// What comes from `to` to the eye, by channels: of each seed a picture of 4 x 4 pixels, which are
/// one packet. It is so narrow that all of its paths begin at one point, and each pixel has numbers
/// at random of its own.
inline std::array<Mean, 3> colors_from(Scene scene, const Vec3d& eye, const Vec3d& to,
                                       const RenderOptions& by, int seeds) {
  scene.camera = Camera{};
  scene.camera.location = eye;
  scene.camera.direction = to - eye;
  scene.camera.up = onb_around(normalize(to - eye)).u;
  scene.camera.fov_degrees = 1e-3;
  const World world = compile(scene);
  std::array<Estimates, 3> channels;
  RenderOptions options = by;
  for (int seed = 0; seed < seeds; ++seed) {
    options.seed = seed;
    const Image image = picture(world, view_of(scene.camera, 4, 4), {0, 0, 4, 4}, options).image;
    for (std::size_t i = 0; i < image.rgb.size(); ++i)
      channels[i % 3].add(static_cast<double>(image.rgb[i]));
  }
  return {channels[0], channels[1], channels[2]};
}
inline RenderOptions by_paths(int samples, int max_depth) {
  RenderOptions options;
  options.integrator = IntegratorName::path;
  options.max_depth = max_depth;
  options.samples = rounds(samples, 4);
  return options;
}
inline Mean light_from(const Scene& scene, const Vec3d& eye, const Vec3d& to, int samples,
                       int max_depth, int seeds = 2) {
  return colors_from(scene, eye, to, by_paths(samples, max_depth), seeds)[0];
}
inline void expect_mean(const Mean& mean, double expected, double rounding = 2e-5) {
  EXPECT_NEAR(mean.value, expected, 4 * mean.error + rounding * expected);
  if (!sanitized()) {
    EXPECT_LT(mean.error, 0.0025 * expected);
  }
}
/// That two are estimates of the same.
inline void expect_equal(const Mean& a, const Mean& b, double rounding = 2e-5) {
  const double error = std::hypot(a.error, b.error);
  EXPECT_NEAR(a.value, b.value, 4 * error + rounding * a.value);
  if (!sanitized()) {
    EXPECT_LT(error, 0.0025 * a.value);
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

inline Mesh mesh_of(const std::vector<Vec3d>& corners, const std::vector<std::uint32_t>& indices) {
  Mesh mesh;
  for (const Vec3d& p : corners)
    mesh.positions.values.insert(mesh.positions.values.end(), {p.x, p.y, p.z});
  mesh.indices.values.insert(mesh.indices.values.end(), indices.begin(), indices.end());
  return mesh;
}
/// A sky as a client sends it, so that reading is tried as well.
inline Light image_light(const std::string& file, double rotate_degrees = 0) {
  Value::Object json{
      {"type", "sky_image"}, {"data", base64(file)}, {"rotate_degrees", rotate_degrees}};
  return read_described<Light>(Value(json));
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

/// A matt floor through the origin, and what it gets there: it is seen from low above.
struct LitFloor {
  Onb frame;
  Vec3d eye;
  Scene scene;
  double albedo;

  explicit LitFloor(Random& random) : frame(onb_around(random.direction())) {
    eye = frame.n * 0.05 - frame.u * 0.1;
    albedo = random.in(0.3, 1);
    scene.objects = {object(Plane{{0, 0, 0}, frame.n}, matt(albedo))};
  }
  Vec3d point(double x, double y, double z) const {
    return frame.u * x + frame.v * y + frame.n * z;
  }
  Mean irradiance(int samples, int max_depth = 1) const {
    const Mean mean = light_from(scene, eye, {0, 0, 0}, samples, max_depth);
    return {mean.value * pi / albedo, mean.error * pi / albedo};
  }
};
}  // namespace tia::test
