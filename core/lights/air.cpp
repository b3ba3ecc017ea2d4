#include "core/lights/air.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "core/lights/spectrum.h"
#include "core/math/octet.h"
#include "core/math/powers.h"

namespace tia {
namespace {

// ---- the air ----------------------------------------------------------------------------------

// Space/units: metres, and 1/m.
constexpr double earth = 6.36e6, top = 6.42e6;
constexpr double air_height = 8000, dust_height = 1200;  // in which they thin out by e (Nishita)
constexpr double forward = 0.76;                         // dust's g (Nishita)
constexpr double dust_albedo = 0.9;  // Source: Bruneton, Neyret, "Precomputed atmospheric
                                     // scattering" (2008)

// Ozone rises from 10 to 25 km and falls to 40 km. Source: Bruneton, "A qualitative and
// quantitative evaluation of 8 clear sky models" (2017).
template <class S>
struct Densities {
  S air, dust, ozone;
};
template <class S>
Densities<S> densities_at(const S& height) {
  const S off = height - S(25e3), ozone = S(1.0) - max_of(off, -off) / S(15e3);
  return {exp_of(-height / S(air_height)), exp_of(-height / S(dust_height)), max_of(ozone, S(0.0))};
}
Depths density_at(double height) {
  const auto [air, dust, ozone] = densities_at(height);
  return {air, dust, ozone};
}

// ---- integrals --------------------------------------------------------------------------------

/// Quadrature: Gauss and Legendre's nodes in (0, 1) and their weights, by Newton's steps from
/// Tricomi's guess. Source: Press et al., "Numerical Recipes", 3rd ed., 4.6.1.
template <std::size_t n>
struct Quadrature {
  std::array<double, n> at, weight;
  Quadrature() {
    for (std::size_t i = 0; i < n; ++i) {
      double x = cos_of(pi * (static_cast<double>(i) + 0.75) / (n + 0.5)), slope = 1;
      for (int step = 0; step < 8; ++step) {
        double p = 1, before = 0;
        for (std::size_t j = 0; j < n; ++j) {
          const double k = static_cast<double>(j);
          const double next = ((2 * k + 1) * x * p - k * before) / (k + 1);
          before = p, p = next;
        }
        slope = n * (x * p - before) / (x * x - 1);
        x -= p / slope;
      }
      at[i] = (1 - x) / 2;
      weight[i] = 1 / ((1 - x * x) * slope * slope);
    }
  }
};

// How far it is to the air's end for whom the earth's middle is r away and the zenith's cosine c.
double way_out(double r, double c) { return std::sqrt(top * top - r * r * (1 - c * c)) - r * c; }
template <class S>
S distance_from_middle(double r, double c, const S& s) {
  using std::sqrt;  // Octet brings its own
  return sqrt(S(r * r) + s * (s + S(2 * r * c)));
}

// Up to the air's end, eight nodes at once, which are added one by one. Domain: c >= 0, so that all
// thins out on the way; the third power has most nodes where it is thickest.
Depths depths_upwards(double r, double c) {
  static const Quadrature<32> nodes;
  const double length = way_out(r, c);
  Depths sum;
  for (std::size_t i = 0; i < nodes.at.size(); i += Octet::size) {
    const Octet x = Octet::load_unaligned(&nodes.at[i]), s = Octet(length) * x * x * x;
    const auto density = densities_at(distance_from_middle(r, c, s) - Octet(earth));
    const Octet share = Octet(3 * length) * x * x * Octet::load_unaligned(&nodes.weight[i]);
    std::array<double, Octet::size> air, dust, ozone;
    (density.air * share).store_unaligned(air.data());
    (density.dust * share).store_unaligned(dust.data());
    (density.ozone * share).store_unaligned(ozone.data());
    for (std::size_t k = 0; k < Octet::size; ++k) sum = sum + Depths{air[k], dust[k], ozone[k]};
  }
  return sum;
}
// The same in any direction that does not meet the earth: one that leads down first is the whole
// line through its lowest point less what lies behind.
Depths depths_of(double r, double c) {
  if (c >= 0) return depths_upwards(r, c);
  const double lowest = r * std::sqrt(1 - c * c);
  return depths_upwards(lowest, 0) * 2 - depths_upwards(r, -c);
}
bool meets_earth(double r, double c) { return c < 0 && r * r * (1 - c * c) < earth * earth; }

Vec3d visible(const Vec3d& c) {
  return {std::max(c.x, 0.0), std::max(c.y, 0.0), std::max(c.z, 0.0)};
}

// What is left of each wavelength's light, and more of which nothing counts; `dust_taken`: at sea
// level, 1/m.
using Transmittances = std::array<double, (wavelengths + 7) / 8 * 8>;
Transmittances transmittances(const Depths& way, double dust_taken) {
  const Spectrum& of = spectrum();
  Transmittances left{};
  for (std::size_t i = 0; i < wavelengths; ++i)
    left[i] = -(way.air * of.air[i] + way.dust * dust_taken + way.ozone * of.ozone[i]);
  for (std::size_t i = 0; i < left.size(); i += Octet::size)
    exp_of(Octet::load_unaligned(&left[i])).store_unaligned(&left[i]);
  return left;
}

}  // namespace

Air::Air(double sun_elevation_degrees, double turbidity)
    : dust_(std::max(0.0, turbidity - 1) * air_scattering(550) * air_height / dust_height),
      sin_sun_(sin_degrees(sun_elevation_degrees)),
      cos_sun_(cos_degrees(sun_elevation_degrees)) {}

Vec3d Air::sun() const {
  if (sin_sun_ < 0) return {};
  const Transmittances left = transmittances(depths_of(earth, sin_sun_), dust_);
  Vec3d sum{};
  for (std::size_t i = 0; i < wavelengths; ++i) sum = sum + spectrum().light[i] * left[i];
  return visible(sum);
}

std::vector<Air::Node> Air::nodes(double sine) const {
  static const Quadrature<32> of_way;
  const double length = way_out(earth, sine), cosine = std::sqrt(1 - sine * sine);
  const Depths all = depths_of(earth, sine);
  std::vector<Node> list;
  for (std::size_t i = 0; i < of_way.at.size(); ++i) {
    const double t = of_way.at[i], s = length * t * t * t;
    const double r = distance_from_middle(earth, sine, s);
    const Depths beyond = depths_of(r, (earth * sine + s) / r);
    list.push_back({s * cosine, earth + s * sine, all - beyond,
                    density_at(r - earth) * (3 * length * t * t * of_way.weight[i])});
  }
  return list;
}

Scattered Air::scattered(const std::vector<Node>& way, double cos_azimuth) const {
  const Spectrum& of = spectrum();
  Scattered sum;
  for (const Node& node : way) {
    const double r = std::sqrt(node.x * node.x + node.y * node.y);
    const double c = (node.x * cos_azimuth * cos_sun_ + node.y * sin_sun_) / r;
    if (meets_earth(r, c)) continue;
    const Transmittances left = transmittances(node.to_eye + depths_of(r, c), dust_);
    Vec3d air{}, dust{};
    for (std::size_t i = 0; i < wavelengths; ++i) {
      const Vec3d light = of.light[i] * left[i];
      air = air + light * of.air[i];
      dust = dust + light;
    }
    sum = sum + Scattered{air * node.here.air, dust * (node.here.dust * dust_ * dust_albedo)};
  }
  return sum;
}

// Source: Rayleigh; Cornette, Shanks, "Physically reasonable analytic expression for the
// single-scattering phase function", Appl. Opt. 31 (1992).
Vec3d Air::seen(const Scattered& scattered, double sine, double cos_azimuth) const {
  const double c = sine * sin_sun_ + std::sqrt(1 - sine * sine) * cos_sun_ * cos_azimuth;
  constexpr double g2 = forward * forward;
  const double rest = 1 + g2 - 2 * forward * c;
  const double air = 3 / (16 * pi) * (1 + c * c);
  const double dust = 3 / (8 * pi) * (1 - g2) * (1 + c * c) / ((2 + g2) * rest * std::sqrt(rest));
  // Times pi: a white matt surface sends back the pi-th part of what it gets.
  return visible((scattered.by_air * air + scattered.by_dust * dust) * pi);
}

}  // namespace tia
