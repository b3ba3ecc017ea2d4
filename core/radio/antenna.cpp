#include "core/radio/antenna.h"

#include <algorithm>
#include <cmath>

#include "core/math/deterministic.h"
#include "core/math/powers.h"
#include "core/math/transform.h"
#include "core/radio/decibels.h"

namespace tia {
namespace {

double isotropic_gain(const Vec3d&) { return 1; }

double dipole_gain(const Vec3d& own) {
  const double aside = own.x * own.x + own.y * own.y;  // sin^2 theta
  if (aside < 1e-18) return 0;
  const double wave = cos_of(pi / 2 * own.z);
  return 1.643 * wave * wave / aside;
}

double patch_gain(const Vec3d& own) {
  constexpr double most = 8, floor = 30, width = 65;
  const auto lost = [=](double degrees) {
    const double share = degrees / width;
    return std::min(12 * share * share, floor);
  };
  const double aside = std::sqrt(own.x * own.x + own.y * own.y);
  const double elevation = atan2_of(own.z, aside) * (180 / pi);
  const double azimuth = atan2_of(own.y, own.x) * (180 / pi);
  return power_of_decibels(most - std::min(lost(elevation) + lost(azimuth), floor));
}

constexpr std::array patterns{isotropic_gain, dipole_gain, patch_gain};
static_assert(patterns.size() == Names<AntennaPattern>::names.size());

// By port how much of theta-hat and of phi-hat.
struct PortMix {
  int count;
  std::array<std::array<double, 2>, 2> of;
};
constexpr double half_root = 0.70710678118654752;
constexpr std::array<PortMix, 4> mixes{{{1, {{{1, 0}}}},
                                        {1, {{{0, 1}}}},
                                        {2, {{{1, 0}, {0, 1}}}},
                                        {2, {{{half_root, half_root}, {half_root, -half_root}}}}}};
static_assert(mixes.size() == Names<Polarization>::names.size());
const PortMix& mix_of(Polarization polarization) {
  return mixes[static_cast<std::size_t>(polarization)];
}

}  // namespace

double gain_of(AntennaPattern pattern, const Vec3d& own) {
  return patterns[static_cast<std::size_t>(pattern)](own);
}

int port_count(Polarization polarization) { return mix_of(polarization).count; }

AntennaPorts ports_of(const Antenna& antenna, const Vec3d& away) {
  const Affine turned = Affine::rotation_degrees(antenna.orientation_degrees);
  const Vec3d x = turned.vector(Vec3d{1, 0, 0}), y = turned.vector(Vec3d{0, 0, -1}),
              z = turned.vector(Vec3d{0, 1, 0});
  const Vec3d own{dot(away, x), dot(away, y), dot(away, z)};
  const double aside = std::sqrt(own.x * own.x + own.y * own.y);
  // At the poles phi is 0.
  const double cosine = aside > 0 ? own.x / aside : 1, sine = aside > 0 ? own.y / aside : 0;
  const Vec3d theta_hat = (x * cosine + y * sine) * own.z - z * aside;
  const Vec3d phi_hat = y * cosine - x * sine;
  const double amplitude = std::sqrt(gain_of(antenna.pattern, own));
  const PortMix& mix = mix_of(antenna.polarization);
  AntennaPorts ports{mix.count, {}};
  for (std::size_t i = 0; i < 2; ++i)
    ports.field[i] = (theta_hat * mix.of[i][0] + phi_hat * mix.of[i][1]) * amplitude;
  return ports;
}

}  // namespace tia
