// Requests that cannot be read: 400, at the place where the text breaks.
#include "tests/server/support.h"

namespace tia::test {
namespace {

using testing::StartsWith;

struct Text {
  const char* law;
  std::string text;
  const char* pointer;
};
void PrintTo(const Text& text, std::ostream* out) { *out << text.text; }

void expect_malformed(const Response& response, const std::string& pointer) {
  EXPECT_EQ(response.status, 400) << response.body;
  const Problem problem = problem_of(response);
  EXPECT_EQ(problem.type, "/problems/malformed");
  ASSERT_EQ(problem.errors.size(), 1U);
  EXPECT_EQ(problem.errors[0].pointer, pointer);
}

class MalformedBody : public testing::TestWithParam<Text> {};
class MalformedQuery : public testing::TestWithParam<Text> {};

TEST_P(MalformedBody, Is400) {
  expect_malformed(host().post("/render", GetParam().text), GetParam().pointer);
}
TEST_P(MalformedQuery, Is400) {
  expect_malformed(host().get(std::string("/render?") + GetParam().text), GetParam().pointer);
}

std::string nested(int levels) {
  const auto n = static_cast<std::size_t>(levels);
  return R"({"scene":)" + std::string(n - 1, '[') + std::string(n - 1, ']') + "}";
}
// The pointer into n - 1 arrays in `scene`.
std::string depths(int levels) {
  std::string text = "/scene";
  for (int i = 2; i < levels; ++i) text += "/0";
  return text;
}

INSTANTIATE_TEST_SUITE_P(Json, MalformedBody,
                         testing::Values(Text{"Unclosed", R"({"key":"a")", "/key"},
                                         Text{"OnlyABrace", "{", ""},
                                         Text{"NoValue", R"({"width":})", "/width"},
                                         Text{"TrailingText", R"({"width":8} x)", ""},
                                         Text{"TwoDocuments", "{}{}", ""},
                                         Text{"Comment", "{/**/}", ""},
                                         Text{"TrailingComma", R"({"width":8,})", "/width"},
                                         Text{"SingleQuotes", "{'width':8}", ""},
                                         Text{"NaN", R"({"width":NaN})", "/width"},
                                         Text{"BeyondDouble", R"({"width":1e400})", "/width"},
                                         Text{"IllFormedUtf8", "{\"key\":\"\xFF\"}", "/key"},
                                         Text{"LoneSurrogate", R"({"key":"\ud800"})", "/key"},
                                         Text{"RawControlCharacter", "{\"key\":\"\x01\"}", "/key"}),
                         law_of);

INSTANTIATE_TEST_SUITE_P(
    Encoding, MalformedQuery,
    testing::Values(Text{"NotHexadecimal", "key=%zz", "/key"}, Text{"OneDigit", "key=%4", "/key"},
                    Text{"NoDigit", "key=%", "/key"}, Text{"InTheName", "%zz=a", ""},
                    Text{"Twice", "key=a&key=d", "/key"},
                    Text{"TwiceTheSame", "key=a&key=a", "/key"},
                    Text{"TwiceWithOneEncoded", "key=a&%6Bey=d", "/key"},
                    Text{"SceneUnclosed", "scene=%7B%22objects%22:%5B", "/scene/objects/0"}),
    law_of);

TEST(Malformed, DuplicateKeysAreRefusedAtAnyDepth) {
  const Response top = host().post("/render", R"({"key":"a","key":"d"})");
  expect_malformed(top, "/key");
  const ProblemError error = only_error(top);
  ASSERT_TRUE(error.got);
  EXPECT_EQ(*error.got, Value("key"));
  const Response deep = host().post("/render", R"({"scene":{"camera":{"up":1,"up":2}}})");
  expect_malformed(deep, "/scene/camera/up");
}

TEST(Malformed, ThirtyTwoLevelsAreReadAndOneMoreIsNot) {
  EXPECT_EQ(host().post("/render", nested(32)).status, 422);  // readable, but no scene
  expect_malformed(host().post("/render", nested(33)), depths(33));
}

TEST(Malformed, ABombOfBracketsIsRefused) {
  const Response response = host().post("/render", R"({"scene":)" + std::string(1'000'000, '['));
  EXPECT_EQ(response.status, 400);
  EXPECT_LT(response.body.size(), 2000U);
}

TEST(Malformed, MoreThan100000ValuesAreALimit) {
  std::string many = R"({"scene":[)";
  for (int i = 0; i < 100'001; ++i) many += "[],";
  many += "[]]}";
  const Response response = host().post("/render", many);
  EXPECT_EQ(response.status, 422);
  EXPECT_EQ(problem_of(response).type, "/problems/limit");
}

TEST(Malformed, TheAnswerToIllFormedUtf8IsJson) {
  for (const char* query : {"key=%FF", "%C0%80=1", "scene=%ED%A0%80", "width=%00", "key=a%00"}) {
    SCOPED_TRACE(query);
    const Response response = host().get(std::string("/render?").append(query));
    EXPECT_EQ(response.status, 422);
    EXPECT_FALSE(problem_of(response).errors.empty());
  }
}

TEST(Malformed, ANameInThePathIsDecodedStrictly) {
  expect_malformed(host().get("/scenes/%zz"), "");
  EXPECT_EQ(host().get("/scenes/%74hesis").status, 200);
}

TEST(Malformed, AJsonBodyThatIsNoObjectHasTheWrongType) {
  for (const char* body : {"[]", "5", "\"key\"", "null", "true"}) {
    SCOPED_TRACE(body);
    const Response response = host().post("/render", body);
    EXPECT_EQ(response.status, 422);
    EXPECT_EQ(problem_of(response).type, "/problems/wrong-type");
    EXPECT_EQ(only_error(response).pointer, "");
  }
}

TEST(Malformed, ABodyThatIsNotJsonIs415) {
  for (const char* type : {"application/x-www-form-urlencoded", "text/plain", ""})
    for (const char* body : {"key=a", "", "  ", "<scene/>", "[]", "\x89PNG"}) {
      SCOPED_TRACE(std::string(type) + ": " + body);
      const Response response = host().post("/render", body, type);
      EXPECT_EQ(response.status, 415);
      EXPECT_THAT(problem_of(response).detail, testing::HasSubstr("JSON"));
    }
}

TEST(Malformed, ABodyThatStartsWithABraceIsJsonWhateverItsType) {
  const std::string picture = host().get("/render?width=8&height=8").body;
  for (const char* type : {"application/x-www-form-urlencoded", "text/plain", "", "image/png"}) {
    EXPECT_EQ(host().post("/render", R"({"width":8,"height":8})", type).body, picture);
    EXPECT_EQ(host().post("/render", " \r\n\t{\"width\":8,\"height\":8}", type).body, picture);
  }
}

TEST(Malformed, PostTakesNoQuery) {
  const Response response = host().post("/render?width=8", R"({"height":8})");
  EXPECT_EQ(response.status, 422);
  EXPECT_EQ(problem_of(response).type, "/problems/conflict");
  EXPECT_THAT(problem_of(response).detail, testing::HasSubstr("body"));
}

}  // namespace
}  // namespace tia::test
