// The corpus over real sockets: what must be refused is, with a problem document and a close, and
// no byte after it is ever answered as a request; what must be read is answered.
#include <set>

#include "tests/server/http/request_corpus.h"
#include "tests/server/http/wire.h"
#include "tests/server/process_support.h"

namespace tia::test {
namespace {

using testing::AnyOf;
using testing::HasSubstr;
using testing::Not;

// Asks for what no other request of the tests asks for.
const std::string smuggled = "GET /version HTTP/1.1\r\nHost: x\r\nX-Request-Id: smuggled\r\n\r\n";

class Refused : public testing::TestWithParam<BadRequest> {};
class Accepted : public testing::TestWithParam<GoodRequest> {};

void expect_refusal(Connection& connection, int status) {
  const Response response = connection.receive();
  EXPECT_EQ(response.status, status);
  problem_of(response);
  EXPECT_EQ(header(response, "Connection"), "close");
  EXPECT_NE(header(response, "X-Request-Id"), "smuggled");
  EXPECT_TRUE(connection.closed());
}

TEST_P(Refused, WithAProblemAndACloseAndNothingAfterIsAnswered) {
  Connection connection(shared_server().port());
  connection.send(GetParam().bytes + smuggled);
  expect_refusal(connection, GetParam().status);
}

TEST_P(Refused, AlsoAfterAGoodRequestWhichIsAnswered) {
  Connection connection(shared_server().port());
  connection.send(forms::get("X-Request-Id: good\r\n") + GetParam().bytes + smuggled);
  const Response good = connection.receive();
  EXPECT_EQ(good.status, 200);
  EXPECT_EQ(header(good, "X-Request-Id"), "good");
  expect_refusal(connection, GetParam().status);
}

TEST_P(Refused, AlsoWhereItsBytesComeOneByOne) {
  const std::string bytes = GetParam().bytes + smuggled;
  const std::size_t piece = 1 + bytes.size() / 1000;  // of a flood it is some more
  Connection connection(shared_server().port());
  for (std::size_t at = 0; at < bytes.size(); at += piece) connection.send(bytes.substr(at, piece));
  expect_refusal(connection, GetParam().status);
}

TEST_P(Accepted, AndSoIsTheNextRequest) {
  const bool closes = GetParam().line.ends_with("close");
  Connection connection(shared_server().port());
  connection.send(GetParam().bytes + smuggled);
  const int status = connection.receive().status;
  EXPECT_THAT(status, AnyOf(200, 204, 404, 405, 415, 422, 400));  // by what it asks for
  if (closes) {
    EXPECT_TRUE(connection.closed());
  } else {
    const Response next = connection.receive();
    EXPECT_EQ(next.status, 200);
    EXPECT_EQ(header(next, "X-Request-Id"), "smuggled");
  }
}

INSTANTIATE_TEST_SUITE_P(Of, Refused, testing::ValuesIn(bad_requests()), law_of);
INSTANTIATE_TEST_SUITE_P(Of, Accepted, testing::ValuesIn(good_requests()), law_of);

TEST(Corpus, HoldsOver60RefusalsEachUnderANameOfItsOwn) {
  std::set<std::string> laws;
  for (const BadRequest& bad : bad_requests()) EXPECT_TRUE(laws.insert(bad.law).second) << bad.law;
  EXPECT_GE(laws.size(), 60U);
}

TEST(Target, Of4096BytesIsReadAndOneMoreIs414) {
  const auto ask = [](std::size_t bytes) {
    return forms::line("GET /" + std::string(bytes - 1, 'a') + " HTTP/1.1");
  };
  EXPECT_EQ(exchange(shared_server().port(), ask(4096)).status, 404);
  EXPECT_EQ(exchange(shared_server().port(), ask(4097)).status, 414);
}

// ---- floods ---------------------------------------------------------------------------------

long most_kilobytes() { return sanitized() ? 8192 : 2048; }

// A sanitizer keeps up to 256 MiB of what is freed for a while: as much as requests are answered
// before the socket is full, which is the kernel's to say.
Tia tia_that_frees(const Process::Words& arguments = {"--port", "0"}) {
  return Tia(arguments, {"ASAN_OPTIONS=quarantine_size_mb=1"});
}

void expect_little_memory(const char* what, const std::function<void(int)>& flood) {
  Tia tia = tia_that_frees();
  EXPECT_EQ(tia.get("/healthz").status, 200);
  EXPECT_EQ(tia.get("/nowhere").status, 404);
  const long before = kilobytes(tia, "VmHWM");
  flood(tia.port());
  const long more = kilobytes(tia, "VmHWM") - before;
  testing::Test::RecordProperty("kilobytes", static_cast<int>(more));
  EXPECT_LE(more, most_kilobytes()) << what;
  EXPECT_EQ(tia.get("/healthz").status, 200);
}

// Sends the same bytes until the server has had enough. Returns: how many it let come.
std::size_t pour(int port, const std::string& head, const std::string& bytes, std::size_t most) {
  Wire wire(port);
  wire.send(head);
  std::size_t sent = 0;
  while (sent < most && wire.send(bytes)) sent += bytes.size();
  return sent;
}

TEST(Flood, OfALineOf64MiBCostsLittleMemory) {
  expect_little_memory("a line", [](int port) {
    pour(port, "GET / HTTP/1.1\r\nHost: x\r\nX: ", std::string(1 << 20, 'a'), 64 << 20);
  });
}

TEST(Flood, OfAFirstLineOf64MiBCostsLittleMemory) {
  expect_little_memory("a first line",
                       [](int port) { pour(port, "GET /", std::string(1 << 20, 'a'), 64 << 20); });
}

TEST(Flood, Of200000LinesCostsLittleMemory) {
  expect_little_memory("lines", [](int port) {
    pour(port, "GET / HTTP/1.1\r\nHost: x\r\n", forms::fields(1000), 5 * 200'000);
  });
}

TEST(Flood, OfChunksThatGoOnForEverEndsAtTheLimit) {
  const std::string chunk = "10000\r\n" + std::string(65536, ' ') + "\r\n";
  Tia tia = tia_that_frees({"--port", "0", "--max-body-bytes", "100000"});
  EXPECT_EQ(tia.get("/healthz").status, 200);
  const long before = kilobytes(tia, "VmHWM");
  pour(tia.port(), forms::post("Transfer-Encoding: chunked\r\n"), chunk, 64 << 20);
  EXPECT_LE(kilobytes(tia, "VmHWM") - before, most_kilobytes());
}

TEST(Flood, OfRequestsThatAreNotWaitedForCostsLittleMemory) {
  expect_little_memory("requests", [](int port) {
    std::string many;
    for (int i = 0; i < 1000; ++i) many += forms::get("");
    Wire wire(port, 4096);  // and nothing is read
    std::size_t sent = 0;
    pollfd poll{wire.descriptor(), POLLOUT, 0};
    while (sent < (32U << 20U) && ::poll(&poll, 1, 500) > 0 && wire.offer(many) > 0)
      sent += many.size();
  });
}

}  // namespace
}  // namespace tia::test
