// The account of memory: what it gives, to whom, in which order, and what it says where it cannot.
#include "server/operation/memory_account.h"

#include <thread>

#include "core/parallel/stopped.h"
#include "server/operation/lru_map.h"
#include "server/operation/memory_costs.h"
#include "tests/server/socket_support.h"

namespace tia::test {
namespace {

constexpr std::int64_t mega = 1 << 20, account_bytes = 512 * mega;

std::string refusal_of(MemoryClaim& claim, std::int64_t bytes) {
  try {
    claim.reserve(bytes, "the test", {});
  } catch (const HttpError& error) {
    EXPECT_EQ(error.type(), "too-large");
    return error.detail();
  }
  return "";
}

TEST(MemoryAccount, BooksTheProgramFirstAndNeverMoreThanItsLimit) {
  MemoryAccount account(account_bytes);
  EXPECT_EQ(account.held(MemoryAccount::program), MemoryAccount::program_bytes);
  EXPECT_EQ(account.free(), account_bytes - MemoryAccount::program_bytes);
  EXPECT_FALSE(account.take(MemoryAccount::pictures, account.free() + 1));
  EXPECT_TRUE(account.take(MemoryAccount::pictures, account.free()));
  EXPECT_EQ(account.free(), 0);
  EXPECT_FALSE(account.take(MemoryAccount::pictures, 1));
  account.add(MemoryAccount::pictures, -mega);
  EXPECT_EQ(account.free(), mega);
}

TEST(MemoryAccount, OneRequestMayHaveAllButTheProgramsAndAnEighth) {
  MemoryAccount account(account_bytes);
  const std::int64_t most = account_bytes - MemoryAccount::program_bytes - account_bytes / 8;
  EXPECT_EQ(account.most_of_one(), most);
  MemoryClaim claim(account);
  const std::string said = refusal_of(claim, most + 1);
  EXPECT_THAT(said, testing::HasSubstr("TIA_MEMORY_BYTES"));
  EXPECT_THAT(said, testing::HasSubstr("the test"));
  EXPECT_THAT(said, testing::HasSubstr(std::to_string(most / mega)));
  EXPECT_EQ(account.refusals(), 1);
  EXPECT_EQ(refusal_of(claim, most), "");
  EXPECT_EQ(claim.granted(), most);
}

TEST(MemoryClaim, GivesAllBackWhenItEndsAndWhatItDoesNotUseWhenItSettles) {
  MemoryAccount account(account_bytes);
  const std::int64_t free = account.free();
  {
    MemoryClaim claim(account);
    claim.reserve(10 * mega, "the test", {});
    EXPECT_EQ(account.free(), free - 10 * mega);
    EXPECT_TRUE(claim.charge(3 * mega));
    claim.reserve(7 * mega, "the test", {});  // which it has already
    EXPECT_EQ(claim.granted(), 10 * mega);
    claim.settle();
    EXPECT_EQ(account.free(), free - 3 * mega);
    claim.discharge(3 * mega);
    claim.settle();
    EXPECT_EQ(claim.granted(), 0);
    EXPECT_EQ(claim.most_used(), 3 * mega);
    claim.reserve(mega, "the test", {});
  }
  EXPECT_EQ(account.free(), free);
}

TEST(MemoryClaim, GrowsByWhatIsAllocatedUntilOnlySmallOnesMayHaveMore) {
  MemoryAccount account(account_bytes);
  MemoryClaim claim(account);
  EXPECT_TRUE(claim.charge(1));
  EXPECT_EQ(claim.granted(), mega);  // in steps
  EXPECT_TRUE(claim.charge(account.free() - account_bytes / 8 + mega - 1));
  EXPECT_EQ(account.free(), account_bytes / 8);
  EXPECT_FALSE(claim.charge(1));
  EXPECT_TRUE(claim.was_refused());
  EXPECT_EQ(claim.refusal().type(), "too-large");  // it has it all itself
  MemoryClaim small(account), another(account), third(account), fourth(account), last(account);
  for (MemoryClaim* each : {&small, &another, &third, &fourth})
    EXPECT_TRUE(each->charge(account.most_small()));
  EXPECT_EQ(account.free(), 0);
  EXPECT_FALSE(last.charge(1));
  EXPECT_EQ(last.refusal().type(), "busy");
  EXPECT_EQ(last.granted(), 0);
}

TEST(ForeseenMemory, StaysWhateverOthersTakeUntilItsStepHasTakenIt) {
  MemoryAccount account(account_bytes);
  const std::int64_t free = account.free();
  {
    MemoryClaim claim(account);
    ForeseenMemory foreseen(claim, 10 * mega, "the test", {});
    claim.settle();
    claim.reserve(4 * mega, "another step", {});
    EXPECT_EQ(claim.granted(), 14 * mega);
    claim.settle();
    foreseen.spend([&] { EXPECT_TRUE(claim.charge(7 * mega)); });
    claim.settle();
    EXPECT_EQ(claim.granted(), 10 * mega);
    foreseen.spend([&] { EXPECT_TRUE(claim.charge(5 * mega)); });  // more than was foreseen
    claim.settle();
    EXPECT_EQ(claim.granted(), 12 * mega);
    EXPECT_THROW(foreseen.spend([] { throw Stopped(); }), Stopped);
    claim.discharge(12 * mega);
  }
  EXPECT_EQ(account.free(), free);
  MemoryClaim claim(account);
  EXPECT_THROW(ForeseenMemory(claim, account_bytes, "the test", {}), HttpError);
  EXPECT_EQ(claim.used(), 0);
}

TEST(MemoryClaim, CachesGiveWayBeforeAnyoneWaits) {
  MemoryAccount account(account_bytes);
  std::int64_t cached = account.free();
  account.add(MemoryAccount::pictures, cached);
  account.on_shortage([&](std::int64_t bytes) {
    const std::int64_t gone = std::min(bytes, cached);
    cached -= gone;
    account.add(MemoryAccount::pictures, -gone);
    return gone;
  });
  MemoryClaim claim(account);
  claim.reserve(4 * mega, "the test", {});
  EXPECT_EQ(claim.granted(), 4 * mega);
  EXPECT_EQ(account.waits(), 1);
  EXPECT_LT(claim.waited_ms(), 1000);
}

TEST(MemoryClaim, WaitsUntilOthersEndAndNotWhenItIsStopped) {
  MemoryAccount account(account_bytes);
  auto first = std::make_unique<MemoryClaim>(account);
  first->reserve(account.most_of_one(), "the test", {});
  std::jthread waiting([&] {
    MemoryClaim second(account);
    second.reserve(account.most_of_one(), "the test", {});
    EXPECT_GT(second.waited_ms(), 10);
  });
  EXPECT_TRUE(eventually([&] { return account.waiting() == 1; }));
  std::stop_source stop;
  std::jthread third([&] {
    MemoryClaim claim(account);
    EXPECT_THROW(claim.reserve(account.most_of_one(), "the test", stop.get_token()), Stopped);
  });
  EXPECT_TRUE(eventually([&] { return account.waiting() == 2; }));
  stop.request_stop();
  third.join();
  std::this_thread::sleep_for(milliseconds(20));
  EXPECT_EQ(account.waiting(), 1);
  first.reset();
}

// A small one needs no more than a 32nd, and an eighth is kept for such.
TEST(MemoryClaim, SmallOnesDoNotWaitForLargeOnes) {
  MemoryAccount account(account_bytes);
  MemoryClaim large(account);
  large.reserve(account.most_of_one(), "the test", {});
  std::stop_source stop;
  std::jthread waiting([&] {
    MemoryClaim second(account);
    EXPECT_THROW(second.reserve(account.most_small() + 1, "the test", stop.get_token()), Stopped);
  });
  EXPECT_TRUE(eventually([&] { return account.waiting() == 1; }));
  MemoryClaim small(account);
  small.reserve(account.most_small(), "the test", {});
  EXPECT_EQ(small.granted(), account_bytes / 32);
  stop.request_stop();
}

// What one client's posters hold leaves room for another's pictures.
TEST(MemoryClaim, OneClientsTogetherHaveHalfOfWhatOneMayHave) {
  MemoryAccount account(account_bytes);
  const std::int64_t half = account.most_of_client();
  MemoryClaim first(account, "a"), second(account, "a"), third(account, "a"), other(account, "b");
  first.reserve(half - 20 * mega, "this", {});
  second.reserve(20 * mega, "this", {});
  third.reserve(account.most_small(), "this", {});  // small ones always
  third.settle();
  std::atomic<bool> granted = false;
  std::jthread waiting([&] {
    MemoryClaim more(account, "a");
    more.reserve(20 * mega, "this", {});
    granted = true;
  });
  ASSERT_TRUE(eventually([&] { return account.waiting() == 1; }));
  other.reserve(40 * mega, "this", {});  // comes later and does not wait for it
  EXPECT_FALSE(granted);
  second.settle();
  waiting.join();
  EXPECT_TRUE(granted);
}

TEST(MemoryClaim, OneRequestAloneMayHaveMoreThanAClientsShare) {
  MemoryAccount account(account_bytes);
  MemoryClaim one(account, "a");
  EXPECT_NO_THROW(one.reserve(account.most_of_one(), "this", {}));
  EXPECT_EQ(account.waits(), 0);
}

// What a store lets go of was never the request's that pushes it out.
TEST(MemoryClaim, IsNotGivenWhatAStoreLetsGoOf) {
  MemoryAccount account(account_bytes);
  MemoryClaim claim(account);
  const ClaimScope scope(&claim);
  struct Seen {
    bool* had_claim;
    ~Seen() { *had_claim = MemoryClaim::current() != nullptr; }
  };
  bool had_claim = true;
  {
    LruMap<int, std::unique_ptr<Seen>> recent;
    recent.add(1, std::unique_ptr<Seen>(new Seen{&had_claim}));
    decltype(recent)::Entries surplus;
    recent.take_last(surplus);
  }
  EXPECT_FALSE(had_claim);
  EXPECT_EQ(MemoryClaim::current(), &claim);
}

TEST(MemoryClaim, IsTheRequestsWhoseThreadItIs) {
  MemoryAccount account(account_bytes);
  MemoryClaim outer(account), inner(account);
  EXPECT_EQ(MemoryClaim::current(), nullptr);
  {
    const ClaimScope scope(&outer);
    EXPECT_EQ(MemoryClaim::current(), &outer);
    const ClaimScope within(&inner);
    EXPECT_EQ(MemoryClaim::current(), &inner);
    Pool pool(2);
    pool.for_each(8, 2, {}, [&](int) { EXPECT_EQ(MemoryClaim::current(), &inner); });
  }
  EXPECT_EQ(MemoryClaim::current(), nullptr);
}

TEST(MemoryShare, AStoreHoldsNoMoreThanItsOwnBoundAndTheAccountsRestButAnEighth) {
  MemoryAccount account(account_bytes);
  const std::int64_t free = account.free();
  {
    MemoryShare share(100 * mega, &account, MemoryAccount::scenes);
    EXPECT_EQ(share.most(), static_cast<std::size_t>(100 * mega));
    share.book(static_cast<std::size_t>(60 * mega));
    EXPECT_EQ(account.held(MemoryAccount::scenes), 60 * mega);
    account.add(MemoryAccount::pictures, account.free() - account_bytes / 8 - 5 * mega);
    EXPECT_EQ(share.most(), static_cast<std::size_t>(65 * mega));
    share.book(static_cast<std::size_t>(10 * mega));
    account.add(MemoryAccount::pictures, -account.held(MemoryAccount::pictures));
  }
  EXPECT_EQ(account.free(), free);
  EXPECT_EQ(MemoryShare(7, nullptr, MemoryAccount::scenes).most(), 7U);
}

TEST(MemoryCosts, OfATextAreTheLargerOfItsBytesAndItsValues) {
  EXPECT_EQ(memory_for_text(0, 1000), 0);
  EXPECT_EQ(memory_for_text(30, 1000), 10 * memory_cost::value.bytes);
  EXPECT_EQ(memory_for_text(30, 5), 5 * memory_cost::value.bytes);
  EXPECT_EQ(memory_for_text(std::size_t{4} << 20, 100'000), memory_cost::text.bytes * (4 << 20));
  for (const MemoryCost& cost : memory_costs()) EXPECT_GT(cost.bytes, 0) << cost.step;
}

TEST(MemoryAccount, KeptScenesLeaveSmallRequestsTheirs) {
  MemoryAccount account(account_bytes);
  account.add(MemoryAccount::scenes, account.free() - account_bytes / 8);
  EXPECT_EQ(account.most_of_one(), account.most_small());
  MemoryClaim claim(account);
  EXPECT_THAT(refusal_of(claim, account.most_small() + 1), testing::HasSubstr("TIA_MEMORY_BYTES"));
  EXPECT_EQ(refusal_of(claim, account.most_small()), "");
}

// What kept scenes hold is nobody's to give: who asks for it would wait in vain.
TEST(MemoryAccount, KeptScenesAreNotThereForARequest) {
  MemoryAccount account(account_bytes);
  const std::int64_t most = account.most_of_one();
  account.add(MemoryAccount::scenes, 100 * mega);
  account.add(MemoryAccount::pressed, 50 * mega);  // which would give way
  EXPECT_EQ(account.most_of_one(), most - 100 * mega);
  MemoryClaim claim(account);
  EXPECT_THAT(refusal_of(claim, most), testing::HasSubstr("TIA_MEMORY_BYTES"));
  account.add(MemoryAccount::scenes, -100 * mega);
  account.add(MemoryAccount::pressed, -50 * mega);
  EXPECT_EQ(refusal_of(claim, most), "");
}

}  // namespace
}  // namespace tia::test
