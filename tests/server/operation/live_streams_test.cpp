// Places for live streams.
#include "server/operation/live_streams.h"

#include <gtest/gtest.h>

#include <list>

#include "server/http/error.h"

namespace tia::test {
namespace {

using server::HttpError;
using server::LiveStreams;

TEST(LiveStreams, AreAsManyAsTheOptionSaysAndOfOneClientAQuarter) {
  LiveStreams live(8);
  std::list<LiveStreams::Seat> seats;
  for (const char* client : {"a", "a", "b", "b", "c", "c", "d"}) seats.push_back(live.take(client));
  EXPECT_THROW(static_cast<void>(live.take("a")), HttpError) << "a third one";
  seats.push_back(live.take("d"));
  EXPECT_THROW(static_cast<void>(live.take("e")), HttpError) << "a ninth one";
  EXPECT_EQ(live.open(), 8);
  seats.erase(seats.begin());
  seats.push_back(live.take("a"));
  seats.clear();
  EXPECT_EQ(live.open(), 0);
}

TEST(LiveStreams, OfFewOneClientMayHaveOneAndOfNoneNobody) {
  LiveStreams few(2);
  const auto seat = few.take("a");
  EXPECT_THROW(static_cast<void>(few.take("a")), HttpError);
  EXPECT_EQ(few.open(), 1);
  LiveStreams none(0);
  EXPECT_THROW(static_cast<void>(none.take("a")), HttpError);
}

}  // namespace
}  // namespace tia::test
