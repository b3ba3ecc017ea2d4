// PLY: what comes of a file's properties and faces is the same in every encoding.
#include "core/models/ply.h"

#include <gtest/gtest.h>

#include <limits>
#include <string>
#include <vector>

#include "tests/core/models/ply_files.h"

namespace tia {
namespace {

using namespace test;

// A text's warnings may have lines where bytes have none.
Model without_lines(Model model) {
  for (ModelWarning& warning : model.warnings) warning.line = 0;
  return model;
}

// The text, which is the same in every other encoding.
ReadFile read_in_all(const PlyFile& file) {
  const ReadFile text = read_ply_file(file.in("ascii"));
  for (const std::string_view encoding : ply_encodings) {
    const ReadFile read = read_ply_file(file.in(encoding));
    for (const Fault& fault : read.faults) ADD_FAILURE() << encoding << ": " << describe(fault);
    EXPECT_TRUE(without_lines(read.model) == without_lines(text.model)) << encoding;
    expect_sound(read);
  }
  return text;
}

PlyFile ply_vertices(std::size_t count) {
  PlyFile file;
  file.element("vertex", count);
  for (const char* name : {"x", "y", "z"}) file.property("float", name);
  return file;
}

// Three vertices with further properties, and the same numbers in each.
ReadFile read_with(const std::vector<std::array<std::string, 2>>& properties,
                   const std::vector<double>& numbers) {
  PlyFile file = ply_vertices(3);
  for (const auto& [type, name] : properties) file.property(type, name);
  for (int i = 0; i < 3; ++i) {
    file.put("float", i).put("float", 0.5).put("float", i * i);
    for (std::size_t k = 0; k < properties.size(); ++k) file.put(properties[k][0], numbers[k]);
    file.end_row();
  }
  return read_in_all(file);
}

// ---- models ---------------------------------------------------------------------------------

TEST(Ply, FilesAreKnownByTheirFirstLine) {
  for (const char* text : {"ply\n", "ply\r\n", "ply\rformat"})
    EXPECT_TRUE(is_ply(bytes_of(text))) << text;
  for (const char* text : {"", "pl", "ply", "plyx\n", " ply\n", "PLY\n", "solid\n"})
    EXPECT_FALSE(is_ply(bytes_of(text))) << text;
}

TEST(Ply, AModelIsOneSceneOfDefaultMatterWithZUp) {
  const ReadFile read = read_ply_file(ply_text(3, ply_face_lines, ply_corners + "3 0 1 2\n"));
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
    const ReadFile read = read_ply_file(ply_text(3, lines, ply_corners));
    ASSERT_TRUE(read.faults.empty()) << describe(read.fault());
    EXPECT_TRUE(read.part().points);
    EXPECT_EQ(read.part().vertices(), 3U);
    EXPECT_TRUE(read.part().indices.empty());
  }
}

TEST(Ply, LinesEndWithCrLfOrBoth) {
  const std::string text =
      ply_text(3, ply_face_lines + "comment x\n\n", ply_corners + "\n3 0 1 2\n");
  const ReadFile expected = read_ply_file(text);
  for (const std::string end : {"\r\n", "\r"}) {
    std::string other;
    for (const char c : text) other += c == '\n' ? end : std::string(1, c);
    const ReadFile read = read_ply_file(other);
    ASSERT_TRUE(read.faults.empty()) << describe(read.fault());
    EXPECT_EQ(read.model, expected.model);
  }
  // The first byte after a CR may look like an LF.
  PlyFile file;
  file.element("vertex", 1);
  for (const char* name : {"x", "y", "z"}) file.property("uchar", name);
  file.put("uchar", 10).put("uchar", 13).put("uchar", 32);
  std::string bytes = file.in("binary_little_endian");
  std::replace(bytes.begin(), bytes.end() - 3, '\n', '\r');
  EXPECT_EQ(read_ply_file(bytes).part().positions, (std::vector<double>{10, 13, 32}));
}

// ---- numbers --------------------------------------------------------------------------------

TEST(Ply, NumbersOfEveryTypeAreThemselves) {
  struct Range {
    const char *name, *other;
    double least, most;
  };
  for (const Range& range : {Range{"char", "int8", -128, 127},
                             {"uchar", "uint8", 0, 255},
                             {"short", "int16", -32768, 32767},
                             {"ushort", "uint16", 0, 65535},
                             {"int", "int32", -1e9, 999'999'999},
                             {"uint", "uint32", 0, 1e9},
                             {"float", "float32", -1e9, 0x1.8p-100},
                             {"double", "float64", -0.1, 1e9}})
    for (const char* type : {range.name, range.other}) {
      PlyFile file;
      file.element("vertex", 1);
      for (const char* name : {"z", "x", "y"}) file.property(type, name);
      file.put(type, range.least).put(type, range.most).put(type, 1).end_row();
      EXPECT_EQ(read_in_all(file).part().positions,
                (std::vector<double>{range.most, 1, range.least}))
          << type;
    }
}

TEST(Ply, RandomFilesAreTheSameInEveryEncoding) {
  Random random(821);
  const std::vector<std::string> types{"char", "uchar", "short", "ushort",
                                       "int",  "uint",  "float", "double"};
  const auto type = [&] { return types[static_cast<std::size_t>(random.below(8))]; };
  const auto whole = [&] { return types[static_cast<std::size_t>(random.below(6))]; };
  for (int round = 0; round < 60; ++round) {
    const int vertices = random.whole(3, 9), faces = random.whole(0, 6), others = random.below(4);
    const std::string place = type(), count = whole(), index = whole(), more = type();
    PlyFile file;
    file.element("other", static_cast<std::size_t>(others));
    file.list(count, more, "skipped").property(more, "x");
    file.element("vertex", static_cast<std::size_t>(vertices)).property(more, "skipped");
    for (const char* name : {"x", "y", "z"}) file.property(place, name);
    file.list(count, more, "nx").element("face", static_cast<std::size_t>(faces));
    file.property(more, "skipped").list(count, index, "vertex_index").list(count, more, "other");
    const auto list = [&](int most) {
      std::vector<int> numbers(static_cast<std::size_t>(random.below(most + 1)));
      for (int& each : numbers) each = random.below(vertices);
      return numbers;
    };
    for (int i = 0; i < others; ++i)
      file.put_list(count, more, list(5)).put(more, random.below(100)).end_row();
    std::vector<double> positions;
    for (int i = 0; i < vertices; ++i) {
      file.put(more, random.below(100));
      for (int axis = 0; axis < 3; ++axis) {
        positions.push_back(random.below(100));
        file.put(place, positions.back());
      }
      file.put_list(count, more, list(3)).end_row();
    }
    std::size_t triangles = 0;
    for (int i = 0; i < faces; ++i) {
      const std::vector<int> corners = list(7);
      triangles += corners.size() < 3 ? 0 : corners.size() - 2;
      file.put(more, 1).put_list(count, index, corners).put_list(count, more, list(3)).end_row();
    }
    const ReadFile read = read_in_all(file);
    EXPECT_EQ(read.part().positions, positions);
    EXPECT_EQ(read.part().triangles(), triangles);
    EXPECT_EQ(read.part().points, faces == 0);
  }
}

TEST(Ply, WhatIsNotUsedIsTold) {
  PlyFile file = ply_vertices(1);
  file.property("float", "confidence").property("int", "red").element("camera", 1);
  file.property("double", "focal").element("none", 0).property("int", "x");
  for (int i = 0; i < 3; ++i) file.put("float", i);
  file.put("float", 1).put("int", 1).end_row().put("double", 5).end_row();
  const ReadFile read = read_in_all(file);
  ASSERT_EQ(read.model.warnings.size(), 2U);
  EXPECT_EQ(read.model.warnings[0].text, "not used of element vertex: confidence, red");
  EXPECT_EQ(read.model.warnings[0].line, 3U);
  EXPECT_EQ(read.model.warnings[1].text, "not used of element camera: all");
  EXPECT_EQ(read.model.warnings[1].line, 9U);
}

// ---- vertices -------------------------------------------------------------------------------

// IEC 61966-2-1:1999, as an exact power.
Long srgb_light(Long signal) {
  return signal <= 0.04045L ? signal / 12.92L : std::pow((signal + 0.055L) / 1.055L, 2.4L);
}

TEST(Ply, WholeColorsAreSrgbAndAlphaIsAShare) {
  for (const auto& [type, most] :
       {std::pair{std::string("uchar"), 255.0}, std::pair{std::string("uint16"), 65535.0}})
    for (const int step : {0, 1, 9, 10, 11, 128, 200, 255}) {
      const double code = step * (most / 255);
      const ReadFile read = read_with(
          {{type, "blue"}, {type, "red"}, {type, "alpha"}, {type, "green"}}, {code, 0, code, most});
      ASSERT_EQ(read.part().colors.size(), 12U);
      const Long share = static_cast<Long>(code) / most;
      for (std::size_t i = 0; i < 12; i += 4) {
        EXPECT_EQ(read.part().colors[i], 0);
        EXPECT_EQ(read.part().colors[i + 1], 1);
        EXPECT_FLOAT_EQ(read.part().colors[i + 2], static_cast<float>(srgb_light(share)));
        EXPECT_FLOAT_EQ(read.part().colors[i + 3], static_cast<float>(share));
      }
    }
}

TEST(Ply, FloatColorsAreLinearAndOpaqueWithoutAlpha) {
  const ReadFile read =
      read_with({{"float", "red"}, {"double", "green"}, {"uchar", "blue"}}, {0.25, 0.5, 255});
  EXPECT_EQ(read.part().colors,
            (std::vector<float>{0.25F, 0.5F, 1, 1, 0.25F, 0.5F, 1, 1, 0.25F, 0.5F, 1, 1}));
  EXPECT_TRUE(read_with({{"float", "red"}, {"float", "green"}}, {0.5, 0.5}).part().colors.empty());
  EXPECT_FALSE(read_with({{"float", "red"}, {"float", "green"}, {"int", "blue"}}, {0, 0, 0})
                   .model.warnings.empty());
}

TEST(Ply, TextureCoordinatesGrowDownward) {
  using Names = std::array<std::string, 2>;
  for (const auto& [u, v] : {Names{"s", "t"}, Names{"u", "v"}, Names{"texture_u", "texture_v"}}) {
    const ReadFile read = read_with({{"float", v}, {"double", u}}, {0.25, -3});
    EXPECT_EQ(read.part().uvs[0], (std::vector<double>{-3, 0.75, -3, 0.75, -3, 0.75})) << u;
  }
  EXPECT_TRUE(read_with({{"float", "u"}, {"float", "t"}}, {0, 0}).part().uvs[0].empty());
  // The first pair that is whole counts.
  EXPECT_EQ(
      read_with({{"float", "v"}, {"float", "u"}, {"float", "t"}, {"float", "s"}}, {1, 2, 3, 4})
          .part()
          .uvs[0][0],
      4);
}

TEST(Ply, NormalsAreAllOrNone) {
  const ReadFile read = read_with({{"float", "nz"}, {"float", "nx"}, {"char", "ny"}}, {5, -1, 3});
  EXPECT_EQ(read.part().normals, (std::vector<float>{-1, 3, 5, -1, 3, 5, -1, 3, 5}));
  EXPECT_TRUE(read_with({{"float", "nz"}, {"float", "nx"}}, {5, -1}).part().normals.empty());
  const ReadFile zero =
      read_ply_file(ply_text(2, "property float nx\nproperty double ny\nproperty float nz\n",
                             "0 0 0 0 1 0\n0 0 0 0 -1e-300 0\n"));
  ASSERT_TRUE(zero.faults.empty());
  EXPECT_TRUE(zero.part().normals.empty());
  ASSERT_EQ(zero.model.warnings.size(), 1U);
  EXPECT_EQ(zero.model.warnings[0].line, 12U);
}

// ---- faces ----------------------------------------------------------------------------------

TEST(Ply, PolygonsBecomeTrianglesInTheirPlace) {
  // An arrow whose third corner is inside of the other three.
  const std::string arrow = "0 0 0\n2 1 0\n0.5 0.5 0\n1 2 0\n",
                    faces = "element face 3\nproperty list uchar int vertex_index\n";
  const ReadFile read = read_ply_file(ply_text(4, faces, arrow + "3 0 1 2\n4 0 1 2 3\n3 3 2 1\n"));
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
    const auto x = [&](std::size_t k) { return part.positions[3 * part.indices[t + k]]; };
    const auto y = [&](std::size_t k) { return part.positions[3 * part.indices[t + k] + 1]; };
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
    file.put("short", corner % 2).put("short", corner / 2).put("short", 0).end_row();
  EXPECT_EQ(read_in_all(file).part().triangles(), 2U);
}

TEST(Ply, FacesOfFewCornersAreLeftOut) {
  const ReadFile read =
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
    file.put("float", i / 2).put("float", i % 2).put("float", 0).end_row();
  file.put_list("int", "int", {0, 2, 1, 3, 3, 5, -1, 0, 1, -1, 4, 2, 5, 3}).end_row();
  file.put_list("int", "int", {}).end_row();
  const ReadFile read = read_in_all(file);
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
    read_ply(ModelFiles{{{"of/a skin.png", bytes_of("PNG")}, {"of/a.ply", bytes_of(file)}}, 1}, {},
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
    const ReadFile read = read_ply_file(file.in(encoding) + "more\n");
    ASSERT_TRUE(read.faults.empty());
    ASSERT_EQ(read.model.warnings.size(), 1U) << encoding;
    EXPECT_EQ(read.model.warnings[0].line, encoding == "ascii" ? 9U : 0U);
  }
}

}  // namespace
}  // namespace tia
