#include "core/film/tone.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/film/white_balance.h"
#include "core/math/deterministic.h"
#include "core/math/powers.h"

namespace tia {
namespace {

// 2^x, exact where x is whole: tone at 0 stops is none, at 1 twice the light.
double power_of_two(double x) {
  const double whole = std::floor(x);
  return std::ldexp(pow_of(2.0, x - whole), static_cast<int>(whole));
}

// What a float holds, so that no matrix makes NaN of infinity.
double finite(double x) {
  constexpr double most = std::numeric_limits<float>::max();
  if (!(x == x)) return 0;
  return std::clamp(x, -most, most);
}

template <class F>
Vec3d each(const Vec3d& v, F f) {
  return {f(v.x), f(v.y), f(v.z)};
}

// The constants are given by rows, as their sources do.
constexpr Affine rows(const Vec3d& x, const Vec3d& y, const Vec3d& z) {
  return {{x.x, y.x, z.x}, {x.y, y.y, z.y}, {x.z, y.z, z.z}, {}};
}

Vec3d aces(const Vec3d& light) {
  constexpr Affine in =
      rows({0.59719, 0.35458, 0.04823}, {0.07600, 0.90834, 0.01566}, {0.02840, 0.13383, 0.83777});
  constexpr Affine out = rows({1.60475, -0.53108, -0.07367}, {-0.10208, 1.10813, -0.00605},
                              {-0.00327, -0.07276, 1.07602});
  return out.vector(each(in.vector(light), [](double v) {
    return (v * (v + 0.0245786) - 0.000090537) / (v * (0.983729 * v + 0.4329510) + 0.238081);
  }));
}

Vec3d agx(const Vec3d& light) {
  constexpr Affine in = rows({0.842479062253094, 0.0784335999999992, 0.0792237451477643},
                             {0.0423282422610123, 0.878468636469772, 0.0791661274605434},
                             {0.0423756549057051, 0.0784336, 0.879142973793104});
  constexpr Affine out = rows({1.19687900512017, -0.0980208811401368, -0.0990297440797205},
                              {-0.0528968517574562, 1.15190312990417, -0.0989611768448433},
                              {-0.0529716355144438, -0.0980434501171241, 1.15107367264116});
  constexpr double least = -12.47393, most = 4.026069;  // stops: 10 below, 6.5 above 0.18
  return out.vector(each(in.vector(light), [=](double v) {
    const double stops = v > 1e-10 ? std::clamp(log2_of(v), least, most) : least;
    const double x = (stops - least) / (most - least);
    return (((((15.5 * x - 40.14) * x + 31.96) * x - 6.868) * x + 0.4298) * x + 0.1191) * x -
           0.00232;
  }));
}

double srgb_signal(double light) {
  return light <= 0.0031308 ? 12.92 * light : 1.055 * pow_of(light, 1 / 2.4) - 0.055;
}

}  // namespace

ToneMap::ToneMap(const Tone& tone)
    : grade_(Affine::scaling(Vec3d{1, 1, 1} * power_of_two(tone.exposure))),
      transfer_(tone.transfer),
      is_plain_(tone == Tone{encoding() == Encoding::srgb ? Transfer::srgb : Transfer::linear}) {
  if (tone.white_balance_kelvin) grade_ = grade_ * white_balance(*tone.white_balance_kelvin);
}

Vec3d ToneMap::developed(const Vec3d& light) const {
  const Vec3d graded = each(grade_.vector(each(light, finite)), finite);
  // Both curves are of no less than no light.
  const auto positive = [](double x) { return std::max(x, 0.0); };
  switch (transfer_) {
    case Transfer::srgb:
    case Transfer::linear: return graded;
    case Transfer::aces: return aces(each(graded, positive));
    case Transfer::agx: return agx(each(graded, positive));
  }
  return graded;
}

Vec3d ToneMap::signal(const Vec3d& light) const {
  const Vec3d shown = each(developed(light), [](double x) { return std::clamp(x, 0.0, 1.0); });
  return encoding() == Encoding::srgb ? each(shown, srgb_signal) : shown;
}

void develop(const ToneMap& tone, FilmTile& tile) {
  for_each_pixel(tile, [&](const Vec3f& light) { return Vec3f(tone.developed(Vec3d(light))); });
}

}  // namespace tia
