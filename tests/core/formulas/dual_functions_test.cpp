// The slopes of each function of formulas, against school mathematics.
#include <gtest/gtest.h>

#include <functional>

#include "core/formulas/parse.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::Long;

std::array<double, 2> slopes_of_text(const char* text, double x, double y) {
  using Slopes = Dual<double, 2>;
  const std::array<Slopes, 2> at{Slopes::variable(x, 0), Slopes::variable(y, 1)};
  return evaluate(program_of({text}, {{"x", "y"}, {}}), at.data()).slope;
}

TEST(Dual, SlopesOfEachFunctionAreItsDerivative) {
  struct Case {
    const char* text;
    std::function<Long(Long, Long)> slope;  ///< by x
  };
  using std::cos, std::sin, std::sqrt, std::exp, std::log, std::cosh, std::sinh, std::pow;
  const std::vector<Case> cases{
      {"x+y", [](Long, Long) { return 1; }},
      {"y-x", [](Long, Long) { return -1; }},
      {"x*y", [](Long, Long y) { return y; }},
      {"x/y", [](Long, Long y) { return 1 / y; }},
      {"y/x", [](Long x, Long y) { return -y / (x * x); }},
      {"x^3", [](Long x, Long) { return 3 * x * x; }},
      {"x^-2", [](Long x, Long) { return -2 / (x * x * x); }},
      {"x^y", [](Long x, Long y) { return y * pow(x, y - 1); }},
      {"y^x", [](Long x, Long y) { return pow(y, x) * log(y); }},
      {"x^2.5", [](Long x, Long) { return 2.5L * pow(x, 1.5L); }},
      {"sqrt(x)", [](Long x, Long) { return 0.5L / sqrt(x); }},
      {"abs(-x)", [](Long, Long) { return 1; }},
      {"min(x, 5+y)", [](Long, Long) { return 1; }},
      {"min(5+y, x)", [](Long, Long) { return 1; }},
      {"min(x, y-5)", [](Long, Long) { return 0; }},
      {"max(x, y-5)", [](Long, Long) { return 1; }},
      {"max(y-5, x)", [](Long, Long) { return 1; }},
      {"max(x, 5+y)", [](Long, Long) { return 0; }},
      {"floor(x)", [](Long, Long) { return 0; }},
      {"exp(x)", [](Long x, Long) { return exp(x); }},
      {"log(x)", [](Long x, Long) { return 1 / x; }},
      {"sin(x)", [](Long x, Long) { return cos(x); }},
      {"cos(x)", [](Long x, Long) { return -sin(x); }},
      {"tan(x)", [](Long x, Long) { return 1 / (cos(x) * cos(x)); }},
      {"asin(x)", [](Long x, Long) { return 1 / sqrt(1 - x * x); }},
      {"acos(x)", [](Long x, Long) { return -1 / sqrt(1 - x * x); }},
      {"atan(x)", [](Long x, Long) { return 1 / (1 + x * x); }},
      {"atan2(x, y)", [](Long x, Long y) { return y / (x * x + y * y); }},
      {"atan2(y, x)", [](Long x, Long y) { return -y / (x * x + y * y); }},
      {"sinh(x)", [](Long x, Long) { return cosh(x); }},
      {"cosh(x)", [](Long x, Long) { return sinh(x); }},
      {"tanh(x)", [](Long x, Long) { return 1 / (cosh(x) * cosh(x)); }},
  };
  test::Random random(1);
  for (const Case& each : cases)
    for (int i = 0; i < 50; ++i) {
      const double x = random.in(0.05, 0.95), y = random.in(0.05, 0.95);
      const double got = slopes_of_text(each.text, x, y)[0];
      const Long expected = each.slope(x, y);
      ASSERT_NEAR(got, static_cast<double>(expected), 1e-13 * (1 + std::fabs(got))) << each.text;
    }
}

TEST(Dual, SlopesAtZeroOfPowers) {
  const auto slope = [](const char* text, double x, double y, std::size_t by) {
    return slopes_of_text(text, x, y)[by];
  };
  EXPECT_EQ(slope("x^2", 0, 0, 0), 0);
  EXPECT_EQ(slope("x^1", 0, 0, 0), 1);
  EXPECT_EQ(slope("x^2.5", 0, 0, 0), 0);
  EXPECT_EQ(slope("x^y", 0, 2, 0), 0);
  EXPECT_EQ(slope("x^y", 0, 2, 1), 0);      // 0^y is 0 for all y > 0
  EXPECT_EQ(slope("sqrt(y)", 0, 0, 0), 0);  // steep, but not by x
}

}  // namespace
}  // namespace tia
