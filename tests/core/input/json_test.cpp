// JSON in: what is refused, where and why. JSON out: canonical_test.cpp.
#include "core/input/json.h"

#include <gtest/gtest.h>

#include "tests/core/faults.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using enum FaultKind;

const auto expect_json_refused =
    test::refusal_by([](const std::string& json) { parse_json(json); });

std::string nested(int depth) {
  const auto n = static_cast<std::size_t>(depth);
  return std::string(n, '[').append(n, ']');
}

// ---- what is read -----------------------------------------------------------------------------

TEST(ParseJson, ReadsEveryKindOfValue) {
  const Value value = parse_json(
      R"( {"n":null, "t":true, "f":false, "d":-1.5e3, "s":"x\u20ac", "a":[1,[2]], "o":{"k":0}} )");
  const auto& object = *value.as<Value::Object>();
  ASSERT_EQ(object.size(), 7U);
  EXPECT_EQ(*find(object, "n"), Value());
  EXPECT_EQ(*find(object, "t"), Value(true));
  EXPECT_EQ(*find(object, "f"), Value(false));
  EXPECT_EQ(*find(object, "d"), Value(-1500.0));
  EXPECT_EQ(*find(object, "s"), Value("x\xE2\x82\xAC"));
  EXPECT_EQ(*find(object, "a"), Value(Value::Array{1, Value::Array{2}}));
  EXPECT_EQ(*find(object, "o"), Value(Value::Object{{"k", 0}}));
  EXPECT_EQ(find(object, "none"), nullptr);
}

TEST(ParseJson, MembersKeepTheTextsOrder) {
  const Value value = parse_json(R"({"z":1,"a":2,"m":3})");
  std::string order;
  for (const auto& [name, member] : *value.as<Value::Object>()) order += name;
  EXPECT_EQ(order, "zam");
}

TEST(ParseJson, NumbersAreTheNearestDoubles) {
  EXPECT_EQ(parse_json("0.1"), Value(0.1));
  EXPECT_EQ(parse_json("1e-400"), Value(0.0));
  EXPECT_EQ(parse_json("1.7976931348623157e308"), Value(1.7976931348623157e308));
  EXPECT_EQ(parse_json("18446744073709551615"), Value(18446744073709551616.0));
  EXPECT_EQ(parse_json("-9223372036854775808"), Value(-9223372036854775808.0));
  EXPECT_EQ(parse_json("123456789012345678901234567890"), Value(1.2345678901234568e29));
}

TEST(ParseJson, EscapesBecomeUtf8) {
  EXPECT_EQ(parse_json(R"("\"\\\/\b\f\n\r\t")"), Value("\"\\/\b\f\n\r\t"));
  EXPECT_EQ(parse_json(R"("\u0041\u00e9\ud83d\ude00")"), Value("A\xC3\xA9\xF0\x9F\x98\x80"));
}

// ---- what is refused --------------------------------------------------------------------------

TEST(ParseJson, TextThatIsNoJsonIsMalformed) {
  for (const char* text :
       {"",          " ",        "nul",         "tru",      "'a'", "01", "+1",    "1.",
        ".5",        "0x1",      "NaN",         "Infinity", "-",   "1e", "\"abc", "\"\\x\"",
        "\"\\u12\"", "\"a\nb\"", "\"\\ud800\"", "]",        "{",   "}",  "// c"})
    expect_json_refused(text, {{malformed, "", "", "JSON text"}});
}

TEST(ParseJson, MalformedTextIsRefusedWhereItBreaks) {
  expect_json_refused("[", {{malformed, "/0", "", "JSON text"}});
  expect_json_refused(R"([1,2,])", {{malformed, "/2", "", "JSON text"}});
  expect_json_refused(R"([1,[2,,3]])", {{malformed, "/1/1", "", "JSON text"}});
  expect_json_refused(R"({"a":1,"b":})", {{malformed, "/b", "", "JSON text"}});
  expect_json_refused(R"({"a":{"b":[{},{"c/d~":tru}]}})",
                      {{malformed, "/a/b/1/c~1d~0", "", "JSON text"}});
  expect_json_refused(R"({"objects":[{"radius":1 "x":2}]})",
                      {{malformed, "/objects/0/radius", "", "JSON text"}});
}

TEST(ParseJson, TextAfterTheValueIsMalformed) {
  for (const char* text : {"{} x", "{}{}", "1 2", "[]]", "null,", "{}/**/"})
    expect_json_refused(text, {{malformed, "", "", "JSON text"}});
  EXPECT_EQ(parse_json("{} \t\r\n"), Value(Value::Object{}));
}

TEST(ParseJson, NulByteDoesNotEndTheText) {
  using std::string_literals::operator""s;
  expect_json_refused("{}\0"s, {{malformed, "", "", "JSON text"}});
  expect_json_refused("{}\0garbage"s, {{malformed, "", "", "JSON text"}});
  expect_json_refused("\"a\0b\""s, {{malformed, "", "", "JSON text"}});
}

TEST(ParseJson, IllFormedUtf8IsMalformed) {
  for (const char* bytes : {"\xFF", "\x80", "\xC0\x80", "\xC3", "\xE2\x82", "\xED\xA0\x80",
                            "\xF4\x90\x80\x80", "\xF8\x88\x80\x80\x80", "\xE0\x80\x80"}) {
    const std::string quoted = std::string("\"").append(bytes).append("\"");
    expect_json_refused(quoted, {{malformed, "", "", "JSON text"}});
    expect_json_refused(std::string("{\"a\":").append(quoted).append("}"),
                        {{malformed, "/a", "", "JSON text"}});
    expect_json_refused(std::string("{").append(quoted).append(":1}"),
                        {{malformed, "", "", "JSON text"}});
  }
}

TEST(ParseJson, NumbersBeyondDoubleAreMalformed) {
  expect_json_refused("1e400", {{malformed, "", "", "JSON text"}});
  expect_json_refused(R"({"a":[0,-1e309]})", {{malformed, "/a/1", "", "JSON text"}});
}

TEST(ParseJson, DuplicateKeysAreMalformedAtTheKey) {
  expect_json_refused(R"({"a":1,"a":2})", {{malformed, "/a", "\"a\"", "each key once"}});
  expect_json_refused(R"({"a":1,"\u0061":1})", {{malformed, "/a", "\"a\"", "each key once"}});
  expect_json_refused(R"({"x":[{"b":1,"a":1,"a":2,"c":3}]})",
                      {{malformed, "/x/0/a", "\"a\"", "each key once"}});
  EXPECT_NO_THROW(parse_json(R"({"a":{"a":1},"b":{"a":2}})"));
}

// ---- bounds -----------------------------------------------------------------------------------

TEST(ParseJson, ThirtyTwoLevelsAreReadAndThirtyThreeAreNot) {
  EXPECT_NO_THROW(parse_json(nested(32)));
  std::string pointer;
  for (int i = 0; i < 32; ++i) pointer += "/0";
  expect_json_refused(nested(33), {{malformed, pointer, "", "at most 32 levels"}});
  const auto member = [](int depth) {
    return std::string("{\"a\":").append(nested(depth)).append("}");
  };
  EXPECT_NO_THROW(parse_json(member(31)));
  expect_json_refused(member(32), {{malformed, std::string("/a").append(pointer.substr(2)), "",
                                    "at most 32 levels"}});
  expect_json_refused(nested(100'000), {{malformed, pointer, "", "at most 32 levels"}});
}

TEST(ParseJson, DepthLimitIsTheCallersToSet) {
  EXPECT_NO_THROW(parse_json("[[]]", {.depth = 2, .values = 10}));
  EXPECT_THROW(parse_json("[[[]]]", {.depth = 2, .values = 10}), InputError);
}

std::string array_of(const char* element, int count) {
  std::string text = "[";
  for (int i = 0; i < count; ++i) text.append(i > 0 ? "," : "").append(element);
  return text + "]";
}

TEST(ParseJson, HundredThousandValuesAreReadAndOneMoreIsNot) {
  // The array itself is one of them.
  for (const char* element : {"\"\"", "null", "true", "{}", "[]"}) {
    EXPECT_NO_THROW(parse_json(array_of(element, 99'999))) << element;
    expect_json_refused(array_of(element, 100'000),
                        {{limit, "/99999", "", "at most 100000 JSON values"}});
  }
}

TEST(ParseJson, NumbersInsideArraysAreNotCounted) {
  EXPECT_NO_THROW(parse_json(array_of("1.5", 300'000)));
  EXPECT_NO_THROW(parse_json(array_of("[0,1,2]", 99'999)));
  expect_json_refused(array_of("[0,1,2]", 100'000), {{limit, "/99999", "", "JSON values"}});
}

TEST(ParseJson, NumbersThatAreMembersAreCounted) {
  EXPECT_NO_THROW(parse_json(R"({"a":1,"b":2})", {.depth = 32, .values = 3}));
  EXPECT_THROW(parse_json(R"({"a":1,"b":2,"c":3})", {.depth = 32, .values = 3}), InputError);
}

TEST(ParseJson, RandomBytesNeverCrash) {
  test::Random random(130);
  const std::string alphabet = "{}[]\",:0123456789.eE+-truefalsnl\\ \n\xC3\xA9\xFF";
  for (int i = 0; i < 20'000; ++i) {
    std::string text;
    for (int k = random.below(30); k >= 0; --k)
      text += alphabet[static_cast<std::size_t>(random.below(static_cast<int>(alphabet.size())))];
    try {
      parse_json(text);
    } catch (const InputError& error) {
      EXPECT_EQ(error.faults().size(), 1U);
    }
  }
}

}  // namespace
}  // namespace tia
