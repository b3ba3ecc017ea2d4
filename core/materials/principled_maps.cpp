#include "core/materials/principled_maps.h"

#include <algorithm>
#include <cmath>

namespace tia {
namespace {

Vec3d rgb_of(const Rgba& rgba) { return {rgba[0], rgba[1], rgba[2]}; }

// How much of a picture's number counts, which matters to occlusion alone.
double weakened(double value, double strength) {
  return strength == 1 ? value : 1 + strength * (value - 1);
}

}  // namespace

bool emission_varies(const PrincipledMaps& maps) {
  return maps.shines_with_mesh || std::ranges::any_of(maps.uses, [](const MapUse& use) {
           return use.color == &PrincipledNumbers::emissive;
         });
}

void multiply(const PrincipledMaps& maps, TextureReader& reader, PrincipledNumbers& numbers) {
  for (const MapUse& use : maps.uses) {
    const Rgba found = reader.rgba_of(use.map);
    if (use.color != nullptr) numbers.*use.color = numbers.*use.color * rgb_of(found);
    for (const auto& [number, channel] : use.channels)
      numbers.*number = numbers.*number * weakened(found[channel], use.map.strength);
  }
  numbers.alpha = numbers.alpha * reader.at().color[3];
  if (maps.shines_with_mesh) numbers.emissive = numbers.emissive * rgb_of(reader.at().color);
}

double map_alpha(const PrincipledMaps& maps, const TexturePoint& at) {
  double alpha = at.color[3];
  for (const MapUse& use : maps.uses)
    for (const auto& [number, channel] : use.channels)
      if (number == &PrincipledNumbers::alpha) alpha *= rgba_at(use.map, at)[channel];
  return alpha;
}

Vec3d mapped_normal(const TextureMap& map, TextureReader& reader) {
  const Rgba found = reader.rgba_of(map);
  const double scale = map.strength;
  const Vec3d n{(2 * found[0] - 1) * scale, (2 * found[1] - 1) * scale, 2 * found[2] - 1};
  return dot(n, n) > 0 ? normalize(n) : Vec3d{0, 0, 1};
}

Vec2d mapped_grain(const Grain& grain, TextureReader& reader) {
  Vec2d along{1, 0};
  if (grain.map) {
    const Rgba found = reader.rgba_of(*grain.map);
    const double x = 2 * found[0] - 1, y = 2 * found[1] - 1, size = std::sqrt(x * x + y * y);
    if (size > 0) along = {x / size, y / size};
  }
  const auto& [c, s] = grain.turned;
  return {c * along.u - s * along.v, s * along.u + c * along.v};
}

const TextureMap& tangent_map(const PrincipledMaps& maps) {
  static const TextureMap as_it_is;
  if (maps.normal) return *maps.normal;
  if (maps.coat_normal) return *maps.coat_normal;
  return maps.grain && maps.grain->map ? *maps.grain->map : as_it_is;
}

}  // namespace tia
