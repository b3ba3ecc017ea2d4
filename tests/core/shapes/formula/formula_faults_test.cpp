// What is refused of implicit, explicit and parametric surfaces: where, what came, what is allowed.
#include <gtest/gtest.h>

#include "core/shapes/formula/explicit.h"
#include "core/shapes/formula/implicit.h"
#include "core/shapes/parametric/parametric.h"
#include "tests/core/shapes/lines.h"

namespace tia {
namespace {

using enum FaultKind;
using namespace test;

std::string implicit_of(const std::string& f, const std::string& more = "") {
  return R"({"f":")" + f + R"(","bounds":{"center":[0,0,0],"radius":1})" + more + "}";
}
std::size_t column_of(const std::vector<Fault>& faults) {
  return faults.size() == 1 ? faults[0].column.value_or(0) : 0;
}

TEST(FormulaFaults, ImplicitNeedsAFormulaAndBounds) {
  expect_faults(faults_in<Implicit>("{}"), {{missing, "/f", "", ""}, {missing, "/bounds", "", ""}});
  const auto faults = faults_in<Implicit>(R"({"f":5,"bounds":{"center":[0,0,0],"radius":1}})");
  ASSERT_FALSE(faults.empty());
  EXPECT_EQ(faults[0].kind, wrong_type);
  EXPECT_EQ(faults[0].pointer, "/f");
  expect_faults(faults_in<Implicit>(R"({"f":"x","bounds":{"center":[0,0,0]}})"),
                {{missing, "/bounds/radius", "", "min and max, or center and radius"}});
  expect_faults(faults_in<Implicit>(R"({"f":"x","bounds":{"min":[0,0,0],"max":[1,0,1]}})"),
                {{out_of_range, "/bounds/max", "[1,0,1]", "above min"}});
}

TEST(FormulaFaults, FormulasSayTheColumn) {
  expect_faults(faults_in<Implicit>(implicit_of("x+")),
                {{out_of_range, "/f", R"("x+")", "at column 3 not the end"}});
  EXPECT_EQ(column_of(faults_in<Implicit>(implicit_of("x+"))), 3U);
  EXPECT_EQ(column_of(faults_in<Implicit>(implicit_of("x + * y"))), 5U);
  EXPECT_EQ(column_of(faults_in<Implicit>(implicit_of("x + 2*w"))), 7U);
  EXPECT_EQ(column_of(faults_in<Implicit>(implicit_of(""))), 1U);
  EXPECT_EQ(column_of(faults_in<Implicit>(implicit_of("u"))), 1U) << "u is parametric's";
  EXPECT_FALSE(faults_in<Implicit>(implicit_of(std::string(5000, '1'))).empty()) << "too long";
  EXPECT_FALSE(faults_in<Implicit>(implicit_of(std::string(200, '(') + "x")).empty()) << "too deep";
}

TEST(FormulaFaults, ParametersAreNamesOfNumbers) {
  const auto with = [](const std::string& parameters) {
    return faults_in<Implicit>(implicit_of("x", R"(,"parameters":)" + parameters));
  };
  EXPECT_TRUE(with(R"({"a":1,"long_name_2":-1e30})").empty());
  for (const char* bad : {R"({"x":1})", R"({"sin":1})", R"({"pi":3})", R"({"2a":1})", R"({"":1})",
                          R"({"a b":1})", R"({"a":1e31})", R"({"a":"1"})", R"({"a":null})"}) {
    const auto faults = with(bad);
    ASSERT_EQ(faults.size(), 1U) << bad;
    EXPECT_EQ(faults[0].pointer.rfind("/parameters", 0), 0U) << bad << faults[0].pointer;
    EXPECT_FALSE(faults[0].allowed.empty()) << bad;
  }
}

TEST(FormulaFaults, ExplicitKnowsXAndYOnly) {
  expect_faults(faults_in<Explicit>("{}"), {{missing, "/z", "", ""}, {missing, "/bounds", "", ""}});
  const auto faults =
      faults_in<Explicit>(R"({"z":"x*y-z","bounds":{"center":[0,0,0],"radius":1}})");
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].kind, unknown_name);
  EXPECT_EQ(faults[0].pointer, "/z");
  EXPECT_EQ(faults[0].column, 5U);
}

TEST(FormulaFaults, ParametricNeedsThreeFormulasAndTwoRanges) {
  expect_faults(faults_in<Parametric>("{}"), {{missing, "/x", "", ""},
                                              {missing, "/y", "", ""},
                                              {missing, "/z", "", ""},
                                              {missing, "/u", "", ""},
                                              {missing, "/v", "", ""}});
  const auto with = [](const std::string& x, const std::string& u) {
    return faults_in<Parametric>(R"({"x":")" + x + R"(","y":"v","z":"u","u":)" + u +
                                 R"(,"v":[0,1]})");
  };
  EXPECT_TRUE(with("u", "[0,1]").empty());
  expect_faults(with("u", "[1,1]"), {{out_of_range, "/u", "[1,1]", "from below to"}});
  expect_faults(with("u", "[2,1]"), {{out_of_range, "/u", "[2,1]", "from below to"}});
  for (const char* bad : {"[0]", "[0,1,2]", "1", "[0,1e10]", R"(["0",1])", "null"}) {
    const auto faults = with("u", bad);
    ASSERT_FALSE(faults.empty()) << bad;
    EXPECT_EQ(faults[0].pointer.rfind("/u", 0), 0U) << bad;
  }
  const auto faults = with("u+x", "[0,1]");
  ASSERT_EQ(faults.size(), 1U);
  EXPECT_EQ(faults[0].pointer, "/x");
  EXPECT_EQ(faults[0].column, 3U);
}

TEST(FormulaFaults, DescriptionsAreWrittenAsTheyWereRead) {
  const std::string implicit =
      R"({"bounds":{"center":[0,0,0],"radius":1},"f":"x-a","parameters":{"a":2}})";
  EXPECT_EQ(to_json(write_value(read_described<Implicit>(parse_json(implicit)))), implicit);
  const std::string parametric = R"({"u":[0,1],"v":[-1,1],"x":"u","y":"v","z":"0"})";
  EXPECT_EQ(to_json(write_value(read_described<Parametric>(parse_json(parametric)))), parametric);
}

}  // namespace
}  // namespace tia
