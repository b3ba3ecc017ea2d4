// OBJ files that are wrong, too large, cut off or contrived: faults with their lines, no more.
// Quick tier, some 0.3 s.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <optional>
#include <string>
#include <vector>

#include "core/models/obj.h"
#include "tests/core/models/obj_files.h"
#include "tests/core/support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

/// WrongObjLine: a line after three positions, two texture coordinates and a normal, in lines 1
/// to 6.
struct WrongObjLine {
  const char* text;
  FaultKind kind;
  const char* got;
  const char* allowed;
};

TEST(ObjFaults, ComeWithTheirLines) {
  constexpr FaultKind malformed = FaultKind::malformed, out_of_range = FaultKind::out_of_range;
  const std::vector<WrongObjLine> lines{
      {"v", malformed, "v", "x y z"},
      {"v 1 2", malformed, "v 1 2", "x y z"},
      {"v 1 2 3 4 5", malformed, "v 1 2 3 4 5", "r g b"},
      {"v 1 2 3 4 5 6 7", malformed, "v 1 2 3 4 5 6 7", "r g b"},
      {"v 1 2 x", malformed, "x", "x y z"},
      {"v 1 2 3x", malformed, "3x", "x y z"},
      {"v 1 2 +-3", malformed, "+-3", "x y z"},
      {"v 1 2 0x3", malformed, "0x3", "x y z"},
      {"v 1,2 2 3", malformed, "1,2", "x y z"},
      {"v 1 2 nan", out_of_range, "nan", "1e9"},
      {"v 1 -inf 3", out_of_range, "-inf", "1e9"},
      {"v 1e400 2 3", out_of_range, "1e400", "1e9"},
      {"v 1 2 1000000001", out_of_range, "v 1 2 1000000001", "1e9"},
      {"v 1 2 3 1 nan 1", out_of_range, "nan", "r g b"},
      {"vt", malformed, "vt", "u v"},
      {"vt 1 2 3 4", malformed, "vt 1 2 3 4", "u v"},
      {"vt inf", out_of_range, "inf", "finite"},
      {"vn 1 2", malformed, "vn 1 2", "x y z"},
      {"vn 0 0 1e39", out_of_range, "vn 0 0 1e39", "single precision"},
      {"f", malformed, "f", "three corners"},
      {"f 1 2", malformed, "f 1 2", "three corners"},
      {"f 1 2 3.5", malformed, "3.5", "v/vt/vn"},
      {"f 1 2 3/1/1/1", malformed, "3/1/1/1", "v/vt/vn"},
      {"f 1 2 /1", malformed, "/1", "v/vt/vn"},
      {"f 1 2 -", malformed, "-", "v/vt/vn"},
      {"f 1 2 3/-", malformed, "3/-", "v/vt/vn"},
      {"f 1 2 3/+1", malformed, "3/+1", "v/vt/vn"},
      {"f 1 2 --3", malformed, "--3", "v/vt/vn"},
      {"f 0 1 2", out_of_range, "0", "of the 3 positions"},
      {"f 1 2 4", out_of_range, "4", "of the 3 positions"},
      {"f 1 2 -4", out_of_range, "-4", "of the 3 positions"},
      {"f 1/1 2/2 3/3", out_of_range, "3/3", "2 texture coordinates"},
      {"f 1//1 2//1 3//-2", out_of_range, "3//-2", "1 normals"},
      {"f 1 2 4294967297", out_of_range, "4294967297", "3 positions"},
      {"f 1 2 18446744073709551617", out_of_range, "18446744073709551617", "3 positions"},
      {"p 1 4", out_of_range, "4", "3 positions"},
      {"p 1 x", malformed, "x", "v/vt/vn"},
  };
  for (const WrongObjLine& line : lines) {
    const ReadObj read = read_obj_text("v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nvt 1 1\nvn 0 0 1\n" +
                                       std::string(line.text) + "\nv 1 1 1\nvt 1 0\nvn 0 1 0\n");
    ASSERT_EQ(read.faults.count(), 1U) << line.text;
    const Fault& fault = read.faults.list()[0];
    EXPECT_EQ(fault.kind, line.kind) << line.text;
    EXPECT_EQ(fault.got, Value(line.got)) << line.text;
    EXPECT_EQ(fault.line, 7U);
    EXPECT_EQ(fault.pointer, "");
    EXPECT_THAT(fault.allowed, HasSubstr(line.allowed)) << line.text;
    EXPECT_TRUE(read.model.meshes.empty());
  }
}
TEST(ObjFaults, LinesAreCountedWhereTheyGoOn) {
  const ReadObj read = read_obj_text("v 0 0 \\\n0\nv 1\\\r\n 0 \\\n0\n\n# \\\nv\nf 1 2 \\\n 9\n");
  ASSERT_EQ(read.faults.count(), 1U);
  EXPECT_EQ(read.faults.list()[0].line, 9U);
}
TEST(ObjFaults, AFaultyPositionKeepsItsPlace) {
  const ReadObj read =
      read_obj_text("v 0 0 0\nv 0 x\nv 1 0 0\nvt\nvn 0\nf 1/1/1 2/1/1 3/1/1\nf 4 1 1\n");
  ASSERT_EQ(read.faults.count(), 4U);
  EXPECT_EQ(read.faults.list()[3].line, 7U);
}
TEST(ObjFaults, TwentyAreEnough) {
  std::string text;
  for (int i = 0; i < 1000; ++i) text += "v\n";
  EXPECT_EQ(read_obj_text(text).faults.count(), 20U);
}

// ---- limits -------------------------------------------------------------------------------------

void expect_obj_limit(const std::string& text, const ModelLimits& limits,
                      std::optional<std::size_t> line, const char* allowed) {
  const ReadObj read = read_obj_text(text, limits);
  ASSERT_EQ(read.faults.count(), 1U) << text;
  EXPECT_EQ(read.faults.list()[0].kind, FaultKind::limit);
  EXPECT_EQ(read.faults.list()[0].line, line);
  EXPECT_THAT(read.faults.list()[0].allowed, HasSubstr(allowed));
}

TEST(ObjFaults, LimitsAreKeptToOne) {
  const std::string head = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
  ModelLimits limits;
  limits.triangles = 2;
  EXPECT_TRUE(read_obj_text(head + "f 1 2 3 4\n", limits).faults.empty());
  expect_obj_limit(head + "f 1 2 3 4\nf 1 2 3\nf x\n", limits, 6, "2 triangles");
  limits = {};
  limits.polygon_corners = 3;
  expect_obj_limit(head + "f 1 2 3\nf 1 2 3 4\n", limits, 6, "3 corners of a polygon");
  limits = {};
  limits.vertices = 4;
  EXPECT_TRUE(read_obj_text(head + "f 1 2 3 4\n", limits).faults.empty());
  expect_obj_limit(head + "v 0 0 0\nv\n", limits, 5, "4 positions");
  expect_obj_limit("vt 0\nvt 0\nvt 0\nvt 0\nvt 0\n", limits, 5, "4 texture coordinates");
  expect_obj_limit("vn 0 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\nvn 0 0 1\n", limits, 5, "4 normals");
  expect_obj_limit(head + "p 1 2\np 3 4\np 1\n", limits, 7, "4 points");
  expect_obj_limit(head + "o a\nf 1 2 3\no b\nf 1 2 3\n", limits, std::nullopt, "4 vertices");
  limits = {};
  limits.nodes = 2;
  expect_obj_limit(head + "o a\nf 1 2 3\no b\no c\nf 1 2 3\no d\nf 1 2 3\n", limits, 11,
                   "2 objects");
  std::string names;
  for (int i = 0; i < 65; ++i) names += "mtllib a" + std::to_string(i) + "\n";
  expect_obj_limit(names, {}, 65, "64 names");
}

// ---- cut off, contrived, random -----------------------------------------------------------------

const TextFiles obj_small_files{
    {{"a.obj",
      "# small\nmtllib a.mtl\no a\nv 0 0 0 1 0 0\nv 1 0 0 0 1 0\nv 0 1 0 0 0 1\nv 1 1 0 1 1 1\n"
      "vt 0 0\nvt 1 1\nvn 0 0 1\nusemtl m\ns 1\nf 1/1/1 2/2/1 \\\n4/1/1 3/1/1\ng b\nf -1 -2 -3\n"},
     {"a.mtl",
      "newmtl m\nKd 0.5 0.25 1\nKe 2 0 0\nNs 100\nd 0.5\nillum 4\nmap_Kd -s 2 2 -o 0.5 0 -clamp on "
      "a.png\nnorm -bm 0.5 a.png\n"},
     {"a.png", "\x89PNG\r\n\x1A\n"}}};

TEST(ObjFaults, WhereverAFileIsCutOffItHasFaultsOrIsSound) {
  for (std::size_t file = 0; file < 3; ++file)
    for (std::size_t size = 0; size <= obj_small_files.texts[file].second.size(); ++size) {
      TextFiles cut = obj_small_files;
      cut.texts[file].second.resize(size);
      const ReadObj read = read_obj_files(cut);
      if (read.faults.empty()) expect_sound(read.model);
    }
}
TEST(ObjFaults, WhateverBytesAFileHasItHasFaultsOrIsSound) {
  Random random(7);
  static constexpr char letters[] = "\0\n\r\\#/-+.eE0123456789 \tvfnptglosmuKdiN\xFF\x80";
  const std::string bytes(letters, sizeof letters - 1);
  for (int i = 0; i < 3000; ++i) {
    TextFiles files = obj_small_files;
    std::string& text = files.texts[static_cast<std::size_t>(random.below(2))].second;
    for (int changes = random.whole(1, 12); changes > 0; --changes) {
      const auto at = static_cast<std::size_t>(random.below(static_cast<int>(text.size())));
      text[at] = bytes[static_cast<std::size_t>(random.below(static_cast<int>(bytes.size())))];
    }
    const ReadObj read = read_obj_files(files);
    if (read.faults.empty()) expect_sound(read.model);
  }
}

// Corners of one position with so many texture coordinates that no list of them may be gone
// through, each twice.
TEST(ObjFaults, OnePositionMayHaveManyVertices) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  const int count = 10000;
  for (int i = 0; i < count; ++i) text += "vt " + std::to_string(i) + "\n";
  for (const bool back : {false, true})
    for (int i = 1; i <= count; ++i) {
      const std::string uv = "/" + std::to_string(back ? count + 1 - i : i);
      text += "f 1" + uv + " 2" + uv + " 3" + uv + "\n";
    }
  const Model model = obj_model(text);
  const ModelPart& part = only_part(model);
  EXPECT_EQ(part.vertices(), 3U * count);
  for (std::size_t i = 0; i < 3U * count; ++i) {
    EXPECT_EQ(part.indices[i], i);
    EXPECT_EQ(part.indices[3U * count + i], 3U * count - 3 - i + 2 * (i % 3));
  }
}
TEST(ObjFaults, ManyNamesAndChangesTakeNoTime) {
  std::string text = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
  for (int i = 0; i < 5000; ++i)
    text += "o a" + std::to_string(i) + "\nusemtl b" + std::to_string(i) + "\nf 1 2 3\n";
  const Model model = obj_model(text);
  EXPECT_EQ(model.meshes.size(), 5000U);
  EXPECT_EQ(model.warnings.size(), 20U);
}

// ---- an independent reading ---------------------------------------------------------------------

using ObjTriple = std::array<int, 3>;  // from 1

std::string obj_corner_text(const ObjTriple& corner, const std::array<int, 3>& counts, bool back) {
  std::string text;
  for (std::size_t k = 0; k < 3; ++k)
    text += (k == 0 ? "" : "/") + std::to_string(back ? corner[k] - counts[k] - 1 : corner[k]);
  return text;
}

TEST(ObjFaults, RandomTrianglesHaveTheCornersThatTheyName) {
  Random random(8);
  for (int round = 0; round < 50; ++round) {
    const std::array counts{random.whole(3, 12), random.whole(1, 6), random.whole(1, 4)};
    std::string text;
    for (int i = 1; i <= counts[0]; ++i)
      text += "v " + std::to_string(i) + " 0 " + std::to_string(i * i) + "\n";
    for (int i = 1; i <= counts[1]; ++i) text += "vt " + std::to_string(i) + " 0.5\n";
    for (int i = 1; i <= counts[2]; ++i) text += "vn 0 1 " + std::to_string(i) + "\n";
    std::vector<ObjTriple> corners;
    for (int i = 0; i < 3 * 40; ++i) {
      ObjTriple corner{};
      for (std::size_t k = 0; k < 3; ++k) corner[k] = random.whole(1, counts[k]);
      text += (i % 3 == 0 ? "\nf " : " ") + obj_corner_text(corner, counts, random.chance(0.5));
      corners.push_back(corner);
    }
    const Model model = obj_model(text);
    const ModelPart& part = only_part(model);
    ASSERT_EQ(part.indices.size(), corners.size());
    std::vector<ObjTriple> seen;
    for (std::size_t i = 0; i < corners.size(); ++i) {
      const std::size_t vertex = part.indices[i];
      EXPECT_EQ(part.positions[3 * vertex], corners[i][0]);
      EXPECT_EQ(part.uvs[0][2 * vertex], corners[i][1]);
      EXPECT_EQ(part.normals[3 * vertex + 2], static_cast<float>(corners[i][2]));
      const auto found = std::find(seen.begin(), seen.end(), corners[i]);
      EXPECT_EQ(vertex, static_cast<std::size_t>(found - seen.begin()));
      if (found == seen.end()) seen.push_back(corners[i]);
    }
    EXPECT_EQ(part.vertices(), seen.size());
  }
}

}  // namespace
}  // namespace tia::test
