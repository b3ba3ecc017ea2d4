// Work that nobody waits for any more: clients that leave, the deadline.
#include <sys/socket.h>

#include <atomic>
#include <mutex>

#include "tests/server/http/held.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

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
    wire.send(plain_get);
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
  wire.send(plain_get + plain_get);
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
    connection.send(plain_get);
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
  connection.send(plain_get);
  EXPECT_EQ(connection.receive().status, 429);  // the worker does not listen
  held.let_go.open();
  EXPECT_TRUE(eventually([&] {
    connection.send(plain_get);
    return connection.receive().status == 200;
  }));
}

}  // namespace
}  // namespace tia::test
