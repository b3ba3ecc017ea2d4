// What everyone writes first: the thesis' algorithm in scalar float, one ray after the other. The
// yardstick of the bench; nothing of the product uses it.
#pragma once

#include <algorithm>
#include <cmath>
#include <limits>
#include <vector>

#include "core/math/vec3.h"

namespace tia::bench {

struct Ball {
  Vec3f center;
  float radius, radius2;
  Vec3f color, emission;

  bool intersect(const Vec3f& origin, const Vec3f& direction, float& t0, float& t1) const {
    const Vec3f l = center - origin;
    const float tca = dot(l, direction);
    if (tca < 0) return false;
    const float d2 = dot(l, l) - tca * tca;
    if (d2 > radius2) return false;
    const float thc = std::sqrt(radius2 - d2);
    t0 = tca - thc;
    t1 = tca + thc;
    return true;
  }
};

inline Vec3f trace(const Vec3f& origin, const Vec3f& direction, const std::vector<Ball>& balls) {
  float nearest = std::numeric_limits<float>::infinity();
  const Ball* hit = nullptr;
  for (const Ball& ball : balls) {
    float t0 = 0, t1 = 0;
    if (!ball.intersect(origin, direction, t0, t1)) continue;
    if (t0 < 0) t0 = t1;
    if (t0 < nearest) {
      nearest = t0;
      hit = &ball;
    }
  }
  if (hit == nullptr) return {0.8F, 0.8F, 0.8F};
  const Vec3f p = origin + direction * nearest;
  const Vec3f n = normalize(p - hit->center);
  Vec3f diffuse{};
  for (const Ball& light : balls) {
    if (light.emission.x <= 0) continue;
    const Vec3f l = normalize(light.center - p);
    bool lit = true;
    for (const Ball& ball : balls) {
      float t0 = 0, t1 = 0;
      if (&ball == &light || !ball.intersect(p + n * 1e-4F, l, t0, t1)) continue;
      lit = false;
      break;
    }
    if (lit) diffuse = diffuse + hit->color * light.emission * std::max(0.0F, dot(n, l));
  }
  return diffuse + hit->emission;
}

inline void render(const std::vector<Ball>& balls, int width, int height, std::vector<Vec3f>& out) {
  const auto w = static_cast<float>(width), h = static_cast<float>(height);
  const float edge = std::tan(3.14159265F * 0.5F * 25 / 180);
  std::size_t i = 0;
  for (int y = 0; y < height; ++y) {
    for (int x = 0; x < width; ++x) {
      const float xx = (2 * ((static_cast<float>(x) + 0.5F) / w) - 1) * edge * w / h;
      const float yy = (1 - 2 * ((static_cast<float>(y) + 0.5F) / h)) * edge;
      out[i++] = trace({}, normalize(Vec3f{xx, yy, -1}), balls);
    }
  }
}

}  // namespace tia::bench
