// Bytes that come one after the other.
#include "server/operation/byte_buffer.h"

#include <gtest/gtest.h>

#include <new>
#include <utility>
#include <vector>

#include "tests/core/support.h"
#include "tests/sanitizer.h"

namespace tia::server {
namespace {

using Bytes = std::vector<std::uint8_t>;
Bytes bytes_of(const ByteBuffer& buffer) { return {buffer.begin(), buffer.end()}; }

TEST(ByteBuffer, HoldsWhatIsWrittenIntoItsRoom) {
  test::Random random(1);
  ByteBuffer buffer;
  Bytes expected;
  EXPECT_TRUE(buffer.is_full());
  while (expected.size() < 300'000) {
    const auto least = static_cast<std::size_t>(random.whole(1, 9000));
    const auto room = buffer.room(least);
    ASSERT_GE(room.size(), least);
    for (std::size_t i = 0; i < least; ++i) {
      room[i] = static_cast<std::uint8_t>(random.below(256));
      expected.push_back(room[i]);
    }
    buffer.add(least);
    ASSERT_EQ(buffer.size(), expected.size());
  }
  EXPECT_EQ(bytes_of(buffer), expected);
}

TEST(ByteBuffer, IsFullWhereNothingFitsAnyMore) {
  ByteBuffer buffer;
  buffer.reserve(3);
  EXPECT_FALSE(buffer.is_full());
  ASSERT_EQ(buffer.room(1).size(), 3U);
  buffer.add(3);
  EXPECT_TRUE(buffer.is_full());
  EXPECT_GE(buffer.room(1).size(), 1U);
}

TEST(ByteBuffer, MovesWithoutItsBytesMoving) {
  ByteBuffer from;
  from.room(2)[0] = 7;
  from.add(1);
  const std::uint8_t* const at = from.begin();
  ByteBuffer to(std::move(from));
  EXPECT_EQ(to.begin(), at);
  EXPECT_EQ(bytes_of(to), Bytes{7});
  to = ByteBuffer();
  EXPECT_EQ(to.size(), 0U);
}

TEST(ByteBuffer, KeepsItsBytesWhereThereIsNoMemoryForMore) {
  if (test::sanitized()) GTEST_SKIP() << "sanitizers end a program that asks for so much";
  ByteBuffer buffer;
  buffer.room(1)[0] = 9;
  buffer.add(1);
  const std::size_t too_much = ~std::size_t{0} / 2 - buffer.size();
  EXPECT_THROW(buffer.reserve(too_much), std::bad_alloc);
  EXPECT_EQ(bytes_of(buffer), Bytes{9});
}

}  // namespace
}  // namespace tia::server
