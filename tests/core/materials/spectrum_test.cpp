// Wavelengths of paths: how far glass bends each, and that all together are white.
#include "core/materials/spectrum.h"

#include <gtest/gtest.h>

#include "tests/core/support.h"

namespace tia {
namespace {

using namespace test;

// Abbe's number, of the indices at sodium's d and hydrogen's F and C lines, is 20 over dispersion.
TEST(Spectrum, PrismsPartColoursByAbbesNumber) {
  Random random(844);
  for (int i = 0; i < 20; ++i) {
    const double ior = random.in(1.3, 2.5), dispersion = random.in(0.1, 1);
    const auto at = [&](double wave) { return ior_at(ior, dispersion, wave); };
    EXPECT_NEAR(at(587.6), ior, 1e-6);
    EXPECT_NEAR((at(587.6) - 1) / (at(486.1) - at(656.3)), 20 / dispersion, 1e-3 * 20 / dispersion);
  }
}
TEST(Spectrum, AllWavesTogetherAreWhite) {
  Vec3d sum{};
  constexpr int count = 3400;
  for (int i = 0; i < count; ++i) sum = sum + wave_color(shortest_wave + (i + 0.5) / 10);
  for (const double mean : {sum.x / count, sum.y / count, sum.z / count})
    EXPECT_NEAR(mean, 1, 1e-3);
  const Vec3d red = wave_color(620.0), blue = wave_color(450.0);
  EXPECT_GT(red.x, 3 * std::fabs(red.z));
  EXPECT_GT(blue.z, 3 * std::fabs(blue.x));
}

}  // namespace
}  // namespace tia
