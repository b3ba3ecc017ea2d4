// What the core's tests share: fixed-seed random numbers, scenes, and the short way from a scene to
// its picture. No expectation lives here.
#pragma once

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <ostream>
#include <random>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

#include "core/film/film.h"
#include "core/film/pfm.h"
#include "core/film/png.h"
#include "core/render/explain.h"
#include "core/render/render.h"
#include "core/scene/keys.h"
#include "core/scene/limits.h"
#include "core/scene/read_scene.h"
#include "core/version.h"
#include "tests/sanitizer.h"

namespace tia {

// How a failed comparison shows its values, by the name that GoogleTest looks for.
// NOLINTBEGIN(readability-identifier-naming)
inline void PrintTo(const RayCounts& rays, std::ostream* out) {
  *out << "primary " << rays.primary << ", shadow " << rays.shadow << ", reflection "
       << rays.reflection << ", refraction " << rays.refraction;
}
template <class Real>
void PrintTo(const Vec3<Real>& v, std::ostream* out) {
  *out << "(" << v.x << ", " << v.y << ", " << v.z << ")";
}
// NOLINTEND(readability-identifier-naming)

}  // namespace tia

namespace tia::test {

/// What tests compute in, to judge doubles by.
using Long = long double;

/// Random numbers that are the same on every machine: the generator's bits are fixed by the
/// standard, the distributions here by us; draw no two in one expression without an order.
class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  /// Uniform in [0, 1).
  double unit() { return static_cast<double>(engine_() >> 11U) * 0x1p-53; }
  double in(double low, double high) { return low + (high - low) * unit(); }
  /// Uniform in 0 .. n - 1.
  int below(int n) { return static_cast<int>(unit() * n); }
  /// Uniform in low .. high.
  int whole(int low, int high) { return low + below(high - low + 1); }
  bool chance(double share) { return unit() < share; }
  Vec3d point(double extent) {
    const double x = in(-extent, extent), y = in(-extent, extent);
    return {x, y, in(-extent, extent)};
  }
  /// Uniform on the unit sphere, by rejection.
  Vec3d direction() {
    for (;;) {
      const Vec3d v = point(1);
      const double square = dot(v, v);
      if (square > 1e-3 && square <= 1) return v * (1 / std::sqrt(square));
    }
  }
  /// A random direction with a length between the two.
  Vec3d vector(double least, double most) {
    const Vec3d way = direction();
    return way * in(least, most);
  }

 private:
  std::mt19937_64 engine_;
};

inline std::string file_text(const std::string& path) {
  std::ifstream file(std::string(TIA_SOURCE_DIR) + "/" + path, std::ios::binary);
  if (!file) throw std::runtime_error("cannot read " + path);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

/// The thesis' first picture, as the gallery has it: two balls, no light, four keys.
inline Scene thesis_scene() { return read_scene(file_text("web/scenes/thesis.json")); }

/// The first picture with the key pressed; '\0' for none.
inline Scene thesis_scene(char key) {
  return key == '\0' ? thesis_scene() : press(thesis_scene(), std::string(1, key));
}

inline Material matte(const Color& color, const Color& emission = {}) {
  Finish finish;
  finish.color = color;
  finish.emission = emission;
  return {finish};
}
inline Object ball(const Vec3d& center, double radius, const Material& material = {}) {
  return {"", Sphere{center, radius}, {}, MaterialRef(material)};
}
/// A black ball before white.
inline Scene black_ball(const Vec3d& center, double radius) {
  Scene scene;
  scene.background = {1, 1, 1};
  scene.objects.push_back(ball(center, radius));
  return scene;
}
inline Light point_light(const Vec3d& position, const Color& color = {1, 1, 1}) {
  Light light;
  light.kind = PointLight{position};
  light.color = color;
  return light;
}
inline Light sphere_light(const Vec3d& position, double radius, const Color& color = {1, 1, 1}) {
  Light light;
  light.kind = SphereLight{position, radius};
  light.color = color;
  return light;
}

struct Picture {
  Image image;
  RayCounts rays;
  std::optional<Reached> reached = {};
};

/// The window of the picture that the view has of a world, linear.
inline Picture picture(const World& world, const View& view, const Window& window,
                       const RenderOptions& options = {}) {
  Pool pool(options.threads);
  LinearFilm film(window.width(), window.height());
  const Rendered drawn =
      render(world, view, window, options, pool, {}, [&](const FilmTile& tile) { film.put(tile); });
  return {film.image(), drawn.rays, drawn.reached};
}
inline Picture picture(const Scene& scene, int width, int height, const Window& window,
                       const RenderOptions& options = {}) {
  return picture(compile(scene), view_of(scene.camera, width, height), window, options);
}
inline Picture picture(const Scene& scene, int width, int height,
                       const RenderOptions& options = {}) {
  return picture(scene, width, height, {0, 0, width, height}, options);
}

/// The light along one ray: the single pixel of a picture whose view plane is centred on it.
inline Vec3f light_along(Scene scene, const Vec3d& origin, const Vec3d& direction) {
  const Vec3d side =
      std::fabs(direction.x) < std::fabs(direction.y) ? Vec3d{1, 0, 0} : Vec3d{0, 1, 0};
  scene.camera = Camera{};
  scene.camera.location = origin;
  scene.camera.direction = direction;
  scene.camera.up = cross(direction, side);
  RenderOptions options;
  options.scalar = Scalar::narrow;
  const Image image = picture(scene, 1, 1, options).image;
  return {image.rgb[0], image.rgb[1], image.rgb[2]};
}

/// The bits of all components: == on it tells -0 from 0 and compares NaN.
inline std::vector<std::uint32_t> bits_of(const Image& image) {
  std::vector<std::uint32_t> all;
  all.reserve(image.rgb.size());
  for (const float value : image.rgb) all.push_back(std::bit_cast<std::uint32_t>(value));
  return all;
}

}  // namespace tia::test
