// `tia radio paths|map`: what the server answers, in a file.
#include <httplib.h>

#include <fstream>

#include "tests/server/process_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

TEST(RadioCommand, WritesWhatTheServerAnswers) {
  Folder folder;
  const std::string scene = folder.file("scene.json"), question = folder.file("question.json");
  const std::string text = R"({"objects":[{"type":"box","min":[0,0,5],"max":[9,9,6]}]})";
  const std::string asked = R"("transmitters":[{"position":[1,2,0]}],
      "receivers":[{"position":[8,3,1]}],"frequency_hz":5e9})";
  std::ofstream(scene) << text;
  std::ofstream(question) << "{" << asked;
  const Finished end = run({"radio", "paths", scene, question, "-o", "-"});
  ASSERT_EQ(end.status, 0) << end.err;
  Tia tia;
  const auto served =
      tia.client().Post("/radio/paths", "{\"scene\":" + text + "," + asked, "application/json");
  ASSERT_TRUE(served);
  EXPECT_TRUE(end.out == served->body);
  std::ofstream(question) << "{" << asked.substr(0, asked.size() - 4) << "1}";
  const Finished wrong = run({"radio", "paths", scene, question, "-o", "-"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.err, HasSubstr("/frequency_hz"));
}

TEST(RadioCommand, WritesTheMapThatTheServerAnswers) {
  Folder folder;
  const std::string question = folder.file("question.json");
  const std::string asked = R"("tx":[[2.6,1.6,2.4]],"frequency_hz":5e9,"cell":1,"rays":1000})";
  std::ofstream(question) << "{" << asked;
  const Finished end = run({"radio", "map", "flat", question, "-o", "-"});
  ASSERT_EQ(end.status, 0) << end.err;
  Tia tia;
  const auto served =
      tia.client().Post("/radio/map", R"({"scene":"flat",)" + asked, "application/json");
  ASSERT_TRUE(served);
  EXPECT_TRUE(end.out == served->body);
}

}  // namespace
}  // namespace tia::test
