// R16 of the parts that all else is made of: what is cut short by a failed allocation leaves
// nothing behind, and comes off the next time.
#include <functional>
#include <new>
#include <string>
#include <system_error>
#include <thread>

#include "core/input/value.h"
#include "core/parallel/per_thread.h"
#include "core/parallel/pool.h"
#include "tests/memory/scarce_memory.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

// Does it while the first allocation fails, the second, …; until it comes off.
void expect_nothing_left_by(const std::function<void()>& act) {
  act();
  bool failed = true;
  for (long n = 1; failed; ++n) {
    SCOPED_TRACE(n);
    const long before = live_pieces();
    run_out_of_memory(n, Shortage::once);
    try {
      act();
      failed = false;
    } catch (const std::bad_alloc&) {
    } catch (const std::system_error&) {  // of a thread that cannot be started
    }
    EXPECT_EQ(end_shortage(), failed);
    ASSERT_EQ(live_pieces(), before);
  }
}

TEST(ScarcePieces, AValueIsCopiedOrNot) {
  const std::string text(40, 'x');
  const Value::Object object{{text, text}, {"a", Value::Array{1, text, Value()}}};
  const Value from = Value::Object{{"b", object}, {"c", text}, {text, true}};
  expect_nothing_left_by([&] { const Value to = from; });
  expect_nothing_left_by([&] {
    Value to = Value::Array{text, object};
    to = from;
  });
}

TEST(ScarcePieces, AThreadsOwnIsMadeOnceThereIsMemory) {
  struct Text {
    std::string is = std::string(40, 'x');
  };
  std::thread([] {
    run_out_of_memory(1, Shortage::lasting);
    EXPECT_THROW((per_thread<Text, struct Here>()), std::bad_alloc);
    EXPECT_TRUE(end_shortage());
    EXPECT_EQ((per_thread<Text, struct Here>().is.size()), 40U);
  }).join();
}

TEST(ScarcePieces, APoolIsMadeOrNot) {
  if (sanitized()) GTEST_SKIP() << "the sanitizer gives up where it has no memory for a thread";
  expect_nothing_left_by([] { Pool(4).for_each(9, 4, {}, [](int) {}); });
}

}  // namespace
}  // namespace tia::test
