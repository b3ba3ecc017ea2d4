// When a pixel is settled.
#include "tests/core/render/chance.h"

namespace tia {
namespace {

using test::Random;

// Of samples of one channel, the others 0.
Estimate of_values(const std::vector<double>& values) {
  Estimate estimate;
  for (const double value : values) {
    estimate.light.x += value;
    estimate.deviations.x += value - values[0];
    estimate.squares.x += (value - values[0]) * (value - values[0]);
    ++estimate.count;
  }
  return estimate;
}

// The same samples in another channel.
Estimate in_one_of_three(Random& random, Estimate e) {
  const auto axis =
      std::array{&Vec3d::x, &Vec3d::y, &Vec3d::z}[static_cast<std::size_t>(random.below(3))];
  for (Vec3d* sum : {&e.light, &e.deviations, &e.squares}) std::swap(sum->x, (*sum).*axis);
  return e;
}

TEST(Convergence, ByThresholdIsTheStandardErrorOfTheMean) {
  // Values 0, 0, 0, 1: mean 1/4, variance (3/16 + 9/16) / 3 = 1/4, standard error sqrt(1/16).
  Estimate values = of_values({0, 0, 0, 1}), turned = of_values({1, 0, 0, 0});
  const auto settled = [](double threshold, Estimate& estimate) {
    return Convergence({.threshold = threshold}).settle(estimate);
  };
  for (Estimate* each : {&values, &turned}) {
    EXPECT_TRUE(settled(0.2501, *each));
    EXPECT_FALSE(settled(0.2499, *each));
  }
  Estimate equal = of_values({0.5, 0.5, 0.5, 0.5});
  EXPECT_TRUE(settled(1e-9, equal));
}

TEST(Convergence, ByNoiseIsTheLargerChangeThatTheStandardErrorMakesOfWhatIsShown) {
  Random random(140);
  for (const Tone& tone : {Tone{Transfer::linear}, Tone{Transfer::srgb}, Tone{Transfer::srgb, 2}}) {
    for (int i = 0; i < 100; ++i) {
      std::vector<double> values(40);
      const double most = random.in(0.05, 1.5);
      double sum = 0, squares = 0;
      for (double& value : values) {
        value = random.in(0, most);
        sum += value, squares += value * value;
      }
      const double n = 40, mean = sum / n;
      const double error = std::sqrt((squares - n * mean * mean) / (n - 1) / n);
      const auto shown = [&](double light) {
        const double x = std::clamp(light * std::exp2(tone.exposure), 0.0, 1.0);
        if (tone.transfer == Transfer::linear) return x;
        return x <= 0.0031308 ? 12.92 * x : 1.055 * std::pow(x, 1 / 2.4) - 0.055;
      };
      const double expected =
          std::max(shown(mean + error) - shown(mean), shown(mean) - shown(mean - error));
      Estimate estimate = of_values(values);
      const bool settled = Convergence({.noise = 0.02, .tone = tone}).settle(estimate);
      ASSERT_NEAR(estimate.error, expected, 1e-6);
      ASSERT_EQ(settled, expected < 0.02);
    }
  }
}

TEST(Convergence, ByNoiseTakes32SamplesAndMoreWhereOneIsWhite) {
  const Convergence convergence({.noise = 0.1});
  Estimate few = of_values(std::vector<double>(31, 0.5)),
           enough = of_values(std::vector<double>(32, 0.5));
  EXPECT_FALSE(convergence.settle(few));
  EXPECT_TRUE(convergence.settle(enough));
  // What is shown is white as a mean, and would be dark without the one.
  std::vector<double> one(64, 0);
  one[40] = 1000;
  Estimate spark = of_values(one);
  EXPECT_FALSE(convergence.settle(spark));
  EXPECT_GT(spark.error, 0.9F);
}

// Curves that mix channels: what samples of one colour, brighter and darker, do to what is shown is
// never more than the error.
TEST(Convergence, BoundsTheChangeOfColoursThatRiseAndFallTogether) {
  Random random(141);
  for (const Transfer transfer : {Transfer::aces, Transfer::agx}) {
    const Tone tone{transfer, 0.5, 4300};
    for (int i = 0; i < 200; ++i) {
      Vec3d color = random.point(1);
      color = {std::fabs(color.x), std::fabs(color.y), std::fabs(color.z)};
      Estimate e;
      for (int n = 0; n < 64; ++n) {
        const Vec3d light = color * random.unit(),
                    deviation = light - (e.count == 0 ? light : Vec3d(e.first));
        if (e.count == 0) e.first = Vec3f(light);
        e.light = e.light + light;
        e.deviations = e.deviations + deviation;
        e.squares = e.squares + deviation * deviation;
        ++e.count;
      }
      Convergence({.noise = 0.01, .tone = tone}).settle(e);
      const Vec3d mean = e.light * (1.0 / 64);
      const auto se = [&](double sum, double squares) {
        return std::sqrt((squares - sum * sum / 64) / 63 / 64);
      };
      const Vec3d by{se(e.deviations.x, e.squares.x), se(e.deviations.y, e.squares.y),
                     se(e.deviations.z, e.squares.z)};
      const ToneMap map(tone);
      for (const Vec3d& way : {by, -by}) {
        const Vec3d moved = map.signal(mean + way) - map.signal(mean);
        for (const double each : {moved.x, moved.y, moved.z})
          ASSERT_LE(std::fabs(each), 1.1 * static_cast<double>(e.error) + 1e-6);
      }
    }
  }
}

// Where a table rules pixels out, it rules out none that has the largest: that is what each is told
// when it is settled for itself.
TEST(Convergence, TellsTheLargestErrorOfManyAsOfEach) {
  Random random(142);
  for (const Tone& tone : {Tone{}, Tone{Transfer::srgb, 2}, Tone{Transfer::srgb, 0, 4000},
                           Tone{Transfer::linear, -1}, Tone{Transfer::agx}}) {
    const Convergence each({.noise = 1e-9, .tone = tone});
    const Convergence all({.tells_errors = true, .tone = tone});
    for (int i = 0; i < 40; ++i) {
      std::vector<Estimate> estimates;
      float largest = 0;
      const double most = std::exp2(random.in(-8, 3));
      for (int k = 0; k < 64; ++k) {
        const double first = random.in(0, most), second = random.in(0, most);
        Estimate e = in_one_of_three(random, of_values({first, second}));
        estimates.push_back(e);
        EXPECT_FALSE(all.settle(estimates.back()));
        each.settle(e);
        largest = std::max(largest, e.error);
      }
      ASSERT_EQ(all.largest_error(estimates), largest);
    }
  }
  EXPECT_EQ(Convergence({.tells_errors = true}).largest_error({of_values({1})}), 1);
}

}  // namespace
}  // namespace tia
