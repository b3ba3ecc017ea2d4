#include "core/materials/texture_map.h"

#include <algorithm>
#include <cmath>

#include "core/math/deterministic.h"

namespace tia {
namespace {

// Which of n texels a place beyond them is. Source: Khronos, OpenGL 4.6, table 8.20.
int wrapped(double texel, int n, Wrap wrap) {
  const double last = n - 1;
  if (texel >= 0 && texel <= last) return static_cast<int>(texel);
  if (wrap == Wrap::clamp_to_edge) return static_cast<int>(std::clamp(texel, 0.0, last));
  const double period = wrap == Wrap::repeat ? n : 2.0 * n;
  double rest = texel - period * std::floor(texel / period);
  rest = std::clamp(rest, 0.0, period - 1);  // where the quotient was rounded
  return static_cast<int>(rest < n ? rest : period - 1 - rest);
}

// Coordinates in texels of which double knows no halves any more, or that are none, are 0.
double sound(double texels) { return std::fabs(texels) < 0x1p50 ? texels : 0; }

Quad between(const Quad& a, const Quad& b, double share) { return a + (b - a) * Quad(share); }

// The texel in which a place is.
TextureLookup::Four nearest(const TextureMap& map, const Vec2d& uv) {
  const int w = map.pyramid->width(0), h = map.pyramid->height(0);
  const int i = wrapped(std::floor(sound(uv.u * w)), w, map.wrap_u);
  const int j = wrapped(std::floor(sound(uv.v * h)), h, map.wrap_v);
  return {{MipPyramid::place(w, i, j), 0, 0, 0}, 0, 0};
}

// Those around a place. The centre of a texel has its colour.
TextureLookup::Four around(const TextureMap& map, int level, const Vec2d& uv) {
  const int w = map.pyramid->width(level), h = map.pyramid->height(level);
  const double x = sound(uv.u * w) - 0.5, y = sound(uv.v * h) - 0.5;
  const double left = std::floor(x), top = std::floor(y);
  const int i = wrapped(left, w, map.wrap_u), next_i = wrapped(left + 1, w, map.wrap_u);
  const int j = wrapped(top, h, map.wrap_v), next_j = wrapped(top + 1, h, map.wrap_v);
  return {{MipPyramid::place(w, i, j), MipPyramid::place(w, next_i, j),
           MipPyramid::place(w, i, next_j), MipPyramid::place(w, next_i, next_j)},
          x - left,
          y - top};
}

Quad bilinear(const MipPyramid& picture, int level, const TextureLookup::Four& of) {
  const auto& [a, b, c, d] = of.texels;
  const Quad above = between(picture.texel(level, a), picture.texel(level, b), of.right);
  const Quad below = between(picture.texel(level, c), picture.texel(level, d), of.right);
  return between(above, below, of.down);
}

// log2 of what is seen of it, in texels: 0 where that is a texel or less.
double level_at(const TextureMap& map, double footprint) {
  const double area = std::fabs(map.along_u.u * map.along_v.v - map.along_u.v * map.along_v.u) *
                      map.pyramid->width(0) * map.pyramid->height(0);
  const double texels = footprint * std::sqrt(area);
  if (!(texels > 1)) return 0;
  return texels < 0x1p30 ? log2_of(texels) : 30;
}

}  // namespace

void TextureMap::transform(const Vec2d& moved, const Vec2d& scale, double rotation) {
  const double c = cos_of(rotation), s = sin_of(rotation);
  offset = moved;
  along_u = {c * scale.u, -s * scale.u};
  along_v = {s * scale.v, c * scale.v};
}

Vec2d place_in(const TextureMap& map, const Vec2d& uv) {
  const double u = uv.u, v = 1 - uv.v;
  return {map.offset.u + u * map.along_u.u + v * map.along_v.u,
          map.offset.v + u * map.along_u.v + v * map.along_v.v};
}

bool look_alike(const TextureMap& a, const TextureMap& b) {
  return a.uv_set == b.uv_set && a.pyramid->width(0) == b.pyramid->width(0) &&
         a.pyramid->height(0) == b.pyramid->height(0) && a.nearest == b.nearest &&
         a.wrap_u == b.wrap_u && a.wrap_v == b.wrap_v && a.offset == b.offset &&
         a.along_u == b.along_u && a.along_v == b.along_v &&
         a.pyramid->levels() == b.pyramid->levels();
}

TextureLookup lookup_of(const TextureMap& map, const TexturePoint& at) {
  const Vec2d uv = place_in(map, at.uv[map.uv_set]);
  TextureLookup lookup;
  if (map.nearest) {
    lookup.of[0] = nearest(map, uv);
    return lookup;
  }
  const double last = map.pyramid->levels() - 1;
  const double level = std::min(level_at(map, at.footprint[map.uv_set]), last);
  const double below = std::floor(level);
  lookup.level = static_cast<int>(below);
  lookup.next = level - below;
  lookup.of[0] = around(map, lookup.level, uv);
  if (lookup.next > 0) lookup.of[1] = around(map, lookup.level + 1, uv);
  return lookup;
}

Rgba rgba_at(const TextureMap& map, const TextureLookup& lookup) {
  const MipPyramid& picture = *map.pyramid;
  if (map.nearest) return doubles_of(picture.texel(0, lookup.of[0].texels[0]));
  const Quad fine = bilinear(picture, lookup.level, lookup.of[0]);
  if (!(lookup.next > 0)) return doubles_of(fine);
  return doubles_of(between(fine, bilinear(picture, lookup.level + 1, lookup.of[1]), lookup.next));
}

}  // namespace tia
