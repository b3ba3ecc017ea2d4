// If-None-Match: a list of entity tags that compare weakly.
#include "server/requests/etag.h"

#include <gtest/gtest.h>

namespace tia::test {
namespace {

bool has(const std::string& if_none_match, const char* etag) {
  const server::Request request{"GET", "/", {{"If-None-Match", if_none_match}}, "", ""};
  return server::has_already(request, etag);
}

TEST(IfNoneMatch, ListsTagsThatCompareWeakly) {
  for (const char* list : {R"("a")", R"(W/"a")", R"("b", "a")", R"("b","a","c")", R"(W/"b",W/"a")",
                           R"("x,y" , "a")", " \"a\" ", R"("", "a")", "*"}) {
    EXPECT_TRUE(has(list, "\"a\"")) << list;
    EXPECT_TRUE(has(list, "W/\"a\"")) << list;
  }
}

TEST(IfNoneMatch, ListsNoOther) {
  for (const char* list : {"", R"("b")", R"("ab")", R"("a)", "a", R"("A")", R"("b, a")", R"("")",
                           R"("b", "a)", R"("*")", R"("x,"a",y")"})
    EXPECT_FALSE(has(list, "\"a\"")) << list;
}

TEST(IfNoneMatch, MayStandInSeveralFields) {
  const server::Request request{
      "GET", "/", {{"If-None-Match", "\"b\""}, {"if-none-match", "\"a\""}}, "", ""};
  EXPECT_TRUE(server::has_already(request, "\"a\""));
  EXPECT_FALSE(server::has_already({"GET", "/", {}, "", ""}, "\"a\""));
}

}  // namespace
}  // namespace tia::test
