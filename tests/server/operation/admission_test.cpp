// Who may draw, and when: laws of Admission, by threads that enter and leave.
#include "server/operation/admission.h"

#include <algorithm>
#include <future>
#include <list>
#include <memory>

#include "core/parallel/stopped.h"
#include "tests/server/socket_support.h"

namespace tia::test {
namespace {

const Cost light_rays{0.001}, heavy_rays{2 * Cost::most_light_seconds};
const std::int64_t many_rays = Cost::most_light_rays + 1;
using Ticket = Admission::Ticket;

/// Someone who enters on a thread of their own.
class Guest {
 public:
  Guest(Admission& admission, const Cost& cost, const std::string& client = "a",
        Admission::Waiting* place = nullptr)
      : ticket_(std::async(std::launch::async, [this, &admission, cost, client, place] {
          return admission.enter(cost, client, stop_.get_token(), place);
        })) {}
  /// One who reads a text.
  Guest(Admission& admission, std::size_t bytes)
      : ticket_(std::async(std::launch::async, [this, &admission, bytes] {
          return admission.read(bytes, "a", stop_.get_token());
        })) {}
  bool is_in(milliseconds timeout = milliseconds(0)) const {
    return ticket_.wait_for(timeout) == std::future_status::ready;
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
  Admission admission({.tickets = 3});
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
  Admission admission({.tickets = 4});
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
  Admission admission({.tickets = 2});
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
  Admission admission({.tickets = 2});
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
  Admission admission({.tickets = 1});
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
  Admission admission({.tickets = 1});
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
  Admission admission({.tickets = 1});
  Guest poster(admission, heavy_rays);
  EXPECT_TRUE(poster.gets_in());
}

TEST(Admission, PostersWaitInAQuarterOfTheQueue) {
  Admission admission({.tickets = 4, .queue = 8});
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
  Admission admission({.tickets = 2, .queue = 8});
  Ticket a = admission.enter(light_rays, "a", {}), b = admission.enter(light_rays, "a", {});
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

TEST(Admission, WhatHasBegunIsNeverSentAway) {
  Admission admission({.tickets = 2, .queue = 8});
  std::list<Ticket> begun;
  for (int i = 0; i < 10; ++i) {  // each turns out heavy, and the next one comes in nevertheless
    begun.push_back(admission.enter(light_rays, "a", {}));
    EXPECT_NO_THROW(begun.back().has_done(many_rays, 0));
  }
  Guest small(admission, light_rays);
  EXPECT_TRUE(small.gets_in());
  EXPECT_EQ(admission.at_work(), 11);
}

TEST(Admission, HoweverMuchOfOneClientTurnsOutHeavyAnothersHeavyWorkBegins) {
  Admission admission({.tickets = 4, .queue = 8});
  std::list<Ticket> begun;
  for (int i = 0; i < 10; ++i) {
    begun.push_back(admission.enter(light_rays, "a", {}));
    begun.back().has_done(many_rays, 0);
  }
  Guest poster(admission, heavy_rays, "b");
  EXPECT_TRUE(poster.gets_in());
  Guest second(admission, heavy_rays, "b");  // it has one already
  wait_until_waiting(admission, 1);
  EXPECT_FALSE(second.is_in(milliseconds(20)));
  begun.clear();
  EXPECT_TRUE(second.gets_in());
}

TEST(Admission, WhatCouldNotEndInTimeDoesNotBegin) {
  Admission admission({.tickets = 8, .queue = 64, .threads = 2, .most_wait_s = 5});
  const Cost dear{4, true};                            // two seconds of two threads
  const Ticket one = admission.enter({100}, "a", {});  // alone, whatever it costs
  EXPECT_THROW(static_cast<void>(admission.enter(dear, "a", {})), HttpError);
  EXPECT_NO_THROW(static_cast<void>(admission.enter(light_rays, "a", {})));
  Admission other({.tickets = 8, .queue = 64, .threads = 2, .most_wait_s = 5});
  const Ticket two = other.enter(dear, "a", {}), three = other.enter(dear, "a", {});
  EXPECT_THROW(static_cast<void>(other.enter(dear, "a", {})), HttpError);  // 6 s in all
}

// What one client has asked for takes no time of who asks for little: they share.
TEST(Admission, OnlyAShareOfWhatOthersAskForCountsAsTime) {
  Admission admission({.tickets = 8, .queue = 64, .threads = 2, .most_wait_s = 5});
  const Ticket one = admission.enter({9, true}, "flood", {});
  EXPECT_THROW(static_cast<void>(admission.enter({2, true}, "flood", {})), HttpError);
  EXPECT_NO_THROW(static_cast<void>(admission.enter({5, true}, "b", {})));  // 5 + 5 of 10
  EXPECT_THROW(static_cast<void>(admission.enter({5.1, true}, "b", {})), HttpError);
}

TEST(Admission, OfThoseThatWaitGoesWhoseClientHasFewest) {
  Admission admission({.tickets = 2, .queue = 8});
  Guest a(admission, light_rays), b(admission, light_rays);
  ASSERT_TRUE(a.gets_in() && b.gets_in());
  Guest c(admission, light_rays);
  wait_until_waiting(admission, 1);
  Guest d(admission, heavy_rays);  // heavy work of its own goes first once, and then has its turn
  wait_until_waiting(admission, 2);
  d.give_up();
  ASSERT_TRUE(d.gets_in());
  Guest other(admission, light_rays, "b");  // more than half is another's: room beyond the tickets
  EXPECT_TRUE(other.gets_in());
  EXPECT_FALSE(c.is_in());
  Guest another(admission, light_rays, "b");
  wait_until_waiting(admission, 2);
  a.leave();
  EXPECT_FALSE(c.is_in(milliseconds(20)));  // two are at work still
  b.leave();
  EXPECT_TRUE(c.gets_in());  // a has none, b has one
  EXPECT_FALSE(another.is_in());
  another.give_up();
}

TEST(Admission, AFullQueueMakesRoomForWhoHasLessOfIt) {
  Admission admission({.tickets = 1, .queue = 4});
  Guest inside(admission, light_rays);
  ASSERT_TRUE(inside.gets_in());
  std::list<Guest> flood;
  for (int i = 1; i <= 4; ++i) {
    flood.emplace_back(admission, light_rays);
    wait_until_waiting(admission, i);
  }
  Guest own(admission, light_rays);  // of the same client: there is no room
  ASSERT_TRUE(own.gets_in());
  EXPECT_THROW(own.leave(), HttpError);
  Guest x(admission, light_rays, "b");  // comes in at once: all that is at work is another's
  ASSERT_TRUE(x.gets_in());
  Guest first(admission, light_rays, "b");
  ASSERT_TRUE(flood.back().gets_in());  // the newest of the flood
  EXPECT_THROW(flood.back().leave(), HttpError);
  flood.pop_back();
  Guest second(admission, light_rays, "b");
  ASSERT_TRUE(flood.back().gets_in());
  EXPECT_THROW(flood.back().leave(), HttpError);
  flood.pop_back();
  Guest third(admission, light_rays, "b");  // half is theirs
  ASSERT_TRUE(third.gets_in());
  EXPECT_THROW(third.leave(), HttpError);
  EXPECT_EQ(admission.waiting(), 4);
  for (Guest& each : flood) each.give_up();
  first.give_up(), second.give_up();
}

// Where all have as much as each other newcomers drive nobody out: else who waits would never get
// in.
TEST(Admission, AFullQueueOfEqualsMakesNoRoom) {
  Admission admission({.tickets = 1, .queue = 2});
  Guest inside(admission, light_rays, "a");
  ASSERT_TRUE(inside.gets_in());
  Guest beside(admission, light_rays, "b");  // all that is at work is another's
  ASSERT_TRUE(beside.gets_in());
  Guest c(admission, light_rays, "c");
  wait_until_waiting(admission, 1);
  Guest d(admission, light_rays, "d");
  wait_until_waiting(admission, 2);
  Guest e(admission, light_rays, "e");
  ASSERT_TRUE(e.gets_in());
  EXPECT_THROW(e.leave(), HttpError);
  EXPECT_EQ(admission.waiting(), 2);
  c.give_up(), d.give_up();
}

TEST(Admission, WhoWaitsForOthersTakesAPlaceOfItsOwnKind) {
  Admission admission({.tickets = 1, .queue = 2});
  auto one = std::make_unique<Admission::QueuePlace>(admission.wait_for_others(""));
  const auto other = admission.wait_for_others("");
  EXPECT_EQ(admission.waiting(), 2);
  EXPECT_THROW(static_cast<void>(admission.wait_for_others("")), HttpError);
  Guest inside(admission, light_rays);  // nor does it fill the queue for those who want to draw
  ASSERT_TRUE(inside.gets_in());
  Guest waiting(admission, light_rays);
  wait_until_waiting(admission, 3);
  one.reset();
  EXPECT_NO_THROW(static_cast<void>(admission.wait_for_others("")));
  waiting.give_up();
}

TEST(Admission, OfThePlacesForOthersAClientMayHaveHalf) {
  Admission admission({.tickets = 1, .queue = 4});
  const auto one = admission.wait_for_others("a");
  auto two = std::make_unique<Admission::QueuePlace>(admission.wait_for_others("a"));
  EXPECT_THROW(static_cast<void>(admission.wait_for_others("a")), HttpError);
  const auto other = admission.wait_for_others("b");
  two.reset();
  EXPECT_NO_THROW(static_cast<void>(admission.wait_for_others("a")));
}

TEST(Admission, LongTextsAreReadAFewAtATime) {
  const std::size_t size = Admission::longest_short_text;
  Admission admission({.tickets = 8, .queue = 4});
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
  Admission admission({.tickets = 1});
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
  Admission admission({.tickets = 3, .queue = 256});
  std::atomic<int> inside = 0, most = 0, done = 0;
  std::vector<std::jthread> threads;
  for (int i = 0; i < 64; ++i)
    threads.emplace_back([&, i] {
      for (int turn = 0; turn < 20; ++turn) {
        const auto ticket = admission.enter((i + turn) % 3 == 0 ? heavy_rays : light_rays, "a", {});
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

// The last of one client's places is wanted by another, too, who has none: it is that one's then.
TEST(Admission, APlaceThatAnotherWantsTooCountsToWhoHasLess) {
  Admission admission({.tickets = 2});
  Guest first(admission, light_rays, "a"), second(admission, light_rays, "a");
  ASSERT_TRUE(first.gets_in() && second.gets_in());
  Guest third(admission, light_rays, "a");
  wait_until_waiting(admission, 1);
  Admission::Waiting place;
  Guest wanted(admission, light_rays, "a", &place);
  wait_until_waiting(admission, 2);
  place.also_for("b");
  first.leave();
  EXPECT_TRUE(wanted.gets_in());
  EXPECT_FALSE(third.is_in());
  place.also_for("c");  // which is too late to matter
  second.leave();
  EXPECT_TRUE(third.gets_in());
}

TEST(Admission, APlaceStaysWithWhoHasLess) {
  Admission admission({.tickets = 2});
  Guest first(admission, light_rays, "a"), second(admission, light_rays, "b");
  ASSERT_TRUE(first.gets_in() && second.gets_in());
  Admission::Waiting place;
  Guest wanted(admission, light_rays, "c", &place);
  wait_until_waiting(admission, 1);
  place.also_for("a");
  Guest others(admission, light_rays, "a");
  wait_until_waiting(admission, 2);
  second.leave();
  EXPECT_TRUE(wanted.gets_in());
  EXPECT_FALSE(others.is_in());
  first.leave();
  EXPECT_TRUE(others.gets_in());
}

}  // namespace
}  // namespace tia::test
