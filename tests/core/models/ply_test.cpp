// PLY: the model that comes of a file, its faces and its texture.
#include "core/models/ply.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

#include "tests/core/models/ply_files.h"

namespace tia {
namespace {

using namespace test;

// ---- models ---------------------------------------------------------------------------------

TEST(Ply, FilesAreKnownByTheirFirstLine) {
  for (const char* text : {"ply\n", "ply\r\n", "ply\rformat"})
    EXPECT_TRUE(is_ply(model_bytes(text))) << text;
  for (const char* text : {"", "pl", "ply", "plyx\n", " ply\n", "PLY\n", "solid\n"})
    EXPECT_FALSE(is_ply(model_bytes(text))) << text;
}

TEST(Ply, AModelIsOneSceneOfDefaultMatterWithZUp) {
  const ReadModel read = read_ply_file(ply_text(3, ply_face_lines, ply_corners + "3 0 1 2\n"));
  ASSERT_TRUE(read.faults.empty());
  const Model& model = read.model;
  EXPECT_EQ(model.format, "ply");
  EXPECT_TRUE(model.z_up);
  EXPECT_EQ(model.materials, std::vector{ModelMaterial{}});
  ASSERT_EQ(model.scenes.size(), 1U);
  EXPECT_EQ(model.scenes[0].nodes, std::vector<ModelIndex>{0});
  ASSERT_EQ(model.nodes.size(), 1U);
  EXPECT_EQ(model.nodes[0].mesh, MaybeIndex{0});
  const ModelPart& part = read.part();
  EXPECT_EQ(part.positions, (std::vector<double>{0, 0, 0, 1, 0, 0, 0, 1, 0}));
  EXPECT_EQ(part.indices, (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(part.material, MaybeIndex{0});
  EXPECT_FALSE(part.points);
  EXPECT_TRUE(part.normals.empty() && part.uvs[0].empty() && part.colors.empty());
  EXPECT_TRUE(model.warnings.empty());
}

TEST(Ply, WithoutFacesVerticesArePoints) {
  for (const std::string& lines : {std::string(), std::string("element face 0\n"),
                                   std::string("element face 0\nproperty list char int x\n")}) {
    const ReadModel read = read_ply_file(ply_text(3, lines, ply_corners));
    ASSERT_TRUE(read.faults.empty()) << describe(read.fault());
    EXPECT_TRUE(read.part().points);
    EXPECT_EQ(read.part().vertices(), 3U);
    EXPECT_TRUE(read.part().indices.empty());
  }
}

// ---- faces ----------------------------------------------------------------------------------

TEST(Ply, PolygonsBecomeTrianglesInTheirPlace) {
  // An arrow whose third corner is inside of the other three.
  const std::string arrow = "0 0 0\n2 1 0\n0.5 0.5 0\n1 2 0\n",
                    faces = "element face 3\nproperty list uchar int vertex_index\n";
  const ReadModel read = read_ply_file(ply_text(4, faces, arrow + "3 0 1 2\n4 0 1 2 3\n3 3 2 1\n"));
  ASSERT_TRUE(read.faults.empty());
  const ModelPart& part = read.part();
  ASSERT_EQ(part.triangles(), 4U);
  EXPECT_EQ(std::vector(part.indices.begin(), part.indices.begin() + 3),
            (std::vector<std::uint32_t>{0, 1, 2}));
  EXPECT_EQ(std::vector(part.indices.end() - 3, part.indices.end()),
            (std::vector<std::uint32_t>{3, 2, 1}));
  // The quadrilateral's triangles turn as it does, so that their areas' sum is its own.
  double area = 0;
  for (std::size_t t = 3; t < 9; t += 3) {
    const auto x = [&](std::size_t k) {
      return part.positions[3 * std::size_t{part.indices[t + k]}];
    };
    const auto y = [&](std::size_t k) {
      return part.positions[3 * std::size_t{part.indices[t + k]} + 1];
    };
    const double own = ((x(1) - x(0)) * (y(2) - y(0)) - (x(2) - x(0)) * (y(1) - y(0))) / 2;
    EXPECT_GT(own, 0);
    area += own;
  }
  EXPECT_NEAR(area, 0.5, 1e-12);  // by the shoelace formula: (0 + 0.5 + 0.5 + 0) / 2
}

TEST(Ply, FacesMayStandBeforeTheirVertices) {
  PlyFile file;
  file.element("face", 1).list("uchar", "uint", "vertex_indices").element("vertex", 4);
  for (const char* name : {"x", "y", "z"}) file.property("short", name);
  file.put_list("uchar", "uint", {0, 1, 2, 3}).end_row();
  for (const int corner : {0, 1, 3, 2})
    file.put("short", corner & 1).put("short", corner >> 1).put("short", 0).end_row();
  EXPECT_EQ(read_in_all(file).part().triangles(), 2U);
}

TEST(Ply, FacesOfFewCornersAreLeftOut) {
  const ReadModel read =
      read_ply_file(ply_text(3, "element face 4\nproperty list uchar int vertex_indices\n",
                             ply_corners + "3 2 1 0\n0\n2 0 1\n1 7\n"));
  ASSERT_TRUE(read.faults.empty()) << describe(read.fault());
  EXPECT_EQ(read.part().indices, (std::vector<std::uint32_t>{2, 1, 0}));
  EXPECT_FALSE(read.part().points);
  ASSERT_EQ(read.model.warnings.size(), 1U);
  EXPECT_EQ(read.model.warnings[0].line, 14U);
  EXPECT_NE(read.model.warnings[0].text.find(": 3, the first of them face 1"), std::string::npos);
}

TEST(Ply, StripsTurnAlikeAndStartAnewAtMinusOne) {
  PlyFile file = ply_vertices(6);
  file.element("tristrips", 2).list("int", "int", "vertex_indices");
  for (int i = 0; i < 6; ++i)
    file.put("float", i >> 1).put("float", i & 1).put("float", 0).end_row();
  file.put_list("int", "int", {0, 2, 1, 3, 3, 5, -1, 0, 1, -1, 4, 2, 5, 3}).end_row();
  file.put_list("int", "int", {}).end_row();
  const ReadModel read = read_in_all(file);
  EXPECT_EQ(read.part().indices, (std::vector<std::uint32_t>{0, 2, 1, 1, 2, 3, 4, 2, 5, 5, 2, 3}));
  EXPECT_FALSE(read.part().points);
}

// ---- textures -------------------------------------------------------------------------------

TEST(Ply, ATextureThatCameIsTheBaseColor) {
  const auto read = [](const std::string& comment, const std::string& lines) {
    const std::string file =
        "ply\nformat ascii 1.0\ncomment " + comment +
        "\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n" + lines +
        "end_header\n0 0 0" + (lines.empty() ? "" : " 0 0") + "\n";
    Faults faults;
    Model model;
    read_ply(
        ModelFiles{{{"of/a skin.png", model_bytes("PNG")}, {"of/a.ply", model_bytes(file)}}, 1}, {},
        faults, model);
    EXPECT_TRUE(faults.empty());
    return model;
  };
  const std::string uvs = "property float s\nproperty float t\n";
  const Model model = read("TextureFile a skin.png ", uvs);
  EXPECT_TRUE(model.warnings.empty());
  EXPECT_EQ(model.images, (std::vector<ModelImage>{{"a skin.png", {'P', 'N', 'G'}}}));
  EXPECT_EQ(model.textures, std::vector{ModelTexture{}});
  EXPECT_EQ(model.materials.at(0).base_color_texture, MaybeTexture{TextureUse{}});
  for (const Model& without :
       {read("TextureFile skin.png", uvs), read("TextureFile a skin.png", ""),
        read("TextureFile ../../a skin.png", uvs)}) {
    EXPECT_TRUE(without.images.empty());
    EXPECT_EQ(without.materials, std::vector{ModelMaterial{}});
    ASSERT_EQ(without.warnings.size(), 1U);
    EXPECT_EQ(without.warnings[0].line, 3U);
  }
  EXPECT_TRUE(read("texturefile none.png", uvs).warnings.empty());
  const Model two = read("TextureFile a skin.png\ncomment TextureFile a skin.png", uvs);
  EXPECT_EQ(two.images.size(), 1U);
  EXPECT_EQ(two.warnings.size(), 1U);
}

TEST(Ply, BytesBehindTheLastRowAreTold) {
  PlyFile file = ply_vertices(1);
  for (int i = 0; i < 3; ++i) file.put("float", i);
  file.end_row();
  for (const std::string_view encoding : ply_encodings) {
    const ReadModel read = read_ply_file(file.in(encoding) + "more\n");
    ASSERT_TRUE(read.faults.empty());
    ASSERT_EQ(read.model.warnings.size(), 1U) << encoding;
    EXPECT_EQ(read.model.warnings[0].line, encoding == "ascii" ? 9U : 0U);
  }
}

}  // namespace
}  // namespace tia
