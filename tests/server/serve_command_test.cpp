// `tia serve` as a process: its first line, its port, its exit on a signal.
#include <fcntl.h>
#include <netinet/in.h>
#include <signal.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <sstream>

#include "core/version.h"
#include "tests/server/process_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

TEST(Serve, SaysItsVersionAndAddressInTheFirstLine) {
  for (const Process::Words& words :
       {Process::Words{"--port", "0"}, {"serve", "--port", "0"}, {"--port", "0", "serve"}}) {
    Tia tia(words);
    EXPECT_EQ(tia.first_line(), std::string("Tia ") + version() +
                                    " listening on http://127.0.0.1:" + std::to_string(tia.port()));
    EXPECT_GT(tia.port(), 0);
    EXPECT_EQ(tia.get("/healthz").status, 200);
  }
}

TEST(Serve, AnIPv6AddressStandsInBracketsInTheFirstLine) {  // RFC 3986, 3.2.2
  try {
    Tia tia({"--host", "::1", "--port", "0"});
    EXPECT_THAT(tia.first_line(), HasSubstr("http://[::1]:"));
  } catch (const std::runtime_error& error) {
    if (std::filesystem::exists("/proc/net/if_inet6")) throw;
    GTEST_SKIP() << "no IPv6 on this machine";
  }
}

class Ending : public testing::TestWithParam<int> {};

TEST_P(Ending, OfAnIdleServerIsASuccess) {
  Tia tia;
  EXPECT_EQ(tia.get("/healthz").status, 200);
  tia.signal(GetParam());
  const Finished end = tia.wait(seconds(10));
  EXPECT_EQ(end.status, 0);
  EXPECT_THAT(end.err, HasSubstr("\"target\":\"/healthz\""));  // the log, and no more
  EXPECT_EQ(std::count(end.err.begin(), end.err.end(), '\n'), 1);
}

TEST_P(Ending, RightAfterTheFirstLineIsASuccess) {
  for (int i = 0; i < 10; ++i) {
    Tia tia;
    tia.signal(GetParam());
    EXPECT_EQ(tia.wait(seconds(10)).status, 0);
  }
}

TEST_P(Ending, DoesNotWaitForAnIdleConnection) {
  Tia tia;
  Connection idle(tia.port());
  idle.send("GET /healthz HTTP/1.1\r\nHost: x\r\n\r\n");
  ASSERT_EQ(idle.receive().status, 200);
  Connection silent(tia.port());
  tia.signal(GetParam());
  const auto start = Clock::now();
  EXPECT_EQ(tia.wait(seconds(20)).status, 0);
  const std::chrono::duration<double> took = Clock::now() - start;
  RecordProperty("seconds", std::to_string(took.count()));
  EXPECT_LT(took.count(), 8);
  EXPECT_TRUE(idle.closed());
}

std::string signal_name(const testing::TestParamInfo<int>& info) {
  return info.param == SIGTERM ? "BySigterm" : "BySigint";
}
INSTANTIATE_TEST_SUITE_P(Of, Ending, testing::Values(SIGTERM, SIGINT), signal_name);

// Twice the pixels until the signal comes while they are traced.
TEST(Serve, FinishesARenderThatRunsWhenTheSignalComes) {
  for (int height = 1024; height <= 4096; height *= 2) {
    const std::string target =
        std::string("/render?key=a&width=4096&height=") + std::to_string(height);
    Tia other;
    const long rested = other.ticks();
    const std::string picture = other.get(target).body;
    const long cost = other.ticks() - rested;

    Tia tia;
    Connection connection(tia.port());
    const long before = tia.ticks();
    connection.send(std::string("GET ") + target + " HTTP/1.1\r\nHost: x\r\n\r\n");
    ASSERT_TRUE(
        eventually([&] { return tia.ticks() > before + cost / 4 || connection.readable(); }));
    tia.signal(SIGTERM);
    if (connection.readable() && height < 4096) continue;
    ASSERT_FALSE(connection.readable()) << "the largest picture was too quick";
    const Response response = connection.receive();
    EXPECT_EQ(tia.wait().status, 0);
    EXPECT_EQ(response.status, 200);
    EXPECT_TRUE(response.body == picture);
    return;
  }
}

// A pipe for the log, which holds some twenty lines, and 500 requests.
struct Piped {
  int read = -1, write = -1;
  Piped() {
    int ends[2];
    if (::pipe2(ends, O_CLOEXEC) != 0) throw std::runtime_error("no pipe");
    read = ends[0], write = ends[1];
    ::fcntl(write, F_SETPIPE_SZ, 4096);
  }
  ~Piped() { ::close(read); }
  static void ask(const Tia& tia) {
    Connection connection(tia.port());
    for (int i = 0; i < 500; ++i) {
      connection.send("GET /healthz HTTP/1.1\r\nHost: x\r\n\r\n");
      ASSERT_EQ(connection.receive().status, 200);
    }
  }
};

TEST(Serve, EndsThoughNobodyReadsItsLog) {
  Piped log;
  Tia tia({"--port", "0"}, {}, log.write);
  Piped::ask(tia);
  tia.signal(SIGTERM);
  const auto started = Clock::now();
  EXPECT_EQ(tia.wait(seconds(10)).status, 0);
  EXPECT_LT(Clock::now() - started, seconds(5));
  ::close(log.write);
}

TEST(Serve, LosesNoLineOfALogThatIsReadLateAndInPieces) {
  Piped log;
  Tia tia({"--port", "0"}, {}, log.write);
  ::close(log.write);
  Piped::ask(tia);
  tia.signal(SIGTERM);
  std::this_thread::sleep_for(milliseconds(200));
  std::string all(1 << 20, '\0');
  std::size_t size = 0;
  for (ssize_t n = 1; n > 0; size += static_cast<std::size_t>(n))
    n = ::read(log.read, all.data() + size, 1000);
  all.resize(size);
  EXPECT_EQ(tia.wait(seconds(10)).status, 0);
  EXPECT_EQ(std::count(all.begin(), all.end(), '\n'), 500);
  std::istringstream lines(all);
  for (std::string line; std::getline(lines, line);) EXPECT_NO_THROW(parse_json(line)) << line;
}

TEST(Serve, TakesNoNewConnectionOnceItHasEnded) {
  Tia tia;
  tia.signal(SIGTERM);
  EXPECT_EQ(tia.wait(seconds(10)).status, 0);
  EXPECT_THROW(Connection(tia.port()), std::runtime_error);
}

TEST(Serve, ASecondSignalEndsItAtOnce) {
  Tia tia;
  Connection busy(tia.port());
  const long before = tia.ticks();
  for (int i = 0; i < 3; ++i)
    busy.send("GET /render?key=a&width=4096&height=4096&format=pfm HTTP/1.1\r\nHost: x\r\n\r\n");
  ASSERT_TRUE(eventually([&] { return tia.ticks() > before + 1; }));
  tia.signal(SIGTERM);
  ASSERT_TRUE(eventually([&] {  // until the first has been taken
    tia.signal(SIGTERM);
    return !tia.running();
  }));
  EXPECT_EQ(tia.wait().status, 128 + SIGTERM);
}

TEST(Serve, ASecondTiaOnItsPortExits2AndTheFirstLives) {
  Tia first;
  const std::string port = std::to_string(first.port());
  for (const char* address : {"127.0.0.1", "0.0.0.0"}) {
    const Finished second = run({"--host", address, "--port", port});
    EXPECT_EQ(second.status, 2) << address;
    EXPECT_EQ(second.out, "") << address;
    EXPECT_THAT(second.err, HasSubstr(port));
    EXPECT_THAT(second.err, HasSubstr("in use"));
  }
  EXPECT_EQ(first.get("/healthz").status, 200);
}

TEST(Serve, APortThatAnotherProgramHasExits2) {
  const int socket = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
  sockaddr_in address{};
  address.sin_family = AF_INET;
  address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
  socklen_t size = sizeof address;
  ASSERT_EQ(::bind(socket, reinterpret_cast<sockaddr*>(&address), size), 0);
  ASSERT_EQ(::listen(socket, 1), 0);
  ASSERT_EQ(::getsockname(socket, reinterpret_cast<sockaddr*>(&address), &size), 0);
  const std::string port = std::to_string(ntohs(address.sin_port));
  const Finished end = run({"--port", port});
  ::close(socket);
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err, HasSubstr(port));
}

TEST(Serve, AnAddressOfAnotherMachineExits2) {
  const Finished end = run({"--host", "192.0.2.1", "--port", "0"});  // RFC 5737: nobody's
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err, HasSubstr("192.0.2.1"));
}

TEST(Serve, ANameOfNoMachineIsNotTakenForAnAddressInUse) {
  const Finished end = run({"--host", "a..invalid", "--port", "0"});
  EXPECT_EQ(end.status, 2);
  EXPECT_THAT(end.err, HasSubstr("a..invalid"));
  EXPECT_THAT(end.err, testing::Not(HasSubstr("in use")));
}

TEST(Serve, TheSamePortCanBeHadAgainAtOnce) {
  int port = 0;
  {
    Tia first;
    port = first.port();
    EXPECT_EQ(first.get("/healthz").status, 200);
    first.signal(SIGTERM);
    EXPECT_EQ(first.wait(seconds(10)).status, 0);
  }
  Tia second({"--port", std::to_string(port)});
  EXPECT_EQ(second.get("/healthz").status, 200);
}

TEST(Serve, TwoServersGiveTheSameBytes) {
  Tia one({"--port", "0", "--threads", "1"}), other({"--port", "0", "--threads", "5"});
  for (const char* target : {"/render?key=a&width=131&height=97", "/render?key=w&format=pfm",
                             "/render?key=w&format=hdr", "/scenes/thesis", "/version", "/"})
    EXPECT_TRUE(one.get(target).body == other.get(target).body) << target;
}

}  // namespace
}  // namespace tia::test
