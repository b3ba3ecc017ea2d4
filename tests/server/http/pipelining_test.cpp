// Requests that do not wait for the answers before them.
#include <atomic>
#include <cstdlib>

#include "tests/server/http/held.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

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
  connection.send("GET /a HTTP/1.1\r\nHost: x\r\nConnection: close\r\n\r\n" + plain_get);
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

std::string get_many(const std::string& target, int count, const std::string& fields = "") {
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
  a.send(get_many("/a", 99, "Connection: close\r\n"));
  b.send(get_many("/b", 99, "Connection: close\r\n"));
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

}  // namespace
}  // namespace tia::test
