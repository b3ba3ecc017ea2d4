// Texts that stand in a URL, packed by another library than the one that unpacks them.
#include "core/input/packed_text.h"

#include <gtest/gtest.h>
#include <zlib.h>

#include <vector>

#include "tests/core/support.h"

namespace tia::test {
namespace {

std::string base64url(const std::vector<unsigned char>& bytes, bool padded) {
  constexpr std::string_view digits =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_";
  std::string text;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    unsigned three = 0;
    for (std::size_t k = 0; k < 3; ++k)
      three = three << 8U | (i + k < bytes.size() ? bytes[i + k] : 0);
    const std::size_t there = std::min<std::size_t>(3, bytes.size() - i) + 1;
    for (unsigned k = 0; k < 4; ++k)
      if (k < there) text += digits[three >> (18 - 6 * k) & 63U];
      else if (padded) text += '=';
  }
  return text;
}
std::string packed(const std::string& text, bool padded = false, int level = 9) {
  std::vector<unsigned char> bytes(compressBound(text.size()));
  uLongf size = bytes.size();
  compress2(bytes.data(), &size, reinterpret_cast<const Bytef*>(text.data()), text.size(), level);
  bytes.resize(size);
  return base64url(bytes, padded);
}
std::string text_or(const std::variant<std::string, PackedFault>& unpacked) {
  const auto* text = std::get_if<std::string>(&unpacked);
  return text != nullptr ? *text : "fault: " + std::get<PackedFault>(unpacked).got;
}
bool is_beyond(const std::variant<std::string, PackedFault>& unpacked) {
  const auto* fault = std::get_if<PackedFault>(&unpacked);
  return fault != nullptr && fault->beyond_limits;
}

TEST(PackedText, IsWhatWasPacked) {
  Random random(1);
  for (int i = 0; i < 300; ++i) {
    std::string text;
    for (int n = random.below(400); n > 0; --n) text += static_cast<char>(random.whole(32, 126));
    for (const bool padded : {false, true})
      EXPECT_EQ(text_or(unpack_text(packed(text, padded, random.below(10)))), text);
  }
}

// A text as long as the limit and one byte more; the ratio is that of random digits, below 100.
TEST(PackedText, HasALimit) {
  Random random(2);
  std::string text;
  while (text.size() < most_unpacked_bytes) text += static_cast<char>(random.whole('0', '9'));
  EXPECT_TRUE(text_or(unpack_text(packed(text))) == text);
  EXPECT_TRUE(is_beyond(unpack_text(packed(text + "1"))));
}

TEST(PackedText, UnpacksToAHundredTimesItself) {
  EXPECT_TRUE(is_beyond(unpack_text(packed(std::string(100'000, 'x')))));
  EXPECT_EQ(text_or(unpack_text(packed(std::string(1000, 'x')))), std::string(1000, 'x'));
}

TEST(PackedText, IsRefusedWhereItIsDamaged) {
  const std::string good = packed("{\"objects\": []}");
  for (std::size_t n = 0; n < good.size(); ++n)
    EXPECT_NE(text_or(unpack_text(good.substr(0, n))), "{\"objects\": []}") << n;
  for (const char* bad : {"", "=", "!!!!", "a b", "+/+/", "AAAA", "eJw", "eJw=="})
    EXPECT_TRUE(std::holds_alternative<PackedFault>(unpack_text(bad))) << bad;
  EXPECT_TRUE(std::holds_alternative<PackedFault>(unpack_text(good + "AAAA")));  // more after it
}

}  // namespace
}  // namespace tia::test
