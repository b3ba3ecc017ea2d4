// The service over a real socket: many requests a connection, many connections, ids, times.
#include "server/http/http_server.h"

#include <httplib.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <memory>
#include <new>

#include "server/contract/problem.h"
#include "tests/server/http/wire.h"

namespace tia::test {
namespace {

TEST(HttpServer, AnswersManyRequestsOnOneConnection) {
  Server server;
  Connection connection(server.port());
  for (int i = 0; i < 300; ++i) {
    const std::string id = std::string("n") + std::to_string(i);
    connection.send(std::string("GET /healthz HTTP/1.1\r\nHost: x\r\nX-Request-Id: ") + id +
                    "\r\n\r\n");
    const Response response = connection.receive();
    ASSERT_EQ(response.status, 200);
    ASSERT_EQ(header(response, "X-Request-Id"), id);
  }
}

TEST(HttpServer, AKeepAliveRoundTripDoesNotWaitForADelayedAck) {
  Server server;
  Connection connection(server.port());
  std::vector<double> ms;
  for (int i = 0; i < 20; ++i) {
    const auto start = Clock::now();
    connection.send("GET /healthz HTTP/1.1\r\nHost: x\r\n\r\n");
    ASSERT_EQ(connection.receive().status, 200);
    ms.push_back(std::chrono::duration<double, std::milli>(Clock::now() - start).count());
  }
  std::nth_element(ms.begin(), ms.begin() + 10, ms.end());
  EXPECT_LT(ms[10], 20);  // Nagle against delayed ACK: 40 and more
}

TEST(HttpServer, EveryBodyHasItsLength) {
  Server server;
  auto client = server.client();
  for (const char* target : {"/", "/style.css", "/render?width=37&height=23", "/scenes", "/healthz",
                             "/render?width=0", "/nowhere"}) {
    const Response response = plain("GET", target, client.Get(target));
    EXPECT_EQ(header(response, "Content-Length"), std::to_string(response.body.size())) << target;
    EXPECT_EQ(header(response, "Transfer-Encoding"), std::nullopt) << target;
  }
}

TEST(HttpServer, GivesTheHandlersBytes) {
  Server server;
  auto client = server.client();
  for (const char* target : {"/", "/render?key=a&width=75&height=50", "/scenes/thesis", "/version",
                             "/render?key=d&width=75&height=50&format=pfm"}) {
    const Response direct = server.host().get(target),
                   sent = plain("GET", target, client.Get(target));
    EXPECT_EQ(sent.status, direct.status) << target;
    EXPECT_EQ(sent.content_type, direct.content_type) << target;
    EXPECT_TRUE(sent.body == direct.body) << target;
  }
}

TEST(HttpServer, HeadHasTheHeadOfGetAndNoBody) {
  Server server;
  auto client = server.client();
  client.set_default_headers({{"X-Request-Id", Host::id}});
  for (const char* target : {"/", "/scenes", "/render", "/render?format=pfm", "/render?width=0"}) {
    const Response get = server.host().get(target),
                   head = plain("HEAD", target, client.Head(target));
    EXPECT_EQ(head.status, get.status) << target;
    EXPECT_EQ(head.content_type, get.content_type) << target;
    EXPECT_EQ(head.body, "") << target;
    EXPECT_EQ(header(head, "Accept-Ranges"), "none") << target;
    const std::string length = std::to_string(get.body.size());
    EXPECT_EQ(header(head, "Content-Length").value_or(length), length) << target;
    EXPECT_EQ(client.Get("/healthz")->body, R"({"status":"ok"})");  // nothing is left over
  }
}

struct Sent {
  const char* law;
  const char* id;
};
class RequestId : public testing::TestWithParam<Sent> {
 protected:
  static std::string answered(const std::string& id) {
    static Server server;
    const Response response =
        exchange(server.port(), std::string("GET /healthz HTTP/1.1\r\nHost: x\r\nX-Request-Id: ") +
                                    id + "\r\n\r\n");
    EXPECT_EQ(response.status, 200);
    return header(response, "X-Request-Id").value_or("");
  }
};
class FitRequestId : public RequestId {};
class UnfitRequestId : public RequestId {};

TEST_P(FitRequestId, IsEchoed) { EXPECT_EQ(answered(GetParam().id), GetParam().id); }
TEST_P(UnfitRequestId, IsReplacedByOneOfOurOwn) {
  const std::string first = answered(GetParam().id), second = answered(GetParam().id);
  EXPECT_THAT(first, testing::MatchesRegex("[0-9a-f]+"));
  EXPECT_NE(first, second);
}

constexpr const char* x64 = "xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx";
constexpr const char* x65 = "xxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxxx";
INSTANTIATE_TEST_SUITE_P(Of, FitRequestId,
                         testing::Values(Sent{"Word", "trace-1_a.B"}, Sent{"Longest", x64}),
                         law_of);
INSTANTIATE_TEST_SUITE_P(Of, UnfitRequestId,
                         testing::Values(Sent{"Empty", ""}, Sent{"TooLong", x65},
                                         Sent{"Space", "a b"}, Sent{"Quote", "a\"b"},
                                         Sent{"EncodedLineBreak", "a%0d%0aSet-Cookie:%20b=c"},
                                         Sent{"Tab", "a\tb"}, Sent{"Utf8", "\xC3\xA4"},
                                         Sent{"Html", "<script>"}),
                         law_of);

TEST(HttpServer, AProblemDocumentIsAnInstanceOfItsRequest) {
  Server server;
  const Response response =
      exchange(server.port(), "GET /nowhere HTTP/1.1\r\nHost: x\r\nX-Request-Id: abc\r\n\r\n");
  EXPECT_EQ(problem_of(response).instance, "abc");
  EXPECT_EQ(header(response, "X-Request-Id"), "abc");
}

TEST(HttpServer, ConcurrentClientsEachGetTheirOwnAnswer) {
  Server server;
  const std::vector<std::string> targets{"/render?key=a&width=64&height=48",
                                         "/render?key=d&width=64&height=48&format=pfm",
                                         "/render?width=75&height=50",
                                         "/render?key=w&width=40&height=30&threads=1",
                                         "/render?width=0",
                                         "/scenes/thesis",
                                         "/nowhere",
                                         "/style.css",
                                         "/healthz"};
  std::vector<Response> expected;
  for (const std::string& target : targets) expected.push_back(server.host().get(target));
  const std::string body = R"({"key":"s","width":64,"height":48})";
  const std::string posted = server.host().post("/render", body).body;

  std::atomic<int> wrong = 0, right = 0;
  std::vector<std::jthread> clients;
  for (std::size_t c = 0; c < 8; ++c)
    clients.emplace_back([&, c] {
      auto client = server.client();
      const httplib::Headers id{{"X-Request-Id", Host::id}};
      for (std::size_t i = 0; i < 25; ++i) {
        const std::size_t n = (c + i) % (targets.size() + 1);
        const bool post = n == targets.size();
        const auto result = post ? client.Post("/render", id, body, "application/json")
                                 : client.Get(targets[n], id);
        const bool same = result && result->status == (post ? 200 : expected[n].status) &&
                          result->body == (post ? posted : expected[n].body);
        ++(same ? right : wrong);
      }
    });
  clients.clear();
  EXPECT_EQ(wrong, 0);
  EXPECT_EQ(right, 200);
}

TEST(HttpServer, StopBeforeRunMakesRunReturn) {
  HttpServer server({.host = "127.0.0.1"}, {.answer = [](const Request&) { return Response{}; },
                                            .refuse = problem_response});
  alarm(20);  // it would wait for ever
  server.stop();
  server.run();
  alarm(0);
}

TEST(HttpServer, AFreePortIsFoundAndATakenOneRefused) {
  const Application nothing{.answer = [](const Request&) { return Response{}; },
                            .refuse = problem_response};
  HttpServer first({.host = "127.0.0.1"}, nothing);
  EXPECT_GT(first.port(), 0);
  try {
    HttpServer second({.host = "127.0.0.1", .port = first.port()}, nothing);
    FAIL() << "two servers on one port";
  } catch (const std::runtime_error& error) {
    EXPECT_THAT(error.what(), testing::HasSubstr(std::to_string(first.port())));
  }
}

// ---- want of memory -------------------------------------------------------------------------

Application without_memory(bool at_once) {
  Application application = answering([](const Request& request) -> Response {
    if (request.target == "/large") throw std::bad_alloc();
    return text("small");
  });
  application.at_once = [at_once](const Request&) { return at_once; };
  return application;
}

TEST(Memory, ThatAnAnswerLacksIs503AndTheConnectionGoesOn) {
  for (const bool at_once : {true, false}) {
    Serving serving(without_memory(at_once));
    Connection connection(serving.port());
    for (int i = 0; i < 3; ++i) {
      connection.send("GET /large HTTP/1.1\r\nHost: x\r\n\r\n");
      const Response response = connection.receive();
      EXPECT_EQ(response.status, 503);
      EXPECT_EQ(problem_of(response).type, "/problems/memory");
      EXPECT_TRUE(header(response, "Retry-After").has_value());
    }
    connection.send("GET /small HTTP/1.1\r\nHost: x\r\n\r\n");
    EXPECT_EQ(connection.receive().body, "small");
  }
}

// What is told of an exchange is told on the connections' own thread, in all of its states.
TEST(Memory, ThatTheConnectionsLackEndsNoMoreThanTheirOwnRequest) {
  for (const bool at_once : {true, false}) {
    Application application = without_memory(at_once);
    application.answered = [](const Exchange& done) {
      if (done.request.target == "/untold") throw std::bad_alloc();
    };
    HttpOptions options = any_port();
    options.deadline = milliseconds(200);
    Serving serving(application, options);
    Connection other(serving.port());
    std::vector<std::unique_ptr<Wire>> untold;
    for (int i = 0; i < 20; ++i) {  // some of them while they are let in
      untold.push_back(std::make_unique<Wire>(serving.port()));
      untold.back()->get("/untold");
      other.send("GET /small HTTP/1.1\r\nHost: x\r\n\r\n");
      ASSERT_EQ(other.receive().body, "small");
      ASSERT_EQ(exchange(serving.port(), "GET /small HTTP/1.1\r\nHost: x\r\n\r\n").status, 200);
    }
    for (const auto& wire : untold) EXPECT_NO_THROW(wire->rest(seconds(10)));
    serving.stop(milliseconds(0), milliseconds(100));
    EXPECT_TRUE(serving.ends());
  }
}

TEST(Memory, ThatANewConnectionLacksDoesNotShutTheDoor) {
  Latch let_go;
  std::atomic<int> at_work = 0, calls = 0;
  Application application = answering([&](const Request&) {
    ++at_work;
    let_go.wait();
    return text("done");
  });
  application.retry_after = [&] {  // asked while one is let in that has no place
    if (++calls <= 3) throw std::bad_alloc();
    return 7;
  };
  HttpOptions options = any_port();
  options.connections = 1;
  Serving serving(application, options);
  Connection busy(serving.port());
  busy.send("GET / HTTP/1.1\r\nHost: x\r\n\r\n");
  ASSERT_TRUE(eventually([&] { return at_work == 1; }));
  for (int i = 1; i <= 3; ++i) {
    Connection(serving.port()).send("GET / HTTP/1.1\r\nHost: x\r\n\r\n");
    ASSERT_TRUE(eventually([&] { return calls == i && serving.connections() == 1; }));
  }
  EXPECT_EQ(exchange(serving.port(), "GET / HTTP/1.1\r\nHost: x\r\n\r\n").status, 429);
  let_go.open();
  EXPECT_EQ(busy.receive().body, "done");
}

TEST(Answers, TellsALivingServerFromNone) {
  int port = 0;
  {
    Server server;
    port = server.port();
    EXPECT_TRUE(answers("127.0.0.1", port, "/healthz"));
    EXPECT_FALSE(answers("127.0.0.1", port, "/nowhere"));
  }
  EXPECT_FALSE(answers("127.0.0.1", port, "/healthz"));
}

}  // namespace
}  // namespace tia::test
