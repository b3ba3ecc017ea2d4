// How long a connection may take for what: slow clients are cut, steady ones are not.
#include "server/http/timeouts.h"

#include <map>

#include "tests/server/http/wire.h"

namespace tia::test {
namespace {

// Within 6 s where 5 s are allowed; the machine that tests may be busy with other things, too.
constexpr double earliest_ms = 4900, latest_ms = 7000;

Application echo() {
  return answering([](const Request& request) { return text(request.body); });
}

// What came, until the close, and when that was.
struct Ended {
  std::string bytes;
  double ms = 0;
};
using Client = std::function<void(Wire&)>;

std::future<Ended> start(int port, const Client& client) {
  return std::async(std::launch::async, [port, client] {
    Wire wire(port);
    const auto started = Clock::now();
    client(wire);
    Ended end{wire.rest(), 0};
    end.ms = ms_since(started);
    return end;
  });
}

// Sends the first part at once and then one byte after the other, until the server has enough.
Client dripping(const std::string& first, milliseconds pause) {
  return [first, pause](Wire& wire) {
    wire.send(first);
    while (!wire.readable(pause)) wire.send("a");
  };
}

TEST(Timeouts, OfFiveSecondsHasAServerForAHeadAndForABodyHoweverTheyDrip) {
  Serving serving(echo());
  const auto port = serving.port();
  const std::string half = "GET / HTTP/1.1\r\nX: ";
  std::map<std::string, std::future<Ended>> slow;
  slow["half a head"] = start(port, [&](Wire& wire) { wire.send(half); });
  slow["one byte"] = start(port, [&](Wire& wire) { wire.send("G"); });
  slow["a dripping head"] = start(port, dripping(half, milliseconds(100)));
  slow["half a body"] = start(port, [&](Wire& wire) { wire.send(forms::sized(" 9", "{")); });
  slow["no body"] = start(port, [&](Wire& wire) { wire.send(forms::sized(" 9", "")); });
  slow["half a chunk"] = start(port, [&](Wire& wire) { wire.send(forms::chunks("9\r\n{")); });
  slow["half a size"] = start(port, [&](Wire& wire) { wire.send(forms::chunks("9")); });
  slow["no trailer"] = start(port, [&](Wire& wire) { wire.send(forms::chunks("0\r\n")); });
  slow["a dripping body"] = start(port, dripping(forms::sized(" 999", ""), milliseconds(100)));
  slow["a body that began fast"] = start(port, [&](Wire& wire) {
    wire.send(forms::sized(" 4000000", std::string(1 << 20, ' ')));  // 16 s at the slowest rate
  });
  slow["a second head"] = start(port, [&](Wire& wire) { wire.send(forms::get("") + half); });
  for (auto& [name, future] : slow) {
    SCOPED_TRACE(name);
    const Ended end = future.get();
    EXPECT_GE(end.ms, earliest_ms);
    EXPECT_LE(end.ms, latest_ms);
    RecordProperty(name, static_cast<int>(end.ms));
    const std::size_t last = end.bytes.rfind("HTTP/1.1 ");
    ASSERT_NE(last, std::string::npos);
    EXPECT_EQ(status_of(end.bytes.substr(last)), 408);
    EXPECT_THAT(end.bytes.substr(last), testing::HasSubstr("/problems/slow"));
  }
}

TEST(Timeouts, AConnectionThatNeverSaysAnythingIsClosedWithoutAWord) {
  Serving serving(echo());
  const Ended end = start(serving.port(), [](Wire&) {}).get();
  EXPECT_EQ(end.bytes, "");
  EXPECT_GE(end.ms, earliest_ms);
  EXPECT_LE(end.ms, latest_ms);
}

// A head may take 5 s, an idle connection 30.
TEST(Timeouts, BetweenTwoRequestsIsLongerThanForOne) {
  Serving serving(echo());
  Wire idle(serving.port());
  idle.get("/");
  EXPECT_EQ(status_of(idle.until("\r\n\r\n")), 200);
  EXPECT_FALSE(idle.readable(milliseconds(7000)));
  idle.get("/");
  EXPECT_EQ(status_of(idle.until("\r\n\r\n")), 200);
}

TEST(Timeouts, ABodyThatComesSteadilyMayTakeLonger) {
  Serving serving(echo());
  constexpr std::size_t pieces = 70, bytes = 12 << 10;  // 7 s at 120 KiB/s
  Wire wire(serving.port());
  wire.send(forms::sized(" " + std::to_string(pieces * bytes), ""));
  const auto started = Clock::now();
  for (std::size_t i = 1; i <= pieces; ++i) {
    ASSERT_FALSE(wire.readable()) << ms_since(started);
    wire.send(std::string(bytes, 'x'));
    std::this_thread::sleep_until(started + i * milliseconds(100));  // what a slow line does
  }
  EXPECT_EQ(status_of(wire.until("\r\n\r\n")), 200);
}

// ---- clients that do not read ---------------------------------------------------------------

// A picture of 1024 x 1024 pixels in floats is larger than what the system takes off our hands. One
// of four times as many took a second to make where threads are watched, of the ten.
constexpr std::size_t large = 1024UL * 1024 * 12;

// A client that reads so many bytes, and then none.
void expect_cut_after(std::size_t bytes) {
  Serving serving(answering([](const Request&) { return text(std::string(large, 'x')); }));
  Wire wire(serving.port(), 4096);
  auto last = Clock::now();
  wire.get("/");
  ASSERT_TRUE(eventually([&] { return serving.connections() == 1; }));
  for (std::size_t got = 0; got < bytes; last = Clock::now()) got += wire.read(16 << 10).size();
  const bool cut = eventually([&] { return serving.connections() == 0; }, std::chrono::seconds(60));
  testing::Test::RecordProperty("ms", static_cast<int>(ms_since(last)));
  EXPECT_TRUE(cut);
  EXPECT_LE(ms_since(last), 11'000);
  EXPECT_LT(bytes + wire.rest().size(), large);
}

TEST(Timeouts, AClientThatDoesNotReadIsCutWithinTenSeconds) { expect_cut_after(0); }

// What it has read sooner than it had to gives it no longer pause.
TEST(Timeouts, AClientThatStopsReadingIsCutWithinTenSeconds) { expect_cut_after(4 << 20); }

// Parts that may take longer than answers, 100 ms here, of a client that reads and one that does
// not.
TEST(Timeouts, PartsThatMayTakeLongerGoOnWhileTheyAreTaken) {
  HttpOptions options = any_port();
  options.deadline = milliseconds(100);
  Serving serving(answering([](const Request& request) {
                    Response response{.content_type = "text/plain", .body = ""};
                    response.parts_deadline = std::chrono::minutes(1);
                    const bool is_long = request.target == "/long";
                    response.parts = [is_long](const SendPart& send) {
                      for (int i = 0; i < (is_long ? 1000 : 4); ++i) {
                        send(std::string(is_long ? 1 << 16 : 1, 'x'));
                        if (!is_long) std::this_thread::sleep_for(milliseconds(50));
                      }
                    };
                    return response;
                  }),
                  options);
  Wire idle(serving.port(), 4096), wire(serving.port());
  idle.get("/long");
  const auto asked = Clock::now();
  wire.get("/");
  EXPECT_THAT(wire.until("0\r\n\r\n"), testing::EndsWith("1\r\nx\r\n0\r\n\r\n"));
  wire.leave();
  EXPECT_TRUE(eventually([&] { return serving.connections() == 0; }, std::chrono::seconds(60)));
  EXPECT_GT(ms_since(asked), 7'000);
  EXPECT_LT(ms_since(asked), 11'000);
}

TEST(Timeouts, AClientThatReadsSlowlyButSteadilyGetsAll) {
  constexpr std::size_t size = 8 << 20;
  Serving serving(answering([](const Request&) { return text(std::string(size, 'x')); }));
  Wire wire(serving.port(), 64 << 10);
  wire.get("/");
  wire.until("\r\n\r\n");
  std::size_t got = 0;
  const auto started = Clock::now();
  for (int i = 1; got < size; ++i) {
    const std::size_t before = got;
    while (got < size && got < static_cast<std::size_t>(i) * (80 << 10)) {
      const std::string more = wire.read(16 << 10);
      if (more.empty()) break;
      got += more.size();
    }
    ASSERT_GT(got, before) << "cut after " << ms_since(started) << " ms";
    std::this_thread::sleep_until(started + i * milliseconds(100));  // 800 KiB/s: 10 s
  }
  EXPECT_EQ(got, size);
}

}  // namespace
}  // namespace tia::test
