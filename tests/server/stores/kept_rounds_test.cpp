// What the picture store keeps of pictures that were left.
#include "core/render/kept_rounds.h"

#include "server/stores/picture_store.h"

#include <gtest/gtest.h>

namespace tia::test {
namespace {

using server::Picture;
using server::PictureStore;

// Of 16 x 16 pixels that have had so many rounds of 16, 32, 64 ... samples.
SharedRounds kept_rounds(int rounds) {
  TilePixels pixels{.width = 16, .height = 16};
  pixels.begin();
  RoundsOfTile tile(std::move(pixels));
  tile.number_rounds(rounds);
  return std::make_shared<const KeptRounds>(
      std::vector{tile}, Sampler(Sampling{.samples = 1024, .is_chance = true, .in_rounds = true}));
}

TEST(KeptRounds, ThatHaveComeFurtherTakeThePlaceOfThoseBefore) {
  PictureStore store(1 << 20);
  EXPECT_EQ(store.rounds_of("a"), nullptr);
  const SharedRounds some = kept_rounds(2), more = kept_rounds(3), others = kept_rounds(1);
  EXPECT_EQ(some->samples(), 32);
  store.keep_rounds("a", some);
  const std::size_t bytes = store.counts().bytes;
  EXPECT_GT(bytes, some->bytes());
  store.keep_rounds("a", others);
  EXPECT_EQ(store.rounds_of("a"), some);
  store.keep_rounds("a", more);
  EXPECT_EQ(store.rounds_of("a"), more);
  EXPECT_EQ(store.rounds_of("b"), nullptr);
  EXPECT_EQ(store.counts().bytes, bytes);
  EXPECT_EQ(store.counts().rounds, 1U);
  EXPECT_EQ(store.counts().pictures, 0U);
}

// Whatever comes in which order, pictures have half of the bytes for themselves.
TEST(KeptRounds, HaveHalfOfTheBytesAtMostAndTheOldestGoFirst) {
  const auto each = static_cast<std::int64_t>(kept_rounds(1)->bytes());
  const std::int64_t most = 7 * each;  // three and their entries
  PictureStore store(most);
  const auto draw = [&](const std::stop_token&) {
    Picture picture;
    picture.bytes.assign(static_cast<std::size_t>(each), 'x');
    return picture;
  };
  for (const char* tag : {"p", "q", "r"}) store.get(tag, {draw});
  for (int i = 0; i < 20; ++i) {
    store.keep_rounds("rounds " + std::to_string(i), kept_rounds(1));
    ASSERT_LE(store.counts().bytes, static_cast<std::size_t>(most));
    ASSERT_LE(store.counts().rounds, 3U);
    ASSERT_TRUE(store.find("r"));
  }
  EXPECT_EQ(store.counts().rounds, 3U);
  EXPECT_EQ(store.counts().pictures, 3U);
  EXPECT_EQ(store.rounds_of("rounds 16"), nullptr);
  EXPECT_NE(store.rounds_of("rounds 17"), nullptr);
  for (int i = 0; i < 20; ++i) {
    store.get(std::to_string(i), {draw});
    ASSERT_LE(store.counts().bytes, static_cast<std::size_t>(most));
  }
  EXPECT_EQ(store.counts().rounds, 0U);
  store.keep_rounds("a", kept_rounds(1));
  const auto held = static_cast<std::int64_t>(store.counts().bytes);
  EXPECT_EQ(store.give_way(held), held);
  EXPECT_EQ(store.counts().rounds + store.counts().bytes, 0U);
}

}  // namespace
}  // namespace tia::test
