// traceparent, by the examples and the rules of W3C Trace Context, sections 3.2 and 4.
#include "server/http/trace_context.h"

#include "tests/server/support.h"

namespace tia::test {
namespace {

using testing::MatchesRegex;

// Section 3.2.4's own example.
const std::string good = "00-4bf92f3577b34da6a3ce929d0e0e4736-00f067aa0ba902b7-01";

TEST(TraceContext, IsReadAndHandedOnWithAnIdOfItsOwn) {
  const auto context = trace_context(good);
  ASSERT_TRUE(context);
  EXPECT_EQ(context->trace_id, "4bf92f3577b34da6a3ce929d0e0e4736");
  EXPECT_EQ(context->parent_id, "00f067aa0ba902b7");
  EXPECT_NE(context->span_id, context->parent_id);
  EXPECT_EQ(context->traceparent(),
            "00-4bf92f3577b34da6a3ce929d0e0e4736-" + context->span_id + "-01");
  EXPECT_THAT(context->span_id, MatchesRegex("[0-9a-f]{16}"));
  EXPECT_NE(trace_context(good)->span_id, context->span_id);
}

TEST(TraceContext, HandsOnTheFlagsThatItKnows) {
  const std::string stem = good.substr(0, good.size() - 2);
  const std::pair<const char*, const char*> flags[] = {{"00", "00"}, {"01", "01"}, {"02", "02"},
                                                       {"03", "03"}, {"04", "00"}, {"ff", "03"}};
  for (const auto& [came, goes] : flags) EXPECT_EQ(trace_context(stem + came)->flags, goes) << came;
}

TEST(TraceContext, ReadsOfLaterVersionsWhatItKnows) {
  const std::string later = "cc" + good.substr(2);
  EXPECT_EQ(trace_context(later)->trace_id, trace_context(good)->trace_id);
  EXPECT_EQ(trace_context(later + "-what-the-future-will-be-like")->parent_id,
            trace_context(good)->parent_id);
  EXPECT_FALSE(trace_context(later + ".what-the-future-will-be-like"));
}

TEST(TraceContext, IsNoneWhereItIsNotValid) {
  std::string upper = good, dashes = good, digit = good;
  upper[5] = 'F';
  dashes[35] = '_';
  digit[40] = 'g';
  for (const std::string& bad :
       {std::string(), std::string("00"), good.substr(1), good.substr(0, good.size() - 1),
        good + "-", good + "-01", " " + good, "ff" + good.substr(2), upper, dashes, digit,
        "00-" + std::string(32, '0') + good.substr(35),
        good.substr(0, 36) + std::string(16, '0') + "-01"})
    EXPECT_FALSE(trace_context(bad)) << bad;
}

TEST(TraceContext, IsInEveryAnswerWhoseRequestHasOne) {
  for (const char* target :
       {"/healthz", "/render?width=8&height=8", "/render?width=x", "/nowhere"}) {
    Request request{"GET", target, {}, "", Host::id};
    EXPECT_FALSE(header(host().ask(request), "traceparent")) << target;
    request.trace = trace_context(good);
    EXPECT_EQ(header(host().ask(request), "traceparent"), request.trace->traceparent()) << target;
  }
}

}  // namespace
}  // namespace tia::test
