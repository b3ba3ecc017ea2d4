// Who may draw, and when: laws of Admission, by threads that enter and leave.
#include "server/admission.h"

#include <algorithm>
#include <future>

#include "core/render/pool.h"
#include "tests/server/socket_support.h"

namespace tia::test {
namespace {

constexpr double light_rays = 1, heavy_rays = 2.0 * Admission::most_light_rays;
constexpr std::int64_t many_rays = Admission::most_light_rays + 1;
using Ticket = Admission::Ticket;

/// Someone who enters on a thread of their own.
class Guest {
 public:
  Guest(Admission& admission, double rays)
      : ticket_(std::async(std::launch::async, [this, &admission, rays] {
          return admission.enter(rays, stop_.get_token());
        })) {}
  /// One who reads a text.
  Guest(Admission& admission, std::size_t bytes)
      : ticket_(std::async(std::launch::async, [this, &admission, bytes] {
          return admission.read(bytes, stop_.get_token());
        })) {}
  bool is_in(milliseconds patience = milliseconds(0)) const {
    return ticket_.wait_for(patience) == std::future_status::ready;
  }
  bool gets_in() const { return is_in(seconds(20)); }
  void leave() { ticket_.get(); }  // the ticket ends here
  void give_up() { stop_.request_stop(); }

 private:
  std::stop_source stop_;
  std::future<Ticket> ticket_;
};

void wait_until_waiting(const Admission& admission, int count) {
  ASSERT_TRUE(eventually([&] { return admission.waiting() == count; }));
}

TEST(Admission, LetsInAsManyAsThereAreTickets) {
  Admission admission(3);
  Guest a(admission, light_rays), b(admission, light_rays), c(admission, light_rays);
  EXPECT_TRUE(a.gets_in() && b.gets_in() && c.gets_in());
  EXPECT_EQ(admission.at_work(), 3);
  Guest d(admission, light_rays);
  wait_until_waiting(admission, 1);
  EXPECT_FALSE(d.is_in(milliseconds(20)));
  b.leave();
  EXPECT_TRUE(d.gets_in());
  EXPECT_EQ(admission.at_work(), 3);
  EXPECT_EQ(admission.waiting(), 0);
}

TEST(Admission, HeavyWorkLeavesRoomForLight) {
  Admission admission(4);
  Guest a(admission, heavy_rays), b(admission, heavy_rays);
  ASSERT_TRUE(a.gets_in() && b.gets_in());
  Guest c(admission, heavy_rays);
  wait_until_waiting(admission, 1);
  Guest small(admission, light_rays);
  EXPECT_TRUE(small.gets_in());  // past the heavy one that waits
  EXPECT_FALSE(c.is_in());
  a.leave();
  EXPECT_TRUE(c.gets_in());
}

TEST(Admission, OfThoseThatWaitLightGoesFirst) {
  Admission admission(2);
  Guest poster(admission, heavy_rays), small(admission, light_rays);
  ASSERT_TRUE(poster.gets_in() && small.gets_in());
  Guest later_poster(admission, heavy_rays);
  wait_until_waiting(admission, 1);
  Guest later_small(admission, light_rays);
  wait_until_waiting(admission, 2);
  small.leave();
  EXPECT_TRUE(later_small.gets_in());
  EXPECT_FALSE(later_poster.is_in());
  poster.leave();
  EXPECT_TRUE(later_poster.gets_in());
}

TEST(Admission, AStreamOfLightWorkDoesNotKeepHeavyWorkOut) {
  Admission admission(2);
  Guest a(admission, light_rays), b(admission, light_rays);
  ASSERT_TRUE(a.gets_in() && b.gets_in());
  Guest small(admission, light_rays);
  wait_until_waiting(admission, 1);
  Guest poster(admission, heavy_rays);
  wait_until_waiting(admission, 2);
  a.leave();
  EXPECT_TRUE(poster.gets_in());  // as none of its kind is at work
  EXPECT_FALSE(small.is_in());
  b.leave();
  EXPECT_TRUE(small.gets_in());
}

TEST(Admission, WhoComesFirstGoesFirst) {
  Admission admission(1);
  Guest inside(admission, light_rays);
  ASSERT_TRUE(inside.gets_in());
  Guest first(admission, light_rays);
  wait_until_waiting(admission, 1);
  Guest second(admission, light_rays);
  wait_until_waiting(admission, 2);
  inside.leave();
  EXPECT_TRUE(first.gets_in());
  EXPECT_FALSE(second.is_in());
  first.leave();
  EXPECT_TRUE(second.gets_in());
}

TEST(Admission, WhoGivesUpNeverStartsAndHoldsNobodyUp) {
  Admission admission(1);
  Guest inside(admission, light_rays);
  ASSERT_TRUE(inside.gets_in());
  Guest leaves(admission, light_rays);
  wait_until_waiting(admission, 1);
  Guest stays(admission, light_rays);
  wait_until_waiting(admission, 2);
  leaves.give_up();
  ASSERT_TRUE(leaves.gets_in());
  EXPECT_THROW(leaves.leave(), Stopped);
  EXPECT_FALSE(stays.is_in());
  inside.leave();
  EXPECT_TRUE(stays.gets_in());
}

TEST(Admission, WithOneTicketHeavyWorkGetsItToo) {
  Admission admission(1);
  Guest poster(admission, heavy_rays);
  EXPECT_TRUE(poster.gets_in());
}

TEST(Admission, PostersWaitInAQuarterOfTheQueue) {
  Admission admission(4, 8);
  Guest a(admission, heavy_rays), b(admission, heavy_rays);
  ASSERT_TRUE(a.gets_in() && b.gets_in());
  Guest c(admission, heavy_rays), d(admission, heavy_rays);
  wait_until_waiting(admission, 2);
  Guest one_too_many(admission, heavy_rays);
  ASSERT_TRUE(one_too_many.gets_in());
  EXPECT_THROW(one_too_many.leave(), HttpError);
  Guest small(admission, light_rays);
  EXPECT_TRUE(small.gets_in());
  c.give_up();
  d.give_up();
}

TEST(Admission, WhatTurnsOutHeavyMakesRoomForLight) {
  Admission admission(2, 8);
  Ticket a = admission.enter(light_rays, {}), b = admission.enter(light_rays, {});
  Guest small(admission, light_rays);
  wait_until_waiting(admission, 1);
  a.has_done(many_rays - 1, Admission::most_light_tests);
  EXPECT_FALSE(small.is_in(milliseconds(20)));
  a.has_done(many_rays, 0);  // is counted among the posters, which have room
  EXPECT_FALSE(small.is_in(milliseconds(20)));
  b.has_done(0, Admission::most_light_tests + 1);  // is beyond their share
  EXPECT_TRUE(small.gets_in());
  EXPECT_EQ(admission.at_work(), 3);
}

TEST(Admission, WhatTurnsOutHeavyIsSentAwayWhereMuchIsAndLightWorkWaits) {
  Admission admission(2, 8);
  Ticket a = admission.enter(light_rays, {}), b = admission.enter(light_rays, {});
  a.has_done(many_rays, 0);
  b.has_done(many_rays, 0);
  Ticket c = admission.enter(light_rays, {});
  c.has_done(many_rays, 0);  // nobody waits
  Guest small(admission, light_rays);
  wait_until_waiting(admission, 1);
  EXPECT_THROW(c.has_done(many_rays, 0), HttpError);
  EXPECT_NO_THROW(b.has_done(2 * many_rays, 0));
  small.give_up();
}

TEST(Admission, LongTextsAreReadAFewAtATime) {
  constexpr std::size_t size = Admission::longest_short_text;
  Admission admission(8, 4);
  Guest a(admission, size + 1), b(admission, size + 1);
  ASSERT_TRUE(a.gets_in() && b.gets_in());
  Guest c(admission, size + 1);
  wait_until_waiting(admission, 1);
  Guest one_too_many(admission, size + 1);
  ASSERT_TRUE(one_too_many.gets_in());
  EXPECT_THROW(one_too_many.leave(), HttpError);
  Guest brief(admission, size), picture(admission, light_rays);
  EXPECT_TRUE(brief.gets_in() && picture.gets_in());
  a.leave();
  EXPECT_TRUE(c.gets_in());
}

TEST(Admission, RetryAfterGrowsWithTheQueueAndWithHowLongWorkTakes) {
  Admission admission(1);
  EXPECT_EQ(admission.retry_after(), 1);
  std::vector<std::unique_ptr<Guest>> guests;
  guests.push_back(std::make_unique<Guest>(admission, light_rays));
  ASSERT_TRUE(guests[0]->gets_in());
  for (int i = 0; i < 30; ++i) guests.push_back(std::make_unique<Guest>(admission, light_rays));
  wait_until_waiting(admission, 30);
  const int when_usual = admission.retry_after();  // 31 times the 0.1 s that is supposed at first
  EXPECT_EQ(when_usual, 4);
  const auto one_leaves = [&] {
    const auto in = [](const auto& guest) { return guest->is_in(); };
    const auto one = std::find_if(guests.begin(), guests.end(), in);
    if (one != guests.end()) guests.erase(one);  // its ticket was held for next to no time
    return guests.empty();
  };
  ASSERT_TRUE(eventually(one_leaves));
  EXPECT_EQ(admission.retry_after(), 1);
}

TEST(Admission, SixtyFourAtOnceAllGetIn) {
  Admission admission(3, 256);
  std::atomic<int> inside = 0, most = 0, done = 0;
  std::vector<std::jthread> threads;
  for (int i = 0; i < 64; ++i)
    threads.emplace_back([&, i] {
      for (int turn = 0; turn < 20; ++turn) {
        const auto ticket = admission.enter((i + turn) % 3 == 0 ? heavy_rays : light_rays, {});
        const int now = ++inside;
        for (int seen = most; now > seen && !most.compare_exchange_weak(seen, now);) {
        }
        --inside;
        ++done;
      }
    });
  threads.clear();
  EXPECT_EQ(done, 64 * 20);
  EXPECT_LE(most, 3);
  EXPECT_EQ(admission.at_work(), 0);
  EXPECT_EQ(admission.waiting(), 0);
}

}  // namespace
}  // namespace tia::test
