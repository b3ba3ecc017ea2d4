// Where the sun stands, against published examples.
#include "core/lights/sun_position.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/math/deterministic.h"

namespace tia {
namespace {

// Source: Meeus, "Astronomical algorithms", 2nd ed., p. 62: 1957-10-04.81 is 2436116.31.
TEST(SunPosition, DaysAreCountedFromNoon) {
  EXPECT_EQ(days_since_2000({2000, 1, 1}, {43200}, 0), 0);
  EXPECT_NEAR(days_since_2000({1957, 10, 4}, {69984}, 0), 2436116.31 - 2451545, 1e-9);
  EXPECT_NEAR(days_since_2000({1999, 1, 1}, {0}, 0), 2451179.5 - 2451545, 1e-9);
  EXPECT_NEAR(days_since_2000({2000, 1, 1}, {43200 + 7200}, 2), 0, 1e-12);
}

TEST(SunPosition, MonthsHaveTheirDays) {
  EXPECT_TRUE(exists({2000, 2, 29}));
  EXPECT_TRUE(exists({2024, 2, 29}));
  EXPECT_FALSE(exists({1900, 2, 29}));
  EXPECT_FALSE(exists({2023, 2, 29}));
  EXPECT_FALSE(exists({2023, 4, 31}));
  EXPECT_TRUE(exists({2023, 12, 31}));
}

// At the pole the elevation is the declination. Source: Meeus, example 25.a: 1992-10-13 0h,
// -7.78507 degrees.
TEST(SunPosition, DeclinationIsMeeuss) {
  const double days = days_since_2000({1992, 10, 13}, {0}, 0);
  EXPECT_NEAR(sun_position(days, 90, 0).elevation, -7.78507, 1e-3);
}

// Source: Reda, Andreas, "Solar position algorithm for solar radiation applications", NREL (2008),
// A.5: 39.872046 degrees above the horizon without refraction, azimuth 194.340241.
TEST(SunPosition, StandsWhereNrelsExampleHasIt) {
  const double days = days_since_2000({2003, 10, 17}, {12 * 3600 + 30 * 60 + 30}, -7);
  const SunPosition at = sun_position(days, 39.742476, -105.1786);
  EXPECT_NEAR(at.elevation, 39.872046, 0.01);
  EXPECT_NEAR(at.azimuth, 194.340241, 0.01);
}

// In the north it goes from the east by way of the south to the west.
TEST(SunPosition, RisesInTheEast) {
  const auto azimuth = [](int hour) {
    return sun_position(days_since_2000({2026, 3, 20}, {hour * 3600}, 0), 51.5, 0).azimuth;
  };
  EXPECT_NEAR(azimuth(6), 90, 5);
  EXPECT_NEAR(azimuth(12), 180, 5);
  EXPECT_NEAR(azimuth(18), 270, 5);
}

}  // namespace
}  // namespace tia
