// `tia simulate`: a scene's motion in a file, which draws the server's own frames.
#include <httplib.h>

#include <fstream>

#include "core/scene/read_scene.h"
#include "tests/server/process_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

const std::string text = R"({"objects":[
    {"name":"floor","type":"plane","point":[0,-2,0],"normal":[0,1,0]},
    {"name":"ball","type":"sphere","center":[0,0,-9],"radius":0.5}],
  "lights":[{"type":"point","position":[4,6,-3]}],
  "physics":{"duration":1,"bodies":[{"object":"ball","mass":2}],"fixed":[{"object":"floor"}]}})";

TEST(SimulateCommand, WritesTheSceneThatDrawsTheSameFrames) {
  Folder folder;
  const std::string scene = folder.file("scene.json"), baked = folder.file("baked.json");
  std::ofstream(scene) << text;
  const Finished end = run({"simulate", scene, "-o", baked});
  ASSERT_EQ(end.status, 0) << end.err;
  EXPECT_FALSE(read_scene(file_bytes(baked)).physics);
  EXPECT_EQ(run({"simulate", scene, "-o", "-"}).out, file_bytes(baked));
  Tia tia;
  const auto drawn = [&](const std::string& file) {
    const Finished frame =
        run({"render", file, "--time", "0.75", "--width", "32", "--height", "24", "-o", "-"});
    EXPECT_EQ(frame.status, 0) << frame.err;
    return frame.out;
  };
  EXPECT_TRUE(drawn(scene) == drawn(baked));
  const auto served =
      tia.client().Post("/render", R"({"time":0.75,"width":32,"height":24,"scene":)" + text + "}",
                        "application/json");
  ASSERT_TRUE(served);
  EXPECT_TRUE(drawn(scene) == served->body);
}

TEST(SimulateCommand, SaysWhatIsWrong) {
  Folder folder;
  const std::string scene = folder.file("scene.json");
  std::ofstream(scene) << R"({"objects":[],"physics":{"bodies":[{"object":"a","mass":1}]}})";
  const Finished wrong = run({"simulate", scene, "-o", "-"});
  EXPECT_EQ(wrong.status, 2);
  EXPECT_THAT(wrong.err, HasSubstr("/physics/bodies/0/object"));
  EXPECT_THAT(run({"simulate", "thesis", "-o", "-"}).err, HasSubstr("without physics"));
  EXPECT_THAT(run({"simulate", "thesi", "-o", "-"}).err, HasSubstr("there are: thesis, "));
}

}  // namespace
}  // namespace tia::test
