#include "tests/bench/rays/ray_set.h"

#include <cmath>

#include "core/accel/world/trace.h"
#include "core/math/rng.h"
#include "core/math/warp.h"
#include "core/render/packet_pixels.h"
#include "tests/bench/rays/geometry.h"

namespace tia::bench {
namespace {

constexpr int width = 640, height = 480;

// Calls visit(x, y) for the pixels in the order in which the tracer packs them.
template <class Visit>
void for_each_pixel(Visit visit) {
  using Pixels = PacketPixels<Wide>;
  for (int top = 0; top < height; top += FilmTile::size)
    for (int left = 0; left < width; left += FilmTile::size)
      for (int y = top; y < top + FilmTile::size; y += Pixels::height)
        for (int x = left; x < left + FilmTile::size; x += Pixels::width)
          for (int i = 0; i < lanes<Wide>; ++i) visit(x + i % Pixels::width, y + i / Pixels::width);
}

// From z = 4 through a window that the cube's front side, at z = 1, just fills.
Ray<float> primary_ray(int x, int y) {
  const double u = (2 * x + 1.0) / width - 1, v = 1 - (2 * y + 1.0) / height;
  return {{0, 0, 4}, static_cast<Vec3f>(normalize(Vec3d{u / 3, v / 4, -1}))};
}

// A point that a ray has hit, lifted off its surface as the tracer does it.
struct Start {
  Vec3f p, n;
};
Start start_of(const World& world, const Ray<float>& ray, const Hit<float>& hit) {
  const SurfacePoint<float> at = surface(world, ray, hit, static_cast<int>(hit.primitive), true);
  return {at.p + at.ng * offset_of(hit.t, at.p), at.ng};
}

void add_shadow(RaySet& rays, const Start& from) {
  const Vec3f way = static_cast<Vec3f>(light_position) - from.p;
  const float distance = length(way);
  if (dot(way, from.n) > 0) rays.add(from.p, way * (1 / distance), distance);
  else rays.add_hole();
}

void add_diffuse(RaySet& rays, const Start& from) {
  RandomWords<1> words{{static_cast<std::uint32_t>(rays.size())}, {0}, {0}, {0}};
  philox(words, RandomKey(7));
  const auto [x, y] = square_to_disc(unit_float(words.a[0]), unit_float(words.b[0]));
  const auto [u, v] = axes_around(from.n);
  const float up = std::sqrt(std::max(0.0F, 1 - x * x - y * y));
  rays.add(from.p, normalize(u * x + v * y + from.n * up), infinity);
}

}  // namespace

void RaySet::add(const Vec3f& from, const Vec3f& way, float far) {
  const std::array<float, 3> p{from.x, from.y, from.z}, d{way.x, way.y, way.z};
  for (std::size_t k = 0; k < 3; ++k) {
    origin[k].push_back(p[k]);
    direction[k].push_back(d[k]);
  }
  t_max.push_back(far);
  active += far >= 0 ? 1 : 0;
}

std::array<RaySet, 4> make_rays(const World& world) {
  std::array<RaySet, 4> sets;
  for (std::size_t k = 0; k < sets.size(); ++k) sets[k].kind = static_cast<RayKind>(k);
  RaySet &primary = sets[0], &shadow = sets[1], &mirror = sets[2], &diffuse = sets[3];
  WorkCounter work;
  for_each_pixel([&](int x, int y) {
    const Ray<float> ray = primary_ray(x, y);
    primary.add(ray.origin, ray.direction, infinity);
    const Hit<float> hit = closest_hit<float>(world, ray, true, work);
    if (!(hit.t < infinity)) {
      for (RaySet* rays : {&shadow, &mirror, &diffuse}) rays->add_hole();
      return;
    }
    const Start from = start_of(world, ray, hit);
    const Vec3f& d = ray.direction;
    add_shadow(shadow, from);
    mirror.add(from.p, normalize(d - from.n * (2 * dot(d, from.n))), infinity);
    add_diffuse(diffuse, from);
  });
  return sets;
}

double disagreement(const RaySet& rays, const Answers& a, const Answers& b) {
  std::size_t differ = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (rays.t_max[i] < 0 || a[i] == b[i]) continue;
    // Infinity minus a number is no less than anything.
    if (!(std::fabs(a[i] - b[i]) <= 1e-4F * std::fabs(a[i])) || std::isinf(a[i])) ++differ;
  }
  return static_cast<double>(differ) / static_cast<double>(std::max<std::size_t>(rays.active, 1));
}

}  // namespace tia::bench
