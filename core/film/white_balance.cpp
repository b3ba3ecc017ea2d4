#include "core/film/white_balance.h"

#include <algorithm>

namespace tia {
namespace {

struct Chromaticity {
  double x, y;
};

Vec3d white_of(const Chromaticity& c) { return {c.x / c.y, 1, (1 - c.x - c.y) / c.y}; }

// By u and v of CIE 1960.
Chromaticity black_body(double t) {
  const double u = (0.860117757 + 1.54118254e-4 * t + 1.28641212e-7 * t * t) /
                   (1 + 8.42420235e-4 * t + 7.08145163e-7 * t * t);
  const double v = (0.317398726 + 4.22806245e-5 * t + 4.20481691e-8 * t * t) /
                   (1 - 2.89741816e-5 * t + 1.61456053e-7 * t * t);
  const double scale = 1 / (2 * u - 8 * v + 4);
  return {3 * u * scale, 2 * v * scale};
}

// Domain: 4000 .. 25000.
Chromaticity daylight(double t) {
  const double r = 1 / t;
  const double x = t <= 7000 ? ((-4.6070e9 * r + 2.9678e6) * r + 0.09911e3) * r + 0.244063
                             : ((-2.0064e9 * r + 1.9018e6) * r + 0.24748e3) * r + 0.237040;
  return {x, (-3 * x + 2.870) * x - 0.275};
}

// The columns of a matrix.
constexpr Affine columns(const Vec3d& x, const Vec3d& y, const Vec3d& z) { return {x, y, z, {}}; }

// Linear sRGB to XYZ: its primaries, so bright that together they are its white.
// Source: IEC 61966-2-1:1999.
constexpr Vec3d srgb_white{0.3127 / 0.3290, 1, (1 - 0.3127 - 0.3290) / 0.3290};
Affine srgb_to_xyz() {
  const Vec3d r = white_of({0.64, 0.33}), g = white_of({0.30, 0.60}), b = white_of({0.15, 0.06});
  const Vec3d bright = columns(r, g, b).inverse().vector(srgb_white);
  return columns(r * bright.x, g * bright.y, b * bright.z);
}

}  // namespace

Vec3d white_point(double kelvin) {
  const double day = std::clamp((kelvin - 4000) / 1000, 0.0, 1.0);
  return white_of(black_body(kelvin)) * (1 - day) +
         white_of(daylight(std::max(kelvin, 4000.0))) * day;
}

Affine white_balance(double kelvin) {
  const Affine bradford =
      columns({0.8951, -0.7502, 0.0389}, {0.2664, 1.7135, -0.0685}, {-0.1614, 0.0367, 1.0296});
  const Vec3d from = bradford.vector(white_point(kelvin)), to = bradford.vector(srgb_white);
  const Affine gains = Affine::scaling({to.x / from.x, to.y / from.y, to.z / from.z});
  const Affine to_eye = bradford * srgb_to_xyz();
  return to_eye.inverse() * gains * to_eye;
}

}  // namespace tia
