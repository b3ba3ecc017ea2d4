#include "core/input/codec.h"

#include <gtest/gtest.h>

#include "tests/core/faults.h"

namespace tia {
namespace {

using enum FaultKind;
using test::Expected;

enum class Fruit { apple, pear };

}  // namespace
template <>
struct Names<Fruit> {
  static constexpr std::array<std::string_view, 2> names{"apple", "pear"};
};
namespace {

template <class T>
T read_as(const std::string& json, const Spec& spec = {}) {
  T out{};
  Faults faults;
  read_value(parse_json(json), Place{}, spec, faults, out);
  faults.raise();
  return out;
}
template <class T>
void expect_value_refused(const char* json, const Spec& spec, const Expected& fault) {
  test::refusal_by([&](const std::string& text) { read_as<T>(text, spec); })(json, {fault});
}

// ---- numbers ----------------------------------------------------------------------------------

constexpr Spec threads_spec{.about = "threads", .min = 1, .max = 64};
constexpr Spec radius_spec{.about = "the radius", .min = 0, .open_min = true};
constexpr Spec angle_spec{.about = "an angle", .unit = "degrees", .min = -90, .max = 90};

TEST(Codec, NumbersAreBoundedInclusivelyUnlessOpen) {
  EXPECT_EQ(read_as<double>("90", angle_spec), 90);
  EXPECT_EQ(read_as<double>("-90", angle_spec), -90);
  EXPECT_EQ(read_as<double>("5e-324", radius_spec), 5e-324);
  expect_value_refused<double>(
      "90.00000001", angle_spec,
      {out_of_range, "", "90.00000001", "a number from -90 to 90 (degrees)"});
  expect_value_refused<double>("0", radius_spec, {out_of_range, "", "0", "a number above 0"});
  expect_value_refused<double>("-0", radius_spec, {out_of_range, "", "0", "a number above 0"});
}

TEST(Codec, WhatIsNoNumberHasTheWrongType) {
  for (const char* json : {"\"1\"", "null", "true", "[1]", "{}"})
    expect_value_refused<double>(json, angle_spec,
                                 {wrong_type, "", json, "a number from -90 to 90"});
}

TEST(Codec, IntegersAreWholeAndInRange) {
  EXPECT_EQ(read_as<int>("64", threads_spec), 64);
  EXPECT_EQ(read_as<int>("1.0", threads_spec), 1);
  EXPECT_EQ(read_as<int>("1e1", threads_spec), 10);
  expect_value_refused<int>("0", threads_spec, {out_of_range, "", "0", "an integer from 1 to 64"});
  expect_value_refused<int>("65", threads_spec,
                            {out_of_range, "", "65", "an integer from 1 to 64"});
  expect_value_refused<int>("1e9", threads_spec,
                            {out_of_range, "", "1000000000", "an integer from 1 to 64"});
  expect_value_refused<int>("1.5", threads_spec,
                            {wrong_type, "", "1.5", "an integer from 1 to 64"});
  expect_value_refused<int>("\"abc\"", threads_spec,
                            {wrong_type, "", "\"abc\"", "an integer from 1 to 64"});
}

TEST(Codec, IntegersNeverLeaveTheirType) {
  EXPECT_EQ(read_as<int>("2147483647"), 2147483647);
  EXPECT_EQ(read_as<int>("-2147483648"), -2147483647 - 1);
  expect_value_refused<int>("2147483648", {}, {out_of_range, "", "2147483648", "an integer"});
  expect_value_refused<int>("-2147483649", {}, {out_of_range, "", "-2147483649", "an integer"});
  expect_value_refused<int>("1e300", {}, {out_of_range, "", "1e+300", "an integer"});
}

TEST(Codec, IntegersStopWhereDoubleNoLongerTellsThemApart) {
  EXPECT_EQ(read_as<std::int64_t>("9007199254740991"), 9007199254740991);
  EXPECT_EQ(read_as<std::int64_t>("-9007199254740991"), -9007199254740991);
  expect_value_refused<std::int64_t>("9007199254740992", {},
                                     {out_of_range, "", "9007199254740992", "an integer"});
}

TEST(Codec, RangesAreSaidInWords) {
  EXPECT_EQ(range_text({}, false), "a number");
  EXPECT_EQ(range_text(threads_spec, true), "an integer from 1 to 64");
  EXPECT_EQ(range_text(radius_spec, false), "a number above 0");
  EXPECT_EQ(range_text({.min = 2}, false), "a number not below 2");
  EXPECT_EQ(range_text({.max = 3}, true), "an integer not above 3");
  EXPECT_EQ(range_text({.unit = "degrees", .min = 0, .max = 179, .open_min = true}, false),
            "a number above 0, at most 179 (degrees)");
}

TEST(Codec, NaNLiesInNoRange) {
  EXPECT_FALSE(in_range(std::numeric_limits<double>::quiet_NaN(), {}));
  EXPECT_FALSE(in_range(std::numeric_limits<double>::quiet_NaN(), threads_spec));
}

// ---- vectors, colours, words ------------------------------------------------------------------

TEST(Codec, VectorsAreThreeNumbersEachAtItsPlace) {
  EXPECT_EQ(read_as<Vec3d>("[1,-2,0.5]"), (Vec3d{1, -2, 0.5}));
  EXPECT_EQ(to_json(write_value(Vec3d{1, -2, 0.5})), "[1,-2,0.5]");
  expect_value_refused<Vec3d>("[1,2]", {}, {wrong_type, "", "[1,2]", "3 numbers, each a number"});
  expect_value_refused<Vec3d>("[1,2,3,4]", {}, {wrong_type, "", "[1,2,3,4]", "3 numbers"});
  expect_value_refused<Vec3d>("1", {}, {wrong_type, "", "1", "3 numbers"});
  expect_value_refused<Vec3d>("{\"x\":1}", {}, {wrong_type, "", "{\"x\":1}", "3 numbers"});
  expect_value_refused<Vec3d>("[1,\"2\",3]", {}, {wrong_type, "/1", "\"2\"", "a number"});
  expect_value_refused<Vec3d>("[0,0,91]", angle_spec, {out_of_range, "/2", "91", "from -90 to 90"});
  test::expect_faults(test::faults_of([] { read_as<Vec3d>("[null,91,-91]", angle_spec); }),
                      {{wrong_type, "/0", "null", "a number"},
                       {out_of_range, "/1", "91", "from -90 to 90"},
                       {out_of_range, "/2", "-91", "from -90 to 90"}});
}

TEST(Codec, ColoursAreThreeNumbersOrAGreyAndNeverNegative) {
  EXPECT_EQ(read_as<Color>("[0,0.5,2]"), (Color{0, 0.5, 2}));
  EXPECT_EQ(read_as<Color>("0.25"), (Color{0.25, 0.25, 0.25}));
  EXPECT_EQ(to_json(write_value(Color{1, 1, 1})), "[1,1,1]");
  expect_value_refused<Color>("[0,-0.1,0]", {.max = 1e6},
                              {out_of_range, "/1", "-0.1", "a number from 0 to 1000000"});
  expect_value_refused<Color>("-1", {}, {out_of_range, "", "-1", "not below 0"});
  expect_value_refused<Color>("\"red\"", {}, {wrong_type, "", "\"red\"", "3 numbers"});
  expect_value_refused<Color>("2e6", {.max = 1e6}, {out_of_range, "", "2000000", "to 1000000"});
}

TEST(Codec, NamedValuesAreOneOfTheirNames) {
  EXPECT_EQ(read_as<Fruit>("\"pear\""), Fruit::pear);
  EXPECT_EQ(to_json(write_value(Fruit::apple)), "\"apple\"");
  expect_value_refused<Fruit>("\"Apple\"", {},
                              {unknown_name, "", "\"Apple\"", "one of apple, pear", "apple"});
  expect_value_refused<Fruit>("\"banana\"", {},
                              {unknown_name, "", "\"banana\"", "one of apple, pear"});
  expect_value_refused<Fruit>("0", {}, {wrong_type, "", "0", "one of apple, pear"});
}

TEST(Codec, StringsAreStrings) {
  EXPECT_EQ(read_as<std::string>("\"a\""), "a");
  expect_value_refused<std::string>("1", {}, {wrong_type, "", "1", "a string"});
}

// ---- containers -------------------------------------------------------------------------------

TEST(Codec, ListsAndMapsNameTheFaultyElement) {
  EXPECT_EQ(read_as<std::vector<int>>("[3,1]"), (std::vector<int>{3, 1}));
  expect_value_refused<std::vector<int>>("[1,\"x\"]", {},
                                         {wrong_type, "/1", "\"x\"", "an integer"});
  expect_value_refused<std::vector<int>>("{}", {}, {wrong_type, "", "{}", "an array"});
  using Map = std::map<std::string, double>;
  EXPECT_EQ(read_as<Map>(R"({"a/b":1,"c":2})"), (Map{{"a/b", 1}, {"c", 2}}));
  expect_value_refused<Map>(R"({"a/b":null})", {}, {wrong_type, "/a~1b", "null", "a number"});
  expect_value_refused<Map>("[]", {}, {wrong_type, "", "[]", "an object"});
}

TEST(Codec, FixedListsOfIntegersHaveTheirLength) {
  using Crop = std::array<int, 4>;
  EXPECT_EQ(read_as<Crop>("[0,1,2,3]"), (Crop{0, 1, 2, 3}));
  EXPECT_EQ(to_json(write_value(Crop{0, 1, 2, 3})), "[0,1,2,3]");
  expect_value_refused<Crop>("[0,1,2]", {},
                             {wrong_type, "", "[0,1,2]", "4 numbers, each an integer"});
  expect_value_refused<Crop>("[0,1,2,3.5]", {}, {wrong_type, "/3", "3.5", "an integer"});
  expect_value_refused<Crop>("[0,1,2,4294967296]", {.min = 0, .max = 1e9},
                             {out_of_range, "/3", "4294967296", "an integer from 0 to 1000000000"});
}

TEST(Codec, FixedListsMayHoldLists) {
  using Rows = std::array<std::array<double, 2>, 2>;
  EXPECT_EQ(read_as<Rows>("[[0,1],[2,3]]"), (Rows{{{0, 1}, {2, 3}}}));
  EXPECT_EQ(to_json(write_value(Rows{{{0, 1}, {2, 3}}})), "[[0,1],[2,3]]");
  expect_value_refused<Rows>("[[0,1],[2,91]]", angle_spec,
                             {out_of_range, "/1/1", "91", "from -90 to 90"});
  expect_value_refused<Rows>(
      "[0,1,2,3]", {}, {wrong_type, "", "[0,1,2,3]", "2 lists, each 2 numbers, each a number"});
  using Coefficients = std::array<double, 10>;
  EXPECT_EQ(read_as<Coefficients>("[0,1,2,3,4,5,6,7,8,9]")[9], 9);
  expect_value_refused<Coefficients>("[1]", {},
                                     {wrong_type, "", "[1]", "10 numbers, each a number"});
}

TEST(Codec, TruthIsTrueOrFalse) {
  EXPECT_TRUE(read_as<bool>("true"));
  EXPECT_FALSE(read_as<bool>("false"));
  EXPECT_EQ(to_json(write_value(true)), "true");
  for (const char* json : {"1", "\"true\"", "null"})
    expect_value_refused<bool>(json, {}, {wrong_type, "", json, "true or false"});
}

TEST(Codec, ZeroItselfMayBeRefused) {
  constexpr Spec factor{.min = -2, .max = 2, .not_zero = true};
  EXPECT_EQ(read_as<double>("-2", factor), -2);
  EXPECT_EQ(read_as<double>("5e-324", factor), 5e-324);
  for (const char* zero : {"0", "-0.0", "1e-999"})
    expect_value_refused<double>(zero, factor,
                                 {out_of_range, "", "0", "a number from -2 to 2, not 0"});
}

TEST(Codec, NumbersAreOneOrThree) {
  using OneOrThree = std::variant<double, Vec3d>;
  EXPECT_EQ(read_as<OneOrThree>("2"), OneOrThree(2.0));
  EXPECT_EQ(read_as<OneOrThree>("[1,2,3]"), OneOrThree(Vec3d{1, 2, 3}));
  EXPECT_EQ(to_json(write_value(OneOrThree(2.0))), "2");
  EXPECT_EQ(to_json(write_value(OneOrThree(Vec3d{1, 2, 3}))), "[1,2,3]");
  expect_value_refused<OneOrThree>("true", {}, {wrong_type, "", "true", "or one number for all 3"});
}

TEST(Codec, MinusZeroIsReadAsZero) {
  EXPECT_FALSE(std::signbit(read_as<double>("-0.0")));
  EXPECT_FALSE(std::signbit(read_as<Vec3d>("[0,-0.0,0]").y));
}

TEST(Codec, ListsMayNeedSoManyElements) {
  EXPECT_EQ(read_as<std::vector<int>>("[1,2]", {.min_items = 2}).size(), 2U);
  expect_value_refused<std::vector<int>>("[1]", {.min_items = 2},
                                         {wrong_type, "", "[1]", "an array of at least 2"});
}

TEST(Codec, OptionalIsLeftEmptyByAFault) {
  EXPECT_EQ(read_as<std::optional<int>>("5"), 5);
  std::optional<int> out;
  Faults faults;
  read_value(parse_json("\"x\""), Place{}, {}, faults, out);
  EXPECT_FALSE(out.has_value());
  EXPECT_FALSE(faults.empty());
}

}  // namespace
}  // namespace tia
