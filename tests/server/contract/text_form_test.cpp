// Text of a query, flag or variable -> JSON of a field.
#include "server/contract/text_form.h"
#include "server/requests/picture_request.h"

#include "tests/server/support.h"

namespace tia::test {
namespace {

TEST(NumberFromText, ReadsJsonNumbers) {
  const std::pair<const char*, double> numbers[] = {{"0", 0},     {"-1", -1},   {"1.5", 1.5},
                                                    {"1e9", 1e9}, {"640", 640}, {"2E-3", 0.002}};
  for (const auto& [text, number] : numbers)
    EXPECT_EQ(number_from_text(text), Value(number)) << text;
}

TEST(NumberFromText, KeepsAllElseAsTheTextThatCame) {
  for (const char* text :
       {"",    "abc", "8px", "0x10", "+1",  ".5",    "5.",   "NaN",  "Infinity", "1e400", "-",
        "1,2", " 16", "16 ", "1\n",  "[1]", "\"1\"", "true", "null", "{}",       "1 2"})
    EXPECT_EQ(number_from_text(text), Value(text)) << text;
}

TEST(ListFromText, ReadsNumbersWithAndWithoutBrackets) {
  const Value list = Value::Array{1, -2.5, 3e2};
  for (const char* text : {"1,-2.5,3e2", "[1,-2.5,3e2]", " 1 , -2.5 , 300 "})
    EXPECT_EQ(list_from_text(text), list) << text;
}

TEST(ListFromText, KeepsAllElseAsTheTextThatCame) {
  for (const char* text : {"1,", ",", "1;2;3", "a,b,c", "[1,2", "1,2]", "1],[2", "1,2,3,[", "[[1]"})
    EXPECT_EQ(list_from_text(text), Value(text)) << text;
}

TEST(WordsFromText, AreWhatStandsBetweenCommasWithoutTheSpacesAround) {
  EXPECT_EQ(words_from_text("a"), Value(Value::Array{"a"}));
  EXPECT_EQ(words_from_text(" a b ,c, ,"), Value(Value::Array{"a b", "c", "", ""}));
  EXPECT_EQ(words_from_text(R"(["a", "b,c"])"), Value(Value::Array{"a", "b,c"}));
  EXPECT_EQ(words_from_text("[::1],b"), Value(Value::Array{"[::1]", "b"}));
  for (const char* nothing : {"", "  "})
    EXPECT_EQ(words_from_text(nothing), Value(Value::Array{})) << nothing;
}

TEST(TextForm, OfATruthIsTrueOrFalse) {
  const Place at;
  EXPECT_EQ(TextForm<bool>::read("true", at), Value(true));
  EXPECT_EQ(TextForm<std::optional<bool>>::read("false", at), Value(false));
  for (const char* text : {"", "1", "0", "True", "yes", " true"})
    EXPECT_EQ(TextForm<bool>::read(text, at), Value(text));
  EXPECT_EQ(TextForm<bool>::allowed({}), "true or false");
}

TEST(TextOf, IsTheTextThatGivesTheValue) {
  EXPECT_EQ(text_of("a b"), "a b");
  EXPECT_EQ(text_of(8080), "8080");
  EXPECT_EQ(text_of(Value::Array{"a", "b"}), "a,b");
  EXPECT_EQ(text_of(Value::Array{}), "");
}

TEST(JsonOrNameFromText, ReadsAnObjectAndElseAName) {
  EXPECT_EQ(json_or_name_from_text(R"({"a":[1]})", Place{}),
            Value(Value::Object{{"a", Value::Array{1}}}));
  for (const char* text : {"", "thesis", "[1]", "5", "null", " {}", "\"{}\""})
    EXPECT_EQ(json_or_name_from_text(text, Place{}), Value(text)) << text;
}

TEST(JsonOrNameFromText, PutsAFaultBelowThePlace) {
  const Place root;
  try {
    json_or_name_from_text(R"({"objects":[1,2,})", root.at("scene"));
    FAIL() << "no fault";
  } catch (const InputError& error) {
    EXPECT_EQ(error.faults().at(0).kind, FaultKind::malformed);
    EXPECT_EQ(error.faults().at(0).pointer, "/scene/objects/2");
  }
}

// By Python: base64.urlsafe_b64encode(zlib.compress(text, 9)).
TEST(JsonOrNameFromText, ReadsWhatIsPacked) {
  EXPECT_EQ(to_json(json_or_name_from_text("z:eNqrVspPykpNLilWslKIjq0FACrRBTk=", {})),
            R"({"objects":[]})");
  EXPECT_EQ(to_json(json_or_name_from_text("z:eNqrVspPykpNLilWslKIjq0FACrRBTk", {})),
            R"({"objects":[]})");
}

TEST(JsonOrNameFromText, TellsWhyAPackedTextIsNone) {
  const auto kind_of = [](std::string_view text) {
    try {
      json_or_name_from_text(text, Place{}.at("scene"));
    } catch (const InputError& error) {
      EXPECT_TRUE(error.faults().front().pointer.starts_with("/scene"));
      return error.faults().front().kind;
    }
    ADD_FAILURE() << text;
    return FaultKind::missing;
  };
  EXPECT_EQ(kind_of("z:"), FaultKind::malformed);
  EXPECT_EQ(kind_of("z:AAAA"), FaultKind::malformed);                              // no zlib
  EXPECT_EQ(kind_of("z:eNqrVspPykpNLilWslKIrQUAJbwE3g=="), FaultKind::malformed);  // no JSON
  EXPECT_EQ(kind_of("z:eNrtwTEBAAAAwqAq65_"
                    "SFl5AAQAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"
                    "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAA"
                    "AAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAAPAwjfRCSA=="),
            FaultKind::limit);  // 150 kB of spaces
}

TEST(FieldFromText, TakesTheFormOfTheFieldOfThatName) {
  EXPECT_EQ(field_from_text<PictureRequest>("width", "8"), Value(8));
  EXPECT_EQ(field_from_text<PictureRequest>("threads", "8"), Value(8));  // optional
  EXPECT_EQ(field_from_text<PictureRequest>("light", "1,2,3"), Value(Value::Array{1, 2, 3}));
  EXPECT_EQ(field_from_text<PictureRequest>("crop", "1,2,3,4"), Value(Value::Array{1, 2, 3, 4}));
  EXPECT_EQ(field_from_text<PictureRequest>("scene", "{}"), Value(Value::Object{}));
}

TEST(FieldFromText, TextOfATextFieldStaysText) {
  EXPECT_EQ(field_from_text<PictureRequest>("key", "1"), Value("1"));
  EXPECT_EQ(field_from_text<PictureRequest>("format", "{}"), Value("{}"));
  EXPECT_EQ(field_from_text<Config>("host", "8"), Value("8"));
  EXPECT_EQ(field_from_text<PictureRequest>("unknown", "8"), Value("8"));
}

TEST(PercentDecode, DecodesTwoHexadecimalDigitsAndNothingElse) {
  EXPECT_EQ(percent_decode("a%20b%2Bc%2bd"), "a b+c+d");
  EXPECT_EQ(percent_decode("%00").size(), 1U);
  EXPECT_EQ(percent_decode("+"), "+");
  EXPECT_EQ(percent_decode("%25zz"), "%zz");  // once only
  EXPECT_EQ(percent_decode(""), "");
}

TEST(PercentDecode, RefusesAllElseAtThePointer) {
  for (const char* text : {"%", "%4", "%zz", "a%4", "%%41", "% 1", "%-1", "%0x"}) {
    try {
      percent_decode(text, "/here");
      ADD_FAILURE() << text;
    } catch (const InputError& error) {
      EXPECT_EQ(error.faults().at(0).kind, FaultKind::malformed);
      EXPECT_EQ(error.faults().at(0).pointer, "/here");
    }
  }
}

TEST(Request, HeaderNamesCompareWithoutCaseAndTheFirstCounts) {
  const Request request{"GET", "/a?b?c", {{"X-One", "1"}, {"x-one", "2"}}, "", ""};
  EXPECT_EQ(request.header("x-ONE"), "1");
  EXPECT_EQ(request.header("x-on"), "");
  EXPECT_EQ(request.path(), "/a");
  EXPECT_EQ(request.query(), "b?c");
}

}  // namespace
}  // namespace tia::test
