// Lists that copies share, and values on the heap: nobody sees another's change.
#include "core/input/shared_list.h"

#include <gtest/gtest.h>

#include "core/input/boxed.h"

namespace tia {
namespace {

TEST(SharedList, CopiesShareUntilOneIsChanged) {
  SharedList<std::string> first{"a", "b"};
  const SharedList<std::string> second = first;
  EXPECT_EQ(&first.get(), &second.get());
  EXPECT_EQ(first, second);
  first[0] = "c";
  EXPECT_NE(&first.get(), &second.get());
  EXPECT_EQ(second[0], "a");
  EXPECT_EQ(first.get(), (std::vector<std::string>{"c", "b"}));
  EXPECT_FALSE(first == second);
}

TEST(SharedList, OneThatNobodySharesIsChangedInPlace) {
  SharedList<int> list{1, 2, 3};
  const auto* const before = &list.get();
  list.push_back(4);
  list.emplace_back(5);
  list.pop_back();
  list.front() = 9;
  list.back() = 7;
  list.at(1) = 8;
  EXPECT_EQ(&list.get(), before);
  EXPECT_EQ(list.get(), (std::vector<int>{9, 8, 3, 7}));
}

TEST(SharedList, AnEmptyOneIsAListToo) {
  SharedList<int> none;
  EXPECT_TRUE(none.empty());
  EXPECT_EQ(none.size(), 0U);
  EXPECT_EQ(none.begin(), none.end());
  EXPECT_EQ(none, SharedList<int>(std::vector<int>{}));
  none.push_back(1);
  EXPECT_EQ(none.size(), 1U);
  none.clear();
  EXPECT_TRUE(none.empty());
}

TEST(Boxed, IsCopiedAndComparedAsItsValue) {
  Boxed<std::string> first(std::string("a"));
  Boxed<std::string> second = first;
  EXPECT_EQ(first, second);
  *second = "b";
  EXPECT_EQ(*first, "a");
  EXPECT_FALSE(first == second);
  first = second;
  EXPECT_EQ(*first, "b");
  EXPECT_EQ(first->size(), 1U);
  Boxed<std::string> third = std::move(second);
  second = third;  // what it was moved from can be assigned to
  EXPECT_EQ(second, third);
  EXPECT_LE(sizeof(Boxed<std::string>), sizeof(void*));
}

}  // namespace
}  // namespace tia
