// JSON out: RFC 8785's own examples, and the laws around them.
#include <gtest/gtest.h>

#include "core/input/json.h"
#include "tests/core/support.h"

namespace tia {
namespace {

std::string again(std::string_view json) { return to_json(parse_json(json)); }

TEST(CanonicalText, NumbersAreAsInRfc8785AppendixB) {
  struct Row {
    std::uint64_t bits;
    const char* text;
  };
  const Row table[] = {
      {0x0000000000000000, "0"},
      {0x8000000000000000, "0"},
      {0x0000000000000001, "5e-324"},
      {0x8000000000000001, "-5e-324"},
      {0x7fefffffffffffff, "1.7976931348623157e+308"},
      {0xffefffffffffffff, "-1.7976931348623157e+308"},
      {0x4340000000000000, "9007199254740992"},
      {0xc340000000000000, "-9007199254740992"},
      {0x4430000000000000, "295147905179352830000"},
      {0x44b52d02c7e14af5, "9.999999999999997e+22"},
      {0x44b52d02c7e14af6, "1e+23"},
      {0x44b52d02c7e14af7, "1.0000000000000001e+23"},
      {0x444b1ae4d6e2ef4e, "999999999999999700000"},
      {0x444b1ae4d6e2ef4f, "999999999999999900000"},
      {0x444b1ae4d6e2ef50, "1e+21"},
      {0x3eb0c6f7a0b5ed8c, "9.999999999999997e-7"},
      {0x3eb0c6f7a0b5ed8d, "0.000001"},
      {0x41b3de4355555553, "333333333.3333332"},
      {0x41b3de4355555554, "333333333.33333325"},
      {0x41b3de4355555555, "333333333.3333333"},
      {0x41b3de4355555556, "333333333.3333334"},
      {0x41b3de4355555557, "333333333.33333343"},
      {0xbecbf647612f3696, "-0.0000033333333333333333"},
      {0x43143ff3c1cb0959, "1424953923781206.2"},
  };
  for (const Row& row : table)
    EXPECT_EQ(number_text(std::bit_cast<double>(row.bits)), row.text) << row.bits;
}

TEST(CanonicalText, NumbersThatJsonLacksAreNull) {
  // Appendix B: NaN and infinity are errors; the writer's domain ends before them.
  for (const std::uint64_t bits : {0x7fffffffffffffffU, 0x7ff0000000000000U, 0xfff0000000000000U})
    EXPECT_EQ(number_text(std::bit_cast<double>(bits)), "null");
}

TEST(CanonicalText, IntegersAndCommonFractionsReadAsWritten) {
  for (const char* text : {"1", "-1", "10", "640", "1000000000", "0.5", "0.25", "12.5", "0.8",
                           "-0.001", "100000000000000000000", "1e-7", "1.5e-10", "2e+21"})
    EXPECT_EQ(number_text(std::strtod(text, nullptr)), text);
}

TEST(CanonicalText, NumbersReadBackAsTheSameDouble) {
  test::Random random(140);
  for (int i = 0; i < 200'000; ++i) {
    const auto bits = static_cast<std::uint64_t>(random.unit() * 0x1p32) << 32U |
                      static_cast<std::uint64_t>(random.unit() * 0x1p32);
    const double number = std::bit_cast<double>(bits);
    if (!std::isfinite(number)) continue;
    const std::string text = number_text(number);
    ASSERT_EQ(std::strtod(text.c_str(), nullptr), number) << text;
    ASSERT_EQ(*parse_json(text).as<double>(), number) << text;
    ASSERT_LE(text.size(), 25U) << text;
  }
}

TEST(CanonicalText, KeysSortByUtf16CodeUnitsAsInRfc8785) {
  // Section 3.2.3: U+1F600, whose first unit is D83D, comes before U+FB33.
  EXPECT_EQ(again(R"({
    "\u20ac": "Euro Sign",
    "\r": "Carriage Return",
    "\ufb33": "Hebrew Letter Dalet With Dagesh",
    "1": "One",
    "\ud83d\ude00": "Emoji: Grinning Face",
    "\u0080": "Control",
    "\u00f6": "Latin Small Letter O With Diaeresis"
  })"),
            "{\"\\r\":\"Carriage Return\",\"1\":\"One\",\"\xC2\x80\":\"Control\","
            "\"\xC3\xB6\":\"Latin Small Letter O With Diaeresis\","
            "\"\xE2\x82\xAC\":\"Euro Sign\",\"\xF0\x9F\x98\x80\":\"Emoji: Grinning Face\","
            "\"\xEF\xAC\xB3\":\"Hebrew Letter Dalet With Dagesh\"}");
}

TEST(CanonicalText, WholeSampleIsAsInRfc8785) {
  // Sections 3.2.2 and 3.2.4.
  EXPECT_EQ(again(R"({
    "numbers": [333333333.33333329, 1E30, 4.50, 2e-3, 0.000000000000000000000000001],
    "string": "\u20ac$\u000F\u000aA'\u0042\u0022\u005c\\\"\/",
    "literals": [null, true, false]
  })"),
            "{\"literals\":[null,true,false],\"numbers\":[333333333.3333333,1e+30,4.5,0.002,1e-27],"
            "\"string\":\"\xE2\x82\xAC$\\u000f\\nA'B\\\"\\\\\\\\\\\"/\"}");
}

TEST(CanonicalText, OnlyWhatMustBeEscapedIs) {
  EXPECT_EQ(to_json(Value("\b\t\n\f\r\"\\/\x7F")), "\"\\b\\t\\n\\f\\r\\\"\\\\/\x7F\"");
  std::string controls;
  for (char c = 1; c < 0x20; ++c) controls += c;
  EXPECT_EQ(
      to_json(Value(controls)),
      R"("\u0001\u0002\u0003\u0004\u0005\u0006\u0007\b\t\n\u000b\f\r\u000e\u000f\u0010\u0011)"
      R"(\u0012\u0013\u0014\u0015\u0016\u0017\u0018\u0019\u001a\u001b\u001c\u001d\u001e\u001f")");
  EXPECT_EQ(to_json(Value(std::string(1, '\0'))), "\"\\u0000\"");
}

TEST(CanonicalText, IllFormedUtf8BecomesTheReplacementCharacter) {
  const std::string r = "\xEF\xBF\xBD";
  EXPECT_EQ(to_json(Value("a\xFF\x62")), "\"a" + r + "b\"");
  EXPECT_EQ(to_json(Value("\xC3")), "\"" + r + "\"");
  EXPECT_EQ(to_json(Value("\xC0\x80")), "\"" + r + r + "\"");          // overlong
  EXPECT_EQ(to_json(Value("\xED\xA0\x80")), "\"" + r + r + r + "\"");  // a surrogate
  EXPECT_EQ(to_json(Value("\xF4\x90\x80\x80")), "\"" + r + r + r + r + "\"");
  EXPECT_EQ(to_json(Value("\xF4\x8F\xBF\xBF")), "\"\xF4\x8F\xBF\xBF\"");  // U+10FFFF is well-formed
}

TEST(CanonicalText, WhatIsWrittenIsReadBack) {
  for (const char* text : {R"({"a":[1,{"b":null}],"c":"\u0000"})", "[]", "{}", "\"\"", "true",
                           R"([[],{},[[]],{"":{"":0}}])"}) {
    EXPECT_EQ(again(again(text)), again(text));
    EXPECT_EQ(parse_json(again(text)), parse_json(text));
  }
}

TEST(CanonicalText, SpacesAndSpellingLeaveNoTrace) {
  EXPECT_EQ(again(" { \"b\" : [ 1.0 , 10e-1 ] ,\n\"\\u0061\" : 0.0e5 } "),
            again(R"({"a":-0,"b":[1,1]})"));
}

}  // namespace
}  // namespace tia
