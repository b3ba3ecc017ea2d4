#include "core/film/pfm.h"

#include <gtest/gtest.h>

#include <cstring>

#include "tests/core/support.h"

namespace tia {
namespace {

TEST(Pfm, BytesOfATwoByTwoPictureAreTheFormats) {
  // Header "PF", size, scale -1 (little-endian); then the bottom row first, left to right.
  Image image(2, 2);
  for (std::size_t i = 0; i < 12; ++i) image.rgb[i] = static_cast<float>(i);
  const std::string pfm = encode_pfm(image);
  const std::string head = "PF\n2 2\n-1.0\n";
  ASSERT_EQ(pfm.size(), head.size() + 48);
  EXPECT_EQ(pfm.substr(0, head.size()), head);
  const float expected[] = {6, 7, 8, 9, 10, 11, 0, 1, 2, 3, 4, 5};
  for (std::size_t i = 0; i < 12; ++i) {
    std::uint32_t bits = 0;  // assembled byte by byte, the lowest first
    for (std::size_t byte = 0; byte < 4; ++byte)
      bits |=
          static_cast<std::uint32_t>(static_cast<unsigned char>(pfm[head.size() + 4 * i + byte]))
          << (8 * byte);
    EXPECT_EQ(std::bit_cast<float>(bits), expected[i]) << i;
  }
}

TEST(Pfm, KeepsEveryBitUnclamped) {
  Image image(4, 1);
  const float inf = std::numeric_limits<float>::infinity();
  const float nan = std::numeric_limits<float>::quiet_NaN();
  image.rgb = {-1, 2, 1e30F, -0.0F, 1e-40F, inf, nan, 0.1F, -inf, 1, 0, 255};
  const std::string pfm = encode_pfm(image), head = "PF\n4 1\n-1.0\n";
  ASSERT_EQ(pfm.size(), head.size() + 48);
  EXPECT_EQ(std::memcmp(pfm.data() + head.size(), image.rgb.data(), 48), 0);
}

TEST(Pfm, HeaderTellsWidthBeforeHeight) {
  EXPECT_EQ(encode_pfm(Image(333, 217)).substr(0, 16), "PF\n333 217\n-1.0\n");
  EXPECT_EQ(encode_pfm(Image(333, 217)).size(), 16U + 333 * 217 * 12);
}

}  // namespace
}  // namespace tia
