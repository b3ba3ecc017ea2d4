// The points that a pixel's rays go through: their strata, their chance, the error that they leave.
#include "core/render/sampler.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <functional>
#include <set>

#include "core/math/deterministic.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::Random;

// ---- strata -------------------------------------------------------------------------------------

TEST(Strata, TileTheSquareWithCellsOfEqualArea) {
  for (int n = 1; n <= 130; ++n) {
    const Strata strata(n);
    ASSERT_EQ(strata.count(), n);
    std::set<float> rows;
    std::vector<int> cells_in_row;
    float x = 1, y = 0, height = 0;  // where the next cell must begin, if the row is full
    for (int i = 0; i < n; ++i) {
      const Strata::Cell& cell = strata[static_cast<std::uint32_t>(i)];
      EXPECT_NEAR(cell.width * cell.height, 1.0 / n, 1e-7) << n;
      if (rows.insert(cell.y).second) {
        EXPECT_NEAR(x, 1, 1e-6) << "the row before is full";
        y += height;
        height = cell.height;
        x = 0;
        cells_in_row.push_back(0);
      }
      EXPECT_NEAR(cell.x, x, 1e-6);
      EXPECT_NEAR(cell.y, y, 1e-6);
      x += cell.width;
      ++cells_in_row.back();
    }
    EXPECT_NEAR(x, 1, 1e-6);
    EXPECT_NEAR(y + height, 1, 1e-6);
    EXPECT_EQ(static_cast<double>(rows.size()), std::round(std::sqrt(n)));
    const auto [few, many] = std::minmax_element(cells_in_row.begin(), cells_in_row.end());
    EXPECT_LE(*many - *few, 1) << n;
  }
}

bool in_cell(const Strata::Cell& cell, double x, double y) {
  constexpr double slack = 1e-6;
  return x >= cell.x - slack && x <= cell.x + cell.width + slack && y >= cell.y - slack &&
         y <= cell.y + cell.height + slack;
}

TEST(Sampler, PutsOneRayInEachStratumOfThePixel) {
  Random random(80);
  for (const int n : {2, 3, 5, 16, 17, 100, 1000}) {
    const Sampler sampler(n, 0, 7);
    for (int k = 0; k < 20; ++k) {
      const int x = random.below(4000), y = random.below(4000);
      for (int i = 0; i < n; ++i) {
        const Aim<float> aim = sampler.aim(x, y, i);
        EXPECT_TRUE(
            in_cell(sampler.strata(0)[static_cast<std::uint32_t>(i)], aim.dx + 0.5, aim.dy + 0.5));
      }
    }
  }
}

// The unit square's point that square_to_disc maps to a point of the disc.
std::pair<double, double> disc_to_square(double x, double y) {
  const double r = std::hypot(x, y);
  const bool flat = std::fabs(x) > std::fabs(y);
  const double large = std::copysign(r, flat ? x : y);
  const double small =
      flat ? large * std::atan(y / x) / (pi / 4) : large * std::atan(x / y) / (pi / 4);
  return {((flat ? large : small) + 1) / 2, ((flat ? small : large) + 1) / 2};
}

TEST(Sampler, PutsOneRayInEachSquareOfTheLens) {
  Random random(81);
  for (const int n : {4, 16, 64}) {
    const Sampler sampler(n, 0, 8);
    const Strata& strata = sampler.strata(0);
    for (int k = 0; k < 20; ++k) {
      const int x = random.below(4000), y = random.below(4000);
      std::vector<int> rays(static_cast<std::size_t>(n));
      for (int i = 0; i < n; ++i) {
        const Aim<float> aim = sampler.aim(x, y, i);
        const auto [u, v] = disc_to_square(aim.lens_x, aim.lens_y);
        for (std::size_t cell = 0; cell < rays.size(); ++cell)
          rays[cell] += in_cell(strata[static_cast<std::uint32_t>(cell)], u, v);
      }
      for (const int count : rays) EXPECT_GE(count, 1);  // 2 where it lies on an edge
      EXPECT_LE(std::count(rays.begin(), rays.end(), 2), 1);
    }
  }
}

TEST(Sampler, LensAndPixelAreIndependent) {
  // Their correlation over m draws is zero with a deviation of 1/sqrt(m).
  constexpr int n = 9, pixels = 4000;
  const Sampler sampler(n, 0, 9);
  double xx = 0, xy = 0, yx = 0, square_pixel = 0, square_lens = 0;
  for (int p = 0; p < pixels; ++p) {
    for (int i = 0; i < n; ++i) {
      const Aim<float> aim = sampler.aim(p % 640, p / 640, i);
      xx += aim.dx * aim.lens_x;
      xy += aim.dx * aim.lens_y;
      yx += aim.dy * aim.lens_x;
      square_pixel += aim.dx * aim.dx;
      square_lens += aim.lens_x * aim.lens_x;
    }
  }
  const double bound = 5 * std::sqrt(square_pixel * square_lens / (n * pixels));
  for (const double sum : {xx, xy, yx}) EXPECT_LT(std::fabs(sum), bound);
  EXPECT_NEAR(square_pixel / (n * pixels), 1.0 / 12, 0.002) << "variance of a uniform number";
  EXPECT_NEAR(square_lens / (n * pixels), 0.25, 0.006) << "<x^2> over the unit disc is 1/4";
}

TEST(Sampler, OneRayGoesThroughTheCentres) {
  const Sampler sampler(1, 0, 5);
  const Aim<float> aim = sampler.aim(17, 4, 0);
  EXPECT_TRUE(sampler.centered());
  for (const float each : {aim.dx, aim.dy, aim.lens_x, aim.lens_y}) EXPECT_EQ(each, 0);
}

TEST(Sampler, RaysDifferBetweenPixelsSamplesSeedsAndRounds) {
  std::set<std::pair<float, float>> seen;
  int drawn = 0;
  for (const std::int64_t seed : {0LL, 1LL, 1LL << 40})
    for (const auto& [x, y] : {std::pair{0, 0}, {1, 0}, {0, 1}, {639, 479}})
      for (int i = 0; i < 64; ++i, ++drawn) {
        const Aim<float> aim = Sampler(4, 0.1, seed).aim(x, y, i);
        seen.emplace(aim.dx, aim.dy);
      }
  EXPECT_EQ(static_cast<int>(seen.size()), drawn);
}

TEST(Sampler, RoundsDoubleAllRaysSoFarUpToSixteenTimesTheFirst) {
  for (const auto& [samples, first] : {std::pair{1, 4}, {4, 4}, {5, 5}, {64, 64}}) {
    const Sampler sampler(samples, 0.01, 0);
    EXPECT_EQ(least_samples(samples, 0.01), first);
    int all = 0;
    for (int round = 0; round < sampler.rounds(); ++round) {
      EXPECT_EQ(sampler.before(round), all);
      EXPECT_EQ(sampler.strata(round).count(), round == 0 ? first : all);
      all += sampler.strata(round).count();
    }
    EXPECT_EQ(all, 16 * first);
  }
  EXPECT_EQ(Sampler(5, 0, 0).rounds(), 1);
  EXPECT_EQ(least_samples(1, 0), 1);
}

// ---- the error of antialiasing ------------------------------------------------------------------

// A straight edge through a pixel: the half plane nx * x + ny * y < c.
struct Edge {
  double nx, ny, c;
  bool covers(double x, double y) const { return nx * x + ny * y < c; }
};

Edge random_edge(Random& random) {
  const double angle = random.in(0, 2 * pi), nx = std::cos(angle), ny = std::sin(angle);
  return {nx, ny, random.in(-0.3, 0.3)};
}

// The covered area of the unit square about the origin. Its width along x at height y is clamped
// and linear; its integral is that of (s + |nx|/2 - |ny|/2 ...)_+^2 at the four corners:
// area = sum of (+-) max(0, c +- |nx|/2 +- |ny|/2)^2 / (2 |nx| |ny|).
double covered_area(const Edge& edge) {
  const double a = std::fabs(edge.nx) / 2, b = std::fabs(edge.ny) / 2;
  const auto square = [](double x) { return x > 0 ? x * x : 0; };
  const double sum = square(edge.c + a + b) - square(edge.c + a - b) - square(edge.c - a + b) +
                     square(edge.c - a - b);
  return sum / (8 * a * b);
}

using Draw = std::function<std::pair<double, double>(int trial, int sample)>;

// Root of the mean square error of an edge's coverage, over random edges.
double rms_error(int n, const Draw& draw) {
  Random random(82);
  constexpr int trials = 400;
  double squares = 0;
  for (int trial = 0; trial < trials; ++trial) {
    const Edge edge = random_edge(random);
    int covered = 0;
    for (int i = 0; i < n; ++i) {
      const auto [x, y] = draw(trial, i);
      covered += edge.covers(x, y);
    }
    const double error = static_cast<double>(covered) / n - covered_area(edge);
    squares += error * error;
  }
  return std::sqrt(squares / trials);
}

// The slope of log error over log n, by least squares.
double slope(const std::function<Draw(int n)>& draw_of) {
  double sum_x = 0, sum_y = 0, sum_xx = 0, sum_xy = 0, count = 0;
  for (const int n : {4, 7, 16, 23, 64, 90, 256, 347, 1024}) {
    const double x = std::log(n), y = std::log(rms_error(n, draw_of(n)));
    sum_x += x;
    sum_y += y;
    sum_xx += x * x;
    sum_xy += x * y;
    ++count;
  }
  return (sum_xy - sum_x * sum_y / count) / (sum_xx - sum_x * sum_x / count);
}

TEST(Antialiasing, ErrorOfStrataFallsAsTheThreeQuartersPower) {
  // An edge cuts about sqrt(n) of n strata; each brings an independent error of order 1/n, so that
  // the variance is of order sqrt(n) / n^2. Source: Mitchell, "Consequences of stratified sampling
  // in graphics", 1996.
  const double fitted = slope([](int n) -> Draw {
    const auto sampler = std::make_shared<Sampler>(n, 0, 11);
    return [sampler](int trial, int i) {
      const Aim<float> aim = sampler->aim(trial % 64, trial / 64, i);
      return std::pair<double, double>(aim.dx, aim.dy);
    };
  });
  EXPECT_NEAR(fitted, -0.75, 0.08);
}

TEST(Antialiasing, ErrorOfPlainChanceFallsAsTheRoot) {
  const auto random = std::make_shared<Random>(83);
  const double fitted = slope([&](int) -> Draw {
    return [random](int, int) {
      const double x = random->in(-0.5, 0.5);
      return std::pair(x, random->in(-0.5, 0.5));
    };
  });
  EXPECT_NEAR(fitted, -0.5, 0.05);
}

TEST(Antialiasing, MeanHasNoBias) {
  // The mean error over m edges is zero but for its own standard error.
  for (const int n : {2, 3, 16, 23}) {
    Random random(84);
    const Sampler sampler(n, 0, 12);
    constexpr int trials = 10'000;
    double sum = 0, squares = 0;
    for (int trial = 0; trial < trials; ++trial) {
      const Edge edge = random_edge(random);
      int covered = 0;
      for (int i = 0; i < n; ++i) {
        const Aim<float> aim = sampler.aim(trial % 128, trial / 128, i);
        covered += edge.covers(aim.dx, aim.dy);
      }
      const double error = static_cast<double>(covered) / n - covered_area(edge);
      sum += error;
      squares += error * error;
    }
    EXPECT_LT(std::fabs(sum / trials), 4 * std::sqrt(squares) / trials) << n;
  }
}

}  // namespace
}  // namespace tia
