#include "tests/bench/rays/geometry.h"

#include <cmath>
#include <random>

namespace tia::bench {
namespace {

// Numbers in [-1, 1); the generator's own words, for the library's distributions differ.
class Places {
 public:
  double one() { return static_cast<double>(random_()) * 0x1p-31 - 1; }
  Vec3d point() {
    const double x = one(), y = one();
    return {x, y, one()};
  }

 private:
  std::mt19937 random_{5};
};

void put(std::vector<float>& list, const Vec3d& p) {
  for (const double x : {p.x, p.y, p.z}) list.push_back(static_cast<float>(x));
}

// Sizes shrink with the cube root of n, so that however many there are fill the same space.
Geometry spheres(int n) {
  Geometry geometry;
  Places places;
  for (int i = 0; i < n; ++i) {
    put(geometry.spheres, places.point());
    geometry.spheres.push_back(static_cast<float>(0.6 / std::cbrt(n)));
  }
  return geometry;
}

Geometry triangles(int n) {
  Geometry geometry;
  Places places;
  for (int i = 0; i < n; ++i) {
    const Vec3d corner = places.point();
    put(geometry.positions, corner);
    for (int k = 1; k < 3; ++k)
      put(geometry.positions, corner + places.point() * (2 / std::cbrt(n)));
    for (int k = 0; k < 3; ++k) geometry.indices.push_back(static_cast<std::uint32_t>(3 * i + k));
  }
  return geometry;
}

// The tube's middle: a torus knot of 3 turns and 11 curls.
Vec3d knot(double s) {
  const double r = 0.68 + 0.25 * std::cos(11 * s);
  return {r * std::cos(3 * s), r * std::sin(3 * s), 0.25 * std::sin(11 * s)};
}

Vec3d tube_point(double s, double angle) {
  const Vec3d middle = knot(s), way = normalize(knot(s + 1e-4) - middle);
  const Vec3d side = normalize(cross(way, Vec3d{0, 0, 1}));
  const Vec3d out = side * std::cos(angle) + cross(way, side) * std::sin(angle);
  return middle + out * 0.07;
}

// 25 times as many rings as corners a ring: triangles nearly as long as wide.
Geometry tubes(int n) {
  constexpr double turn = 6.283185307179586;
  const auto round = static_cast<std::uint32_t>(std::lround(std::sqrt(n / 50.0)));
  const std::uint32_t along = static_cast<std::uint32_t>(n) / (2 * round), all = along * round;
  Geometry geometry;
  for (std::uint32_t i = 0; i < along; ++i) {
    for (std::uint32_t j = 0; j < round; ++j) {
      put(geometry.positions, tube_point(turn * i / along, turn * j / round));
      const std::uint32_t a = i * round + j, b = i * round + (j + 1) % round;
      const std::uint32_t c = (a + round) % all, d = (b + round) % all;
      for (const std::uint32_t corner : {a, b, c, b, d, c}) geometry.indices.push_back(corner);
    }
  }
  return geometry;
}

}  // namespace

const std::vector<GeometryKind>& geometry_kinds() {
  static const std::vector<GeometryKind> kinds{
      {"spheres", spheres, {100, 1000, 10'000, 100'000, 1'000'000}},
      {"triangles", triangles, {100, 1000, 10'000, 100'000, 1'000'000}},
      {"tubes", tubes, {20'000, 980'000}},
  };
  return kinds;
}

Scene scene_of(const Geometry& geometry) {
  Scene scene;
  const auto& s = geometry.spheres;
  for (std::size_t i = 0; i < s.size(); i += 4) {
    Object ball;
    ball.shape = Sphere{{s[i], s[i + 1], s[i + 2]}, s[i + 3]};
    scene.objects.push_back(std::move(ball));
  }
  if (!geometry.indices.empty()) {
    Mesh mesh;
    mesh.positions.values.assign(geometry.positions.begin(), geometry.positions.end());
    mesh.indices.values.assign(geometry.indices.begin(), geometry.indices.end());
    Object object;
    object.shape = std::move(mesh);
    scene.objects.push_back(std::move(object));
  }
  scene.lights.push_back({PointLight{light_position}, {1, 1, 1}, 1});
  return scene;
}

}  // namespace tia::bench
