// R17: a call of the C library fails in the program that serves, any time that it comes. The client
// gets the right answer, a 5xx, or at worst none; the next one is served as ever.
#include <signal.h>

#include <cerrno>

#include "tests/server/faults/faults_support.h"

namespace tia::test {
namespace {

// What a client may get while the call fails once.
enum class Least { right, problem, closed };

struct Row {
  BrokenCall how;
  Least least;
};
void PrintTo(const Row& row, std::ostream* out) { *out << name_of(row.how); }

const Row rows[] = {
    {{faults_accept, EMFILE}, Least::right},
    {{faults_accept, ENFILE}, Least::right},
    {{faults_accept, ENOBUFS}, Least::right},
    {{faults_accept, EINTR}, Least::right},
    {{faults_accept, ECONNABORTED}, Least::right},
    {{faults_epoll_wait, EINTR}, Least::right},
    {{faults_epoll_ctl, ENOSPC}, Least::closed},
    {{faults_ioctl, ENOMEM}, Least::closed},
    {{faults_setsockopt, ENOBUFS}, Least::right},
    {{faults_getpeername, ENOTCONN}, Least::right},
    {{faults_recv, EINTR}, Least::right},
    {{faults_recv, EAGAIN}, Least::right},
    {{faults_recv, 0}, Least::right},
    {{faults_recv, ECONNRESET}, Least::closed},
    {{faults_send, EINTR}, Least::right},
    {{faults_send, EAGAIN}, Least::right},
    {{faults_send, 0}, Least::right},
    {{faults_send, EPIPE}, Least::closed},
    {{faults_send, ECONNRESET}, Least::closed},
    {{faults_shutdown, ENOTCONN}, Least::right},
    {{faults_close, EINTR}, Least::right},
    {{faults_close, EIO}, Least::right},
    {{faults_poll, EINTR}, Least::right},
    {{faults_write, EINTR}, Least::right},
    {{faults_write, EAGAIN}, Least::right},
    {{faults_write, 0}, Least::right},
    {{faults_write, ENOSPC}, Least::right},
    {{faults_write, EIO}, Least::right},
    {{faults_malloc, ENOMEM}, Least::closed},
};

// A picture of more bytes than a socket takes at once.
const std::string small_request =
    "GET /render?format=pfm&width=320&height=240&key=a HTTP/1.1\r\n"
    "Host: x\r\nConnection: close\r\n\r\n";

constexpr milliseconds moment{50};

const char* const own_allocator = "has an allocator of its own";
const char* const slow = "takes a minute, and breaks what the test before it breaks";

class BrokenCalls : public testing::TestWithParam<Row> {
 protected:
  BrokenCalls() { due_ = exchange(tia_.port(), small_request).body; }
  std::size_t descriptors() const { return entries(tia_, "fd"); }

  Least answer(Connection& connection) {
    try {
      const Response response = connection.receive();
      if (response.status == 0) return Least::closed;
      if (response.status == 200) {
        EXPECT_TRUE(response.body == due_);
        return Least::right;
      }
      EXPECT_EQ(response.status / 100, 5);
      problem_of(response);
      return Least::problem;
    } catch (const std::runtime_error& error) {
      EXPECT_THAT(error.what(), testing::HasSubstr("cut"));
      return Least::closed;
    }
  }
  void expect_service() {
    const auto start = Clock::now();
    ASSERT_TRUE(tia_.running()) << tia_.wait().status << tia_.err();
    Connection connection(tia_.port());
    connection.send(small_request);
    EXPECT_EQ(answer(connection), Least::right);
    EXPECT_LT(Clock::now() - start, seconds(sanitized() ? 5 : 1));
  }

  void expect_all_given_back() {
    EXPECT_TRUE(eventually([&] { return descriptors() <= descriptors_; }));
    tia_.signal(SIGTERM);
    EXPECT_EQ(tia_.wait().status, 0);
  }

  Faults faults_;
  Tia tia_{{"--port", "0", "--threads", "2", "--cache-bytes", "0"}, faults_.environment()};
  const std::size_t descriptors_ = descriptors();
  std::string due_;
};

TEST_P(BrokenCalls, CostNoMoreThanTheirOwnAnswer) {
  if (sanitized() && GetParam().how.call == faults_malloc) GTEST_SKIP() << own_allocator;
  const auto& [how, least] = GetParam();
  long n = 1;
  for (bool failed = true; failed && n < 1000 && !HasFailure(); ++n) {
    SCOPED_TRACE(n);
    faults_.once(how, n);
    {
      const Connection silent(tia_.port());  // which must keep nobody waiting
      Connection connection(tia_.port());
      connection.send(small_request);
      EXPECT_LE(answer(connection), least);
    }
    // It may come after the answer: the first time it does.
    failed = eventually([&] { return faults_.failed() > 0; }, n == 1 ? seconds(20) : moment);
    faults_.end();
    expect_service();
  }
  RecordProperty("calls", static_cast<int>(n - 1));
  EXPECT_GT(n, 2);
  expect_all_given_back();
}

// It fails from then on, until two clients have asked; both know what became of them soon after.
TEST_P(BrokenCalls, ThatLastKeepNobodyWaitingOnceTheyAreOver) {
  if (sanitized()) GTEST_SKIP() << slow;
  const auto& [how, least] = GetParam();
  for (const long first : {1, 3, 30, 300}) {
    SCOPED_TRACE(first);
    faults_.begin(how, first);
    Connection one(tia_.port()), other(tia_.port());
    one.send(small_request);
    other.send(small_request);
    eventually([&] { return one.readable() && other.readable(); }, moment);
    faults_.end();
    const auto start = Clock::now();
    answer(one), answer(other);
    EXPECT_LT(Clock::now() - start, seconds(1));
    expect_service();
  }
  expect_all_given_back();
}

TEST_P(BrokenCalls, NowAndThenGiveNobodyAnothersOrHalfAnAnswer) {
  if (sanitized()) GTEST_SKIP() << slow;
  faults_.begin(GetParam().how, 1, Faults::ever, 7);
  {
    std::vector<std::jthread> clients;
    for (int c = 0; c < 4; ++c)
      clients.emplace_back([&] {
        for (int i = 0; i < 5; ++i) {
          Connection connection(tia_.port());
          connection.send(small_request);
          answer(connection);
        }
      });
  }
  faults_.end();
  expect_service();
  expect_all_given_back();
}

TEST(BrokenMemory, IsToldInOneLastAnswer) {
  if (sanitized()) GTEST_SKIP() << own_allocator;
  Faults faults;
  Tia tia({"--port", "0"}, faults.environment());
  Connection connection(tia.port());
  const std::string health = "GET /healthz HTTP/1.1\r\nHost: x\r\n\r\n";
  connection.send(health);
  ASSERT_EQ(connection.receive().status, 200);
  faults.begin({faults_malloc, ENOMEM});
  connection.send(health);
  const Response response = connection.receive();
  faults.end();
  EXPECT_EQ(response.status, 503);
  EXPECT_EQ(problem_of(response).type, "/problems/memory");
  EXPECT_TRUE(connection.closed());
  EXPECT_EQ(tia.get("/healthz").status, 200);
}

INSTANTIATE_TEST_SUITE_P(Of, BrokenCalls, testing::ValuesIn(rows),
                         [](const auto& one) { return name_of(one.param.how); });

}  // namespace
}  // namespace tia::test
