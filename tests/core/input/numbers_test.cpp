#include "core/input/numbers.h"

#include <gtest/gtest.h>

#include "tests/core/faults.h"

namespace tia {
namespace {

using enum FaultKind;
using test::Expected;
using Floats = Numbers<float>;
using Indices = Numbers<std::uint32_t>;

constexpr Spec position_spec{.about = "positions", .min = -1e9, .max = 1e9};

template <class T>
Numbers<T> read_numbers(const Value& value, const Spec& spec = {}) {
  Numbers<T> out;
  Faults faults;
  read_value(value, Place{}, spec, faults, out);
  faults.raise();
  return out;
}
template <class T>
Numbers<T> read_numbers(const char* json, const Spec& spec = {}) {
  return read_numbers<T>(parse_json(json), spec);
}
template <class T>
void expect_numbers_refused(const char* json, const Spec& spec,
                            const std::vector<Expected>& faults) {
  test::refusal_by([&](const std::string& text) { read_numbers<T>(text.c_str(), spec); })(json,
                                                                                          faults);
}

TEST(Numbers, AreAFlatArray) {
  EXPECT_EQ(read_numbers<float>("[1,-2.5,1e9]", position_spec).values,
            (std::vector<double>{1, -2.5, 1e9}));
  EXPECT_EQ(read_numbers<std::uint32_t>("[0,4294967295]").values,
            (std::vector<std::uint32_t>{0, 4294967295U}));
  EXPECT_TRUE(read_numbers<float>("[]").values.empty());
}

// 1.0f is 0x3F800000, -2.5f is 0xC0200000: bytes 00 00 80 3F 00 00 20 C0.
TEST(Numbers, AreLittleEndianBytesInBase64) {
  EXPECT_EQ(read_numbers<float>(R"({"float32":"AACAPwAAIMA="})").values,
            (std::vector<double>{1, -2.5}));
  // 00 00 00 00, 01 00 00 00, 02 01 00 00
  EXPECT_EQ(read_numbers<std::uint32_t>(R"({"uint32":"AAAAAAEAAAACAQAA"})").values,
            (std::vector<std::uint32_t>{0, 1, 258}));
  EXPECT_TRUE(read_numbers<float>(R"({"float32":""})").values.empty());
}

TEST(Numbers, OfBothSpellingsHaveTheSameText) {
  EXPECT_EQ(to_json(write_value(read_numbers<float>(R"({"float32":"AACAPwAAIMA="})"))), "[1,-2.5]");
  EXPECT_EQ(to_json(write_value(read_numbers<float>("[1.0,-25e-1]"))), "[1,-2.5]");
  EXPECT_EQ(to_json(write_value(read_numbers<std::uint32_t>(R"({"uint32":"AgEAAA=="})"))), "[258]");
  // 0.1f is 0.100000001490116...: its 17 digits read back as it.
  const Floats tenth = read_numbers<float>(R"({"float32":"zczMPQ=="})");
  EXPECT_EQ(tenth.values.at(0), static_cast<double>(0.1F));
  EXPECT_EQ(read_numbers<float>(write_value(tenth)), tenth);
}

TEST(Numbers, NeverHoldMinusZeroWhichTheirTextCannotTell) {
  EXPECT_FALSE(std::signbit(read_numbers<float>(R"({"float32":"AAAAgA=="})").values.at(0)));
  EXPECT_FALSE(std::signbit(read_numbers<float>("[-0.0]").values.at(0)));
}

TEST(Numbers, OfAnArrayAreRefusedEachAtItsPlace) {
  expect_numbers_refused<float>("[0,\"1\",2e9,null]", position_spec,
                                {{wrong_type, "/1", "\"1\"", "a number from -1000000000"},
                                 {out_of_range, "/2", "2000000000", "to 1000000000"},
                                 {wrong_type, "/3", "null", "a number"}});
  expect_numbers_refused<std::uint32_t>(
      "[-1,1.5,4294967296]", {},
      {{out_of_range, "/0", "-1", "an integer from 0 to 4294967295"},
       {wrong_type, "/1", "1.5", "an integer"},
       {out_of_range, "/2", "4294967296", "to 4294967295"}});
}

// NaN is 0x7FC00000, infinity 0x7F800000, 1e10f 0x501502F9.
TEST(Numbers, OfBytesAreRefusedWithTheirIndex) {
  expect_numbers_refused<float>(
      R"({"float32":"AAAAAAAAwH8AAIB/AACA//kCFVA="})", position_spec,
      {{out_of_range, "/float32", "\"NaN at index 1\"", "each a number from -1000000000"},
       {out_of_range, "/float32", "\"Infinity at index 2\"", "each a number"},
       {out_of_range, "/float32", "\"-Infinity at index 3\"", "each a number"},
       {out_of_range, "/float32", "\"10000000000 at index 4\"", "to 1000000000"}});
  expect_numbers_refused<float>(R"({"float32":"AADAfw=="})", {},
                                {{out_of_range, "/float32", "\"NaN at index 0\"", "a number"}});
  expect_numbers_refused<std::uint32_t>(
      R"({"uint32":"AAAAAAoAAAA="})", {.max = 9},
      {{out_of_range, "/uint32", "\"10 at index 1\"", "from 0 to 9"}});
}

TEST(Numbers, OfIllBytesSayFromWhereOn) {
  expect_numbers_refused<float>(
      R"({"float32":"AACA-wAAIMA="})", {},
      {{wrong_type, "/float32", "\"-wAAIMA=\"", "not from its character 4 on"}});
  expect_numbers_refused<float>(R"({"float32":"AACAPwAAIMA"})", {},
                                {{wrong_type, "/float32", "\"\"", "not from its character 11 on"}});
  expect_numbers_refused<float>(R"({"float32":"AACAPwAA"})", {},
                                {{wrong_type, "/float32", "\"6 bytes\"", "4 bytes each"}});
  expect_numbers_refused<float>(
      R"({"float32":5})", {},
      {{wrong_type, "/float32", "5", "little-endian, in base64 (RFC 4648)"}});
}

TEST(Numbers, OfAnotherSpellingAreRefused) {
  expect_numbers_refused<float>("5", position_spec,
                                {{wrong_type, "", "5", R"(or {"float32": "base64"})"}});
  expect_numbers_refused<float>(R"("AACAPw==")", position_spec,
                                {{wrong_type, "", R"("AACAPw==")", "an array of"}});
  expect_numbers_refused<float>("{}", {}, {{missing, "/float32", "", "base64 (RFC 4648)"}});
  expect_numbers_refused<std::uint32_t>(
      R"({"unt32":"","uint32":""})", {},
      {{unknown_name, "/unt32", "\"unt32\"", "uint32", "uint32"}});
  expect_numbers_refused<std::uint32_t>(
      R"({"float32":""})", {},
      {{missing, "/uint32", "", "the numbers: the bytes of uint32"},
       {unknown_name, "/float32", "\"float32\"", "one of uint32"}});
}

TEST(Numbers, AreAtLeastSoMany) {
  constexpr Spec two{.min_items = 2};
  EXPECT_EQ(read_numbers<float>("[1,2]", two).values.size(), 2U);
  expect_numbers_refused<float>("[1]", two, {{wrong_type, "", "[1]", "an array of at least 2"}});
  expect_numbers_refused<float>(
      R"({"float32":"AACAPw=="})", two,
      {{wrong_type, "/float32", "\"4 bytes\"", "at least 2 numbers of 4 bytes"}});
}

TEST(Numbers, AreLeftAsTheyWereByAFault) {
  Floats out{{7}};
  Faults faults;
  read_value(parse_json("[1,null]"), Place{}, {}, faults, out);
  EXPECT_EQ(out.values, std::vector<double>{7});
}

TEST(Numbers, StopAtTwentyFaultsHoweverMany) {
  const Value::Array wrong(200'000, Value("x"));
  EXPECT_EQ(test::faults_of([&] { read_numbers<float>(wrong); }).size(), Faults::most);
}

// Room for a mesh of a third of a million vertices: arrays of numbers do not count as values.
TEST(Numbers, AreAsManyAsAMeshNeeds) {
  std::string text = "[0";
  for (int i = 1; i < 200'000; ++i) text += ",1.25";
  EXPECT_EQ(read_numbers<float>((text + "]").c_str()).values.size(), 200'000U);
}

}  // namespace
}  // namespace tia
