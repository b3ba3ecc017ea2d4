// Answers that are made in parts: sent while they are made, and only as fast as they are read.
#include <atomic>

#include "tests/server/http/parts_support.h"

namespace tia::test {
namespace {

using testing::EndsWith;
using testing::HasSubstr;
using testing::Not;

TEST(Parts, AreSentWhileTheNextIsMade) {
  Latch second;
  Serving serving(in_parts([&](const SendPart& send) {
    send("one");
    second.wait();
    send("two");
  }));
  Wire wire(serving.port());
  wire.send(plain_get);
  const std::string head = wire.until("\r\n\r\n");
  EXPECT_THAT(head, HasSubstr("Transfer-Encoding: chunked\r\n"));
  EXPECT_THAT(head, Not(HasSubstr("Content-Length")));
  const std::string first = wire.until("one\r\n");
  second.open();
  EXPECT_EQ(data_of(first + wire.until("0\r\n\r\n")), "onetwo");
  wire.send(plain_get);  // the connection goes on
  EXPECT_EQ(status_of(wire.until("\r\n\r\n")), 200);
}

TEST(Parts, AnEmptyOneDoesNotEndTheAnswer) {
  Serving serving(in_parts([](const SendPart& send) {
    send("");
    send("one");
    send("");
    send("two");
  }));
  Wire wire(serving.port());
  wire.send(plain_get);
  wire.until("\r\n\r\n");
  EXPECT_EQ(data_of(wire.until("\r\n0\r\n\r\n")), "onetwo");
}

TEST(Parts, OfNothingAreAnEmptyBody) {
  Serving serving(in_parts([](const SendPart&) {}));
  Wire wire(serving.port());
  wire.send(plain_get);
  wire.until("\r\n\r\n");
  EXPECT_EQ(wire.until("\r\n\r\n"), "0\r\n\r\n");
}

TEST(Parts, AreOneBodyWithItsLengthForHttp10) {
  Serving serving(in_parts([](const SendPart& send) {
    send("one");
    send("two");
  }));
  Wire wire(serving.port());
  wire.send(plain_get_1_0);
  const std::string answer = wire.rest();
  EXPECT_THAT(answer, HasSubstr("Content-Length: 6\r\n"));
  EXPECT_THAT(answer, Not(HasSubstr("Transfer-Encoding")));
  EXPECT_EQ(body_of(answer), "onetwo");
}

TEST(Parts, AreNotMadeForHead) {
  std::atomic<bool> made = false;
  Serving serving(in_parts([&](const SendPart&) { made = true; }));
  Wire wire(serving.port());
  wire.send("HEAD / HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n");
  const std::string answer = wire.rest();
  EXPECT_EQ(status_of(answer), 200);
  EXPECT_EQ(body_of(answer), "");
  EXPECT_FALSE(made);
}

TEST(Parts, WaitWhileTheClientDoesNotRead) {
  const std::string part(64 << 10, 'x');
  constexpr std::size_t count = 256;  // 16 MiB
  std::atomic<std::size_t> made = 0;
  Serving serving(in_parts([&](const SendPart& send) {
    for (std::size_t i = 0; i < count; ++i) {
      send(part);
      ++made;
    }
  }));
  Wire wire(serving.port(), 4096);
  wire.send(plain_get);
  std::size_t before = 0;
  while (eventually([&] { return made > before; }, milliseconds(300))) before = made;
  EXPECT_GT(made, 0U);
  EXPECT_LT(made, count / 2);  // the system's buffers are some MiB
  wire.until("\r\n\r\n");
  std::string chunks;
  while (!chunks.ends_with("\r\n0\r\n\r\n")) {
    const std::string more = wire.read(1 << 16);
    ASSERT_FALSE(more.empty());
    chunks += more;
  }
  EXPECT_EQ(made, count);
  EXPECT_EQ(data_of(chunks).value_or("").size(), count * part.size());
}

TEST(Parts, ThatBreakOffAreSeenToBeCut) {
  Serving serving(in_parts([](const SendPart& send) {
    send("one");
    throw std::runtime_error("broken");
  }));
  Wire wire(serving.port());
  wire.send(plain_get);
  const auto started = Clock::now();
  const std::string answer = wire.rest();
  EXPECT_LT(ms_since(started), 5000);
  EXPECT_EQ(status_of(answer), 200);
  EXPECT_THAT(answer, HasSubstr("one"));
  EXPECT_FALSE(data_of(body_of(answer)).has_value());
}

TEST(Parts, ThatBreakOffAre500ForHttp10) {
  Serving serving(in_parts([](const SendPart& send) {
    send("one");
    throw std::runtime_error("broken");
  }));
  testing::internal::CaptureStderr();
  const std::string answer = [&] {
    Wire wire(serving.port());
    wire.send(plain_get_1_0);
    return wire.rest();
  }();
  EXPECT_THAT(testing::internal::GetCapturedStderr(), HasSubstr("broken"));
  EXPECT_EQ(status_of(answer), 500);
  EXPECT_THAT(answer, Not(HasSubstr("broken")));
}

TEST(Parts, StopWithin100MsWhenTheClientLeaves) {
  std::promise<Clock::time_point> stopped;
  std::atomic<bool> works = false;
  Serving serving(in_parts([&](const SendPart& send) {
    try {
      for (;;) {
        send("x");
        works = true;
      }
    } catch (...) {
      stopped.set_value(Clock::now());
      throw;
    }
  }));
  Wire wire(serving.port());
  wire.send(plain_get);
  ASSERT_TRUE(eventually([&] { return works.load(); }));
  const auto left = Clock::now();
  wire.leave();
  auto end = stopped.get_future();
  ASSERT_EQ(end.wait_for(seconds(20)), std::future_status::ready);
  EXPECT_LT(std::chrono::duration<double>(end.get() - left).count(), 0.1);
}

TEST(Parts, AfterTheDeadlineAreSeenToBeCut) {
  HttpOptions options = any_port();
  options.deadline = milliseconds(200);
  Serving serving(in_parts([](const SendPart& send) {
                    for (;;) {  // until it is told to stop
                      send("one");
                      std::this_thread::sleep_for(milliseconds(5));
                    }
                  }),
                  options);
  Wire wire(serving.port());
  wire.send(plain_get);
  const auto started = Clock::now();
  const std::string answer = wire.rest();
  EXPECT_LT(ms_since(started), 5000);
  EXPECT_EQ(status_of(answer), 200);
  EXPECT_THAT(answer, HasSubstr("one"));
  EXPECT_FALSE(data_of(body_of(answer)).has_value());
}

}  // namespace
}  // namespace tia::test
