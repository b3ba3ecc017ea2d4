// `tia still`: the server's own bytes of a model's file.
#include <fstream>

#include "core/models/formats.h"
#include "core/scene/read_scene.h"
#include "server/commands/picture_file.h"
#include "server/requests/still_query.h"
#include "tests/server/model_support.h"
#include "tests/server/process_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

using namespace server;
using testing::HasSubstr;

class StillCommand : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) {
    const std::filesystem::path path = folder_.file(name);
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
  }
  Finished still(Process::Words words, const std::string& output = "still.png") {
    words.insert(words.begin(), "still");
    words[1] = folder_.file(words[1]);
    words.insert(words.end(), {"-o", output == "-" ? output : folder_.file(output)});
    return run(words);
  }
  std::string drawn(const Process::Words& words, const std::string& output = "still.png") {
    const Finished end = still(words, output);
    EXPECT_EQ(end.status, 0) << end.err;
    return end.status == 0 ? file_bytes(folder_.file(output)) : "";
  }

  Folder folder_;
};

TEST_F(StillCommand, GivesTheServersBytes) {
  write("part.stl", stl_text());
  const auto served = [&](const std::string& query) {
    return host().post("/still?" + query, stl_text(), "model/stl").body;
  };
  EXPECT_TRUE(drawn({"part.stl", "--width", "40", "--height=30", "--samples=4"}) ==
              served("width=40&height=30&samples=4"));
  EXPECT_TRUE(drawn({"part.stl", "--width=40", "--orbit=10,-20", "--studio=sun", "--background",
                     "1,0.5,0", "--samples=2", "--plain"},
                    "still.pfm") ==
              served("width=40&orbit=10,-20&studio=sun&background=1,0.5,0&samples=2&format=pfm"));
  EXPECT_TRUE(drawn({"part.stl", "--as", "scene"}, "still.json") == served("as=scene"));
  const Finished out = still({"part.stl", "--as=scene"}, "-");
  EXPECT_TRUE(out.out == served("as=scene"));
}

TEST_F(StillCommand, FindsWhatTheFileNames) {
  const NamedTexts files{{"chair.obj", "mtllib wood.mtl\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"},
                         {"wood.mtl", "newmtl wood\nKd 0.5 0.25 0.125\n"}};
  for (const auto& [path, text] : files) write("a/" + path, text);
  const Value scene = parse_json(drawn({"a/chair.obj", "--as=scene"}, "scene.json"));
  EXPECT_THAT(to_json(at(scene, "objects")), HasSubstr(upload_of_texts(files).id));
}

// What nobody keeps cannot be looked up again.
TEST_F(StillCommand, LooksUpOnceWhatAModelShows) {
  const std::string text = stl_text();
  auto kept = std::make_shared<KeptModel>();
  kept->model = std::make_shared<const Model>(read_model({{file_of("part.stl", text)}, 0}));
  StillParameters asked;
  asked.id = "nobody's";
  asked.width = asked.height = 16;
  asked.samples = 1;
  const Scene scene = still_of(asked, kept);
  PictureRequest picture = asked;
  picture.scene = scene;
  Workshop workshop{Config{}};
  workshop.draw_to(folder_.file("still.png"), picture, false);
  EXPECT_TRUE(file_bytes(folder_.file("still.png")).starts_with("\x89PNG"));
  picture.scene = read_scene(canonical_text(scene));
  EXPECT_THROW(workshop.draw_to(folder_.file("still.png"), picture, false), InputError);
}

TEST_F(StillCommand, ABadParameterOrFileExits2NamingIt) {
  write("part.stl", stl_text());
  write("text.txt", "hello");
  const auto refused = [&](const Process::Words& words, const std::string& output = "none.png") {
    const Finished end = still(words, output);
    EXPECT_EQ(end.status, 2);
    EXPECT_FALSE(std::filesystem::exists(folder_.file("none.png")));
    return end.err;
  };
  EXPECT_THAT(refused({"part.stl", "--orbit", "0,91"}), HasSubstr("/orbit/1"));
  EXPECT_THAT(refused({"part.stl", "--hide", "wheel"}), HasSubstr("/hide/0"));
  EXPECT_THAT(refused({"part.stl"}, "none.jpg"), HasSubstr("none.jpg"));
  EXPECT_THAT(refused({"part.stl"}, "none.pfm"), HasSubstr("background"));
  EXPECT_THAT(refused({"text.txt"}), HasSubstr("GLB"));
  EXPECT_THAT(refused({"none.stl"}), HasSubstr("none.stl"));
  EXPECT_THAT(refused({"part.stl", "--model", "0"}), HasSubstr("--model"));
}

}  // namespace
}  // namespace tia::test
