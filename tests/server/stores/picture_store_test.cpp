// Drawn pictures: what is drawn how often, who waits for whom, what falls out when.
#include "server/stores/picture_store.h"

#include <future>
#include <semaphore>

#include "tests/server/socket_support.h"

namespace tia::test {
namespace {

constexpr std::int64_t ample = 1 << 20;

server::Picture picture_of(std::size_t bytes, char filled_with = 'x') {
  server::Picture picture;
  picture.bytes.assign(bytes, filled_with);
  return picture;
}
PictureStore::Draw drawing(std::size_t bytes) {
  return [bytes](const std::stop_token&) { return picture_of(bytes); };
}
const PictureStore::Draw never = [](const std::stop_token&) -> server::Picture {
  ADD_FAILURE() << "drawn again";
  return {};
};

// ---- what is kept ---------------------------------------------------------------------------

TEST(PictureStore, DrawsOnceWhatIsAskedForAgain) {
  PictureStore store(ample);
  const auto first = store.get("a", {drawing(100)});
  EXPECT_EQ(first.source, Source::drawn);
  EXPECT_TRUE(first.kept);
  const auto again = store.get("a", {never});
  EXPECT_EQ(again.source, Source::stored);
  EXPECT_EQ(again.picture, first.picture);
  EXPECT_EQ(store.get("b", {drawing(10)}).source, Source::drawn);
  const PictureCounts counts = store.counts();
  EXPECT_EQ(counts.stored, 1);
  EXPECT_EQ(counts.drawn, 2);
  EXPECT_EQ(counts.pictures, 2U);
}

TEST(PictureStore, OfNoBytesKeepsNothing) {
  PictureStore store(0);
  for (int i = 0; i < 2; ++i) {
    const auto found = store.get("a", {drawing(0)});
    EXPECT_EQ(found.source, Source::drawn);
    EXPECT_FALSE(found.kept);
  }
  EXPECT_EQ(store.counts().bytes, 0U);
}

TEST(PictureStore, TheOneNotAskedForLongestFallsOutFirst) {
  PictureStore store(8000);
  for (const char* tag : {"a", "b", "c"}) store.get(tag, {drawing(2000)});
  store.get("a", {never});
  store.get("d", {drawing(2000)});  // now b goes
  for (const char* tag : {"a", "c", "d"}) store.get(tag, {never});
  EXPECT_EQ(store.get("b", {drawing(2000)}).source, Source::drawn);
}

TEST(PictureStore, BytesNeverPassTheLimitAndAPictureThatIsLargerDrivesNothingOut) {
  constexpr std::int64_t limit = 50'000;
  PictureStore store(limit);
  std::size_t held = 0;
  for (int i = 0; i < 200; ++i) {
    const auto size = static_cast<std::size_t>(1 + 997 * i % 9000);
    store.get(std::to_string(i), {drawing(size)});
    ASSERT_LE(store.counts().bytes, static_cast<std::size_t>(limit));
  }
  for (int i = 0; i < 200; ++i) {
    const auto found = store.get(std::to_string(199 - i), {drawing(limit)});
    EXPECT_EQ(found.kept, found.source == Source::stored);
    held += found.kept ? found.picture->bytes.size() : 0;
  }
  EXPECT_GT(held, static_cast<std::size_t>(limit) / 2);
  EXPECT_GE(store.counts().bytes, held);
}

// ---- who waits for whom ---------------------------------------------------------------------

/// Held: a drawing that goes on until it is let go or given up.
class Held {
 public:
  PictureStore::Draw draw() {
    return [this](const std::stop_token& given_up) {
      ++begun;
      const std::stop_callback end(given_up, [this] { go.release(64); });
      go.acquire();
      if (given_up.stop_requested()) throw Stopped();
      return picture_of(10, 'h');
    };
  }
  std::atomic<int> begun = 0;
  std::counting_semaphore<> go{0};
};

using Answer = std::future<PictureStore::Found>;

Answer ask(PictureStore& store, const PictureStore::Draw& draw, const std::stop_token& stop = {}) {
  return std::async(std::launch::async, [&store, draw, stop] {
    return store.get("a", {draw, stop});
  });
}

class Flight : public testing::Test {
 protected:
  // Until so many wait for the one that draws.
  void wait_for(std::int64_t joined) {
    ASSERT_TRUE(eventually([&] { return held.begun > 0 && store.counts().joined == joined; }));
  }
  PictureStore store{ample};
  Held held;
};

TEST_F(Flight, TenWhoAskAtOnceShareOneDrawing) {
  std::vector<Answer> answers;
  answers.push_back(ask(store, held.draw()));
  ASSERT_TRUE(eventually([&] { return held.begun == 1; }));
  for (int i = 1; i < 10; ++i) answers.push_back(ask(store, never));
  wait_for(9);
  held.go.release();
  int drawn = 0, joined = 0;
  for (Answer& each : answers) {
    const auto found = each.get();
    EXPECT_EQ(found.picture->bytes, std::string(10, 'h'));
    EXPECT_TRUE(found.kept);
    ++(found.source == Source::drawn ? drawn : joined);
  }
  EXPECT_EQ(drawn, 1);
  EXPECT_EQ(joined, 9);
}

TEST_F(Flight, GoesOnForOthersWhenTheFirstLeaves) {
  std::stop_source first;
  Answer leader = ask(store, held.draw(), first.get_token());
  ASSERT_TRUE(eventually([&] { return held.begun == 1; }));
  Answer other = ask(store, never);
  wait_for(1);
  first.request_stop();
  held.go.release();
  EXPECT_EQ(other.get().picture->bytes.size(), 10U);
  leader.get();  // nobody reads it
  EXPECT_EQ(held.begun, 1);
}

TEST_F(Flight, IsGivenUpWhenTheLastOneLeaves) {
  std::stop_source first, second;
  Answer leader = ask(store, held.draw(), first.get_token());
  ASSERT_TRUE(eventually([&] { return held.begun == 1; }));
  Answer other = ask(store, never, second.get_token());
  wait_for(1);
  first.request_stop();
  second.request_stop();
  EXPECT_THROW(other.get(), Stopped);
  EXPECT_THROW(leader.get(), Stopped);
  EXPECT_EQ(store.get("a", {drawing(3)}).source, Source::drawn);
}

TEST_F(Flight, OneWhoLeavesTakesNothingFromTheOthers) {
  std::stop_source impatient;
  Answer leader = ask(store, held.draw());
  ASSERT_TRUE(eventually([&] { return held.begun == 1; }));
  Answer leaves = ask(store, never, impatient.get_token()), stays = ask(store, never);
  wait_for(2);
  impatient.request_stop();
  EXPECT_THROW(leaves.get(), Stopped);
  held.go.release();
  EXPECT_EQ(stays.get().picture, leader.get().picture);
}

TEST_F(Flight, ThatFailsFailsForAllAndIsNotKept) {
  const auto failing = [&](const std::stop_token&) -> server::Picture {
    ++held.begun;
    held.go.acquire();
    throw std::runtime_error("no");
  };
  Answer leader = ask(store, failing);
  ASSERT_TRUE(eventually([&] { return held.begun == 1; }));
  Answer other = ask(store, never);
  wait_for(1);
  held.go.release();
  EXPECT_THROW(leader.get(), std::runtime_error);
  EXPECT_THROW(other.get(), std::runtime_error);
  EXPECT_EQ(store.get("a", {drawing(3)}).source, Source::drawn);
}

// What is being given up takes its time; who comes then waits for it no more.
TEST_F(Flight, BeginsAnewForOneWhoComesAfterAllHaveLeft) {
  std::counting_semaphore<> end{0};
  std::stop_source first;
  Answer slow = ask(
      store,
      [&](const std::stop_token& given_up) -> server::Picture {
        ++held.begun;
        end.acquire();
        EXPECT_TRUE(given_up.stop_requested());
        throw Stopped();
      },
      first.get_token());
  ASSERT_TRUE(eventually([&] { return held.begun == 1; }));
  first.request_stop();
  EXPECT_EQ(store.get("a", {drawing(5)}).source, Source::drawn);
  EXPECT_EQ(store.get("a", {never}).source, Source::stored);
  end.release();
  EXPECT_THROW(slow.get(), Stopped);
  EXPECT_EQ(store.get("a", {never}).picture->bytes.size(), 5U);
}

TEST(PictureStore, ManyThreadsGetTheirOwnPictures) {
  PictureStore store(20'000);
  std::vector<std::jthread> threads;
  for (int t = 0; t < 8; ++t)
    threads.emplace_back([&store, t] {
      for (int i = 0; i < 300; ++i) {
        const auto size = static_cast<std::size_t>(100 * ((t * 7 + i) % 23));
        const auto found = store.get(std::to_string(size), {drawing(size)});
        ASSERT_EQ(found.picture->bytes.size(), size);
      }
    });
  threads.clear();
  const PictureCounts counts = store.counts();
  EXPECT_EQ(counts.stored + counts.drawn + counts.joined, 8 * 300);
}

// A place in the queue is a client's own: that the first had none is not the other's fault.
TEST_F(Flight, ThatIsRefusedForWantOfRoomIsDrawnByWhoWaitedForIt) {
  Answer leader = ask(store, [&](const std::stop_token&) -> server::Picture {
    ++held.begun;
    held.go.acquire();
    throw HttpError("busy", "the queue is full");
  });
  ASSERT_TRUE(eventually([&] { return held.begun == 1; }));
  Answer other = ask(store, drawing(7));
  wait_for(1);
  held.go.release();
  EXPECT_THROW(leader.get(), HttpError);
  const auto found = other.get();
  EXPECT_EQ(found.picture->bytes.size(), 7U);
  EXPECT_EQ(found.source, Source::drawn);
}

TEST_F(Flight, IsToldWhoElseWaitsForIt) {
  std::vector<std::string> joined;
  PictureStore::Wish first{held.draw()};
  first.joined_by = [&](const std::string& client) { joined.push_back(client); };
  Answer leader = std::async(std::launch::async, [&] { return store.get("a", first); });
  ASSERT_TRUE(eventually([&] { return held.begun == 1; }));
  Answer other = std::async(std::launch::async,
                            [&] { return store.get("a", {.draw = never, .client = "other"}); });
  wait_for(1);
  held.go.release();
  EXPECT_EQ(other.get().picture, leader.get().picture);
  EXPECT_EQ(joined, std::vector<std::string>{"other"});
}

}  // namespace
}  // namespace tia::test
