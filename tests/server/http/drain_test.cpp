// How a server ends: what has come is answered, what is too slow is given up.
#include <atomic>

#include "tests/server/http/wire.h"

namespace tia::test {
namespace {

constexpr milliseconds no_delay{0}, patient = std::chrono::hours(1);

bool refuses(int port) {
  try {
    const Wire wire(port);
    return false;
  } catch (const std::runtime_error&) {
    return true;
  }
}

struct Waiting {
  Latch let_go;
  std::atomic<int> at_work = 0;
  Application application() {
    return answering([this](const Request&) {
      ++at_work;
      let_go.wait();
      return text("done");
    });
  }
};

TEST(Drain, ARequestAtWorkIsAnsweredAndItsConnectionClosed) {
  Waiting waiting;
  Serving serving(waiting.application());
  Connection connection(serving.port());
  connection.send(plain_get);
  ASSERT_TRUE(eventually([&] { return waiting.at_work == 1; }));
  serving.stop(no_delay, patient);
  EXPECT_TRUE(eventually([&] { return refuses(serving.port()); }));
  EXPECT_FALSE(serving.ends(milliseconds(50)));
  waiting.let_go.open();
  const Response response = connection.receive();
  EXPECT_EQ(response.status, 200);
  EXPECT_EQ(header(response, "Connection"), "close");
  EXPECT_TRUE(connection.closed());
  EXPECT_TRUE(serving.ends());
}

TEST(Drain, WhoHasSentRequestsAheadIsToldWhichIsTheLast) {
  Latch stopped;
  std::atomic<int> answered = 0;
  Application application = answering([&](const Request&) {
    if (++answered == 1) stopped.wait();
    return text("here");
  });
  application.at_once = [](const Request&) { return true; };
  Serving serving(application);
  Wire wire(serving.port());
  std::string ahead;
  for (int i = 0; i < 2000; ++i) ahead += plain_get;  // in one reading
  wire.send(ahead);
  ASSERT_TRUE(eventually([&] { return answered == 1; }));
  serving.stop(no_delay, patient);
  stopped.open();
  const std::string answers = wire.rest();
  const std::string last = answers.substr(answers.rfind("HTTP/1.1 "));
  EXPECT_THAT(last, testing::HasSubstr("Connection: close"));
  EXPECT_LT(answered, 2000);
  EXPECT_TRUE(serving.ends());
}

TEST(Drain, DuringItsDelayNewRequestsAreTaken) {
  Serving serving(answering([](const Request&) { return text("here"); }));
  const auto started = Clock::now();
  serving.stop(milliseconds(500), patient);
  while (ms_since(started) < 400) EXPECT_EQ(exchange(serving.port(), plain_get).status, 200);
  EXPECT_TRUE(eventually([&] { return refuses(serving.port()); }));
  EXPECT_GE(ms_since(started), 500);
  EXPECT_TRUE(serving.ends());
}

TEST(Drain, IdleConnectionsAreClosedAtOnce) {
  Serving serving(answering([](const Request&) { return text("here"); }));
  Connection idle(serving.port());
  idle.send(plain_get);
  EXPECT_EQ(idle.receive().status, 200);
  serving.stop(no_delay, patient);
  EXPECT_TRUE(idle.closed());
}

TEST(Drain, AConnectionThatHasJustComeMayStillAsk) {
  for (int i = 0; i < 20; ++i) {
    Serving serving(answering([](const Request&) { return text("here"); }));
    {
      Connection late(serving.port());
      serving.stop(no_delay, patient);
      late.send(plain_get);
      ASSERT_EQ(late.receive().status, 200);
      EXPECT_TRUE(late.closed());
    }
    EXPECT_TRUE(serving.ends());
  }
}

TEST(Drain, AfterItsLimitARequestAtWorkIsGivenUpWith503) {
  Waiting waiting;
  Serving serving(waiting.application());
  Connection connection(serving.port());
  connection.send(plain_get);
  ASSERT_TRUE(eventually([&] { return waiting.at_work == 1; }));
  const auto started = Clock::now();
  serving.stop(no_delay, milliseconds(200));
  const Response response = connection.receive();
  EXPECT_EQ(response.status, 503);
  EXPECT_EQ(problem_of(response).type, "/problems/draining");
  EXPECT_TRUE(header(response, "Retry-After").has_value());
  EXPECT_GE(ms_since(started), 195);
  EXPECT_LT(ms_since(started), 2000);
  EXPECT_TRUE(connection.closed());
  waiting.let_go.open();
  EXPECT_TRUE(serving.ends());
}

TEST(Drain, AfterItsLimitNoClientKeepsTheServerUp) {
  Serving serving(answering([](const Request&) { return text(std::string(48 << 20, 'x')); }));
  Wire half(serving.port()), silent(serving.port()), deaf(serving.port(), 4096);
  half.send("POST / HTTP/1.1\r\nHost: x\r\nContent-Length: 9\r\n\r\n{");
  deaf.send(plain_get);
  ASSERT_TRUE(deaf.readable(seconds(20)));
  const auto started = Clock::now();
  serving.stop(no_delay, milliseconds(200));
  EXPECT_TRUE(serving.ends(seconds(60)));
  RecordProperty("ms", static_cast<int>(ms_since(started)));
  EXPECT_LT(ms_since(started), 4000);
}

TEST(Drain, ASecondStopChangesNothing) {
  Waiting waiting;
  Serving serving(waiting.application());
  Connection connection(serving.port());
  connection.send(plain_get);
  ASSERT_TRUE(eventually([&] { return waiting.at_work == 1; }));
  serving.stop(no_delay, patient);
  serving.stop(no_delay, no_delay);
  EXPECT_FALSE(connection.readable(milliseconds(200)));
  waiting.let_go.open();
  EXPECT_EQ(connection.receive().status, 200);
}

}  // namespace
}  // namespace tia::test
