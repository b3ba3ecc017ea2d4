#include "core/input/base64.h"

#include <gtest/gtest.h>

#include "tests/core/support.h"

namespace tia {
namespace {

// The encoder by its definition: 3 bytes are 4 digits of 6 bits, the first byte's bits first.
std::string encoded(const std::vector<std::uint8_t>& bytes) {
  const std::string digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const auto byte = [&](std::size_t j) { return j < bytes.size() ? bytes[j] : 0U; };
    const unsigned group = byte(i) * 65536U + byte(i + 1) * 256U + byte(i + 2);
    for (unsigned j = 0; j < 4; ++j)
      text += i + j > bytes.size() ? '=' : digits[group >> (18 - 6 * j) & 63U];
  }
  return text;
}

std::string from_base64(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  EXPECT_FALSE(decode_base64(text, bytes).has_value()) << text;
  return {bytes.begin(), bytes.end()};
}
std::optional<std::size_t> wrong_at(std::string_view text) {
  std::vector<std::uint8_t> bytes;
  return decode_base64(text, bytes);
}

// The test vectors of RFC 4648, section 10.
TEST(Base64, ReadsTheRfcsExamples) {
  EXPECT_EQ(from_base64(""), "");
  EXPECT_EQ(from_base64("Zg=="), "f");
  EXPECT_EQ(from_base64("Zm8="), "fo");
  EXPECT_EQ(from_base64("Zm9v"), "foo");
  EXPECT_EQ(from_base64("Zm9vYg=="), "foob");
  EXPECT_EQ(from_base64("Zm9vYmE="), "fooba");
  EXPECT_EQ(from_base64("Zm9vYmFy"), "foobar");
}

TEST(Base64, ReadsBackRandomBytes) {
  test::Random random(1);
  for (int i = 0; i < 300; ++i) {
    std::vector<std::uint8_t> bytes(static_cast<std::size_t>(random.below(40)));
    for (auto& byte : bytes) byte = static_cast<std::uint8_t>(random.below(256));
    ASSERT_EQ(from_base64(encoded(bytes)), std::string(bytes.begin(), bytes.end()));
  }
}

TEST(Base64, OtherCharactersAreRefusedWhereTheyStand) {
  for (const char other : {'-', '_', ' ', '\n', '.', '\0', '\x80', '=', '@', '[', '`', '{', ':'}) {
    std::string text = "Zm9vYmFy";
    for (std::size_t i = 0; i < 6; ++i) {
      std::string spoilt = text;
      spoilt[i] = other;
      EXPECT_EQ(wrong_at(spoilt), i) << spoilt;
    }
  }
}

TEST(Base64, PaddingIsNeitherMissingNorTooMuch) {
  EXPECT_EQ(wrong_at("Zg"), 2U);
  EXPECT_EQ(wrong_at("Zg="), 3U);
  EXPECT_EQ(wrong_at("Zm8"), 3U);
  EXPECT_EQ(wrong_at("Zm8=="), 3U);
  EXPECT_EQ(wrong_at("Zm9v="), 4U);
  EXPECT_EQ(wrong_at("Zg==="), 2U);
  EXPECT_EQ(wrong_at("Z"), 1U);
  EXPECT_EQ(wrong_at("Z==="), 1U);
  EXPECT_EQ(wrong_at("===="), 0U);
}

TEST(Base64, UnusedBitsAreZero) {
  EXPECT_EQ(wrong_at("Zh=="), 1U);  // "Zg==" with one of four unused bits set
  EXPECT_EQ(wrong_at("Zm9="), 2U);  // "Zm8=" with one of two
}

}  // namespace
}  // namespace tia
