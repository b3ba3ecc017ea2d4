// Antennas: their gains, frames and polarisations.
#include "core/radio/antenna.h"

#include <gtest/gtest.h>

#include "core/math/onb.h"
#include "core/radio/decibels.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;

// The mean gain over the sphere, by the midpoint rule.
double mean_gain(AntennaPattern pattern) {
  constexpr int rows = 400, columns = 400;
  double sum = 0;
  for (int i = 0; i < rows; ++i)
    for (int k = 0; k < columns; ++k) {
      const double z = 1 - 2 * (i + 0.5) / rows, phi = 2 * pi * (k + 0.5) / columns;
      const double aside = std::sqrt(1 - z * z);
      sum += gain_of(pattern, {aside * std::cos(phi), aside * std::sin(phi), z});
    }
  return sum / (rows * columns);
}

TEST(RadioAntenna, IsotropicAndDipoleSendWhatTheyAreGiven) {
  EXPECT_DOUBLE_EQ(mean_gain(AntennaPattern::isotropic), 1);
  // A half wave's directivity is 1.640922 (Balanis, (4-91)); 1.643 is what the contract has.
  EXPECT_NEAR(mean_gain(AntennaPattern::dipole), 1.643 / 1.640922, 2e-5);
  EXPECT_NEAR(gain_of(AntennaPattern::dipole, {1, 0, 0}), 1.643, 1e-12);
  EXPECT_EQ(gain_of(AntennaPattern::dipole, {0, 0, 1}), 0);
}

// 3GPP TR 38.901, table 7.3-1: 8 dBi ahead, 3 dB less at half of 65 degrees, 30 dB less behind.
TEST(RadioAntenna, PatchIsThe3gppElement) {
  const auto gain = [](double elevation, double azimuth) {
    const double e = elevation * pi / 180, a = azimuth * pi / 180;
    return decibels_of(gain_of(AntennaPattern::patch, {std::cos(e) * std::cos(a),
                                                       std::cos(e) * std::sin(a), std::sin(e)}));
  };
  EXPECT_NEAR(gain(0, 0), 8, 1e-12);
  EXPECT_NEAR(gain(32.5, 0), 5, 1e-12);
  EXPECT_NEAR(gain(0, -32.5), 5, 1e-12);
  EXPECT_NEAR(gain(32.5, 32.5), 2, 1e-12);
  EXPECT_NEAR(gain(0, 180), -22, 1e-12);
}

TEST(RadioAntenna, PortsArePerpendicularToTheRayAndToEachOther) {
  Random random(1);
  for (const Polarization polarization : {Polarization::cross, Polarization::slant})
    for (int i = 0; i < 50; ++i) {
      Antenna antenna{.polarization = polarization};
      antenna.orientation_degrees.x = random.in(-180, 180);
      antenna.orientation_degrees.y = random.in(-180, 180);
      const double y = random.in(-1, 1), x = random.in(-1, 1);
      const Vec3d away = unit(Vec3d{x, y, random.in(-1, 1)});
      const AntennaPorts ports = ports_of(antenna, away);
      ASSERT_EQ(ports.count, 2);
      EXPECT_NEAR(dot(ports.field[0], ports.field[1]), 0, 1e-14);
      for (const Vec3d& field : ports.field) {
        EXPECT_NEAR(dot(field, away), 0, 1e-14);
        EXPECT_NEAR(length(field), 1, 1e-14);
      }
    }
}

// z' is y, x' is x: along x theta-hat is -y, and phi-hat y' = -z.
TEST(RadioAntenna, UnturnedFrameIsTheScenes) {
  Antenna antenna{.polarization = Polarization::cross};
  const AntennaPorts ports = ports_of(antenna, {1, 0, 0});
  EXPECT_EQ(ports.field[0], (Vec3d{0, -1, 0}));
  EXPECT_EQ(ports.field[1], (Vec3d{0, 0, -1}));
  antenna.orientation_degrees = {0, 90, 0};  // turns x to -z
  antenna.pattern = AntennaPattern::patch;
  EXPECT_NEAR(length(ports_of(antenna, {0, 0, -1}).field[0]), std::sqrt(power_of_decibels(8)),
              1e-12);
  antenna.polarization = Polarization::slant;
  const double half = std::sqrt(0.5);
  antenna = {.polarization = Polarization::slant};
  EXPECT_NEAR(ports_of(antenna, {1, 0, 0}).field[0].y, -half, 1e-15);
  EXPECT_NEAR(ports_of(antenna, {1, 0, 0}).field[1].z, half, 1e-15);
}

}  // namespace
}  // namespace tia
