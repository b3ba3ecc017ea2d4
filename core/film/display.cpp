#include "core/film/display.h"

#include <cstdint>

#include "core/math/deterministic.h"
#include "core/math/vec3.h"

namespace tia {
namespace {

Vec3f of_normal(const Vec3f& n) {
  if (n == Vec3f{0, 0, 0}) return n;
  return n * 0.5F + Vec3f{0.5F, 0.5F, 0.5F};
}

Vec3f of_depth(const Vec3f& t) { return {1 / (1 + t.x), 1 / (1 + t.y), 1 / (1 + t.z)}; }

// Codes 64 .. 255 along a sequence that fills the cube of colours evenly: the fractions of i/g,
// i/g^2, i/g^3 for g^4 = g + 1, in units of 2^-32.
// Source: Martin Roberts, "The unreasonable effectiveness of quasirandom sequences", 2018.
Vec3f of_number(const Vec3f& v) {
  if (!(v.x >= 1)) return {0, 0, 0};
  const auto i = static_cast<std::uint32_t>(v.x);
  const auto channel = [i](std::uint32_t step) {
    const std::uint32_t share = i * step >> 16U;
    return static_cast<float>(64 + (share * 192U >> 16U)) / 255;
  };
  return {channel(0xD1B54A33U), channel(0xABC98388U), channel(0x8CB92BA7U)};
}

Vec3f of_cost(const Vec3f& c) {
  const auto shown = [](float x) {
    return static_cast<float>(log2_of(1 + static_cast<double>(x)) / 16);
  };
  return {shown(c.x), shown(c.y), shown(c.z)};
}

}  // namespace

void show(FeatureDisplay shown, FilmTile& tile) {
  switch (shown) {
    case FeatureDisplay::light:
    case FeatureDisplay::share: return;
    case FeatureDisplay::normal: return for_each_pixel(tile, of_normal);
    case FeatureDisplay::depth: return for_each_pixel(tile, of_depth);
    case FeatureDisplay::number: return for_each_pixel(tile, of_number);
    case FeatureDisplay::cost: return for_each_pixel(tile, of_cost);
  }
}

}  // namespace tia
