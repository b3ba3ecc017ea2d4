// More connections, requests and bodies than there is room for.
#include <algorithm>
#include <atomic>
#include <memory>

#include "tests/server/http/held.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

// ---- too many -------------------------------------------------------------------------------

HttpOptions few(int connections) {
  HttpOptions options = any_port();
  options.connections = connections;
  return options;
}

TEST(Connections, BeyondTheLimitTheOneThatHasWaitedLongestIsClosed) {
  Serving serving(echo_target(true), few(8));
  std::vector<std::unique_ptr<Wire>> wires;
  for (int i = 0; i < 8; ++i) {
    wires.push_back(std::make_unique<Wire>(serving.port()));
    wires.back()->send(plain_get);
    ASSERT_EQ(status_of(wires.back()->until("\r\n\r\n/")), 200);
  }
  wires[0]->send(plain_get);  // so that the second is the one that has waited longest
  ASSERT_EQ(status_of(wires[0]->until("\r\n\r\n/")), 200);
  Wire ninth(serving.port());
  ninth.send(plain_get);
  EXPECT_EQ(status_of(ninth.until("\r\n\r\n/")), 200);
  EXPECT_EQ(wires[1]->rest(), "");
  EXPECT_FALSE(wires[0]->readable());
  wires[0]->send(plain_get);
  EXPECT_EQ(status_of(wires[0]->until("\r\n\r\n/")), 200);
  EXPECT_LE(serving.connections(), 8);
}

TEST(Connections, AThousandSilentOnesDoNotKeepAnyoneOut) {
  Serving serving(echo_target(true), few(100));
  std::vector<std::unique_ptr<Wire>> silent;
  for (int i = 0; i < 400; ++i) silent.push_back(std::make_unique<Wire>(serving.port()));
  for (int i = 0; i < 10; ++i) EXPECT_EQ(exchange(serving.port(), plain_get).status, 200);
  EXPECT_LE(serving.connections(), 100);
}

TEST(Connections, WhereAllAreAtWorkANewOneIsTurnedAwayWith429) {
  Held held;
  Serving serving(held.application(), few(8));
  std::vector<std::unique_ptr<Connection>> busy;
  for (int i = 0; i < 8; ++i) {
    busy.push_back(std::make_unique<Connection>(serving.port()));
    busy.back()->send("GET /held HTTP/1.1\r\nHost: x\r\n\r\n");
  }
  ASSERT_TRUE(eventually([&] { return held.at_work == 8; }));
  Connection ninth(serving.port());
  ninth.send(plain_get);
  const Response refused = ninth.receive();
  EXPECT_EQ(refused.status, 429);
  EXPECT_EQ(header(refused, "Retry-After"), "7");
  EXPECT_EQ(problem_of(refused).type, "/problems/busy");
  EXPECT_THAT(problem_of(refused).detail, HasSubstr("TIA_CONNECTIONS"));
  EXPECT_TRUE(ninth.closed());
  held.let_go.open();
  for (auto& each : busy) EXPECT_EQ(each->receive().status, 200);
}

TEST(Connections, ThoseThatAreTurnedAwayMakeNoRoomForMoreThanTheLimit) {
  Held held;
  Serving serving(held.application(), few(2));
  std::vector<std::unique_ptr<Connection>> all;
  for (int i = 0; i < 10; ++i) {
    all.push_back(std::make_unique<Connection>(serving.port()));
    all.back()->send("GET /held HTTP/1.1\r\nHost: x\r\n\r\n");
    if (i < 2) ASSERT_TRUE(eventually([&] { return held.at_work == i + 1; }));
    else if (all.back()->readable(seconds(5))) EXPECT_EQ(all.back()->receive().status, 429);
    else break;
  }
  held.let_go.open();
  EXPECT_EQ(held.at_work, 2);
}

Application large_unless_small() {
  return answering([](const Request& request) {
    return text(request.target == "/small" ? "small" : std::string(16 << 20, 'x'));
  });
}

TEST(Connections, OneWhoseClientTakesNothingMakesRoom) {
  Serving serving(large_unless_small(), few(4));
  std::vector<std::unique_ptr<Wire>> deaf;
  for (int i = 0; i < 4; ++i) {
    deaf.push_back(std::make_unique<Wire>(serving.port(), 4096));
    deaf.back()->get("/");
    ASSERT_TRUE(deaf.back()->readable(seconds(20)));
  }
  std::this_thread::sleep_for(milliseconds(1500));  // by their timeout they have 8 s
  EXPECT_EQ(exchange(serving.port(), "GET /small HTTP/1.1\r\nHost: x\r\n\r\n").status, 200);
}

TEST(Connections, OneWhoseClientTakesItsAnswerSlowlyKeepsItsPlace) {
  Serving serving(large_unless_small(), few(2));
  Wire slow(serving.port(), 64 << 10), deaf(serving.port(), 4096);
  slow.get("/");
  slow.until("\r\n\r\n");
  deaf.get("/");
  ASSERT_TRUE(deaf.readable(seconds(20)));
  std::size_t got = 0;
  for (const auto started = Clock::now(); ms_since(started) < 2500;
       std::this_thread::sleep_for(milliseconds(20)))
    got += slow.read(64 << 10).size();
  EXPECT_EQ(exchange(serving.port(), "GET /small HTTP/1.1\r\nHost: x\r\n\r\n").status, 200);
  while (got < (16U << 20U)) {
    const std::string more = slow.read(1 << 20);
    ASSERT_NE(more, "");
    got += more.size();
  }
}

// Else as many bodies as there are connections would lie in memory until their last bytes come.
TEST(Connections, TogetherHoldNoMoreThanTheLimit) {
  constexpr std::size_t size = 128 << 10;
  HttpOptions options = any_port();
  options.max_body_bytes = size;
  options.most_held_bytes = 16 * size;
  Serving serving(
      answering([](const Request& request) { return text(std::to_string(request.body.size())); }),
      options);
  std::vector<std::unique_ptr<Connection>> all;
  for (int i = 0; i < 40; ++i) {
    all.push_back(std::make_unique<Connection>(serving.port()));
    all.back()->send(forms::sized(" " + std::to_string(size), std::string(size - 1, 'x')));
  }
  const auto has_answer = [](const auto& each) { return each->readable(); };
  ASSERT_TRUE(eventually([&] { return std::count_if(all.begin(), all.end(), has_answer) >= 24; },
                         seconds(4)));
  int refused = 0, read = 0;
  for (auto& each : all) {
    each->send("x");
    const Response response = each->receive();
    ++(response.status == 429 ? refused : read);
    if (response.status == 200) EXPECT_EQ(response.body, std::to_string(size));
    else EXPECT_TRUE(header(response, "Retry-After").has_value());
  }
  EXPECT_GE(refused, 24);
  EXPECT_GE(read, 4);  // memory comes in larger pieces than bodies do
}

// ---- workers --------------------------------------------------------------------------------

TEST(Workers, TheLastAreForClientsThatHaveFewerThanTwo) {
  Held held;
  HttpOptions options = any_port();
  options.workers = 4;
  options.spare_workers = 1;
  options.trusts_proxy = [](const std::string&) { return true; };
  options.share_of = [](const std::string& address) { return address; };
  Serving serving(held.application(), options);
  const auto held_by = [](const std::string& client) {
    return "GET /held HTTP/1.1\r\nHost: x\r\nX-Forwarded-For: " + client + "\r\n\r\n";
  };
  std::vector<std::unique_ptr<Connection>> connections;
  const auto ask = [&](const std::string& client) -> Connection& {
    connections.push_back(std::make_unique<Connection>(serving.port()));
    connections.back()->send(held_by(client));
    return *connections.back();
  };
  for (int i = 0; i < 3; ++i) ask("10.0.0.1");
  ASSERT_TRUE(eventually([&] { return held.at_work == 3; }));
  EXPECT_EQ(ask("10.0.0.1").receive().status, 429);
  Connection& other = ask("10.0.0.2");
  ASSERT_TRUE(eventually([&] { return held.at_work == 4; }));
  EXPECT_EQ(ask("10.0.0.3").receive().status, 429);  // there is none
  held.let_go.open();
  EXPECT_EQ(other.receive().status, 200);
  EXPECT_EQ(connections[0]->receive().status, 200);
}

TEST(Workers, WhereAllAreTakenOneIsRefusedWith429WithinTenMs) {
  Held held;
  Serving serving(held.application(), one_worker());
  Connection first(serving.port());
  first.send("GET /held HTTP/1.1\r\nHost: x\r\n\r\n");
  ASSERT_TRUE(eventually([&] { return held.at_work == 1; }));
  double quickest = 1e9;
  Connection second(serving.port());
  for (int i = 0; i < 20; ++i) {
    const auto started = Clock::now();
    second.send(plain_get);
    const Response refused = second.receive();
    quickest = std::min(quickest, ms_since(started));
    EXPECT_EQ(refused.status, 429);
    EXPECT_EQ(header(refused, "Retry-After"), "7");
    EXPECT_EQ(problem_of(refused).type, "/problems/busy");
  }
  EXPECT_LT(quickest, 10);
  RecordProperty("microseconds", static_cast<int>(quickest * 1000));
  second.send("GET /at-once HTTP/1.1\r\nHost: x\r\n\r\n");
  EXPECT_EQ(second.receive().status, 200);
  held.let_go.open();
  EXPECT_EQ(first.receive().status, 200);
  EXPECT_TRUE(eventually([&] {
    second.send(plain_get);
    return second.receive().status == 200;
  }));
}

}  // namespace
}  // namespace tia::test
