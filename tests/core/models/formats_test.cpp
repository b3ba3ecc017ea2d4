// One model in every format that is taken is one model.
#include "core/models/formats.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cstring>

#include "core/models/check_model.h"
#include "core/models/describe.h"
#include "tests/core/support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

ModelFile file_of(const std::string& path, const std::string& text) {
  return {path, {reinterpret_cast<const std::uint8_t*>(text.data()), text.size()}};
}
std::string refusal_of(const std::vector<ModelFile>& files) {
  try {
    read_model({files, 0});
  } catch (const InputError& error) {
    return error.what();
  }
  return "";
}
// The corners of all triangles, in order.
std::vector<double> corners_of(const Model& model) {
  std::vector<double> all;
  for (const ModelMesh& mesh : model.meshes)
    for (const ModelPart& part : mesh.parts)
      for (const std::uint32_t i : part.indices)
        for (std::size_t k = 0; k < 3; ++k) all.push_back(part.positions[3 * i + k]);
  return all;
}

// Triangles of whole eighths, which every format can say exactly.
using Soup = std::vector<std::array<double, 9>>;
Soup random_soup(Random& random) {
  Soup all(static_cast<std::size_t>(random.whole(1, 20)));
  for (auto& each : all)
    for (double& x : each) x = random.whole(-40, 40) / 8.0;
  return all;
}
std::string bytes_of_float(float x) {
  std::string bytes(4, '\0');
  std::memcpy(bytes.data(), &x, 4);  // tests run on little-endian machines
  return bytes;
}
std::string as_stl(const Soup& soup) {
  std::string text = "solid soup\n";
  for (const auto& t : soup) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (std::size_t i = 0; i < 9; i += 3)
      text += "vertex " + std::to_string(t[i]) + " " + std::to_string(t[i + 1]) + " " +
              std::to_string(t[i + 2]) + "\n";
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid soup\n";
}
std::string as_obj(const Soup& soup) {
  std::string text = "# soup\n";
  for (const auto& t : soup) {
    for (std::size_t i = 0; i < 9; i += 3)
      text += "v " + std::to_string(t[i]) + " " + std::to_string(t[i + 1]) + " " +
              std::to_string(t[i + 2]) + "\n";
    text += "f -3 -2 -1\n";
  }
  return text;
}
std::string as_gltf(const Soup& soup) {
  const std::string size = std::to_string(36 * soup.size());
  return R"({"asset":{"version":"2.0"},"buffers":[{"uri":"soup.bin","byteLength":)" + size +
         R"(}],"bufferViews":[{"buffer":0,"byteLength":)" + size +
         R"(}],"accessors":[{"bufferView":0,"componentType":5126,"type":"VEC3","count":)" +
         std::to_string(3 * soup.size()) +
         R"(}],"meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"nodes":[{"mesh":0}],)"
         R"("scenes":[{"nodes":[0]}]})";
}
std::string as_bin(const Soup& soup) {
  std::string bytes;
  for (const auto& t : soup)
    for (const double x : t) bytes += bytes_of_float(static_cast<float>(x));
  return bytes;
}

TEST(ModelFormats, SayTheSameTriangles) {
  Random random(1);
  for (int i = 0; i < 30; ++i) {
    const Soup soup = random_soup(random);
    std::vector<double> corners;
    for (const auto& t : soup) corners.insert(corners.end(), t.begin(), t.end());
    const std::string stl = as_stl(soup), obj = as_obj(soup), gltf = as_gltf(soup),
                      bin = as_bin(soup);
    for (const ModelFiles& files :
         {ModelFiles{{file_of("a.stl", stl)}}, ModelFiles{{file_of("a.obj", obj)}},
          ModelFiles{{file_of("a.gltf", gltf), file_of("soup.bin", bin)}}}) {
      const Model model = read_model(files);
      EXPECT_EQ(corners_of(model), corners) << files.main_file().path;
      Faults faults;
      check_model(model, {}, faults);
      EXPECT_TRUE(faults.empty()) << files.main_file().path;
    }
  }
}

TEST(ModelFormats, AreKnownByTheirBytesWhateverTheirName) {
  Random random(2);
  const Soup soup = random_soup(random);
  EXPECT_EQ(read_model({{file_of("a.gltf", as_obj(soup))}}).format, "obj");
  EXPECT_EQ(read_model({{file_of("a.obj", as_stl(soup))}}).format, "stl");
}

TEST(ModelFormats, OfWhatNoneKnowsTellWhatIsTaken) {
  EXPECT_THAT(refusal_of({file_of("a.fbx", "Kaydara FBX Binary  ")}),
              testing::AllOf(HasSubstr("4b617964617261"), HasSubstr("GLB")));
  EXPECT_THAT(refusal_of({file_of("a", "")}), HasSubstr("GLB"));
}

TEST(ModelFormats, RefuseAModelWithoutATriangleOrAPoint) {
  EXPECT_THAT(refusal_of({file_of("a.gltf", R"({"asset":{"version":"2.0"}})")}),
              HasSubstr("a triangle or a point"));
}

TEST(ModelFiles, AreFoundFromTheFolderOfWhoNamesThem) {
  const ModelFiles files{{file_of("a/b/model.obj", "1"), file_of("a/c/x.mtl", "2"),
                          file_of("a/b/y.mtl", "3"), file_of("z.mtl", "4")}};
  const auto found = [&](std::string_view path) {
    const ModelFile* file = files.find(path, "a/b/model.obj");
    return file == nullptr ? std::string() : file->path;
  };
  EXPECT_EQ(found("y.mtl"), "a/b/y.mtl");
  EXPECT_EQ(found("./y.mtl"), "a/b/y.mtl");
  EXPECT_EQ(found("../c/x.mtl"), "a/c/x.mtl");
  EXPECT_EQ(found("../../z.mtl"), "z.mtl");
  for (const char* none : {"x.mtl", "/z.mtl", "../../../z.mtl", "", "a/b/y.mtl"})
    EXPECT_EQ(found(none), "") << none;
}

TEST(ModelDescription, CountsWhatTheFileHolds) {
  const std::string text =
      "o left\nv 0 0 0\nv 1 0 0\nv 1 2 0\nv 0 2 0\nf 1 2 3 4\no right\nv 5 0 -1\nf 1 2 5\n";
  const Value told = description_of(read_model({{file_of("a.obj", text)}}));
  const auto& members = *told.as<Value::Object>();
  EXPECT_EQ(*find(members, "format"), Value("obj"));
  EXPECT_EQ(*find(members, "triangles"), Value(3));
  EXPECT_EQ(*find(members, "nodes"), Value(2));
  EXPECT_EQ(*find(members, "up"), Value("y"));
  const Value box = Value::Object{{"min", Value::Array{0, 0, -1}}, {"max", Value::Array{5, 2, 0}}};
  EXPECT_EQ(*find(members, "bounds"), box);
}

}  // namespace
}  // namespace tia::test
