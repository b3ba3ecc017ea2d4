#include "core/formulas/parse.h"

#include <gtest/gtest.h>

#include "tests/core/support.h"

namespace tia {
namespace {

const std::vector<std::string_view> x_and_y{"x", "y"};

double value(const std::string& text, double x = 0, double y = 0) {
  const std::array<double, 2> at{x, y};
  const Program program = program_of({text}, {x_and_y, {{"a", 7}, {"pipe", 9}, {"e", 11}}});
  return evaluate(program, at.data());
}

TEST(Parse, PowersBindTightestAndToTheRight) {
  EXPECT_EQ(value("-2^2"), -4);
  EXPECT_EQ(value("(-2)^2"), 4);
  EXPECT_EQ(value("2^-1"), 0.5);
  EXPECT_EQ(value("2^3^2"), 512);
  EXPECT_EQ(value("(2^3)^2"), 64);
  EXPECT_EQ(value("2^-2^2"), 1.0 / 16);
  EXPECT_EQ(value("2^-1*4"), 2);
  EXPECT_EQ(value("2^-1+4"), 4.5);
  EXPECT_EQ(value("-x^2", 3), -9);
  EXPECT_EQ(value("2*x^2", 3), 18);
  EXPECT_EQ(value("x^2/y^2", 6, 3), 4);
  EXPECT_EQ(value("--x^2", 3), 9);
  EXPECT_EQ(value("x^y^2", 2, 3), 512);
}

TEST(Parse, SumsAndProductsAreMadeFromTheLeft) {
  EXPECT_EQ(value("10-4-3"), 3);
  EXPECT_EQ(value("10-(4-3)"), 9);
  EXPECT_EQ(value("12/2*3"), 18);
  EXPECT_EQ(value("12/2/3"), 2);
  EXPECT_EQ(value("12/(2*3)"), 2);
  EXPECT_EQ(value("2+3*4"), 14);
  EXPECT_EQ(value("2*3+4"), 10);
  EXPECT_EQ(value("10-2*3-1"), 3);
}

TEST(Parse, SignsStandBeforeAnyOperand) {
  EXPECT_EQ(value("2*-3"), -6);
  EXPECT_EQ(value("2--3"), 5);
  EXPECT_EQ(value("2---3"), -1);
  EXPECT_EQ(value("6/-3"), -2);
  EXPECT_EQ(value("-2*3"), -6);
  EXPECT_EQ(value("-2+3"), 1);
  EXPECT_EQ(value("-(2+3)"), -5);
  EXPECT_EQ(value("max(-1, -2)"), -1);
}

TEST(Parse, NumbersAreDecimal) {
  EXPECT_EQ(value("12"), 12);
  EXPECT_EQ(value("12."), 12);
  EXPECT_EQ(value(".5"), 0.5);
  EXPECT_EQ(value("0.1"), 0.1);
  EXPECT_EQ(value("007"), 7);
  EXPECT_EQ(value("1e3"), 1000);
  EXPECT_EQ(value("1E3"), 1000);
  EXPECT_EQ(value("1.e+3"), 1000);
  EXPECT_EQ(value(".5e-1"), 0.05);
  EXPECT_EQ(value("2e3-1"), 1999);
  EXPECT_EQ(value("1e-310"), 1e-310);
  EXPECT_EQ(value("1.7976931348623157e308"), std::numeric_limits<double>::max());
  EXPECT_EQ(value("0.30000000000000004"), 0.1 + 0.2);
}

TEST(Parse, NamesAreVariablesParametersAndPi) {
  EXPECT_EQ(value("x-y", 5, 3), 2);
  EXPECT_EQ(value("a*x", 5), 35);
  EXPECT_EQ(value("pi"), pi);
  EXPECT_EQ(value("pipe"), 9);
  EXPECT_EQ(value("e*2"), 22);
  EXPECT_EQ(value("3-e"), -8);
}

TEST(Parse, SpaceMeansNothing) {
  EXPECT_EQ(value(" \t\r\n2 +\n3 * ( x ) ^ 2 ", 4), 50);
  EXPECT_EQ(value("max ( 1 , 2 )"), 2);
}

TEST(Parse, CallsTakeFormulas) {
  EXPECT_EQ(value("max(min(x, y), 2*3)", 7, 8), 7);
  EXPECT_EQ(value("atan2(1, 0)"), pi / 2);
  EXPECT_EQ(value("atan2(0, 1)"), 0);
  EXPECT_EQ(value("-abs(-2)^2"), -4);
  EXPECT_EQ(value("sqrt(4)^3"), 8);
  EXPECT_EQ(value("2^abs(-3)"), 8);
  EXPECT_EQ(value("((((x))))", 3), 3);
}

TEST(Parse, ParametersNeedNamesOfTheirOwn) {
  const auto wrong = [](const std::string& name) {
    Faults faults;
    check_parameters({x_and_y, {{name, 1}}}, Place{}.at("parameters"), faults);
    return faults.empty() ? "" : faults.list().front().pointer;
  };
  for (const char* name : {"a", "A", "_", "a1", "pipe", "sinus", "X"}) EXPECT_EQ(wrong(name), "");
  for (const char* name : {"x", "y", "pi", "sin", "atan2", "1a", "a-b", "a b", "\xC3\xA9"})
    EXPECT_EQ(wrong(name), "/parameters/" + std::string(name)) << name;
  EXPECT_EQ(wrong(""), "/parameters/");
}

}  // namespace
}  // namespace tia
