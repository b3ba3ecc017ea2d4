// images, samplers, textures and texture infos of glTF.
#include <gmock/gmock.h>

#include "core/models/gltf/gltf_parts.h"
#include "tests/core/models/gltf_part.h"
#include "tests/core/models/webp_files.h"

namespace tia {
namespace {

using test::Bytes;
using test::PartRead;
using testing::ElementsAre;
using testing::IsEmpty;

const Bytes png_file = test::png({1, 1, 8, test::grey}, "\xFF");
const Bytes jpeg_file = test::flat_jpeg({100});
const Bytes webp_file = test::lossless_webp(1, 1, {1, 2, 3, 4, 5}, "0");
const std::vector<test::NamedFile> beside{{"a.png", png_file},
                                          {"pictures/b.jpg", jpeg_file},
                                          {"c.webp", webp_file},
                                          {"d.ktx2", test::to_bytes("\xABKTX 20\xBB\r\n\x1A\n")}};

PartRead textures_of(const std::string& json, const std::vector<test::NamedFile>& files = beside) {
  return test::read_part(gltf::read_materials, json, files);
}
PartRead material_with(const std::string& info) {
  return textures_of(R"({"textures": [{"source": 0}, {}, {"source": 0}],
      "images": [{"uri": "a.png"}], "materials": [{"emissiveTexture": )" +
                     info + "}]}");
}

// ---- texture infos ------------------------------------------------------------------------------

TEST(GltfTextures, ATextureIsLookedUpAsItsTransformSays) {
  const PartRead read = material_with(R"({"index": 2, "texCoord": 0, "extensions": {
      "KHR_texture_transform": {"offset": [0, -1], "rotation": 1.5, "scale": [0.5, -2],
                                "texCoord": 1}}})");
  EXPECT_THAT(read.fault_lines(), IsEmpty());
  ASSERT_EQ(read.model.textures.size(), 2U);
  const TextureUse expected{1, 1, {0, -1}, {0.5, -2}, 1.5, 1};
  EXPECT_EQ(read.model.materials.at(0).emissive_texture, expected);
}

TEST(GltfTextures, OtherUvSetsThanTwoAreTheFirstWithAWarning) {
  const PartRead read = material_with(R"({"index": 0, "texCoord": 2})");
  EXPECT_EQ(read.model.materials.at(0).emissive_texture->uv_set, 0U);
  EXPECT_THAT(read.model.warnings.at(1).pointer, "/materials/0/emissiveTexture");
  EXPECT_THAT(read.model.warnings.at(1).text, testing::HasSubstr("TEXCOORD_2"));
  const PartRead overridden = material_with(R"({"index": 0, "texCoord": 4, "extensions": {
      "KHR_texture_transform": {"texCoord": 1}}})");
  EXPECT_EQ(overridden.model.materials.at(0).emissive_texture->uv_set, 1U);
  EXPECT_EQ(overridden.model.warnings.size(), 1U);
}

TEST(GltfTextures, WrongTextureInfosAreFaults) {
  EXPECT_THAT(material_with("{}").fault_lines(),
              ElementsAre("missing /materials/0/emissiveTexture/index"));
  EXPECT_THAT(material_with("3").fault_lines(),
              ElementsAre("wrong_type /materials/0/emissiveTexture"));
  for (const char* index : {"3", "-1", "0.5", "4294967296", "1e300"})
    EXPECT_THAT(material_with(R"({"index": )" + std::string(index) + "}").fault_lines(),
                ElementsAre("out_of_range /materials/0/emissiveTexture/index"));
  EXPECT_THAT(material_with(R"({"index": 0, "texCoord": -1, "extensions": {
      "KHR_texture_transform": {"offset": [0], "rotation": "0", "scale": [1e300, 1]}}})")
                  .fault_lines(),
              ElementsAre("out_of_range /materials/0/emissiveTexture/texCoord",
                          "wrong_type /materials/0/emissiveTexture/extensions/"
                          "KHR_texture_transform/offset",
                          "out_of_range /materials/0/emissiveTexture/extensions/"
                          "KHR_texture_transform/scale/0",
                          "wrong_type /materials/0/emissiveTexture/extensions/"
                          "KHR_texture_transform/rotation"));
}

// ---- textures and samplers ----------------------------------------------------------------------

TEST(GltfTextures, SamplersSayHowTheyRepeat) {
  const PartRead read = textures_of(R"({"images": [{"uri": "a.png"}],
      "samplers": [{"wrapS": 33071, "wrapT": 33648, "magFilter": 9728},
                   {"wrapS": 10497, "wrapT": 33071, "magFilter": 9729, "minFilter": 9987}, {}],
      "textures": [{"source": 0, "sampler": 1}, {"source": 0, "sampler": 0}, {"source": 0},
                   {"source": 0, "sampler": 2}]})");
  EXPECT_THAT(read.fault_lines(), IsEmpty());
  EXPECT_THAT(read.model.textures,
              ElementsAre(ModelTexture{0, Wrap::repeat, Wrap::clamp_to_edge, false},
                          ModelTexture{0, Wrap::clamp_to_edge, Wrap::mirrored_repeat, true},
                          ModelTexture{}, ModelTexture{}));
}

TEST(GltfTextures, WrongSamplersAreFaults) {
  EXPECT_THAT(textures_of(R"({"samplers": [{"wrapS": 10496}, {"wrapT": "10497"},
      {"magFilter": 9987}, {"wrapS": 1e9}], "textures": [{"sampler": 4, "source": 0}],
      "images": [{"uri": "a.png"}]})")
                  .fault_lines(),
              ElementsAre("out_of_range /samplers/0/wrapS", "wrong_type /samplers/1/wrapT",
                          "out_of_range /samplers/2/magFilter", "out_of_range /samplers/3/wrapS",
                          "out_of_range /textures/0/sampler"));
}

TEST(GltfTextures, WithoutAnImageTheFactorStays) {
  const PartRead read = textures_of(R"({"images": [{"uri": "a.png"}, {"uri": "d.ktx2"}],
      "textures": [{}, {"extensions": {"KHR_texture_basisu": {"source": 1}}}, {"source": 0}],
      "materials": [{"emissiveTexture": {"index": 0}, "normalTexture": {"index": 1},
                     "occlusionTexture": {"index": 2}, "emissiveFactor": [1, 0, 0]}]})");
  EXPECT_THAT(read.fault_lines(), IsEmpty());
  const ModelMaterial& material = read.model.materials.at(0);
  EXPECT_EQ(material.emissive_texture, std::nullopt);
  EXPECT_EQ(material.emissive, (Color{1, 0, 0}));
  EXPECT_EQ(material.normal_texture, std::nullopt);
  ASSERT_TRUE(material.occlusion_texture.has_value());
  EXPECT_EQ(material.occlusion_texture->texture, 0U);
  EXPECT_EQ(read.model.textures.size(), 1U);
  EXPECT_THAT(read.warning_lines(),
              ElementsAre("/textures/0: a texture without an image is left out; the factors that "
                          "it belongs to stay",
                          "/textures/1: a texture with no image but a KTX2 is left out; the "
                          "factors that it belongs to stay"));
}

TEST(GltfTextures, TheSourceComesBeforeAWebpAndThatBeforeNothing) {
  const PartRead read = textures_of(R"({"images": [{"uri": "a.png"}, {"uri": "c.webp"}],
      "textures": [{"source": 0, "extensions": {"EXT_texture_webp": {"source": 1}}},
                   {"extensions": {"EXT_texture_webp": {"source": 1},
                                   "KHR_texture_basisu": {"source": 0}}},
                   {"source": 0, "extensions": {"KHR_texture_basisu": {"source": 1}}}]})");
  EXPECT_THAT(read.fault_lines(), IsEmpty());
  EXPECT_THAT(read.warning_lines(), IsEmpty());
  ASSERT_EQ(read.model.textures.size(), 3U);
  EXPECT_EQ(read.model.textures[0].image, 0U);
  EXPECT_EQ(read.model.textures[1].image, 1U);
  EXPECT_EQ(read.model.textures[2].image, 0U);
}

// ---- images -------------------------------------------------------------------------------------

// A document whose buffer is data.bin, of that many bytes.
std::string with_buffer(std::size_t bytes, const std::string& members) {
  return R"({"asset": {"version": "2.0"}, "buffers": [{"uri": "data.bin", "byteLength": )" +
         std::to_string(bytes) + "}], " + members + "}";
}
std::string view_text(std::size_t offset, std::size_t length) {
  return R"({"buffer": 0, "byteOffset": )" + std::to_string(offset) + R"(, "byteLength": )" +
         std::to_string(length) + "}";
}

TEST(GltfImages, FilesComeFromTextsFilesAndViews) {
  Bytes data = test::to_bytes("....");
  data.insert(data.end(), webp_file.begin(), webp_file.end());
  const PartRead read =
      textures_of(with_buffer(data.size(), R"("bufferViews": [)" + view_text(4, webp_file.size()) +
                                               R"(], "images": [{"name": "text", "uri": ")" +
                                               test::data_uri("image/png", png_file) + R"("},
      {"name": "file", "uri": "pictures/b.jpg"},
      {"name": "view", "bufferView": 0, "mimeType": "image/webp"}],
      "textures": [{"source": 0}, {"source": 1}, {"source": 2}])"),
                  {{"data.bin", data}, {"pictures/b.jpg", jpeg_file}});
  EXPECT_THAT(read.fault_lines(), IsEmpty());
  EXPECT_THAT(read.model.images,
              ElementsAre(ModelImage{"text", png_file}, ModelImage{"file", jpeg_file},
                          ModelImage{"view", webp_file}));
}

TEST(GltfImages, WhatNoTextureNamesIsNotLookedAt) {
  const PartRead read = textures_of(R"({"images": [{"uri": "nowhere.png"}, {"uri": "a.png"}, {}],
      "textures": [{"source": 1}]})");
  EXPECT_THAT(read.fault_lines(), IsEmpty());
  EXPECT_THAT(read.model.images, ElementsAre(ModelImage{}, ModelImage{"", png_file}, ModelImage{}));
  EXPECT_EQ(read.model.textures.at(0).image, 1U);
}

TEST(GltfImages, TheSameBytesAreHeldOnce) {
  const PartRead read = textures_of(R"({"images": [{"uri": "c.webp"}, {"uri": "a.png"},
      {"uri": "./a.png"}], "textures": [{"source": 2}, {"source": 1}, {"source": 0}]})");
  EXPECT_THAT(read.fault_lines(), IsEmpty());
  EXPECT_THAT(read.model.images.at(2).file, IsEmpty());
  EXPECT_EQ(read.model.textures.at(0).image, 1U);
  EXPECT_EQ(read.model.textures.at(1).image, 1U);
  EXPECT_EQ(read.model.textures.at(2).image, 0U);
}

TEST(GltfImages, WrongImagesAreFaults) {
  EXPECT_THAT(textures_of(R"({"images": [{}, {"uri": "a.png", "bufferView": 0}, {"uri": "no.png"},
      {"uri": "d.ktx2"}, {"uri": 5}, {"bufferView": 0}, {"uri": "data:image/png;base64,AA"}, 3],
      "textures": [{"source": 0}, {"source": 1}, {"source": 2}, {"source": 3}, {"source": 4},
      {"source": 5}, {"source": 6}, {"source": 7}, {"source": 8}]})")
                  .fault_lines(),
              ElementsAre("out_of_range /textures/8/source", "missing /images/0",
                          "conflict /images/1", "missing /images/2/uri", "wrong_type /images/3",
                          "wrong_type /images/4/uri", "out_of_range /images/5/bufferView",
                          "malformed /images/6/uri", "wrong_type /images/7"));
}

// A thousand views of nearly all of one file: copies of no more than came are made.
TEST(GltfImages, OverlappingViewsAreNotCopiedEndlessly) {
  std::string views, images, textures;
  Bytes data = png_file;
  data.resize(100'000);
  for (std::size_t i = 0; i < 1000; ++i) {
    const std::string comma = i == 0 ? "" : ",", number = std::to_string(i);
    views += comma + view_text(0, data.size() - i);
    images += comma + R"({"bufferView": )" + number + "}";
    textures += comma + R"({"source": )" + number + "}";
  }
  const PartRead read =
      textures_of(with_buffer(data.size(), R"("bufferViews": [)" + views + R"(], "images": [)" +
                                               images + R"(], "textures": [)" + textures + "]"),
                  {{"data.bin", data}});
  EXPECT_EQ(read.faults.list().size(), Faults::most);
  EXPECT_EQ(read.faults.list().at(0).kind, FaultKind::limit);
  std::size_t held = 0;
  for (const ModelImage& image : read.model.images) held += image.file.size();
  EXPECT_LT(held, 300'000U);
}

// Whatever members come, in place of a whole document's: no crash, and what is read is in order.
TEST(GltfImages, DamagedDocumentsLeaveNoIndexBeyondItsList) {
  const std::string whole = R"({"images": [{"uri": "a.png"}, {"uri": "c.webp"}],
      "samplers": [{"wrapS": 33071}], "textures": [{"source": 0, "sampler": 0}, {"source": 1}],
      "materials": [{"normalTexture": {"index": 1, "scale": 2},
                     "emissiveTexture": {"index": 0}}]})";
  test::Random random(345);
  int read_whole = 0;
  for (int i = 0; i < 3000; ++i) {
    std::string json = whole;
    for (int changes = random.below(3); changes >= 0; --changes) {
      const auto at = static_cast<std::size_t>(random.below(static_cast<int>(json.size())));
      json[at] = "0123[]{},:\"-e. "[random.below(15)];
    }
    try {
      const PartRead read = textures_of(json);
      if (!read.faults.empty()) continue;
      ++read_whole;
      for (const ModelTexture& texture : read.model.textures)
        ASSERT_LT(texture.image, read.model.images.size());
      for (const ModelMaterial& material : read.model.materials)
        for (const MaybeTexture& use : {material.normal_texture, material.emissive_texture})
          ASSERT_TRUE(!use || use->texture < read.model.textures.size());
    } catch (const InputError&) {  // no JSON
    }
  }
  EXPECT_GT(read_whole, 50);
}

}  // namespace
}  // namespace tia
