// What came as a model, by its id, packed and unpacked.
#include "server/stores/model_upload.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "server/stores/digest.h"
#include "tests/server/model_support.h"

namespace tia::test {
namespace {

using server::sha256_hex;
using server::unpacked_upload;

std::string packed_text(const server::ModelUpload& upload) { return joined_text(upload.packed()); }

TEST(ModelUpload, OfOneFileIsCalledBySha256OfItAndKeptAsItIs) {
  const std::string text = stl_text();
  const server::ModelUpload upload = upload_of_texts({{"part.stl", text}});
  EXPECT_EQ(upload.id, sha256_hex(text));
  const NamedTexts texts{{"part.stl", text}};
  EXPECT_EQ(packed_text(upload_of_texts(texts)), text);
  EXPECT_EQ(upload.bytes(), text.size());
}

// The text of RFC 8785, written out.
TEST(ModelUpload, OfSeveralIsCalledBySha256OfTheirNamesAndHashes) {
  const NamedTexts texts = obj_and_mtl();
  const std::string said = R"({"files":{"chair.obj":")" + sha256_hex(texts[0].second) +
                           R"(","mtl/wood.mtl":")" + sha256_hex(texts[1].second) +
                           R"("},"main":"chair.obj"})";
  EXPECT_EQ(upload_of_texts(texts).id, sha256_hex(said));
}

TEST(ModelUpload, IsTheSameInWhateverOrderTheFilesCame) {
  NamedTexts texts = obj_and_mtl();
  texts.emplace_back("a.png", "a picture");
  const std::string packed = packed_text(upload_of_texts(texts));
  std::reverse(texts.begin() + 1, texts.end());
  EXPECT_EQ(packed_text(upload_of_texts(texts)), packed);
}

TEST(ModelUpload, IsUnpackedAsItWasPacked) {
  NamedTexts texts = obj_and_mtl();
  texts.emplace_back("empty.bin", "");
  const server::ModelUpload upload = upload_of_texts(texts);
  const std::string packed = packed_text(upload);
  const auto again = unpacked_upload(upload.id, packed);
  ASSERT_TRUE(again);
  EXPECT_EQ(again->id, upload.id);
  EXPECT_EQ(packed_text(*again), packed);
  EXPECT_EQ(again->files.main_file().path, "chair.obj");
  ASSERT_EQ(again->files.all.size(), 3U);
  for (const auto& [path, text] : texts) {
    const auto file = std::ranges::find(again->files.all, path, &ModelFile::path);
    ASSERT_NE(file, again->files.all.end());
    EXPECT_TRUE(std::ranges::equal(file->bytes, file_of("", text).bytes)) << path;
  }
}

TEST(ModelUpload, ThatIsDamagedAnywhereIsNotUnpacked) {
  for (const NamedTexts& texts : {NamedTexts{{"part.stl", stl_text()}}, obj_and_mtl()}) {
    const server::ModelUpload upload = upload_of_texts(texts);
    const std::string packed = packed_text(upload);
    ASSERT_TRUE(unpacked_upload(upload.id, packed));
    for (std::size_t i = 0; i < packed.size(); ++i) {
      std::string damaged = packed;
      damaged[i] = static_cast<char>(damaged[i] ^ 1);
      EXPECT_FALSE(unpacked_upload(upload.id, damaged)) << i;
      EXPECT_FALSE(unpacked_upload(upload.id, packed.substr(0, i))) << i;
    }
    EXPECT_FALSE(unpacked_upload(upload.id, packed + "x"));
    EXPECT_FALSE(unpacked_upload(upload.id, ""));
  }
}

// The first line is what the id says, but nothing that upload_of() writes.
TEST(ModelUpload, OfAnotherFormIsNotUnpacked) {
  const std::string hash = sha256_hex("");
  for (const std::string& line :
       {std::string("{}"), std::string("[]"), std::string("{"), std::string(R"({"files":{}})"),
        std::string(R"({"files":1,"main":"a"})"), std::string(R"({"files":{},"main":1})")})
    for (const char* sizes : {"[]", "{}", "[0]", "x"})
      EXPECT_FALSE(unpacked_upload(sha256_hex(line), line + '\n' + sizes + "\nrest")) << line;
  const std::string one = R"({"files":{"a":")" + hash + R"("},"main":"a"})";
  const auto with = [&](const std::string& rest) {
    return unpacked_upload(sha256_hex(one), one + '\n' + rest);
  };
  EXPECT_TRUE(with("[0]\n"));
  for (const char* rest : {"[1]\n", "[-1]\n", "[\"0\"]\n", "[0,0]\n", "[0]", "[0]\nx", "{}\n"})
    EXPECT_FALSE(with(rest)) << rest;
}

TEST(ModelUpload, IdsAre64SmallHexadecimalDigits) {
  EXPECT_TRUE(server::is_model_id(sha256_hex("")));
  for (const std::string& text :
       {std::string(), std::string(63, 'a'), std::string(65, 'a'), std::string(64, 'A'),
        std::string(64, 'g'), "../" + std::string(61, 'a'), std::string(64, '.')})
    EXPECT_FALSE(server::is_model_id(text)) << text;
}

}  // namespace
}  // namespace tia::test
