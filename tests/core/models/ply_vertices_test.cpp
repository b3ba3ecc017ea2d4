// The vertices of PLY files: colours, texture coordinates and normals, alike in every encoding.
#include "core/models/ply_vertices.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "tests/core/models/ply_files.h"

namespace tia {
namespace {

using namespace test;

// Three vertices with further properties, and the same numbers in each.
ReadModel read_with(const std::vector<std::array<std::string, 2>>& properties,
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

// IEC 61966-2-1:1999, as an exact power.
Long srgb_light(Long signal) {
  return signal <= 0.04045L ? signal / 12.92L : std::pow((signal + 0.055L) / 1.055L, 2.4L);
}

TEST(PlyVertices, WholeColorsAreSrgbAndAlphaIsAShare) {
  for (const auto& [type, most] :
       {std::pair{std::string("uchar"), 255.0}, std::pair{std::string("uint16"), 65535.0}})
    for (const int step : {0, 1, 9, 10, 11, 128, 200, 255}) {
      const double code = step * (most / 255);
      const ReadModel read = read_with(
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

TEST(PlyVertices, FloatColorsAreLinearAndOpaqueWithoutAlpha) {
  const ReadModel read =
      read_with({{"float", "red"}, {"double", "green"}, {"uchar", "blue"}}, {0.25, 0.5, 255});
  EXPECT_EQ(read.part().colors,
            (std::vector<float>{0.25F, 0.5F, 1, 1, 0.25F, 0.5F, 1, 1, 0.25F, 0.5F, 1, 1}));
  EXPECT_TRUE(read_with({{"float", "red"}, {"float", "green"}}, {0.5, 0.5}).part().colors.empty());
  EXPECT_FALSE(read_with({{"float", "red"}, {"float", "green"}, {"int", "blue"}}, {0, 0, 0})
                   .model.warnings.empty());
}

TEST(PlyVertices, ColorsHaveThreeSpellings) {
  const std::vector<float> color{0.25F, 0.5F, 1, 0.75F};
  const std::vector<std::array<std::string, 4>> spellings{
      {"red", "green", "blue", "alpha"},
      {"diffuse_red", "diffuse_green", "diffuse_blue", "diffuse_alpha"},
      {"r", "g", "b", "a"}};
  for (const auto& [r, g, b, a] : spellings) {
    const ReadModel read =
        read_with({{"float", r}, {"float", g}, {"float", b}, {"float", a}}, {0.25, 0.5, 1, 0.75});
    ASSERT_EQ(read.part().colors.size(), 12U) << r;
    for (std::size_t i = 0; i < 12; ++i) EXPECT_EQ(read.part().colors[i], color[i % 4]) << r;
    EXPECT_TRUE(read.model.warnings.empty()) << r;
  }
  EXPECT_TRUE(read_with({{"float", "red"}, {"float", "g"}, {"float", "b"}}, {0, 0, 0})
                  .part()
                  .colors.empty());
}

TEST(PlyVertices, TextureCoordinatesGrowDownward) {
  using Names = std::array<std::string, 2>;
  for (const auto& [u, v] : {Names{"s", "t"}, Names{"u", "v"}, Names{"texture_u", "texture_v"}}) {
    const ReadModel read = read_with({{"float", v}, {"double", u}}, {0.25, -3});
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

TEST(PlyVertices, NormalsAreAllOrNone) {
  const ReadModel read = read_with({{"float", "nz"}, {"float", "nx"}, {"char", "ny"}}, {5, -1, 3});
  EXPECT_EQ(read.part().normals, (std::vector<float>{-1, 3, 5, -1, 3, 5, -1, 3, 5}));
  EXPECT_TRUE(read_with({{"float", "nz"}, {"float", "nx"}}, {5, -1}).part().normals.empty());
  const ReadModel zero =
      read_ply_file(ply_text(2, "property float nx\nproperty double ny\nproperty float nz\n",
                             "0 0 0 0 1 0\n0 0 0 0 -1e-300 0\n"));
  ASSERT_TRUE(zero.faults.empty());
  EXPECT_TRUE(zero.part().normals.empty());
  ASSERT_EQ(zero.model.warnings.size(), 1U);
  EXPECT_EQ(zero.model.warnings[0].line, 12U);
}

}  // namespace
}  // namespace tia
