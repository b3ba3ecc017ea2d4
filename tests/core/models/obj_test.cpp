// OBJ files: what their statements make, by models written out by hand and by an independent
// reading of random ones. Quick tier, some 0.2 s.
#include "core/models/obj.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <string>
#include <vector>

#include "tests/core/models/obj_files.h"
#include "tests/core/support.h"

namespace tia::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string obj_three = "v 0 0 0\nv 1 0 0\nv 0 1 0\n";
const std::string obj_square = obj_three + "v 1 1 0\n";

// ---- what is one --------------------------------------------------------------------------------

bool is_obj_text(const std::string& text) { return is_obj(bytes_of(text)); }

TEST(Obj, IsKnownByItsStatements) {
  EXPECT_TRUE(is_obj_text(obj_three + "f 1 2 3\n"));
  EXPECT_TRUE(is_obj_text("# made by hand\r\n\r\nmtllib a.mtl\r\no a\r\nv 0 0 0\r\n"));
  EXPECT_TRUE(is_obj_text("\xEF\xBB\xBF\tv +1. .5 -0\nvn 0 0 1"));
  EXPECT_TRUE(is_obj_text("v 0 0 \\\n0\nl 1 1\n"));
  EXPECT_TRUE(is_obj_text("g a\nv 0 0 0\n"));
}
TEST(Obj, IsNotOtherTexts) {
  for (const char* text :
       {"", "v", "v \n", "v 0 0 0\n", "f 1 2 3\n", "ply\nformat ascii 1.0\n", "solid a\nfacet",
        "{\"asset\": {\"version\": \"2.0\"}}", "newmtl a\nKd 1 1 1\n", "v is a letter\nf too\n",
        "hello\nv 0 0 0\nf 1 1 1\n", "#VRML V2.0 utf8\nShape {}\nv 0 0 0\nf 1 1 1\n"})
    EXPECT_FALSE(is_obj_text(text)) << text;
  EXPECT_FALSE(is_obj_text(obj_three + std::string("f 1 2 3\n\0", 9)));
}
TEST(Obj, IsKnownByPositionsAloneWhereTheyGoOnAndOn) {
  std::string text;
  while (text.size() <= 1 << 20) text += "v 0.25 0.25 0.25\n";
  EXPECT_TRUE(is_obj_text(text));
  text.resize(1 << 20);
  EXPECT_FALSE(is_obj_text(text));
}

// ---- faces --------------------------------------------------------------------------------------

TEST(Obj, ATriangleIsAModel) {
  Model expected;
  expected.format = "obj";
  expected.scenes = {{"", {0}}};
  ModelNode node;
  node.mesh = 0;
  expected.nodes = {node};
  ModelPart part;
  part.positions = {0, 0, 0, 1, 0, 0, 0, 1, 0};
  part.indices = {0, 1, 2};
  expected.meshes = {{"", {part}, {}}};
  EXPECT_EQ(obj_model(obj_three + "f 1 2 3\n"), expected);
}
TEST(Obj, VerticesComeInTheOrderInWhichCornersFirstHaveThem) {
  const ModelPart part = only_part(obj_model(obj_square + "f 4 3 2\nf 2 3 1\n"));
  EXPECT_THAT(part.positions, ElementsAre(1, 1, 0, 0, 1, 0, 1, 0, 0, 0, 0, 0));
  EXPECT_THAT(part.indices, ElementsAre(0, 1, 2, 2, 1, 3));
}
TEST(Obj, NegativeIndicesCountBackFromWhatHasCome) {
  const ModelPart part = only_part(obj_model(obj_three + "f -3 -2 -1\nv 1 1 0\nf -1 -2 2\n"));
  EXPECT_THAT(part.positions, ElementsAre(0, 0, 0, 1, 0, 0, 0, 1, 0, 1, 1, 0));
  EXPECT_THAT(part.indices, ElementsAre(0, 1, 2, 3, 2, 1));
}
TEST(Obj, PolygonsAreCut) {
  EXPECT_THAT(only_part(obj_model(obj_square + "f 1 2 4 3\n")).indices,
              ElementsAre(3, 0, 1, 3, 1, 2));
  // A dart, whose dent is its third corner.
  EXPECT_THAT(only_part(obj_model("v 0 0 0\nv 4 0 0\nv 1 1 0\nv 0 4 0\nf 1 2 3 4\n")).indices,
              ElementsAre(0, 1, 2, 3, 0, 2));
}
TEST(Obj, EqualCornersAreOneVertexAndOthersAreNot) {
  const ModelPart part = only_part(
      obj_model(obj_three +
                "vt 0 0\nvt 1 0\nvn 0 0 1\nvn 0 0 2\nf 1/1/1 2/1/1 3/1/1\nf 1/1/1 2/2/1 3/1/2\n"));
  EXPECT_THAT(part.indices, ElementsAre(0, 1, 2, 0, 3, 4));
  EXPECT_THAT(part.uvs[0], ElementsAre(0, 1, 0, 1, 0, 1, 1, 1, 0, 1));
  EXPECT_THAT(part.normals, ElementsAre(0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 1, 0, 0, 2));
}
TEST(Obj, TextureCoordinatesGoDownward) {
  const ModelPart part =
      only_part(obj_model(obj_three + "vt 0.25 0.25\nvt 2\nvt -1 -1 7\nf 1/1 2/2 3/3\n"));
  EXPECT_THAT(part.uvs[0], ElementsAre(0.25, 0.75, 2, 1, -1, 2));
  EXPECT_THAT(part.uvs[1], IsEmpty());
}
TEST(Obj, WhatOnlySomeCornersHaveIsLeftOut) {
  const std::string lists = obj_three + "vt 0 0\nvt 1 1\nvn 0 0 1\nvn 1 0 0\n";
  const ModelPart uvs = only_part(obj_model(lists + "f 1/1/1 2/1/1 3/1/1\nf 1/2/2 2/2 3/2/2\n"));
  EXPECT_THAT(uvs.normals, IsEmpty());
  EXPECT_EQ(uvs.vertices(), 6U);  // by the two texture coordinates, not by the normals
  const ModelPart normals =
      only_part(obj_model(lists + "f 1/1/1 2//1 3/1/1\nf 1/2/1 2/2/1 3//1\n"));
  EXPECT_THAT(normals.uvs[0], IsEmpty());
  EXPECT_EQ(normals.vertices(), 3U);
  EXPECT_EQ(normals.normals.size(), 9U);
}
TEST(Obj, SlashesWithNothingAfterThemSayNothing) {
  const ModelPart part = only_part(obj_model(obj_three + "vt 0 0\nf 1/1/ 2/1/ 3/1/\n"));
  EXPECT_EQ(part.uvs[0].size(), 6U);
  EXPECT_THAT(only_part(obj_model(obj_three + "f 1/ 2// 3\n")).uvs[0], IsEmpty());
}
TEST(Obj, NormalsOfNoLengthAreDropped) {
  const Model model = obj_model(obj_three + "vn 0 0 1\nvn 0 -0 1e-60\nvn 0 0 0\n" +
                                "usemtl a\nf 1//1 2//1 3//1\nusemtl b\nf 1//1 2//2 3//3\n");
  ASSERT_EQ(model.warnings.size(), 3U);
  EXPECT_EQ(model.warnings[0].line, 5U);
  EXPECT_THAT(model.warnings[0].text, HasSubstr("length 0"));
  EXPECT_THAT(only_part(model).normals, IsEmpty());
}

// ---- numbers ------------------------------------------------------------------------------------

TEST(Obj, NumbersAreTheNearestDoubles) {
  const ModelPart part = only_part(obj_model(
      "v 0.1 +1e3 -.5e-3\nv 123456789.123456789 4. 4.9e-324\nv 1e-400 0.1e-309 -1000000000\n"
      "vn 0.1 1e-3 1\nf 1//1 2//1 3//1\n"));
  EXPECT_THAT(part.positions,
              ElementsAre(0.1, 1000, -0.0005, 123456789.12345679, 4, 5e-324, 0, 1e-310, -1e9));
  EXPECT_THAT(std::vector(part.normals.begin(), part.normals.begin() + 3),
              ElementsAre(0.1F, 0.001F, 1.0F));
}
// As the C library reads them, of up to 20 digits on both sides of those that are read at once.
TEST(Obj, NumbersOfAnyLengthAreTheNearestDoubles) {
  Random random(22);
  std::string text;
  std::vector<double> expected;
  for (int i = 0; i < 3 * 500; ++i) {
    std::string word = random.below(2) == 0 ? "" : "-";
    const int digits = random.whole(1, 20), point = random.whole(std::max(0, digits - 9), digits);
    for (int k = 0; k < digits; ++k) {
      if (k == digits - point) word += '.';
      word += static_cast<char>('0' + random.below(10));
    }
    text += (i % 3 == 0 ? "v " : " ") + word + (i % 3 == 2 ? "\n" : "");
    expected.push_back(std::strtod(word.c_str(), nullptr));
  }
  for (int i = 1; i <= 500; ++i) text += "p " + std::to_string(i) + '\n';
  EXPECT_EQ(only_part(obj_model(text)).positions, expected);
}

TEST(Obj, ColorsAreDecoded) {
  // ((0.5 + 0.055) / 1.055)^2.4 and 0.04 / 12.92, by IEC 61966-2-1.
  const Model model = obj_model("v 0 0 0 0 0.5 1\nv 1 0 0 0.04 0 0\nv 0 1 0 -1 2 0.5\nf 1 2 3\n");
  const ModelPart& part = only_part(model);
  const std::array expected{0.0F, 0.214041140F, 1.0F, 1.0F, 0.00309597523F, 0.0F,
                            0.0F, 1.0F,         0.0F, 1.0F, 0.214041140F,   1.0F};
  ASSERT_EQ(part.colors.size(), expected.size());
  for (std::size_t i = 0; i < expected.size(); ++i)
    EXPECT_NEAR(part.colors[i], expected[i], 1e-8) << i;
  ASSERT_EQ(model.warnings.size(), 1U);
  EXPECT_EQ(model.warnings[0].line, 3U);
}
TEST(Obj, ColorsThatSomeLackAreLeftOut) {
  const Model model =
      obj_model("v 0 0 0\nv 1 0 0 1 1 1\nv 0 1 0 1 1 1\nv 1 1 0 1 1 1\nv 2 0 0 1\n" +
                std::string("o a\nf 1 2 3\no b\nf 2 3 4\no c\nf 3 4 5\n"));
  EXPECT_THAT(model.meshes.at(0).parts.at(0).colors, IsEmpty());
  EXPECT_EQ(model.meshes.at(1).parts.at(0).colors, std::vector<float>(12, 1));
  EXPECT_THAT(model.meshes.at(2).parts.at(0).colors, IsEmpty());
}

// ---- lines --------------------------------------------------------------------------------------

TEST(Obj, LinesEndAndGoOnAsTheyMay) {
  const Model plain = obj_model(obj_square + "o a b\nf 1 2 4 3\n");
  EXPECT_EQ(plain.meshes.at(0).name, "a b");
  for (const char* text :
       {"v 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nv 1 1 0\r\no a b\r\nf 1 2 4 3",
        "\xEF\xBB\xBFv 0 0 0\n  v\t1\t0\t0  \n# f 1 1 1\n\nv 0 1 \\\n0\nv 1\\\r\n1\\\r\n0\n"
        "o  a b \nf 1 2\\\n4 3 # a square\n#",
        "v 0 0 0 # here\nv 1 0 0 #\nv 0 1 0\nv 1 1 0\ns off\ns 1\no a b\nf 1 2 4 3\\"})
    EXPECT_EQ(obj_model(text), plain) << text;
}
TEST(Obj, NamesMayHaveHashes) {
  const Model model = obj_model(obj_three + "o Box #1\nf 1 2 3\n");
  EXPECT_EQ(model.meshes.at(0).name, "Box #1");
}

// ---- objects, groups, materials -----------------------------------------------------------------

std::vector<std::string> obj_names_of(const Model& model) {
  std::vector<std::string> names;
  for (std::size_t i = 0; i < model.nodes.size(); ++i) {
    EXPECT_EQ(model.nodes[i].mesh, static_cast<ModelIndex>(i));
    EXPECT_EQ(model.nodes[i].name, model.meshes.at(i).name);
    EXPECT_EQ(model.scenes.at(0).nodes.at(i), i);
    names.push_back(model.nodes[i].name);
  }
  return names;
}

TEST(Obj, ObjectsAreNodesInOrder) {
  EXPECT_THAT(obj_names_of(
                  obj_model(obj_three + "f 1 2 3\no b\nf 1 2 3\no empty\no a\nf 1 2 3\nf 1 2 3\n")),
              ElementsAre("", "b", "a"));
  EXPECT_THAT(obj_names_of(obj_model(obj_three + "o a\nf 1 2 3\no a\nf 1 2 3\n")),
              ElementsAre("a", "a"));
}
TEST(Obj, GroupsAreNodesWhereNoObjectsAre) {
  EXPECT_THAT(
      obj_names_of(obj_model(obj_three + "g  a   b\nf 1 2 3\ng\nf 1 2 3\ng c\ng d\nf 1 2 3\n")),
      ElementsAre("a b", "", "d"));
  EXPECT_THAT(obj_names_of(obj_model(obj_three + "g a\nf 1 2 3\no b\nf 1 2 3\ng c\nf 1 2 3\n")),
              ElementsAre("a", "b"));
  EXPECT_THAT(obj_names_of(obj_model(obj_three + "g a\nf 1 2 3\ng a\nf 1 2 3\n")),
              ElementsAre("a"));
}
TEST(Obj, PartsWearMaterialsInTheOrderInWhichTheyCome) {
  const Model model =
      obj_model({{{"a.obj", "mtllib a.mtl\n" + obj_square +
                                "f 1 2 3\nusemtl red\nf 1 2 3\nusemtl blue\nf 2 4 3\n"
                                "usemtl red\nf 2 4 3\no b\nf 1 2 3\n"},
                  {"a.mtl", "newmtl blue\nnewmtl red\nnewmtl blue\n"}}});
  ASSERT_EQ(model.meshes.size(), 2U);
  const auto& parts = model.meshes[0].parts;
  ASSERT_EQ(parts.size(), 3U);
  EXPECT_EQ(parts[0].material, std::nullopt);
  EXPECT_EQ(parts[1].material, 1U);
  EXPECT_THAT(parts[1].indices, ElementsAre(0, 1, 2, 1, 3, 2));
  EXPECT_EQ(parts[2].material, 0U);
  EXPECT_THAT(parts[2].positions, ElementsAre(1, 0, 0, 1, 1, 0, 0, 1, 0));
  ASSERT_EQ(model.meshes[1].parts.size(), 1U);
  EXPECT_EQ(model.meshes[1].parts[0].material, 1U);
  EXPECT_THAT(model.warnings, IsEmpty());
}
TEST(Obj, UnknownMaterialsAreTold) {
  const Model model =
      obj_model(obj_three + "usemtl no such one\nf 1 2 3\nusemtl x\nusemtl no such one\n");
  EXPECT_EQ(only_part(model).material, std::nullopt);
  ASSERT_EQ(model.warnings.size(), 2U);
  EXPECT_EQ(model.warnings[0], (ModelWarning{"", 4, "no material no such one"}));
  EXPECT_EQ(model.warnings[1], (ModelWarning{"", 6, "no material x"}));
}
TEST(Obj, ALibraryIsFoundBesideTheFile) {
  const std::string text = obj_three + "usemtl m\nf 1 2 3\n";
  for (const auto& [named, path] :
       std::vector<std::pair<std::string, std::string>>{{"a.mtl", "d/a.mtl"},
                                                        {"my own.mtl", "d/my own.mtl"},
                                                        {"./sub/../a.mtl # 1", "d/a.mtl # 1"},
                                                        {"sub\\a.mtl", "d/sub/a.mtl"},
                                                        {"../a.mtl", "a.mtl"}}) {
    const Model model =
        obj_model({{{"d/a.obj", "mtllib " + named + "\n" + text}, {path, "newmtl m\n"}}});
    EXPECT_EQ(only_part(model).material, 0U) << named;
    EXPECT_THAT(model.warnings, IsEmpty());
  }
}
TEST(Obj, SeveralLibrariesAreReadOnceEach) {
  const Model model = obj_model({{{"a.obj", "mtllib a.mtl b.mtl\nmtllib ./a.mtl\n" + obj_three +
                                                "usemtl b\nf 1 2 3\nmtllib a.mtl b.mtl\n"},
                                  {"a.mtl", "newmtl a\n"},
                                  {"b.mtl", "newmtl b\n"}}});
  ASSERT_EQ(model.materials.size(), 2U);
  EXPECT_EQ(only_part(model).material, 1U);
}
TEST(Obj, AMissingLibraryIsAFaultInABundleAndAWarningAlone) {
  const std::string text = "mtllib my own~.mtl\n" + obj_three + "usemtl m\nf 1 2 3\n";
  const Model alone = obj_model(text);
  ASSERT_EQ(alone.warnings.size(), 1U);
  EXPECT_EQ(alone.warnings[0], (ModelWarning{"", 1, "my own~.mtl did not come"}));
  const ReadObj read = read_obj_files({{{"a.obj", text}, {"x/my own~.mtl", ""}}});
  ASSERT_EQ(read.faults.count(), 1U);
  const Fault& fault = read.faults.list()[0];
  EXPECT_EQ(fault.kind, FaultKind::missing);
  EXPECT_EQ(fault.pointer, "/my own~0.mtl");
  EXPECT_EQ(fault.got, Value("my own~.mtl"));
  EXPECT_EQ(fault.line, 1U);
  const ReadObj some = read_obj_files({{{"a.obj", "mtllib a.mtl b/c.mtl\n"}, {"a.mtl", ""}}});
  ASSERT_EQ(some.faults.count(), 1U);
  EXPECT_EQ(some.faults.list()[0].pointer, "/b~1c.mtl");
}

// ---- points, and what is not taken --------------------------------------------------------------

TEST(Obj, PointsAreTakenWhereNoFacesAre) {
  const Model model = obj_model("v 1 2 3\nv 4 5 6\nv 7 8 9\np 3 1\no b\np -2 2\n");
  ASSERT_EQ(model.meshes.size(), 2U);
  const ModelPart& part = model.meshes[0].parts.at(0);
  EXPECT_TRUE(part.points);
  EXPECT_THAT(part.positions, ElementsAre(7, 8, 9, 1, 2, 3));
  EXPECT_THAT(part.indices, IsEmpty());
  EXPECT_THAT(model.meshes[1].parts.at(0).positions, ElementsAre(4, 5, 6));
  const Model both = obj_model(obj_three + "o a\np 1\no b\nf 1 2 3\n");
  EXPECT_THAT(obj_names_of(both), ElementsAre("b"));
  ASSERT_EQ(both.warnings.size(), 1U);
  EXPECT_THAT(both.warnings[0].text, HasSubstr("points"));
}
TEST(Obj, WhatIsNotTakenIsToldOnceEachKind) {
  const Model model = obj_model(obj_three +
                                "l 1 2\nl 2 3\ncstype bezier\ncurv 0 1 1 2\nf 1 2 3\nend\n"
                                "vp 0.5\nl 1 2\nunheard of\n");
  std::vector<std::uint64_t> lines;
  for (const ModelWarning& warning : model.warnings) lines.push_back(warning.line);
  EXPECT_THAT(lines, ElementsAre(4, 6, 7, 9, 10, 12));
  EXPECT_THAT(model.warnings[0].text, HasSubstr("l: "));
  std::string many = obj_three;
  for (int i = 0; i < 1000; ++i) many += "x" + std::to_string(i) + "\n";
  EXPECT_EQ(obj_model(many).warnings.size(), 20U);
}
TEST(Obj, NothingIsAModelWithoutMeshes) {
  const Model model = obj_model("v 0 0 0\n");
  EXPECT_THAT(model.meshes, IsEmpty());
  EXPECT_THAT(model.nodes, IsEmpty());
  expect_sound(model);
}

}  // namespace
}  // namespace tia::test
