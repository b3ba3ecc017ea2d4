// The scene of the first example of Sionna RT's "Understanding Radio Materials", by the formulas of
// its "Primer on Electromagnetics" (nvlabs.github.io/sionna/rt, release 1), written out here: a
// reflector of half a metre, a slab of permittivity 5, 1 S/m and 0.1 m, at 3.5 GHz, between
// antennas 2 m to either side and 1 m up.
#include <gtest/gtest.h>

#include <complex>

#include "tests/core/radio/rooms.h"

namespace tia {
namespace {

using Std = std::complex<double>;

constexpr double light_speed = 299792458, carrier_hz = 3.5e9,
                 way = 2 * 2.23606797749978969;  // twice sqrt 5

// The reflector in the plane y = 0, which is z = 0 there.
Scene simple_reflector() {
  return test::radio_scene(
      R"({"type":"mesh","material":"m","positions":[-0.25,0,-0.25,-0.25,0,0.25,0.25,0,0.25,0.25,0,-0.25],
          "indices":[0,1,2,0,2,3]})",
      R"({"type":"dielectric","relative_permittivity":5,"conductivity":1,"thickness":0.1})");
}

// R of the single layer slab: r' (1 - e^{-2jq}) / (1 - r'^2 e^{-2jq}).
Std slab(bool parallel) {
  const double cosine = 1 / std::sqrt(5.0);
  const Std eta(5, -1 / (2 * pi * carrier_hz * 8.8541878128e-12));
  const Std root = std::sqrt(eta - (1 - cosine * cosine));
  const Std once =
      parallel ? (eta * cosine - root) / (eta * cosine + root) : (cosine - root) / (cosine + root);
  const Std q = 2 * pi * 0.1 * carrier_hz / light_speed * root, echo = std::exp(Std(0, -2) * q);
  return once * (1.0 - echo) / (1.0 - once * once * echo);
}

TEST(SionnaRt, SimpleReflectorReflectsAsItsSlab) {
  for (const Polarization polarization : {Polarization::vertical, Polarization::horizontal}) {
    for (const RadioMethod method : {RadioMethod::image, RadioMethod::hybrid}) {
      RadioQuestion question = test::link({-2, 1, 0}, {2, 1, 0}, method, carrier_hz);
      question.transmitters[0].polarization = question.receivers[0].polarization = polarization;
      const std::vector<RadioPath> paths = test::paths_of(simple_reflector(), question);
      ASSERT_EQ(paths.size(), 2U);
      // Beside the straight path of 4 m, which has the ports' own signs.
      const Std expected = 4 / way * slab(polarization == Polarization::vertical) *
                           std::polar(1.0, -2 * pi * carrier_hz / light_speed * (way - 4));
      const Complex got = paths[1].gain[0][0] / paths[0].gain[0][0];
      EXPECT_NEAR(std::abs(Std(got.re, got.im) / expected - 1.0), 0, 1e-9);
      EXPECT_NEAR(paths[1].length / light_speed, 14.917e-9, 1e-12);  // by hand
    }
  }
}

}  // namespace
}  // namespace tia
