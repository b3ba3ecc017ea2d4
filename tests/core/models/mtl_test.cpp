// MTL files: what each statement makes of a material. Quick tier, some 10 ms.
#include "core/models/mtl.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <string>
#include <vector>

#include "core/models/mtl_maps.h"
#include "tests/core/models/obj_files.h"

namespace tia::test {
namespace {

using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

const std::string mtl_png = "\x89PNG\r\n\x1A\n", mtl_jpeg = "\xFF\xD8\xFF\xE0",
                  mtl_webp = "RIFF\4\1\1\1WEBPVP8 ";

/// ReadMtl: what came of reading the second of these files; the first is an OBJ file.
struct ReadMtl {
  Model model;
  Faults faults;
};
ReadMtl read_mtl_text(const std::string& text, bool alone = false) {
  const TextFiles texts{{{"d/a.obj", ""},
                         {"d/a.mtl", text},
                         {"d/a.png", mtl_png},
                         {"d/my picture.jpg", mtl_jpeg},
                         {"d/tex/c.webp", mtl_webp},
                         {"d/1 2.png", mtl_png},
                         {"d/b.tga", "none of these"}}};
  const ModelFiles files = texts.files();
  ReadMtl read;
  read_mtl(files.all[1], files, alone, read.faults, read.model);
  return read;
}
Model mtl_model(const std::string& text) {
  ReadMtl read = read_mtl_text(text);
  for (const Fault& fault : read.faults.list()) ADD_FAILURE() << describe(fault);
  return std::move(read.model);
}
// Of a text without warnings, behind newmtl.
ModelMaterial mtl_material(const std::string& text) {
  const Model model = mtl_model("newmtl m\n" + text);
  for (const ModelWarning& warning : model.warnings) ADD_FAILURE() << warning.text;
  EXPECT_EQ(model.materials.size(), 1U);
  return model.materials.at(0);
}

TEST(Mtl, NothingSaidIsTheDefault) {
  ModelMaterial expected;
  expected.name = "m";
  EXPECT_EQ(mtl_material(""), expected);
  EXPECT_TRUE(expected.double_sided);
}
TEST(Mtl, MaterialsComeInOrder) {
  const Model model = mtl_model(
      "# two\r\nnewmtl a b #1\r\nKd 1 0 0\r\n\r\nNEWMTL c\r\n\tkd 0 \\\r\n1 0 # green\r\n");
  ASSERT_EQ(model.materials.size(), 2U);
  EXPECT_EQ(model.materials[0].name, "a b #1");
  EXPECT_EQ(model.materials[0].base_color, (Color{1, 0, 0}));
  EXPECT_EQ(model.materials[1].name, "c");
  EXPECT_EQ(model.materials[1].base_color, (Color{0, 1, 0}));
}
TEST(Mtl, NumbersAreTaken) {
  const ModelMaterial material = mtl_material(
      "Kd 0.25\nNi 1.33\nPr 0.125\nNs 1000\nPm 0.75\nPs 0.5\nPc 0.875\nPcr 0.0625\nKa 1 1 1\n"
      "Ks 9 9 9\nTf 0 0 0\n");
  ModelMaterial expected;
  expected.name = "m";
  expected.base_color = {0.25, 0.25, 0.25};
  expected.ior = 1.33;
  expected.roughness = 0.125;
  expected.metallic = 0.75;
  expected.sheen_color = {0.5, 0.5, 0.5};
  expected.clearcoat = 0.875;
  expected.clearcoat_roughness = 0.0625;
  EXPECT_EQ(material, expected);
}
TEST(Mtl, ExponentsAreRoughnesses) {
  // alpha = sqrt(2 / (Ns + 2)), roughness = sqrt(alpha).
  EXPECT_EQ(mtl_material("Ns 0").roughness, 1);
  EXPECT_EQ(mtl_material("Ns 30").roughness, 0.5);
  EXPECT_NEAR(mtl_material("Ns 225").roughness, std::pow(2 / 227.0, 0.25), 1e-15);
}
TEST(Mtl, WhatShinesMoreThanOneHasAStrength) {
  const ModelMaterial strong = mtl_material("Ke 8 4 2");
  EXPECT_EQ(strong.emissive, (Color{1, 0.5, 0.25}));
  EXPECT_EQ(strong.emissive_strength, 8);
  const ModelMaterial weak = mtl_material("Ke 0.5 0.25 0");
  EXPECT_EQ(weak.emissive, (Color{0.5, 0.25, 0}));
  EXPECT_EQ(weak.emissive_strength, 1);
}
TEST(Mtl, DissolveIsAlphaOrTransmission) {
  for (const char* illum : {"", "illum 0\n", "illum 2\n", "illum 5\n", "illum 10\n"}) {
    const ModelMaterial material = mtl_material(std::string(illum) + "d 0.25");
    EXPECT_EQ(material.alpha, 0.25) << illum;
    EXPECT_EQ(material.transmission, 0);
    EXPECT_EQ(material.alpha_mode, AlphaMode::blend);
  }
  for (const char* illum : {"illum 4\n", "illum 6\n", "illum 7\n", "illum 9\n"}) {
    const ModelMaterial material = mtl_material("Tr 0.75\n" + std::string(illum));
    EXPECT_EQ(material.alpha, 1) << illum;
    EXPECT_EQ(material.transmission, 0.75);
    EXPECT_EQ(material.alpha_mode, AlphaMode::opaque);
  }
  EXPECT_EQ(mtl_material("d 1\nTr 1\nillum 2").alpha, 1);  // d is what counts
  EXPECT_EQ(mtl_material("d 1").alpha_mode, AlphaMode::opaque);
  EXPECT_EQ(mtl_material("Tr 0.25").alpha, 0.75);
}
TEST(Mtl, WhatLiesOutsideIsTheNearestAndTold) {
  const Model model = mtl_model(
      "newmtl m\nKd 2 -1 0.5\nPr 1.5\nNs -1\nKe -1 0 0\nd 7\nPm -0.5\nNi 0\nNi 11\nKd spectral "
      "a.rfl\n");
  const ModelMaterial& material = model.materials.at(0);
  EXPECT_EQ(material.base_color, (Color{1, 0, 0.5}));
  EXPECT_EQ(material.roughness, 1);
  EXPECT_EQ(material.emissive, Color{});
  EXPECT_EQ(material.alpha, 1);
  EXPECT_EQ(material.metallic, 0);
  EXPECT_EQ(material.ior, 1.5);
  std::vector<std::uint64_t> lines;
  for (const ModelWarning& warning : model.warnings) {
    lines.push_back(warning.line);
    EXPECT_EQ(warning.pointer, "/d~1a.mtl");
  }
  EXPECT_THAT(lines, ElementsAre(2, 2, 3, 4, 5, 6, 7, 8, 9, 10));
}

// ---- pictures -----------------------------------------------------------------------------------

TEST(Mtl, PicturesAreTexturesOfTheirKinds) {
  const Model model = mtl_model(
      "newmtl m\nmap_Kd a.png\nmap_Ke my picture.jpg\nmap_d tex\\c.webp\nmap_Pr "
      "../d/a.png\n"
      "map_Pm 1 2.png\nnorm -bm 0.5 a.png\nmap_Ka a.png\n");
  ASSERT_EQ(model.images.size(), 4U);
  EXPECT_EQ(model.images[0], (ModelImage{"d/a.png", {mtl_png.begin(), mtl_png.end()}}));
  EXPECT_EQ(model.images[1].name, "d/my picture.jpg");
  EXPECT_EQ(model.images[2].name, "d/tex/c.webp");
  EXPECT_EQ(model.images[3].name, "d/1 2.png");
  ASSERT_EQ(model.textures.size(), 4U);
  const ModelMaterial& material = model.materials.at(0);
  EXPECT_EQ(material.base_color_texture.value(), TextureUse{});
  EXPECT_EQ(material.emissive_texture.value().texture, 1U);
  EXPECT_EQ(material.alpha_texture.value().texture, 2U);
  EXPECT_EQ(material.roughness_texture.value().texture, 0U);
  EXPECT_EQ(material.metallic_texture.value().texture, 3U);
  EXPECT_EQ(material.normal_texture.value().texture, 0U);
  EXPECT_EQ(material.normal_texture.value().strength, 0.5);
  EXPECT_EQ(material.alpha_mode, AlphaMode::blend);
  EXPECT_THAT(model.warnings, IsEmpty());
}
TEST(Mtl, APictureAloneHasTheFactorOne) {
  const ModelMaterial alone =
      mtl_material("map_Kd a.png\nmap_Ke a.png\nmap_Pr a.png\nmap_Pm a.png\nNs 30\n");
  EXPECT_EQ(alone.base_color, (Color{1, 1, 1}));
  EXPECT_EQ(alone.emissive, (Color{1, 1, 1}));
  EXPECT_EQ(alone.roughness, 1);
  EXPECT_EQ(alone.metallic, 1);
  const ModelMaterial both = mtl_material(
      "map_Kd a.png\nmap_Ke a.png\nmap_Pr a.png\nmap_Pm a.png\nKd 0.5 0.25 0\nKe 0 "
      "0 0\nPr 0.5\nPm "
      "0.25\n");
  EXPECT_EQ(both.base_color, (Color{0.5, 0.25, 0}));
  EXPECT_EQ(both.emissive, (Color{0, 0, 0}));
  EXPECT_EQ(both.roughness, 0.5);
  EXPECT_EQ(both.metallic, 0.25);
}
// v upward is 2 v' - 0.25 in the file, so that 1 - v' = 2 (1 - v) - 0.25, or v' = 2 v - 0.75.
TEST(Mtl, ScaleAndOffsetAreOfVDownward) {
  const TextureUse use =
      mtl_material("map_Kd -s 3 2 1 -o 0.5 -0.25 a.png").base_color_texture.value();
  EXPECT_THAT(use.scale, ElementsAre(3, 2));
  EXPECT_THAT(use.offset, ElementsAre(0.5, -0.75));
  const TextureUse short_one = mtl_material("map_Kd -o 1 -s 2 a.png").base_color_texture.value();
  EXPECT_THAT(short_one.scale, ElementsAre(2, 1));
  EXPECT_THAT(short_one.offset, ElementsAre(1, 0));
  const TextureUse number = mtl_material("map_Kd -s 1 1 1 1 2.png").base_color_texture.value();
  EXPECT_EQ(number, TextureUse{});
}
TEST(Mtl, ATextureIsAPictureAndItsWrap) {
  const Model model = mtl_model(
      "newmtl m\nmap_Kd -clamp on a.png\nmap_Ke a.png\nnewmtl n\nmap_Kd ./a.png\n"
      "map_Ke -clamp off -blendu on -clamp on a.png\n");
  ASSERT_EQ(model.textures.size(), 2U);
  EXPECT_EQ(model.textures[0], (ModelTexture{0, Wrap::clamp_to_edge, Wrap::clamp_to_edge, false}));
  EXPECT_EQ(model.textures[1], (ModelTexture{0, Wrap::repeat, Wrap::repeat, false}));
  EXPECT_EQ(model.materials[1].base_color_texture.value().texture, 1U);
  EXPECT_EQ(model.materials[1].emissive_texture.value().texture, 0U);
  EXPECT_EQ(model.images.size(), 1U);
}
TEST(Mtl, TwoFilesShareTheirPictures) {
  const Model model = obj_model({{{"a.obj", "mtllib a.mtl b.mtl\n"},
                                  {"a.mtl", "newmtl a\nmap_Kd a.png\n"},
                                  {"b.mtl", "newmtl b\nmap_Kd a.png\nmap_Ke -clamp on a.png\n"},
                                  {"a.png", mtl_png}}});
  EXPECT_EQ(model.images.size(), 1U);
  EXPECT_EQ(model.textures.size(), 2U);
  EXPECT_EQ(model.materials.at(1).base_color_texture.value().texture, 0U);
}

// ---- what is not taken, and what is wrong -------------------------------------------------------

TEST(Mtl, WhatIsNotTakenIsToldOnceEachKind) {
  const Model model = mtl_model(
      "Kd 1 1 1\nKd 1 1 1\nnewmtl m\nbump a.png\nmap_Bump a.png\nbump a.png\naniso "
      "0.5\n"
      "map_Kd -mm 0 1 -t 1 1 1 -imfchan r a.png\nmap_Kd -mm 0 1 a.png\nmap_Kd "
      "b.tga\nmap_Kd b.tga\n"
      "d -halo 0.5\n");
  std::vector<std::uint64_t> lines;
  for (const ModelWarning& warning : model.warnings) lines.push_back(warning.line);
  EXPECT_THAT(lines, ElementsAre(1, 4, 5, 7, 8, 8, 8, 10, 12));
  EXPECT_THAT(model.warnings[7].text, HasSubstr("no PNG, JPEG or WebP"));
  EXPECT_EQ(model.images.size(), 1U);
  EXPECT_EQ(model.materials.at(0).alpha, 0.5);
  EXPECT_EQ(model.materials.at(0).base_color_texture.value(), TextureUse{});
}
TEST(Mtl, AMissingPictureIsAFaultInABundleAndAWarningAlone) {
  const ReadMtl bundle = read_mtl_text("newmtl m\nmap_Kd x/no such.png\nmap_Ke x/no such.png\n");
  ASSERT_EQ(bundle.faults.count(), 1U);
  const Fault& fault = bundle.faults.list()[0];
  EXPECT_EQ(fault.kind, FaultKind::missing);
  EXPECT_EQ(fault.pointer, "/x~1no such.png");
  EXPECT_EQ(fault.got, Value("x/no such.png"));
  EXPECT_EQ(fault.line, 2U);
  const ReadMtl alone = read_mtl_text("newmtl m\nmap_Kd no such.png\n", true);
  EXPECT_TRUE(alone.faults.empty());
  ASSERT_EQ(alone.model.warnings.size(), 1U);
  EXPECT_EQ(alone.model.warnings[0], (ModelWarning{"/d~1a.mtl", 2, "no such.png did not come"}));
  EXPECT_EQ(alone.model.materials.at(0).base_color_texture, std::nullopt);
}
TEST(Mtl, FaultsComeWithTheirFileAndLine) {
  struct Wrong {
    const char* text;
    FaultKind kind;
    const char* allowed;
  };
  constexpr FaultKind malformed = FaultKind::malformed, out_of_range = FaultKind::out_of_range;
  for (const Wrong& wrong : std::vector<Wrong>{{"Kd", malformed, "numbers"},
                                               {"Kd 1 1", malformed, "one number or three"},
                                               {"Kd 1 1 1 1", malformed, "one number or three"},
                                               {"Kd 1 x 1", malformed, "numbers"},
                                               {"Kd 1 1 nan", out_of_range, "finite"},
                                               {"Ns", malformed, "numbers"},
                                               {"Ns 1 2", malformed, "one number"},
                                               {"d inf", out_of_range, "finite"},
                                               {"Ni 1e999", out_of_range, "finite"},
                                               {"illum x", malformed, "numbers"},
                                               {"map_Kd", malformed, "name of a picture"},
                                               {"map_Kd -s 1 1", malformed, "name of a picture"},
                                               {"map_Kd -s a.png", malformed, "-s and numbers"},
                                               {"map_Kd -o 2e9 a.png", out_of_range, "1e9"},
                                               {"norm -bm nan a.png", out_of_range, "-bm and"},
                                               {"map_Kd -clamp a.png", malformed, "on or off"}}) {
    const ReadMtl read = read_mtl_text("newmtl m\n\n" + std::string(wrong.text) + "\nKd 1 1 1\n");
    ASSERT_EQ(read.faults.count(), 1U) << wrong.text;
    const Fault& fault = read.faults.list()[0];
    EXPECT_EQ(fault.kind, wrong.kind) << wrong.text;
    EXPECT_EQ(fault.pointer, "/d~1a.mtl");
    EXPECT_EQ(fault.line, 3U);
    EXPECT_EQ(fault.got, Value(wrong.text));
    EXPECT_THAT(fault.allowed, HasSubstr(wrong.allowed)) << wrong.text;
  }
}
TEST(Mtl, MaterialsAndNamesHaveLimits) {
  std::string text;
  for (std::size_t i = 0; i <= most_mtl_materials; ++i) text += "newmtl\n";
  const ReadMtl materials = read_mtl_text(text);
  ASSERT_EQ(materials.faults.count(), 1U);
  EXPECT_EQ(materials.faults.list()[0].kind, FaultKind::limit);
  EXPECT_EQ(materials.faults.list()[0].line, most_mtl_materials + 1);
  EXPECT_EQ(materials.model.materials.size(), most_mtl_materials);
  text = "newmtl m\n";
  for (std::size_t i = 0; i <= most_mtl_names; ++i)
    text += "map_Kd " + std::to_string(i) + "/../a.png\n";
  const ReadMtl names = read_mtl_text(text);
  ASSERT_EQ(names.faults.count(), 1U);
  EXPECT_EQ(names.faults.list()[0].line, most_mtl_names + 2);
  EXPECT_EQ(names.model.images.size(), 1U);
}

}  // namespace
}  // namespace tia::test
