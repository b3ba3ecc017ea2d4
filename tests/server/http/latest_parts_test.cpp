// Parts that replace one another while a client is slow, and parts that end with a problem.
#include <atomic>
#include <thread>

#include "tests/server/http/parts_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

// ---- parts that replace one another ---------------------------------------------------------

TEST(LatestParts, ReachASlowClientAsFarAsItReads) {
  constexpr int count = 100;
  const std::string rest(1 << 20, 'x');
  const auto part = [&](int i) { return '<' + std::to_string(i) + '>' + rest; };
  Latch made;
  Serving serving(in_parts([&](const SendPart& send) {
    for (int i = 0; i < count; ++i) send.latest(part(i));  // 100 MiB, and waits for nobody
    made.open();
  }));
  Wire wire(serving.port(), 4096);
  wire.send(plain_get);
  made.wait();
  const auto data = [&] {
    wire.until("\r\n\r\n");
    std::string chunks;
    while (!chunks.ends_with("\r\n0\r\n\r\n")) chunks += wire.read(1 << 20);
    return data_of(chunks).value_or("");
  }();
  // One on its way, one more in the system's buffers, the last one.
  EXPECT_LE(data.size(), 4 * part(0).size());
  EXPECT_TRUE(data.ends_with(part(count - 1)));
  EXPECT_EQ(data[0], '<');
}

TEST(LatestParts, LeaveOthersInTheirPlace) {
  Serving serving(in_parts([&](const SendPart& send) {
    send("head ");
    for (const char* each : {"one ", "two ", "three "}) send.latest(each);
    send("middle ");
    send.latest("four ");
    send.latest("five");
  }));
  Wire wire(serving.port());
  wire.send(plain_get_1_0);  // which has them all at once
  EXPECT_EQ(body_of(wire.rest()), "head three middle five");
}

// The client's system, ours and the connection have some of them; what is not taken is not made.
TEST(LatestParts, AreMadeNoFasterThanTheyAreTaken) {
  const int count = test::sanitized() ? 4 : 20;
  std::atomic<int> made = 0;
  Serving serving(in_parts([&](const SendPart& send) {
    for (int i = 0; i < count; ++i) {
      send.latest(std::to_string(++made) + ' ' + std::string(2 << 20, 'x') + '\n');
      send.await_taken();
    }
  }));
  Wire wire(serving.port(), 4096);
  wire.send(plain_get);
  wire.until("\r\n\r\n");
  std::this_thread::sleep_for(milliseconds(50));  // in which all could be made
  EXPECT_LE(made, 3);
  const std::string data = [&] {
    std::string chunks;
    while (!chunks.ends_with("\r\n0\r\n\r\n")) chunks += wire.read(1 << 20);
    return data_of(chunks).value_or("");
  }();
  std::size_t at = 0;
  for (int i = 1; i <= count; ++i) {
    EXPECT_EQ(data.compare(at, std::to_string(i).size() + 1, std::to_string(i) + ' '), 0) << i;
    at = data.find('\n', at) + 1;
  }
}

TEST(LatestParts, MayComeFromAnotherThread) {
  Serving serving(
      in_parts([](const SendPart& send) { std::jthread([&] { send.latest("one"); }).join(); }));
  Wire wire(serving.port());
  wire.send(plain_get);
  wire.until("\r\n\r\n");
  EXPECT_EQ(data_of(wire.until("0\r\n\r\n")), "one");
}

// ---- problems ---------------------------------------------------------------------------------

TEST(Parts, WhatFailsBeforeTheFirstIsAnsweredAsEver) {
  Serving serving(in_parts([](const SendPart&) {
    throw HttpError("busy", "not now", {{"Retry-After", "3"}});
  }));
  Connection connection(serving.port());
  for (int i = 0; i < 2; ++i) {  // and the connection goes on
    connection.send(plain_get);
    const Response refused = connection.receive();
    EXPECT_EQ(refused.status, 429);
    EXPECT_EQ(header(refused, "Retry-After"), "3");
  }
}

TEST(Parts, MayEndWithAProblem) {
  for (const std::string end : {"busy", "timeout", "draining"}) {
    HttpOptions options = any_port();
    if (end == "timeout") options.deadline = milliseconds(200);
    Application application = answering([end](const Request& request) {
      Response response{.status = 200, .content_type = "text/plain", .body = ""};
      response.problem_part = [](const std::string& document) { return "problem " + document; };
      response.parts = [end, stop = request.stop](const SendPart& send) {
        send("one ");
        if (end == "busy") throw HttpError("busy", "not now");
        while (!stop.stop_requested()) std::this_thread::sleep_for(milliseconds(1));
      };
      return response;
    });
    Serving serving(application, options);
    Wire wire(serving.port());
    wire.send(plain_get);
    wire.until("\r\n\r\n");
    if (end == "draining") serving.stop(milliseconds(0), milliseconds(100));
    const std::string data = data_of(wire.rest()).value_or("");  // until the server closes
    EXPECT_THAT(data, testing::StartsWith("one problem {"));
    EXPECT_THAT(data, HasSubstr("/problems/" + end));
  }
}

}  // namespace
}  // namespace tia::test
