// STL as bytes and as text: what is known as such, which corners are one vertex.
#include "core/models/stl.h"

#include <gtest/gtest.h>

#include <array>
#include <map>
#include <string>
#include <vector>

#include "tests/core/models/stl_files.h"

namespace tia {
namespace {

using namespace test;

// By a search tree of triples.
void expect_shared(const std::vector<StlTriangle>& triangles, const ModelPart& part) {
  std::map<std::array<float, 3>, std::uint32_t> numbers;
  std::vector<std::uint32_t> indices;
  std::vector<double> positions;
  for (const StlTriangle& t : triangles)
    for (std::size_t i = 0; i < 9; i += 3) {
      const auto next = static_cast<std::uint32_t>(numbers.size());
      const auto [found, is_new] = numbers.try_emplace({t[i], t[i + 1], t[i + 2]}, next);
      indices.push_back(found->second);
      if (is_new) positions.insert(positions.end(), {t[i], t[i + 1], t[i + 2]});
    }
  EXPECT_EQ(part.indices, indices);
  EXPECT_EQ(part.positions, positions);
}

// ---- what is STL ----------------------------------------------------------------------------

TEST(Stl, BytesAreKnownByTheirNumberAlone) {
  const std::string file = stl_bytes({StlTriangle{}, StlTriangle{}});
  EXPECT_EQ(file.size(), 184U);
  EXPECT_TRUE(is_stl(model_bytes(file)));
  EXPECT_FALSE(is_stl(model_bytes(file + "x")));
  EXPECT_FALSE(is_stl(model_bytes(file.substr(0, 183))));
  EXPECT_FALSE(is_stl({}));
  for (std::size_t size = 0; size < file.size(); ++size) {
    EXPECT_FALSE(is_stl(model_bytes(file).first(size))) << size;
    EXPECT_EQ(read_stl_file(file.substr(0, size)).fault().kind, FaultKind::malformed) << size;
  }
}

TEST(Stl, CountsThatOverflowAreNone) {
  std::string file = stl_bytes({StlTriangle{}});
  const auto with_count = [&](std::uint32_t count) {
    return file.replace(80, 4, bytes_of_number(count));
  };
  EXPECT_FALSE(is_stl(model_bytes(with_count(0xFFFFFFFFU))));
  // 50 times 2^31 is a multiple of 2^32.
  EXPECT_FALSE(is_stl(model_bytes(with_count(0x80000001U))));
  EXPECT_TRUE(is_stl(model_bytes(with_count(1))));
}

TEST(Stl, BytesThatBeginAsATextAreBytes) {
  const ReadModel read = read_stl_file(stl_bytes({{0, 0, 0, 1, 0, 0, 0, 1, 0}}, "solid of bytes"));
  EXPECT_TRUE(read.faults.empty());
  EXPECT_EQ(read.part().triangles(), 1U);
}

TEST(Stl, TextsBeginWithTheWordSolid) {
  for (const char* text : {"solid", "solid x", " \r\n\tSOLID\nfacet"})
    EXPECT_TRUE(is_stl(model_bytes(text))) << text;
  for (const char* text : {"", "soli", "solids", "so lid", "x solid", "ply\n"})
    EXPECT_FALSE(is_stl(model_bytes(text))) << text;
}

// ---- what comes out -------------------------------------------------------------------------

TEST(Stl, ACubeHasEightVertices) {
  std::vector<StlTriangle> cube;
  const auto add = [&](const std::array<int, 4>& corners) {  // bits: z y x
    for (const std::array<int, 3> triangle : {std::array{0, 1, 2}, std::array{0, 2, 3}}) {
      StlTriangle t{};
      for (std::size_t i = 0; i < 3; ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
          t[3 * i + axis] =
              (corners[static_cast<std::size_t>(triangle[i])] >> axis & 1) != 0 ? 1.0F : -0.0F;
      cube.push_back(t);
    }
  };
  for (const std::array<int, 4>& side :
       {std::array{0, 2, 3, 1}, std::array{4, 5, 7, 6}, std::array{0, 1, 5, 4},
        std::array{2, 6, 7, 3}, std::array{0, 4, 6, 2}, std::array{1, 3, 7, 5}})
    add(side);
  const ReadModel read = read_stl_file(stl_bytes(cube));
  ASSERT_TRUE(read.faults.empty());
  EXPECT_EQ(read.part().vertices(), 8U);
  EXPECT_EQ(read.part().triangles(), 12U);
  EXPECT_EQ(read.part().indices[0], 0U);
  EXPECT_EQ(std::vector(read.part().indices.begin(), read.part().indices.begin() + 6),
            (std::vector<std::uint32_t>{0, 1, 2, 0, 2, 3}));
}

TEST(Stl, AModelIsOneSceneOfDefaultMatterWithZUp) {
  const Model model = read_stl_file(stl_bytes({{0, 0, 0, 1, 0, 0, 0, 1, 0}})).model;
  EXPECT_EQ(model.format, "stl");
  EXPECT_TRUE(model.z_up);
  EXPECT_EQ(model.materials, std::vector{ModelMaterial{}});
  ASSERT_EQ(model.scenes.size(), 1U);
  EXPECT_EQ(model.scenes[0].nodes, std::vector<ModelIndex>{0});
  ASSERT_EQ(model.nodes.size(), 1U);
  EXPECT_EQ(model.nodes[0].mesh, MaybeIndex{0});
  EXPECT_EQ(model.meshes.at(0).parts.at(0).material, MaybeIndex{0});
  EXPECT_FALSE(model.meshes[0].parts[0].points);
  EXPECT_TRUE(model.meshes[0].parts[0].normals.empty());
  EXPECT_TRUE(model.warnings.empty());
}

TEST(Stl, EqualCornersAreOneVertexInTheOrderOfTheFile) {
  Random random(811);
  for (const int count : {1, 10, 11, 300, 6000})
    for (const int grid : {0, 1, 4, 60}) {
      const auto triangles = stl_on_a_grid(random, count, grid);
      const ReadModel read = read_stl_file(stl_bytes(triangles));
      ASSERT_TRUE(read.faults.empty());
      expect_shared(triangles, read.part());
    }
}

// z cancels the middle of the hash, and x and y are chosen so that its upper half stays.
TEST(Stl, CornersOfOneHashAreSharedAsOthersAre) {
  constexpr std::uint64_t factor = 0x9E3779B97F4A7C15U;
  std::uint64_t inverse = factor;  // modulo 2^64, by Newton's method
  for (int i = 0; i < 6; ++i) inverse *= 2 - factor * inverse;
  ASSERT_EQ(factor * inverse, 1U);
  constexpr std::uint32_t upper = 0x3F800000U;
  std::vector<float> corners;
  for (std::uint32_t low = 0; corners.size() < 90'000; ++low) {
    const std::uint64_t xy = inverse * (std::uint64_t{upper} << 32U | low);
    const std::uint32_t z_bits = low ^ upper;
    const auto x = std::bit_cast<float>(static_cast<std::uint32_t>(xy >> 32U)),
               y = std::bit_cast<float>(static_cast<std::uint32_t>(xy)),
               z = std::bit_cast<float>(z_bits);
    if (std::fabs(x) < 1e9F && std::fabs(y) < 1e9F && std::fabs(z) < 1e9F)
      corners.insert(corners.end(), {x, y, z});
  }
  std::vector<StlTriangle> triangles(2 * corners.size() / 9);
  for (std::size_t i = 0; i < triangles.size(); ++i)
    for (std::size_t k = 0; k < 9; ++k) triangles[i][k] = corners[(9 * i + k) % corners.size()];
  const ReadModel read = read_stl_file(stl_bytes(triangles));
  ASSERT_TRUE(read.faults.empty());
  EXPECT_EQ(read.part().vertices(), 30'000U);
  expect_shared(triangles, read.part());
}

TEST(Stl, TextEqualsBytes) {
  Random random(812);
  for (int i = 0; i < 20; ++i) {
    const auto triangles = stl_on_a_grid(random, random.whole(1, 40), 3);
    const ReadModel bytes = read_stl_file(stl_bytes(triangles)),
                    text = read_stl_file(stl_text(triangles, ""));
    ASSERT_TRUE(text.faults.empty()) << describe(text.fault());
    EXPECT_EQ(text.model, bytes.model);
  }
}

TEST(Stl, NumbersOfATextAreDoublesButEqualAsFloats) {
  const std::string text =
      "solid\nfacet normal a b c outer loop vertex +0.1 -.5e+1 5. vertex 0.10000000001 -5 +5\n"
      "vertex 1e-400 -1e-400 1e-30 endloop endfacet endsolid";
  const ReadModel read = read_stl_file(text);
  ASSERT_TRUE(read.faults.empty());
  EXPECT_EQ(read.part().positions, (std::vector<double>{0.1, -5, 5, 0, 0, 1e-30}));
  EXPECT_EQ(read.part().indices, (std::vector<std::uint32_t>{0, 0, 1}));
}

TEST(Stl, EachSolidIsAMeshAndANodeOfItsName) {
  std::string text = "\n solid  a lid \r\n" + stl_facet + stl_facet + "EndSolid\nSOLID\r\n";
  std::string loud = stl_facet;
  for (char& c : loud) c = static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
  text += loud + "endsolid other name\nsolid none\nendsolid none\n";
  const ReadModel read = read_stl_file(text);
  ASSERT_TRUE(read.faults.empty()) << describe(read.fault());
  ASSERT_EQ(read.model.meshes.size(), 2U);
  EXPECT_EQ(read.model.meshes[0].name, "a lid");
  EXPECT_EQ(read.model.nodes[0].name, "a lid");
  EXPECT_EQ(read.model.meshes[1].name, "");
  EXPECT_EQ(read.model.nodes[1].mesh, MaybeIndex{1});
  EXPECT_EQ(read.model.scenes.at(0).nodes, (std::vector<ModelIndex>{0, 1}));
  EXPECT_EQ(read.part(0).triangles(), 2U);
  EXPECT_EQ(read.part(1).triangles(), 1U);
  ASSERT_EQ(read.model.warnings.size(), 1U);
  EXPECT_EQ(read.model.warnings[0].line, 27U);
}

}  // namespace
}  // namespace tia
