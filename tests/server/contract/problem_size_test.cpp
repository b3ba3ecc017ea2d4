// Problem documents are short, whatever is wrong: of a long input they repeat the start.
#include "server/contract/problem.h"

#include <chrono>
#include <functional>

#include "tests/server/support.h"

namespace tia::test {
namespace {

struct TooMuch {
  const char* law;
  std::string target, body;  ///< GET where there is no body
  int status = 422;
};
void PrintTo(const TooMuch& wrong, std::ostream* out) { *out << wrong.law; }

class LongFault : public testing::TestWithParam<TooMuch> {};

TEST_P(LongFault, IsToldInAtMost16KiB) {
  const TooMuch& wrong = GetParam();
  const Response response =
      wrong.body.empty() ? host().get(wrong.target) : host().post(wrong.target, wrong.body);
  EXPECT_EQ(response.status, wrong.status) << response.body;
  EXPECT_LE(response.body.size(), longest_problem);
  EXPECT_EQ(longest_problem, 16384U);
  const Problem problem = problem_of(response);
  if (wrong.status != 414) {
    EXPECT_FALSE(problem.errors.empty());
  }
}

// so many items, with commas between.
std::string items(int count, const std::function<std::string(int)>& item) {
  std::string text;
  for (int i = 0; i < count; ++i) text.append(i > 0 ? "," : "").append(item(i));
  return text;
}
std::string repeated(const std::string& text, int count) {
  return items(count, [&](int) { return text; });
}
std::string times(std::size_t count, const std::string& text) {
  std::string all;
  for (std::size_t i = 0; i < count; ++i) all += text;
  return all;
}

std::vector<TooMuch> wrongs() {
  const std::string megabyte(1 << 20, 'x'), control = times(255, "\\u0001");
  const std::string sphere = R"({"type":"sphere","radius":1,"center":[0,0,0])";
  const auto scene = [](const std::string& objects) {
    return R"({"scene":{"objects":[)" + objects + "]}}";
  };
  const auto named = [](const std::string& name) { return ",\"" + name + "\":1"; };
  const auto numbered = [&](int i) { return std::to_string(i) + control; };
  std::string deep, query = "/render?";
  for (int i = 0; i < 30; ++i) deep += "{\"" + std::string(100'000, 'd') + "\":";
  for (int i = 0; i < 10; ++i) query += "%01" + times(120, "%02") + std::to_string(i) + "=%22&";
  std::string names =
      R"({"scene":{"materials":{)" + items(60, [&](int i) { return "\"" + numbered(i) + "\":{}"; });
  return {
      {"UnknownMember", "/render", scene(sphere + named(megabyte) + "}")},
      {"UnknownMembersInAList", "/render",
       scene(items(3, [&](int) { return sphere + named(megabyte) + "}"; }))},
      {"UnknownMembersOfControlCharacters", "/render",
       scene(sphere + "," + items(20, [&](int i) { return "\"" + numbered(i) + "\":1"; }) + "}")},
      {"UnknownMembersAtDepth", "/render",
       scene(times(12, R"({"type":"group","children":[)") +
             repeated(sphere + named(control) + "}", 20) + times(12, "]}"))},
      {"UnknownMaterials", "/render",
       names + R"(},"objects":[)" +
           items(20, [&](int i) { return sphere + R"(,"material":"?)" + numbered(i) + "\"}"; }) +
           "]}}"},
      {"NamesThatAreTooLong", "/scenes",
       R"({"keys":{)" +
           items(20,
                 [](int i) {
                   return "\"" + std::to_string(i) + std::string(100'000, 'k') + "\":{\"light\":0}";
                 }) +
           "}}"},
      {"KeysThatLeaveNoScene", "/scenes",
       R"({"keys":{)" +
           items(20,
                 [&](int i) {
                   return "\"" + std::to_string(i) + times(250, "\\u0002") + "\":{\"" + control +
                          "\":1}";
                 }) +
           "}}"},
      {"Types", "/render", scene(repeated(R"({"type":")" + control + "\"}", 20))},
      {"ALongType", "/render", scene(R"({"type":")" + megabyte + "\"}")},
      {"TextsForNumbers", "/render",
       scene(repeated(
           R"({"type":"sphere","center":[0,0,0],"radius":")" + times(9'000, "\\\"") + "\"}", 20))},
      {"AListForANumber", "/render",
       scene(R"({"type":"sphere","center":[0,0,0],"radius":[)" + repeated("0.1", 500'000) + "]}")},
      {"AFormula", "/render",
       scene(repeated(R"({"type":"implicit","f":")" + std::string(50'000, 'y') +
                          R"(","bounds":{"min":[0,0,0],"max":[1,1,1]}})",
                      20))},
      {"SceneName", "/render", R"({"scene":")" + times(100'000, "\\\\") + "\"}"},
      {"Key", "/render", R"({"key":")" + megabyte + "\"}"},
      {"Parameters", "/render",
       "{" + items(20, [&](int i) { return "\"" + numbered(i) + "\":" + "\"" + control + "\""; }) +
           "}"},
      {"ALongNumber", "/render", "{\"width\":1" + std::string(60'000, '0') + "}", 400},
      {"NoJson", "/render", "{\"width\":" + megabyte + "}", 400},
      {"NoString", "/render", "{\"width\":\"" + megabyte, 400},
      {"TwiceTheSameName", "/render", "{\"" + megabyte + "\":1,\"" + megabyte + "\":2}", 400},
      {"BrokenAtDepth", "/render", deep + "?", 400},
      {"Query", query, "", 422},
      {"QueryTwice", "/render?" + times(2, times(500, "%03") + "=" + times(150, "%04") + "&"), "",
       400},
      {"BadEncoding", "/render?" + std::string(1500, 'q') + "=%ZZ" + std::string(1000, 'z'), "",
       400},
      {"PostWithAQuery", "/render?" + std::string(4000, 'q'), "{}"},
  };
}
INSTANTIATE_TEST_SUITE_P(Of, LongFault, testing::ValuesIn(wrongs()), law_of);

TEST(LongFaults, ThatHaveNoRoomAreCounted) {
  std::vector<Fault> faults;
  for (int i = 0; i < 20; ++i)
    faults.push_back({FaultKind::unknown_name, "/" + std::string(600, 'p'),
                      Value(std::string(200, 'g')), std::string(2000, 'a'), "near"});
  const Response response =
      problem_response(std::make_exception_ptr(InputError(faults)), {"GET", "/", {}, "", Host::id});
  EXPECT_LE(response.body.size(), longest_problem);
  const Problem problem = problem_of(response);
  EXPECT_GE(problem.errors.size(), 5U);
  EXPECT_LT(problem.errors.size(), 20U);
  EXPECT_THAT(problem.detail,
              testing::StartsWith("20 faults, the first " + std::to_string(problem.errors.size()) +
                                  " listed in errors; one is /ppp"));
}

TEST(LongFaults, AllFaultsOfAnOrdinarySceneHaveRoom) {
  std::string objects;
  for (int i = 0; i < 30; ++i) objects += R"(,{"type":"spher","radius":-1})";
  const Response response =
      host().post("/render", R"({"scene":{"objects":[)" + objects.substr(1) + "]}}");
  EXPECT_EQ(problem_of(response).errors.size(), 20U);
}

}  // namespace
}  // namespace tia::test
