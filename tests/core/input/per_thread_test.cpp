#include "core/parallel/per_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <thread>

namespace tia {
namespace {

std::atomic<int> living = 0;

struct Counted {
  Counted() { ++living; }
  ~Counted() { --living; }
  Counted(const Counted&) = delete;
  Counted& operator=(const Counted&) = delete;
  int number = 0;
};

Counted& one() { return per_thread<Counted, struct One>(); }
Counted& other() { return per_thread<Counted, struct Other>(); }

TEST(PerThread, EachThreadHasItsOwnForEachUse) {
  std::thread([] {
    one().number = 1;
    other().number = 2;
    EXPECT_EQ(one().number, 1);
    EXPECT_EQ(other().number, 2);
    std::thread([] { EXPECT_EQ(one().number, 0); }).join();
    EXPECT_EQ(one().number, 1);
  }).join();
}

TEST(PerThread, AllEndWithTheThreadAndNotBefore) {
  const int before = living;
  std::thread([before] {
    one(), one(), other();
    EXPECT_EQ(living, before + 2);
  }).join();
  EXPECT_EQ(living, before);
}

}  // namespace
}  // namespace tia
