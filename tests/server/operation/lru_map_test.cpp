// Values in the order in which they were last asked for.
#include "server/operation/lru_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <utility>
#include <vector>

#include "tests/core/support.h"

namespace tia::server {
namespace {

using Words = LruMap<std::string, int>;

TEST(LruMap, LetsGoFirstOfTheOneNotAskedForLongest) {
  Words words;
  for (const char* each : {"a", "b", "c"}) words.add(each, each[0]);
  EXPECT_EQ(*words.find("a"), 'a');
  EXPECT_TRUE(words.contains("b")) << "which asks for nothing";
  EXPECT_EQ(words.last(), 'b');
  Words::Entries out;
  words.take_last(out);
  words.take_last(out);
  ASSERT_EQ(out.size(), 2U);
  EXPECT_EQ(out.front().key + out.back().key, "bc");
  EXPECT_EQ(words.find("b"), nullptr);
  EXPECT_EQ(words.size(), 1U);
}

// Against a list that is searched from its start.
TEST(LruMap, IsAListInTheOrderOfUse) {
  test::Random random(64);
  LruMap<int, int> recent;
  std::vector<std::pair<int, int>> list;  // the last used last
  for (int i = 0; i < 5000; ++i) {
    const int key = random.below(30);
    const auto at =
        std::find_if(list.begin(), list.end(), [&](const auto& each) { return each.first == key; });
    const int* const found = recent.find(key);
    ASSERT_EQ(found != nullptr, at != list.end());
    if (found != nullptr) {
      ASSERT_EQ(*found, at->second);
      std::rotate(at, at + 1, list.end());
    } else {
      recent.add(key, i);
      list.emplace_back(key, i);
    }
    if (list.size() > 10) {
      ASSERT_EQ(recent.last(), list.front().second);
      LruMap<int, int>::Entries out;
      recent.take_last(out);
      EXPECT_EQ(out.front().key, list.front().first);
      list.erase(list.begin());
    }
    ASSERT_EQ(recent.size(), list.size());
  }
}

}  // namespace
}  // namespace tia::server
