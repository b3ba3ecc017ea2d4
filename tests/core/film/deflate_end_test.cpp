// Streams of libdeflate at all of its levels, of texts that make it choose each kind of block.
#include "core/film/deflate_end.h"

#include <gtest/gtest.h>
#include <libdeflate.h>

#include <algorithm>
#include <memory>
#include <optional>
#include <stdexcept>

#include "tests/core/film/files.h"

namespace tia {
namespace {

using test::Bytes;
using test::Random;

Bytes deflated(const Bytes& text, int level) {
  const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
      libdeflate_alloc_compressor(level), libdeflate_free_compressor);
  Bytes out(libdeflate_deflate_compress_bound(compressor.get(), text.size()));
  out.resize(libdeflate_deflate_compress(compressor.get(), text.data(), text.size(), out.data(),
                                         out.size()));
  return out;
}
std::optional<Bytes> inflated(const Bytes& stream, std::size_t bytes) {
  const std::unique_ptr<libdeflate_decompressor, void (*)(libdeflate_decompressor*)> decompressor(
      libdeflate_alloc_decompressor(), libdeflate_free_decompressor);
  Bytes text(bytes);
  const auto result = libdeflate_deflate_decompress(
      decompressor.get(), stream.data(), stream.size(), text.data(), text.size(), nullptr);
  if (result != LIBDEFLATE_SUCCESS) return std::nullopt;
  return text;
}
DeflateEnd end_of(Bytes stream) {
  const std::size_t bytes = stream.size();
  stream.resize(bytes + deflate_end_margin, 0xA5);
  return deflate_end(stream.data(), bytes);
}

// Texts of codes below `kinds`, of which every `repeated`-th or so begins a copy of what came.
Bytes random_text(std::size_t bytes, int kinds, int repeated, std::uint64_t seed) {
  Random random(seed);
  Bytes text;
  while (text.size() < bytes) {
    text.push_back(static_cast<std::uint8_t>(random.below(kinds)));
    if (repeated == 0 || random.below(repeated) != 0) continue;
    const auto most = static_cast<int>(std::min<std::size_t>(text.size(), 32768));
    const std::size_t back = 1 + static_cast<std::size_t>(random.below(most));
    for (int i = random.below(400); i > 0; --i) text.push_back(text[text.size() - back]);
  }
  text.resize(bytes);
  return text;
}
std::vector<Bytes> texts() {
  std::vector<Bytes> all{{}, {7}, Bytes(100'000)};
  for (const std::size_t bytes : {40U, 3'000U, 300'000U})
    for (const int kinds : {2, 40, 256})
      for (const int repeated : {0, 3, 50}) all.push_back(random_text(bytes, kinds, repeated, 340));
  return all;
}

TEST(DeflateEnd, IsInTheLastByteAndTheLastBlockSaysThatItIs) {
  for (const Bytes& text : texts()) {
    for (int level = 0; level <= 12; ++level) {
      const Bytes stream = deflated(text, level);
      const DeflateEnd at = end_of(stream);
      ASSERT_EQ((at.end + 7) / 8, stream.size()) << text.size() << ", level " << level;
      ASSERT_LT(at.last_block, at.end);
      ASSERT_EQ(stream[at.last_block / 8] >> at.last_block % 8 & 1, 1);
    }
  }
}

// Bit by bit behind one another, as nothing else would notice an end that is a bit off. The second
// stream has no stored block, for those would have to begin with a byte.
TEST(DeflateEnd, StreamsThatAreJoinedThereAreOneStreamOfBothTexts) {
  const Bytes more = random_text(2'000, 40, 3, 343), second = deflated(more, 2);
  for (const Bytes& text : texts()) {
    const Bytes first = deflated(text, 2);
    const DeflateEnd at = end_of(first);
    Bytes both = first;
    both.resize(first.size() + second.size() + 1);
    both[at.last_block / 8] &= static_cast<std::uint8_t>(~(1U << at.last_block % 8));
    for (std::size_t i = 0; i < 8 * second.size(); ++i)
      both[(at.end + i) / 8] |=
          static_cast<std::uint8_t>((second[i / 8] >> i % 8 & 1U) << (at.end + i) % 8);
    Bytes expected = text;
    expected.insert(expected.end(), more.begin(), more.end());
    ASSERT_TRUE(inflated(both, expected.size()) == expected) << text.size();
  }
}

TEST(DeflateEnd, StreamsThatAreCutShortAreRefused) {
  const Bytes stream = deflated(random_text(3'000, 40, 3, 341), 2);
  for (std::size_t bytes = 0; bytes < stream.size(); ++bytes)
    EXPECT_THROW(end_of({stream.begin(), stream.begin() + static_cast<std::ptrdiff_t>(bytes)}),
                 std::invalid_argument)
        << bytes;
}

TEST(DeflateEnd, WhatIsNoStreamIsRefusedOrEndsWithinItsBytes) {
  EXPECT_THROW(end_of({0x07, 0, 0}), std::invalid_argument);  // a block of the kind 3
  EXPECT_THROW(end_of({0x01, 1, 0, 0, 0, 9}),
               std::invalid_argument);  // a length and not its inverse
  Random random(342);
  for (int i = 0; i < 20'000; ++i) {
    Bytes any(static_cast<std::size_t>(random.below(200)));
    for (auto& byte : any) byte = static_cast<std::uint8_t>(random.below(256));
    if (!any.empty()) any[0] = static_cast<std::uint8_t>((any[0] & ~6U) | 4U);  // a dynamic block
    try {
      EXPECT_LE(end_of(any).end, 8 * any.size());
    } catch (const std::invalid_argument&) {
      continue;
    }
  }
}

}  // namespace
}  // namespace tia
