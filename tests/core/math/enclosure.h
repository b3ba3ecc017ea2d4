// Whether intervals hold what they must, and little more: random boxes against sampled points whose
// values are computed in long double. No expectation about a function lives here.
#pragma once

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <functional>
#include <iomanip>
#include <sstream>

#include "core/formulas/scalars.h"
#include "tests/core/support.h"

namespace tia::test {

inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr double largest = std::numeric_limits<double>::max();

struct Section {
  double lo = 0, hi = 0;
  bool holds(double x) const { return lo <= x && x <= hi; }
};
using Sections = std::array<Section, 8>;

inline std::ostream& operator<<(std::ostream& out, const Section& box) {
  return out << std::setprecision(20) << "[" << box.lo << ", " << box.hi << "]";
}

/// A number of any size, often one at which a function is special.
inline double any_number(Random& random) {
  static constexpr std::array specials{0.0,    0.0,     -0.0,   1.0,    -1.0,    0.5,      2.0,
                                       -2.0,   709.78,  -745.1, 710.3,  1e9,     -1e9,     5e-324,
                                       1e-310, -1e-310, 1e300,  -1e300, largest, -largest, 1e15,
                                       1e-300, 1e154,   -1e154, 1e-154, 20.0,    -20.0,    256.0};
  const double kind = random.unit();
  if (kind < 0.15)
    return specials[static_cast<std::size_t>(random.below(static_cast<int>(specials.size())))];
  const double sign = random.chance(0.5) ? -1 : 1;
  if (kind < 0.25) return random.below(40) * (pi / 2) * sign;
  if (kind < 0.35) return random.below(2000) * sign;
  if (kind < 0.45) return sign * std::pow(10, random.in(-320, 308));
  return sign * std::pow(10, random.in(-12, 6));
}

inline Section any_section(Random& random) {
  const double from = any_number(random), kind = random.unit();
  double to = from;
  if (kind < 0.05) return {from, from};
  if (kind < 0.35) to = any_number(random);
  else if (kind < 0.75) to = from + std::pow(10, random.in(-12, 6));
  else if (kind < 0.90) to = from * (1 + std::pow(10, random.in(-16, 0)));
  else if (kind < 0.94) return {-infinite, from};
  else if (kind < 0.98) return {from, infinite};
  else return {-infinite, infinite};
  if (!(std::fabs(to) <= largest)) to = largest;
  return {std::min(from, to), std::max(from, to)};
}

/// A finite number of the box: an end, close to one, special, or anywhere.
inline double point_in(const Section& box, Random& random) {
  const double lo = std::max(box.lo, -largest), hi = std::min(box.hi, largest),
               kind = random.unit();
  if (kind < 0.2) return lo;
  if (kind < 0.4) return hi;
  const double t = kind < 0.6 ? std::pow(10, random.in(-17, 0)) : random.unit();
  double x = lo * (1 - t) + hi * t;
  if (kind > 0.7 && kind < 0.8) x = std::nearbyint(x / (pi / 2)) * (pi / 2);
  if (kind > 0.8 && kind < 0.9) x = std::nearbyint(x);
  if (kind > 0.9) x = random.in(-2, 2) * std::pow(10, random.in(-3, 3));
  return std::clamp(x, lo, hi);
}

inline Interval<Octet> load(const Sections& boxes) {
  std::array<double, 8> lo{}, hi{};
  for (std::size_t i = 0; i < 8; ++i) lo[i] = boxes[i].lo, hi[i] = boxes[i].hi;
  return {Octet::load_unaligned(lo.data()), Octet::load_unaligned(hi.data())};
}

/// Law: what is known about a function of one or two numbers.
struct Law {
  /// Its exact value; NaN where it has none, infinite at a pole and beyond a long double.
  std::function<Long(Long, Long)> exact;
  /// Whether it jumps or has a pole inside of the box.
  std::function<bool(const Section&, const Section&)> breaks = [](const Section&, const Section&) {
    return false;
  };
  /// Whether its extremes are the corners' values.
  std::function<bool(const Section&, const Section&)> corners = [](const Section&, const Section&) {
    return true;
  };
  double slack = 8 * 0x1p-52;  ///< by what share of itself a bound may be off
};

// The bounds are not far from the extremes, where those are finite, and the corners' values.
inline void expect_tight(const Law& law, const Section& a, const Section& b, const Section& got) {
  Long least = infinite, greatest = -infinite;
  for (const double x : {a.lo, a.hi})
    for (const double y : {b.lo, b.hi}) {
      const Long value = law.exact(x, y);
      if (!(std::fabs(value) <= 1e300L)) return;
      least = std::min(least, value);
      greatest = std::max(greatest, value);
    }
  const Long thin = 16 * 0x1p-1022L;
  ASSERT_GE(got.lo, least - std::fabs(least) * law.slack - thin) << a << ", " << b << ": " << got;
  ASSERT_LE(got.hi, greatest + std::fabs(greatest) * law.slack + thin)
      << a << ", " << b << ": " << got;
}

// `f` at sampled points of the box: exactly, and as doubles compute it.
template <class F>
void expect_held(F f, const Law& law, const Section& a, const Section& b, const Section& got,
                 bool whole, bool some, Random& random) {
  for (int i = 0; i < 4; ++i) {
    const double x = point_in(a, random), y = point_in(b, random);
    Anywhere where;
    const double value = f(x, y, where);
    const Long exact = law.exact(x, y);
    const auto note = [&](const char* what) {
      std::ostringstream text;
      text << what << std::setprecision(20) << " at " << x << ", " << y << " of " << a << ", " << b
           << ": " << exact << " (" << value << ") in " << got;
      return text.str();
    };
    ASSERT_TRUE(some || std::isnan(value)) << note("defined");
    ASSERT_TRUE((got.lo <= value && value <= got.hi) || std::isnan(value)) << note("double");
    ASSERT_FALSE(whole && std::isnan(exact)) << note("undefined");
    ASSERT_TRUE((some && got.lo <= exact && exact <= got.hi) || std::isnan(exact)) << note("exact");
  }
}

/// Expects of f(a, b, where), on random boxes, that its interval holds its values and no more, and
/// that it knows where it is defined; that one box alone gives the same as eight.
template <class F>
void expect_law(F f, const Law& law, std::uint64_t seed, int boxes = 80'000) {
  Random random(seed);
  for (int n = 0; n < boxes; n += 8) {
    Sections a, b;
    for (Section& each : a) each = any_section(random);
    for (Section& each : b) each = any_section(random);
    Definedness<Octet> where;
    const Interval<Octet> all = f(load(a), load(b), where);
    const unsigned whole = bits(where.whole), some = bits(where.some);
    for (std::size_t i = 0; i < 8; ++i) {
      const int k = static_cast<int>(i);
      const Section got{lane(all.lo, k), lane(all.hi, k)};
      const bool is_whole = (whole >> i & 1U) != 0, is_some = (some >> i & 1U) != 0;
      ASSERT_TRUE(got.lo <= got.hi && got.lo < infinite && got.hi > -infinite)
          << a[i] << b[i] << got;
      ASSERT_FALSE(is_whole && law.breaks(a[i], b[i])) << a[i] << ", " << b[i];
      expect_held(f, law, a[i], b[i], got, is_whole, is_some, random);
      if (is_whole && law.corners(a[i], b[i])) expect_tight(law, a[i], b[i], got);
      if (testing::Test::HasFatalFailure()) return;
    }
    Definedness<double> lone;
    const Interval<double> first =
        f(Interval<double>(a[0].lo, a[0].hi), Interval<double>(b[0].lo, b[0].hi), lone);
    ASSERT_EQ(first.lo, lane(all.lo, 0)) << a[0] << ", " << b[0];
    ASSERT_EQ(first.hi, lane(all.hi, 0)) << a[0] << ", " << b[0];
    ASSERT_EQ(lone.whole, (whole & 1U) != 0);
    ASSERT_EQ(lone.some, (some & 1U) != 0);
  }
}

}  // namespace tia::test
