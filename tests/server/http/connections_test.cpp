// Connections under hard use: too many, in a queue, left by their clients.
#include <sys/socket.h>

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <memory>
#include <mutex>

#include "tests/server/http/wire.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

const std::string asked = "GET / HTTP/1.1\r\nHost: x\r\n\r\n";

Application echo_target(bool at_once) {
  Application application = answering([](const Request& request) { return text(request.target); });
  application.at_once = [at_once](const Request&) { return at_once; };
  return application;
}

// ---- pipelining -----------------------------------------------------------------------------

TEST(Pipelining, AHundredRequestsAtOnceGetTheirAnswersInOrder) {
  for (const bool at_once : {true, false}) {
    Serving serving(echo_target(at_once));
    std::string all;
    for (int i = 0; i < 100; ++i)
      all += "GET /" + std::to_string(i) + " HTTP/1.1\r\nHost: x\r\n\r\n";
    Connection connection(serving.port());
    connection.send(all);
    for (int i = 0; i < 100; ++i) ASSERT_EQ(connection.receive().body, "/" + std::to_string(i));
  }
}

TEST(Pipelining, AnswersComeInOrderHoweverLongTheyTake) {
  Latch first;
  Serving serving(answering([&](const Request& request) {
    if (request.target == "/first") first.wait();
    return text(request.target);
  }));
  Wire wire(serving.port());
  wire.get("/first");
  wire.get("/second");
  EXPECT_FALSE(wire.readable(milliseconds(100)));
  first.open();
  EXPECT_THAT(wire.until("/first"), HasSubstr("\r\n\r\n/first"));
  EXPECT_THAT(wire.until("/second"), HasSubstr("\r\n\r\n/second"));
}

TEST(Pipelining, NothingIsAnsweredAfterARequestThatSaysClose) {
  Serving serving(echo_target(false));
  Connection connection(serving.port());
  connection.send("GET /a HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n" + asked);
  EXPECT_EQ(connection.receive().body, "/a");
  EXPECT_TRUE(connection.closed());
}

// Whose requests were answered, in order. One to /hold keeps the connections' thread until all that
// is to come has come.
struct Order {
  Latch all_have_come;
  std::atomic<bool> holds = false;
  std::string order;  // the connections' thread's, until the last answer has been read
  Application application() {
    Application application = answering([this](const Request& request) {
      if (request.target == "/hold") {
        holds = true;
        all_have_come.wait();
      } else {
        order += request.target[1];
      }
      return text(request.target);
    });
    application.at_once = [](const Request&) { return true; };
    return application;
  }
};

std::string many(const std::string& target, int count, const std::string& fields = "") {
  std::string all;
  for (int i = 0; i < count; ++i) all += "GET " + target + " HTTP/1.1\r\nHost: x\r\n\r\n";
  return all + "GET " + target + " HTTP/1.1\r\nHost: x\r\n" + fields + "\r\n";
}

TEST(Pipelining, ClientsThatSendManyRequestsAheadAreServedInTurn) {
  Order asked_in;
  Serving serving(asked_in.application());
  Wire holder(serving.port()), a(serving.port()), b(serving.port()), lone(serving.port());
  for (Wire* wire : {&a, &b, &lone}) {  // so that it has been let in
    wire->get("/x");
    wire->until("\r\n\r\n/x");
  }
  holder.get("/hold");
  ASSERT_TRUE(eventually([&] { return asked_in.holds.load(); }));
  a.send(many("/a", 99, "Connection: close\r\n"));
  b.send(many("/b", 99, "Connection: close\r\n"));
  lone.get("/1");
  asked_in.all_have_come.open();
  a.rest();
  b.rest();
  serving.stop(milliseconds(0), milliseconds(0));
  ASSERT_TRUE(serving.ends());
  const std::string order = asked_in.order.substr(3);
  ASSERT_EQ(order.size(), 201U);
  EXPECT_LT(order.find('1'), 8U) << order;
  int ahead = 0;
  for (const char who : order) {
    ahead += who == 'a' ? 1 : who == 'b' ? -1 : 0;
    ASSERT_LE(std::abs(ahead), 4) << order;
  }
}

// Held: an application whose requests to /held wait, and all others are answered.
struct Held {
  Latch let_go;
  std::atomic<int> at_work = 0;
  Application application() {
    Application application = answering([this](const Request& request) {
      if (request.target == "/held") {
        ++at_work;
        let_go.wait();
      }
      return text("done");
    });
    application.at_once = [](const Request& request) { return request.target == "/at-once"; };
    application.retry_after = [] { return 7; };
    return application;
  }
};

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
    wires.back()->send(asked);
    ASSERT_EQ(status_of(wires.back()->until("\r\n\r\n/")), 200);
  }
  wires[0]->send(asked);  // so that the second is the one that has waited longest
  ASSERT_EQ(status_of(wires[0]->until("\r\n\r\n/")), 200);
  Wire ninth(serving.port());
  ninth.send(asked);
  EXPECT_EQ(status_of(ninth.until("\r\n\r\n/")), 200);
  EXPECT_EQ(wires[1]->rest(), "");
  EXPECT_FALSE(wires[0]->readable());
  wires[0]->send(asked);
  EXPECT_EQ(status_of(wires[0]->until("\r\n\r\n/")), 200);
  EXPECT_LE(serving.connections(), 8);
}

TEST(Connections, AThousandSilentOnesDoNotKeepAnyoneOut) {
  Serving serving(echo_target(true), few(100));
  std::vector<std::unique_ptr<Wire>> silent;
  for (int i = 0; i < 400; ++i) silent.push_back(std::make_unique<Wire>(serving.port()));
  for (int i = 0; i < 10; ++i) EXPECT_EQ(exchange(serving.port(), asked).status, 200);
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
  ninth.send(asked);
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
  std::this_thread::sleep_for(milliseconds(1500));  // by their patience they have 8 s
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

HttpOptions one_worker() {
  HttpOptions options = any_port();
  options.workers = 1;
  return options;
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
    second.send(asked);
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
    second.send(asked);
    return second.receive().status == 200;
  }));
}

// ---- clients that leave ---------------------------------------------------------------------

// Abandoned: an application that works until nobody wants its answer.
struct Abandoned {
  std::atomic<bool> works = false;
  std::promise<Clock::time_point> stopped;
  Application application() {
    return answering([this](const Request& request) {
      std::mutex mutex;
      std::unique_lock lock(mutex);
      std::condition_variable_any never;
      works = true;
      never.wait(lock, request.stop, [] { return false; });
      stopped.set_value(Clock::now());
      return text("too late");
    });
  }
};

TEST(Leaving, StopsTheWorkWithin100Ms) {
  for (const bool resets : {false, true}) {
    Abandoned abandoned;
    std::atomic<int> status = 0;
    Application application = abandoned.application();
    application.answered = [&](const Exchange& done) { status = done.response.status; };
    Serving serving(application);
    Wire wire(serving.port());
    wire.send(asked);
    ASSERT_TRUE(eventually([&] { return abandoned.works.load(); }));
    if (resets) {
      const linger hard{1, 0};
      ::setsockopt(wire.descriptor(), SOL_SOCKET, SO_LINGER, &hard, sizeof hard);
    }
    const auto left = Clock::now();
    wire.leave();
    auto stopped = abandoned.stopped.get_future();
    ASSERT_EQ(stopped.wait_for(seconds(20)), std::future_status::ready);
    const std::chrono::duration<double, std::milli> took = stopped.get() - left;
    EXPECT_LT(took.count(), 100);
    EXPECT_TRUE(eventually([&] { return status == Application::client_left; }));
    EXPECT_TRUE(eventually([&] { return serving.connections() == 0; }));
  }
}

TEST(Leaving, IsNoticedAlsoWhereTheNextRequestHasBeenSent) {
  Abandoned abandoned;
  Serving serving(abandoned.application());
  Wire wire(serving.port());
  wire.send(asked + asked);
  ASSERT_TRUE(eventually([&] { return abandoned.works.load(); }));
  wire.leave();
  EXPECT_EQ(abandoned.stopped.get_future().wait_for(seconds(1)), std::future_status::ready);
}

// ---- the deadline ---------------------------------------------------------------------------

TEST(Deadline, IsKeptWithin50MsAndSaysWhenToAskAgain) {
  HttpOptions options = any_port();
  options.deadline = milliseconds(300);
  double nearest = 1e9;
  for (int i = 0; i < 5 && nearest > 350; ++i) {
    Abandoned abandoned;
    Serving serving(abandoned.application(), options);
    Connection connection(serving.port());
    const auto started = Clock::now();
    connection.send(asked);
    const Response late = connection.receive();
    const double took = ms_since(started);
    EXPECT_EQ(late.status, 503);
    EXPECT_EQ(problem_of(late).type, "/problems/timeout");
    EXPECT_THAT(problem_of(late).detail, HasSubstr("TIA_DEADLINE_MS"));
    EXPECT_EQ(header(late, "Retry-After"), "1");
    EXPECT_GE(took, 295);
    nearest = std::min(nearest, took);
    EXPECT_EQ(abandoned.stopped.get_future().wait_for(seconds(1)), std::future_status::ready);
  }
  EXPECT_LE(nearest, 350);
  RecordProperty("ms", static_cast<int>(nearest));
}

TEST(Deadline, LeavesTheConnectionToTheNextRequestAndTheWorkerOnceItStops) {
  Held held;
  HttpOptions options = one_worker();
  options.deadline = milliseconds(100);
  Serving serving(held.application(), options);
  Connection connection(serving.port());
  connection.send("GET /held HTTP/1.1\r\nHost: x\r\n\r\n");
  EXPECT_EQ(connection.receive().status, 503);
  connection.send(asked);
  EXPECT_EQ(connection.receive().status, 429);  // the worker does not listen
  held.let_go.open();
  EXPECT_TRUE(eventually([&] {
    connection.send(asked);
    return connection.receive().status == 200;
  }));
}

}  // namespace
}  // namespace tia::test
