// Radiance pictures: what the writer and what others write comes back; broken ones end.
#include "core/film/decode_hdr.h"

#include <gtest/gtest.h>

#include "core/film/hdr.h"
#include "tests/core/film/files.h"
#include "tests/core/film/radiance_reader.h"

namespace tia {
namespace {

using namespace test;

constexpr PictureLimits limits{1 << 20, 1 << 16};

const std::string rgbe_head = "#?RADIANCE\n# made by hand\nFORMAT=32-bit_rle_rgbe\nEXPOSURE=2\n\n";

std::variant<RgbeImage, PictureFault> decoded(const std::string& file) {
  return decode_hdr(to_bytes(file), limits);
}

TEST(DecodeHdr, WhatIsWrittenComesBack) {
  Random random(930);
  for (const int width : {1, 7, 8, 200}) {
    Image image(width, 5);
    for (float& light : image.rgb)
      light = static_cast<float>(random.chance(0.5) ? 0.25 : std::pow(10.0, random.in(-6, 6)));
    const std::string file = encode_hdr(image);
    const RadiancePicture expected = read_radiance(file);
    const auto read = std::get<RgbeImage>(decoded(file));
    ASSERT_EQ(read.width, width);
    ASSERT_EQ(read.height, 5);
    for (std::size_t i = 0; i < read.pixels.size(); ++i)
      for (std::size_t k = 0; k < 4; ++k)
        ASSERT_EQ(int{read.pixels[i][k]}, expected.pixels[i][k]) << i;
  }
}

TEST(DecodeHdr, OldRunsRepeatThePixelBefore) {
  const std::string pixel = "\x10\x20\x30\x80", other = "\x11\x21\x31\x81";
  const std::string rows = pixel + std::string("\1\1\1\3", 4) + other + pixel;
  const auto read = std::get<RgbeImage>(decoded(rgbe_head + "-Y 1 +X 6\n" + rows));
  EXPECT_EQ(read.pixels[3], read.pixels[0]);
  EXPECT_EQ(int{read.pixels[4][0]}, 0x11);
  // A second count is 256 times as much.
  const std::string many = pixel + std::string("\1\1\1\2\1\1\1\1", 8);
  EXPECT_EQ(std::get<RgbeImage>(decoded(rgbe_head + "-Y 1 +X 259\n" + many)).pixels.back(),
            read.pixels[0]);
}

TEST(DecodeHdr, WhatIsCutOffIsRefusedWhereverItEnds) {
  Image image(9, 3);
  for (std::size_t i = 0; i < image.rgb.size(); ++i) image.rgb[i] = static_cast<float>(i);
  const std::string file = encode_hdr(image);
  for (std::size_t size = 0; size < file.size(); ++size) {
    const auto read = decoded(file.substr(0, size));
    ASSERT_TRUE(std::holds_alternative<PictureFault>(read)) << size;
    EXPECT_FALSE(std::get<PictureFault>(read).beyond_limits);
  }
  EXPECT_TRUE(std::holds_alternative<RgbeImage>(decoded(file)));
}

TEST(DecodeHdr, OtherKindsAreRefused) {
  for (const std::string& file :
       {std::string("#?RADIANCE\n\n-Y 1 +X 1\n\0\0\0\0", 27), rgbe_head + "+Y 1 +X 1\nabcd",
        rgbe_head + "-Y 0 +X 1\nabcd", rgbe_head + "-Y 1 +X 1 \nabcd",
        rgbe_head + "-Y 1 +X 99999999\nabcd", rgbe_head + "-Y 1 +X 8\n\2\2\1\1",
        std::string("#?RADIANT\n")})
    EXPECT_FALSE(std::get<PictureFault>(decoded(file)).beyond_limits);
  const auto large = decoded(rgbe_head + "-Y 300 +X 300\n");
  EXPECT_TRUE(std::get<PictureFault>(large).beyond_limits);
  EXPECT_EQ(std::get<PictureFault>(large).got, "300 x 300 pixels");
}

// Runs that end beyond their row, or are empty.
TEST(DecodeHdr, RunsStayInTheirRow) {
  const std::string row = rgbe_head + "-Y 1 +X 8\n" + std::string("\2\2\0\x08", 4);
  for (const std::string& run : {std::string("\x89"
                                             "a"),
                                 std::string("\0", 1),
                                 std::string("\x09"
                                             "aaaaaaaaa")})
    EXPECT_TRUE(std::holds_alternative<PictureFault>(decoded(row + run + std::string(64, 'b'))));
}

}  // namespace
}  // namespace tia
