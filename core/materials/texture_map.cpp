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

Rgba between(const Rgba& a, const Rgba& b, double share) {
  Rgba sum;
  for (std::size_t k = 0; k < 4; ++k) sum[k] = a[k] + (b[k] - a[k]) * share;
  return sum;
}

/// LevelOf: a level of a map's picture, with texels beyond its edges.
struct LevelOf {
  const TextureMap& map;
  int level = 0;

  int width() const { return map.pyramid->width(level); }
  int height() const { return map.pyramid->height(level); }
  int column(double x) const { return wrapped(x, width(), map.wrap_u); }
  int row(double y) const { return wrapped(y, height(), map.wrap_v); }
  Rgba nearest(const Vec2d& uv) const {
    return map.pyramid->texel(level, column(std::floor(sound(uv.u * width()))),
                              row(std::floor(sound(uv.v * height()))));
  }
  // The centre of a texel has its colour.
  Rgba bilinear(const Vec2d& uv) const {
    const double x = sound(uv.u * width()) - 0.5, y = sound(uv.v * height()) - 0.5;
    const double left = std::floor(x), top = std::floor(y);
    const int i = column(left), j = row(top), next_i = column(left + 1), next_j = row(top + 1);
    const MipPyramid& picture = *map.pyramid;
    const Rgba above =
        between(picture.texel(level, i, j), picture.texel(level, next_i, j), x - left);
    const Rgba below =
        between(picture.texel(level, i, next_j), picture.texel(level, next_i, next_j), x - left);
    return between(above, below, y - top);
  }
};

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

Rgba rgba_at(const TextureMap& map, const TexturePoint& at) {
  const Vec2d uv = place_in(map, at.uv[map.uv_set]);
  if (map.nearest) return LevelOf{map}.nearest(uv);
  const double last = map.pyramid->levels() - 1;
  const double level = std::min(level_at(map, at.footprint[map.uv_set]), last);
  const double below = std::floor(level);
  const int first = static_cast<int>(below);
  const Rgba fine = LevelOf{map, first}.bilinear(uv);
  if (level == below) return fine;
  return between(fine, LevelOf{map, first + 1}.bilinear(uv), level - below);
}

}  // namespace tia
