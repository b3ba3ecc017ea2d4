// `tia render`: the server's own bytes, in a file or on standard output.
#include <fstream>

#include "tests/server/process_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

const std::string thesis_file = std::string(TIA_SOURCE_DIR) + "/web/scenes/thesis.json";

class RenderCommand : public testing::Test {
 protected:
  // What `tia render` with these words leaves in the file.
  std::string drawn(Process::Words words, const std::string& name = "picture.png") {
    words.insert(words.begin(), "render");
    words.insert(words.end(), {"-o", folder_.file(name)});
    const Finished end = run(words);
    EXPECT_EQ(end.status, 0) << end.err;
    EXPECT_EQ(end.out, "");
    return end.status == 0 ? file_bytes(folder_.file(name)) : "";
  }
  // What is said where `tia render` with these words must refuse; no file is left.
  std::string refused(Process::Words words) {
    words.insert(words.begin(), "render");
    words.insert(words.end(), {"-o", folder_.file("none.png")});
    const Finished end = run(words);
    EXPECT_EQ(end.status, 2);
    EXPECT_EQ(end.out, "");
    EXPECT_FALSE(std::filesystem::exists(folder_.file("none.png")));
    return end.err;
  }
  std::string served(const std::string& query) { return tia_.get("/render?" + query).body; }

  Folder folder_;
  Tia tia_;
};

TEST_F(RenderCommand, GivesTheServersBytes) {
  EXPECT_TRUE(drawn({"thesis"}) == served(""));
  EXPECT_TRUE(drawn({"thesis", "--key", "a"}) == served("key=a"));
  EXPECT_TRUE(drawn({"thesis", "--light", "-20,20,-10"}) == served("key=a"));
  EXPECT_TRUE(drawn({"thesis", "--width", "75", "--height=50", "--key=d", "--crop", "3,2,40,33",
                     "--transfer", "srgb", "--threads", "3", "--seed", "7"}) ==
              served("width=75&height=50&key=d&crop=3,2,40,33&transfer=srgb&seed=7"));
}

TEST_F(RenderCommand, TakesSamplesAndACameraAsTheServerDoes) {
  const std::string camera = R"({"fov_degrees":40})";
  EXPECT_TRUE(drawn({"thesis", "--samples", "4", "--threshold", "0.1", "--width", "75", "--camera",
                     camera}) ==
              served("samples=4&threshold=0.1&width=75&camera=" + url_encode(camera)));
}

TEST_F(RenderCommand, GivesPfmToAPfmFileOrWhereAskedFor) {
  const std::string pfm = served("key=a&format=pfm");
  EXPECT_TRUE(drawn({"thesis", "--key", "a"}, "picture.pfm") == pfm);
  EXPECT_TRUE(drawn({"thesis", "--key", "a", "--format", "pfm"}, "picture.dat") == pfm);
}

TEST_F(RenderCommand, GivesHdrToAnHdrFileOrWhereAskedFor) {
  const std::string hdr = served("key=a&format=hdr");
  EXPECT_TRUE(drawn({"thesis", "--key", "a"}, "picture.hdr") == hdr);
  EXPECT_TRUE(drawn({"thesis", "--key", "a", "--format", "hdr"}, "picture.dat") == hdr);
}

TEST_F(RenderCommand, ReadsASceneFile) {
  EXPECT_TRUE(drawn({thesis_file, "--key", "a"}) == served("key=a"));
}

TEST_F(RenderCommand, ASceneFileMayHaveAnyName) {
  const std::string file = folder_.file("scene.txt");
  std::ofstream(file) << file_bytes(thesis_file);
  EXPECT_TRUE(drawn({file, "--key", "a"}) == served("key=a"));
}

TEST_F(RenderCommand, BlursWhatMovesAsTheServerDoes) {
  const std::string scene = R"({"animation":{"duration":2,"shutter":1,"fps":2,"tracks":[
      {"target":"/objects/0/center","keys":[[0,[-2,0,-9]],[2,[2,0,-9]]]}]},
    "lights":[{"type":"point","position":[0,5,0]}],
    "objects":[{"type":"sphere","center":[0,0,-9],"radius":1}]})";
  const std::string file = folder_.file("moving.json");
  std::ofstream(file) << scene;
  EXPECT_TRUE(drawn({file, "--samples", "8", "--blur-steps", "4", "--frame", "2", "--width=60"}) ==
              served("samples=8&blur_steps=4&frame=2&width=60&scene=" + url_encode(scene)));
}

TEST_F(RenderCommand, AFormatThatTheFilesNameContradictsExits2) {
  const std::string file = folder_.file("picture.pfm");
  const Finished end = run({"render", "thesis", "--format", "png", "-o", file});
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err, HasSubstr("--format png"));
  EXPECT_THAT(end.err, HasSubstr(file));
}

TEST_F(RenderCommand, WritesToStandardOutputForADash) {
  const Finished end = run({"render", "thesis", "--key", "a", "-o", "-"});
  EXPECT_EQ(end.status, 0);
  EXPECT_TRUE(end.out == served("key=a"));
  EXPECT_EQ(end.err, "");
}

// What a server tells in headers and in its log.
TEST_F(RenderCommand, SaysWhatThePictureIsNot) {
  const auto said_of = [&](const char* options) {
    const std::string file = folder_.file("foggy.json");
    std::ofstream(file) << R"({"fog":{"density":1},"objects":[{"type":"torus","major_radius":2,)"
                           R"("minor_radius":0.5,"material":{"emission":1}}],"options":{)"
                        << options << "}}";
    const Finished end = run({"render", file, "--width=8", "--height=6", "-o", "-"});
    EXPECT_EQ(end.status, 0);
    return end.err;
  };
  EXPECT_EQ(said_of(R"("clamp":1)"),
            "tia: /fog is ignored: only path sees fog\n"
            "tia: /options/clamp is ignored: only path's samples are clamped\n");
  EXPECT_EQ(said_of(R"("clamp":1,"integrator":"path","samples":2,"max_depth":1)"),
            "tia: 1 luminous objects are met by chance alone\n"
            "tia: 96 paths are cut by max_depth\n"
            "tia: /options/clamp: bright samples may be darkened\n");
}

TEST_F(RenderCommand, AMissingSceneFileExits2NamingIt) {
  EXPECT_THAT(refused({folder_.file("none.json")}), HasSubstr("none.json"));
}

TEST_F(RenderCommand, ASceneFileThatIsNoSceneExits2NamingThePlace) {
  const std::string file = folder_.file("bad.json");
  std::ofstream(file) << R"({"objects":[{"type":"sphere","center":[0,0,-5],"radius":-1}]})";
  const std::string said = refused({file});
  EXPECT_THAT(said, HasSubstr("/objects/0/radius"));
  EXPECT_THAT(said, HasSubstr("-1"));
  std::ofstream(file) << "{";
  EXPECT_THAT(refused({file}), HasSubstr("JSON"));
  EXPECT_THAT(refused({file}), HasSubstr("bad.json"));
  EXPECT_THAT(refused({folder_.file("")}), HasSubstr("cannot read"));
}

TEST_F(RenderCommand, AnUnknownSceneOrKeyExits2AndSaysWhichAreKnown) {
  EXPECT_THAT(refused({"thesi"}), HasSubstr("thesis"));
  EXPECT_THAT(refused({"thesis", "--key", "q"}), HasSubstr("a, d, s, w"));
}

TEST_F(RenderCommand, ABadParameterExits2NamingItAndItsRange) {
  const std::string said = refused({"thesis", "--width", "0"});
  EXPECT_THAT(said, HasSubstr("width"));
  EXPECT_THAT(said, HasSubstr("from 1 to 16777216"));
  EXPECT_THAT(refused({"thesis", "--key", "a", "--light", "1,2,3"}), HasSubstr("light"));
  EXPECT_THAT(refused({"thesis", "--width", "4096", "--height", "4097"}),
              HasSubstr("TIA_MAX_PIXELS"));
  EXPECT_THAT(refused({"thesis", "--colour", "red"}), HasSubstr("--colour"));
}

TEST_F(RenderCommand, AFileOfAnotherKindOfPictureExits2SayingWhichThereAre) {
  const Finished end = run({"render", "thesis", "-o", folder_.file("x.jpg")});
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err, HasSubstr("x.jpg, allowed: NAME.png, NAME.pfm, NAME.hdr, NAME.tiff, "
                                 "NAME.exr, NAME.zip, -, or any"));
}

TEST_F(RenderCommand, AFileThatCannotBeWrittenExits2NamingIt) {
  const std::string file = folder_.file("no/such/folder.png");
  const Finished end = run({"render", "thesis", "-o", file});
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err, HasSubstr(file));
  EXPECT_EQ(run({"render", "thesis", "-o", "/dev/full"}).status, 2);
}

TEST_F(RenderCommand, ShowsWhatItDoesAndDrawsTheSame) {
  const Process::Words words{"cornell-light", "--width", "32", "--height", "24", "--samples", "64"};
  const std::string plain = drawn(words);
  Process::Words watched = words;
  watched.insert(watched.begin(), "render");
  for (const char* word : {"--progress", "--every", "1ms", "-o"}) watched.emplace_back(word);
  watched.push_back(folder_.file("watched.png"));
  const Finished end = run(watched);
  EXPECT_EQ(end.status, 0) << end.err;
  EXPECT_TRUE(file_bytes(folder_.file("watched.png")) == plain);
  EXPECT_FALSE(std::filesystem::exists(folder_.file("watched.png.part")));
  EXPECT_THAT(end.err, HasSubstr("[########################] 100 %, 64 of 64 samples, noise 0."));
}

TEST_F(RenderCommand, WritesTheFileAsOftenAsItMay) {
  const std::string file = folder_.file("soon.png");
  Process long_one({"render", "cornell-light", "--width", "64", "--height", "48", "--samples",
                    "65536", "--progress", "--every", "10ms", "-o", file});
  EXPECT_TRUE(eventually([&] { return std::filesystem::exists(file); }));
  EXPECT_THAT(file_bytes(file), testing::StartsWith("\x89PNG"));
  EXPECT_TRUE(eventually([&] { return long_one.err().find(" s left") != std::string::npos; }));
  long_one.signal(SIGKILL);
  long_one.wait();
  for (const char* time : {"5", "s", "0s", "-1s", "1h", "1.5s", "1234567ms"})
    EXPECT_THAT(refused({"thesis", "--every", time}), HasSubstr("option --every: got ")) << time;
  EXPECT_EQ(run({"render", "thesis", "--every", "1s", "-o", "-"}).status, 2);
}

}  // namespace
}  // namespace tia::test
