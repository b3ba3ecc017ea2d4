// `tia model`: what is in a file, in words.
#include <fstream>

#include "core/film/png.h"
#include "core/input/json.h"
#include "tests/server/process_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

class ModelCommand : public testing::Test {
 protected:
  void write(const std::string& name, const std::string& text) {
    const std::filesystem::path path = folder_.file(name);
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
  }
  Finished model(const std::vector<std::string>& names) {
    Process::Words words{"model"};
    for (const std::string& name : names) words.push_back(folder_.file(name));
    return run(words);
  }
  Value described(const std::string& name) {
    const Finished end = model({name});
    EXPECT_EQ(end.status, 0) << end.err;
    return end.status == 0 ? parse_json(end.out) : Value(Value::Object{});
  }
  static double count(const Value& description, std::string_view name) {
    return *find(*description.as<Value::Object>(), name)->as<double>();
  }
  static std::size_t size(const Value& description, std::string_view name) {
    return find(*description.as<Value::Object>(), name)->as<Value::Array>()->size();
  }

  Folder folder_;
};

const std::string square = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nvt 0 0\nvt 1 0\nvt 1 1\nvt 0 1\n";

TEST_F(ModelCommand, TellsWhatAFileHolds) {
  write("square.obj", square + "f 1/1 2/2 3/3 4/4\n");
  const Value told = described("square.obj");
  EXPECT_EQ(count(told, "vertices"), 4);
  EXPECT_EQ(count(told, "triangles"), 2);
  EXPECT_EQ(to_json(*find(*told.as<Value::Object>(), "bounds")),
            R"({"max":[1,1,0],"min":[0,0,0]})");
}

TEST_F(ModelCommand, FindsWhatTheFileNames) {
  write("a/square.obj", "mtllib square.mtl\n" + square + "usemtl red\nf 1/1 2/2 3/3 4/4\n");
  write("a/square.mtl", "newmtl red\nKd 1 0 0\nmap_Kd pictures/red.png\n");
  write("a/pictures/red.png", encode_png(Image8(1, 1)));
  const Value told = described("a/square.obj");
  EXPECT_EQ(size(told, "warnings"), 0U) << to_json(told);
  EXPECT_EQ(count(told, "textures"), 1);
}

TEST_F(ModelCommand, NamesWhatIsMissing) {
  write("lone.gltf", R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"uri":"not.bin"}]})");
  const Finished end = model({"lone.gltf"});
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err, HasSubstr("/buffers/0/uri"));
  EXPECT_THAT(end.err, HasSubstr("not.bin"));
}

// A picture that stands beside the OBJ is not the one that its materials mean in their folder.
TEST_F(ModelCommand, AsksForNothingTwice) {
  write("a.obj", "mtllib m/a.mtl\n" + square + "usemtl red\nf 1/1 2/2 3/3 4/4\n");
  write("m/a.mtl", "newmtl red\nmap_Kd red.png\n");
  write("other.mtl", "");
  write("red.png", encode_png(Image8(1, 1)));
  EXPECT_EQ(model({"a.obj"}).status, 2);
}

// A file may not name what is not its own.
TEST_F(ModelCommand, LooksNowhereElse) {
  write("secret.bin", "1234");
  write("a/b.gltf",
        R"({"asset":{"version":"2.0"},"buffers":[{"byteLength":4,"uri":"../secret.bin"}]})");
  EXPECT_EQ(model({"a/b.gltf"}).status, 2);
}

TEST_F(ModelCommand, SaysWhatItTakes) {
  write("text.txt", "hello");
  const Finished end = model({"text.txt"});
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err, HasSubstr("GLB, glTF, "));
  EXPECT_EQ(model({"none.obj"}).status, 2);
}

}  // namespace
}  // namespace tia::test
