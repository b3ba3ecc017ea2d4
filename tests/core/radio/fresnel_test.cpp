// Reflection and transmission against closed forms, and the table of materials.
#include "core/radio/fresnel.h"

#include <gtest/gtest.h>

#include <complex>

#include "core/radio/permittivity.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;
using Std = std::complex<double>;

Std of(const Complex& z) { return {z.re, z.im}; }

TEST(RadioComplex, IsArithmetic) {
  Random random(1);
  for (int i = 0; i < 200; ++i) {
    const auto some = [&] {
      const double re = random.in(-3, 3);
      return Complex{re, random.in(-3, 3)};
    };
    const Complex a = some(), b = some();
    EXPECT_NEAR(std::abs(of(a * b) - of(a) * of(b)), 0, 1e-14);
    EXPECT_NEAR(std::abs(of(a / b) - of(a) / of(b)), 0, 1e-14 * std::abs(of(a) / of(b)) + 1e-15);
    EXPECT_NEAR(std::abs(of(sqrt_of(a)) - std::sqrt(of(a))), 0, 1e-15 * 4);
    EXPECT_GE(sqrt_of(a).re, 0);
  }
  EXPECT_EQ(sqrt_of({-4, 0}), (Complex{0, -2}));  // the limit of what is lossy
  EXPECT_EQ(sqrt_of({4, 0}), (Complex{2, 0}));
}

// (1 - n)/(1 + n) for the field, n the root of eta; the parallel one is its negative in the basis
// that turns with the ray.
TEST(Fresnel, StraightOnIsOneLessIndexOverOneAndIndex) {
  Random random(2);
  for (int i = 0; i < 50; ++i) {
    const double real = random.in(1, 30);
    const Complex eta{real, -random.in(0, 5)};
    const Std n = std::sqrt(of(eta)), r = (1.0 - n) / (1.0 + n);
    const Polarized got = half_space(eta, 1);
    EXPECT_NEAR(std::abs(of(got.perpendicular) - r), 0, 1e-14);
    EXPECT_NEAR(std::abs(of(got.parallel) + r), 0, 1e-14);
  }
}

TEST(Fresnel, NothingParallelIsReflectedAtBrewstersAngle) {
  for (const double eta : {1.5, 5.24, 31.0}) {
    const double cosine = 1 / std::sqrt(1 + eta);  // tan theta = n
    EXPECT_NEAR(half_space({eta, 0}, cosine).parallel.re, 0, 1e-15);
    EXPECT_LT(half_space({eta, 0}, cosine).perpendicular.re, -0.1);
  }
}

TEST(Fresnel, GrazingTurnsBothFieldsOver) {
  const Polarized r = half_space({5.24, -0.3}, 1e-9);
  EXPECT_NEAR(std::abs(of(r.perpendicular) + 1.0), 0, 2e-9);
  EXPECT_NEAR(std::abs(of(r.parallel) + 1.0), 0, 1e-8);
}

// |r|^2 + q/cos |t|^2 = 1 with t = 1 + r of the field across, and for the other n t = 1 + r.
TEST(Fresnel, LosslessReflectionAndTransmissionMakeOne) {
  Random random(3);
  for (int i = 0; i < 100; ++i) {
    const double eta = random.in(1, 20), cosine = random.in(0.01, 1);
    const double q = std::sqrt(eta - (1 - cosine * cosine));
    const Polarized r = half_space({eta, 0}, cosine);
    const double across = 1 + r.perpendicular.re, in = (1 + r.parallel.re) / std::sqrt(eta);
    EXPECT_NEAR(norm_of(r.perpendicular) + q / cosine * across * across, 1, 1e-13);
    EXPECT_NEAR(norm_of(r.parallel) + q / cosine * in * in, 1, 1e-13);
    const Polarized door = half_space_through({eta, 0}, cosine);
    EXPECT_NEAR(norm_of(door.perpendicular), 1 - norm_of(r.perpendicular), 1e-13);
  }
}

// A sheet as the sum of all ways back and forth in it, computed term by term.
TEST(Sheet, IsTheSumOfItsEchoes) {
  Random random(4);
  for (int i = 0; i < 40; ++i) {
    const double real = random.in(1.5, 9);
    const Complex eta{real, -random.in(0.01, 1)};
    const double cosine = random.in(0.1, 1), thickness = random.in(0.01, 0.3);
    const Wave wave{random.in(1e9, 6e9)};
    const Std q = std::sqrt(of(eta) - (1 - cosine * cosine)), j{0, 1};
    const double kd = 2 * pi * wave.frequency / 299792458.0 * thickness;
    const Std once = std::exp(-j * kd * q);
    const auto check = [&](Std r, const Complex& reflected, const Complex& passed) {
      Std back = r, on = 0, echo = (1.0 - r * r) * once;
      for (int n = 0; n < 400; ++n) {
        on += echo;
        back -= echo * once * r;  // the other side's r is -r
        echo *= r * r * once * once;
      }
      on *= std::exp(j * kd * cosine);  // referred to the undisturbed ray
      EXPECT_NEAR(std::abs(back - of(reflected)), 0, 1e-12);
      EXPECT_NEAR(std::abs(on - of(passed)), 0, 1e-12);
    };
    const Polarized r = half_space(eta, cosine);
    const SheetFactors got = sheet(eta, cosine, thickness, wave);
    check(of(r.perpendicular), got.reflected.perpendicular, got.transmitted.perpendicular);
    check(of(r.parallel), got.reflected.parallel, got.transmitted.parallel);
  }
}

TEST(Sheet, HalfAWaveThickIsAWindow) {
  const Wave wave{2.4e9};
  for (const double cosine : {1.0, 0.6}) {
    const double q = std::sqrt(4 - (1 - cosine * cosine));
    const SheetFactors got = sheet({4, 0}, cosine, wave.length() / (2 * q), wave);
    EXPECT_NEAR(norm_of(got.reflected.perpendicular), 0, 1e-28);
    EXPECT_NEAR(norm_of(got.transmitted.parallel), 1, 1e-14);
  }
}

TEST(Sheet, LosslessKeepsAllPowerAndThickLossyIsAHalfSpace) {
  Random random(5);
  for (int i = 0; i < 50; ++i) {
    const double eta = random.in(1.1, 12), cosine = random.in(0.05, 1), d = random.in(0.001, 0.5);
    const SheetFactors got = sheet({eta, 0}, cosine, d, {5e9});
    EXPECT_NEAR(norm_of(got.reflected.perpendicular) + norm_of(got.transmitted.perpendicular), 1,
                1e-12);
    EXPECT_NEAR(norm_of(got.reflected.parallel) + norm_of(got.transmitted.parallel), 1, 1e-12);
    const Polarized half = half_space({eta, -0.5}, cosine);
    const SheetFactors thick = sheet({eta, -0.5}, cosine, 50, {5e9});
    EXPECT_NEAR(std::abs(of(thick.reflected.parallel) - of(half.parallel)), 0, 1e-12);
    EXPECT_LT(norm_of(thick.transmitted.perpendicular), 1e-20);
  }
}

// Source: ITU-R P.2040-3, table 3, by its own formulas eta' = a f^b, eta'' = 17.98 sigma/f (29),
// whose factor 17.98 is rounded.
TEST(ItuMaterials, AllRowsAreTheRecommendationsAtTheirBandsEnds) {
  ASSERT_EQ(itu_rows.size(), 14U);
  for (std::size_t i = 0; i < itu_rows.size(); ++i) {
    const ItuRow& row = itu_rows[i];
    const RadioMaterial is{ItuRadio{static_cast<ItuMaterial>(i)}};
    for (const double ghz : {row.low_ghz, row.high_ghz}) {
      const Wave wave{ghz * 1e9};
      const RadioMatter got = matter_of(is, wave);
      const double sigma = row.c * std::pow(ghz, row.d);
      EXPECT_NEAR(got.eta.re, row.a * std::pow(ghz, row.b), 1e-12 * row.a) << row.name;
      EXPECT_NEAR(-got.eta.im, 17.98 * sigma / ghz, 1e-3 * 17.98 * sigma / ghz) << row.name;
      EXPECT_EQ(band_warning(is, wave), "");
    }
    if (row.high_ghz < 300) EXPECT_NE(band_warning(is, {row.high_ghz * 1.01e9}), "") << row.name;
    if (row.low_ghz > 0.001) EXPECT_NE(band_warning(is, {row.low_ghz * 0.99e9}), "") << row.name;
  }
}

// Values that others publish for 5 GHz and 28 GHz, to their digits: concrete's conductivity
// 0.0462 f^0.7822 and glass' relative permittivity.
TEST(ItuMaterials, ConcreteAndGlassAtKnownFrequencies) {
  const auto imaginary = [](const char* name, double hz) {
    for (std::size_t i = 0; i < itu_rows.size(); ++i)
      if (itu_rows[i].name == name)
        return matter_of({ItuRadio{static_cast<ItuMaterial>(i)}}, {hz}).eta;
    return Complex{};
  };
  EXPECT_NEAR(imaginary("concrete", 5e9).im, -0.0462 * 3.5215 * 17.975 / 5, 1e-3);
  EXPECT_DOUBLE_EQ(imaginary("glass", 28e9).re, 6.31);
  EXPECT_NEAR(imaginary("wet_ground", 10e9).re, 30 * 0.39810717, 1e-6);
}

}  // namespace
}  // namespace tia
