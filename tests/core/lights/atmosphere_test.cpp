// The sunlit sky, against sums over many small steps, and the numbers that it is made of.
#include "core/lights/atmosphere.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/lights/spectrum.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;
using test::rounds;

// Source: Bucholtz, "Rayleigh-scattering calculations for the terrestrial atmosphere", Appl. Opt.
// 34 (1995), table 3: 1.149e-2 / km at 550 nm, 4.2e-2 / km at 400 nm.
TEST(Spectrum, AirScattersAsBucholtzsTableSays) {
  EXPECT_NEAR(air_scattering(550), 1.149e-5, 2e-7);
  EXPECT_NEAR(air_scattering(400), 4.2e-5, 8e-7);
}

// A black body of 5772 K, which the sun above the air is: CIE 1931 (0.326, 0.335).
TEST(Spectrum, SunAboveTheAirIsABlackBody) {
  Vec3d rgb{};
  for (const Vec3d& each : spectrum().light) rgb = rgb + each;
  const double x = 0.4124 * rgb.x + 0.3576 * rgb.y + 0.1805 * rgb.z;
  const double y = 0.2126 * rgb.x + 0.7152 * rgb.y + 0.0722 * rgb.z;
  const double z = 0.0193 * rgb.x + 0.1192 * rgb.y + 0.9505 * rgb.z;
  EXPECT_NEAR(y, 1, 1e-3);
  EXPECT_NEAR(x / (x + y + z), 0.326, 2e-3);
  EXPECT_NEAR(y / (x + y + z), 0.335, 2e-3);
}

// The same model in steps of equal length, nothing shared but the spectrum.
struct Steps {
  double sun_elevation, turbidity;
  static constexpr double earth = 6.36e6, top = 6.42e6;
  struct Column {
    double air = 0, dust = 0, ozone = 0;
  };
  using Point = std::array<double, 3>;
  static double radius(const Point& p) { return std::hypot(p[0], p[1], p[2]); }
  static Point ahead(const Point& p, const Point& way, double s) {
    return {p[0] + way[0] * s, p[1] + way[1] * s, p[2] + way[2] * s};
  }
  static Column at(const Point& p) {
    const double height = radius(p) - earth;
    return {std::exp(-height / 8000), std::exp(-height / 1200),
            height < 10e3 || height > 40e3 ? 0
            : height < 25e3                ? height / 15e3 - 2.0 / 3
                                           : 8.0 / 3 - height / 15e3};
  }
  static double end(const Point& p, const Point& way) {
    const double b = p[0] * way[0] + p[1] * way[1] + p[2] * way[2], r = radius(p);
    return -b + std::sqrt(b * b - r * r + top * top);
  }
  // Up to the air's end; none where the earth is in the way.
  static std::optional<Column> column(const Point& p, const Point& way) {
    constexpr int steps = 600;
    const double step = end(p, way) / steps;
    Column sum;
    for (int i = 0; i < steps; ++i) {
      const Point q = ahead(p, way, (i + 0.5) * step);
      if (radius(q) < earth) return std::nullopt;
      const Column here = at(q);
      sum.air += here.air * step, sum.dust += here.dust * step, sum.ozone += here.ozone * step;
    }
    return sum;
  }
  double dust() const { return (turbidity - 1) * air_scattering(550) * 8000 / 1200; }
  double kept(const Column& a, const Column& b, std::size_t i) const {
    return std::exp(-(spectrum().air[i] * (a.air + b.air) + dust() * (a.dust + b.dust) +
                      spectrum().ozone[i] * (a.ozone + b.ozone)));
  }
  Vec3d sky(double elevation, double azimuth) const {
    constexpr int steps = 1200;
    const double e = elevation * pi / 180, a = azimuth * pi / 180, s = sun_elevation * pi / 180;
    const Point eye{0, earth, 0};
    const Point way{std::cos(e) * std::cos(a), std::sin(e), std::cos(e) * std::sin(a)};
    const Point sun{std::cos(s), std::sin(s), 0};
    const double c = way[0] * sun[0] + way[1] * sun[1], g = 0.76;
    const double by_air = 3 / (16 * pi) * (1 + c * c);
    const double by_dust = 3 / (8 * pi) * (1 - g * g) * (1 + c * c) /
                           ((2 + g * g) * std::pow(1 + g * g - 2 * g * c, 1.5));
    const double step = end(eye, way) / steps;
    Column passed;
    Vec3d sum{};
    for (int i = 0; i < steps; ++i) {
      const Point p = ahead(eye, way, (i + 0.5) * step);
      const Column here = at(p);
      const auto half = [&] {
        passed.air += here.air * step / 2, passed.dust += here.dust * step / 2;
        passed.ozone += here.ozone * step / 2;
      };
      half();
      if (const auto to_sun = column(p, sun))
        for (std::size_t k = 0; k < wavelengths; ++k)
          sum = sum + spectrum().light[k] * (kept(passed, *to_sun, k) * step * pi *
                                             (spectrum().air[k] * here.air * by_air +
                                              dust() * 0.9 * here.dust * by_dust));
      half();
    }
    return {std::max(sum.x, 0.0), std::max(sum.y, 0.0), std::max(sum.z, 0.0)};
  }
};

TEST(SunlitSky, TableIsTheSumOverManySteps) {
  Random random(930);
  for (int i = 0; i < rounds(6, 1); ++i) {
    const Weather weather{random.in(0, 1) * random.in(0, 90), random.in(1, 6), 0};
    const Steps steps{weather.sun_elevation_degrees, weather.turbidity};
    const SunlitSky sky = make_sunlit_sky(weather);
    // At the centres of texels, where nothing is between.
    for (int k = 0; k < rounds(6, 2); ++k) {
      const int x = random.below(512), y = k == 0 ? 127 : random.below(128);
      const Vec3f got = sky.dome->texel(x, y);
      const Vec3d expected = steps.sky(90 - (y + 0.5) * 180 / 256, (x + 0.5) * 360 / 512 - 180);
      const double most = std::max({expected.x, expected.y, expected.z});
      const auto at = [&] {
        return testing::Message() << weather.sun_elevation_degrees << ", " << weather.turbidity
                                  << " at " << x << ", " << y;
      };
      EXPECT_NEAR(double{got.x}, expected.x, 0.01 * most) << at();
      EXPECT_NEAR(double{got.y}, expected.y, 0.01 * most) << at();
      EXPECT_NEAR(double{got.z}, expected.z, 0.01 * most) << at();
    }
    const auto way = Steps::column({0, Steps::earth, 0},
                                   {std::cos(weather.sun_elevation_degrees * pi / 180),
                                    std::sin(weather.sun_elevation_degrees * pi / 180), 0});
    Vec3d sun{};
    for (std::size_t k = 0; k < wavelengths; ++k)
      sun = sun + spectrum().light[k] * steps.kept(*way, {}, k);
    EXPECT_NEAR(sky.sun.y, sun.y, 0.01 * sun.y);
    EXPECT_NEAR(sky.sun.x, sun.x, 0.01 * sun.x);
  }
}

TEST(SunlitSky, IsAlikeOnBothSidesOfTheSunAndBlueAtNoon) {
  const auto sky = sunlit_sky({60, 2, 0.3});
  for (int x = 0; x < 256; x += 5)
    EXPECT_EQ(sky->dome->texel(x, 40), sky->dome->texel(511 - x, 40));
  const Vec3f away = sunlit_sky({60, 1.3, 0.3})->dome->texel(0, 40);
  EXPECT_GT(away.z, 2 * away.x);
  EXPECT_EQ(sunlit_sky({60, 2, 0.3}), sky) << "kept";
}

TEST(SunlitSky, GroundSendsBackItsShareOfSunAndDome) {
  const auto sky = sunlit_sky({30, 3, 0.4});
  double sum = 0;
  for (int y = 0; y < 128; ++y)
    for (int x = 0; x < 512; ++x) {
      const double upper = std::sin(pi * y / 256), lower = std::sin(pi * (y + 1) / 256);
      sum += double{sky->dome->texel(x, y).y} * (lower * lower - upper * upper) / 512;
    }
  const double expected = 0.4 * (sum + sky->sun.y * 0.5);
  EXPECT_NEAR(double{sky->dome->texel(17, 200).y}, expected, 1e-5 * expected);
}

TEST(SunlitSky, NightIsDark) {
  const auto sky = sunlit_sky({-40, 2, 0.2});
  EXPECT_EQ(sky->sun, Vec3d{});
  EXPECT_EQ(sky->dome->texel(3, 3), Vec3f{});
  const auto dusk = sunlit_sky({-3, 2, 0.2});
  EXPECT_EQ(dusk->sun, Vec3d{});
  EXPECT_GT(dusk->dome->texel(256, 120).x, 0);
}

}  // namespace
}  // namespace tia
