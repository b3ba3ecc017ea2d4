// Request bodies over a real socket: how long they may be and how they may come.
#include <httplib.h>

#include <algorithm>
#include <cstdio>

#include "tests/server/http/request_forms.h"
#include "tests/server/socket_support.h"

namespace tia::test {
namespace {

constexpr std::size_t most_bytes = 4 << 20;  // the default of max_body_bytes

// {"width":8,"height":8} made that long with white space.
std::string body_of_size(std::size_t bytes) {
  std::string body = R"({"width":8,"height":8)";
  return body.append(bytes - body.size() - 1, ' ').append(1, '}');
}

std::string with_length(const std::string& body) {
  return forms::post("Content-Length: " + std::to_string(body.size()) + "\r\n", body);
}
// In chunks of 16 bytes to 64 KiB, whose sizes are in hexadecimal digits.
std::string chunked(const std::string& body) {
  std::string chunks;
  for (std::size_t at = 0, size = 16; at < body.size();
       at += size, size = std::min<std::size_t>(2 * size, 65536)) {
    const std::string chunk = body.substr(at, size);
    char digits[20];
    std::snprintf(digits, sizeof digits, "%zx\r\n", chunk.size());
    chunks += digits + chunk + "\r\n";
  }
  return forms::post("Transfer-Encoding: chunked\r\n", chunks + "0\r\n\r\n");
}

class Body : public testing::Test {
 protected:
  static Server& server() {
    static Server shared;
    return shared;
  }
  Response ask(const std::string& request) { return exchange(server().port(), request); }
  const std::string picture = server().host().get("/render?width=8&height=8").body;
};

TEST_F(Body, OfExactlyTheLimitIsRead) {
  for (const std::string& request :
       {with_length(body_of_size(most_bytes)), chunked(body_of_size(most_bytes))}) {
    const Response response = ask(request);
    EXPECT_EQ(response.status, 200);
    EXPECT_TRUE(response.body == picture);
  }
}

TEST_F(Body, OneByteLongerIs413NamingTheLimitAndItsOption) {
  for (const std::string& request :
       {with_length(body_of_size(most_bytes + 1)), chunked(body_of_size(most_bytes + 1))}) {
    const Response response = ask(request);
    EXPECT_EQ(response.status, 413);
    const Problem problem = problem_of(response);
    EXPECT_EQ(problem.type, "/problems/too-large");
    EXPECT_THAT(problem.detail, testing::HasSubstr("4194304"));
    EXPECT_THAT(problem.detail, testing::HasSubstr("TIA_MAX_BODY_BYTES"));
    EXPECT_EQ(ask("GET /healthz HTTP/1.1\r\nHost: x\r\n\r\n").status, 200);
  }
}

TEST_F(Body, TheLimitIsTheOptionsNotAConstant) {
  Server small({.host = "127.0.0.1", .port = 0, .max_body_bytes = 2000});
  EXPECT_EQ(exchange(small.port(), with_length(body_of_size(2000))).status, 200);
  EXPECT_EQ(exchange(small.port(), with_length(body_of_size(2001))).status, 413);
}

// Else the rest of a body would be read as requests, which another client's may be by then.
TEST_F(Body, AfterOneTooLongTheConnectionCloses) {
  const std::string next = "GET /version HTTP/1.1\r\nHost: x\r\n\r\n";
  Connection connection(server().port());
  connection.send(
      forms::post("Content-Length: " + std::to_string(most_bytes + 1 + next.size()) + "\r\n",
                  body_of_size(most_bytes + 1)));
  const Response refused = connection.receive();
  EXPECT_EQ(refused.status, 413);
  EXPECT_EQ(header(refused, "Connection"), "close");
  EXPECT_TRUE(header(refused, "X-Request-Id").has_value());
  connection.send(next);  // still the body
  EXPECT_TRUE(connection.closed());
}

TEST_F(Body, CutShortIsNotTakenForAWholeOne) {
  for (const char* head :
       {"Content-Length: 30\r\n\r\n{}", "Transfer-Encoding: chunked\r\n\r\n2\r\n{}"}) {
    Connection connection(server().port());
    connection.send("POST /render HTTP/1.1\r\nHost: x\r\n" + std::string(head));
    connection.finish();
    const int status = connection.receive().status;
    EXPECT_TRUE(status == 0 || status == 400 || status == 408) << status;
  }
}

TEST_F(Body, ThatStopsComingIsNotTakenForAWholeOne) {
  Connection connection(server().port());
  connection.send(forms::post("Content-Length: 30\r\n", "{}"));
  const int status = connection.receive().status;  // after the server's read deadline
  EXPECT_TRUE(status == 0 || status == 400 || status == 408) << status;
}

TEST_F(Body, ThatIsNotAnnouncedIsNotWaitedFor) {  // as of curl -X POST
  const auto start = Clock::now();
  EXPECT_EQ(ask("POST /render HTTP/1.1\r\nHost: x\r\n\r\n").status, 411);
  EXPECT_EQ(ask("PUT /render HTTP/1.1\r\nHost: x\r\n\r\n").status, 411);
  EXPECT_EQ(ask(forms::post("Content-Length: 0\r\n", "")).status, 415);
  EXPECT_LT(Clock::now() - start, seconds(4));
}

TEST_F(Body, OfALongCurlDIsReadAsJson) {  // declared as a form, beyond the library's 8 KiB
  const std::string type = "Content-Type: application/x-www-form-urlencoded\r\n";
  for (const std::size_t bytes :
       {std::size_t{100}, std::size_t{8192}, std::size_t{8193}, most_bytes}) {
    const std::string length = "Content-Length: " + std::to_string(bytes) + "\r\n";
    const Response response = ask(forms::post(type + length, body_of_size(bytes)));
    EXPECT_EQ(response.status, 200) << bytes;
    EXPECT_TRUE(response.body == picture) << bytes;
  }
}

TEST_F(Body, AfterExpectContinueIsReadToo) {
  auto client = server().client();
  const httplib::Headers expect{{"Expect", "100-continue"}};
  EXPECT_TRUE(plain("POST", "/render",
                    client.Post("/render", expect, body_of_size(most_bytes), "application/json"))
                  .body == picture);
}

TEST_F(Body, OfAnotherTypeIs415) {
  const std::string form =
      "--X\r\nContent-Disposition: form-data; name=\"key\"\r\n\r\na\r\n--X--\r\n";
  const std::string length = "Content-Length: " + std::to_string(form.size()) + "\r\n";
  for (const char* type : {"multipart/form-data", "text/plain"}) {
    const Response response =
        ask(forms::post("Content-Type: " + std::string(type) + "\r\n" + length, form));
    EXPECT_EQ(response.status, 415) << type;
  }
}

TEST_F(Body, ThatIsCompressedCannotGrowBeyondTheLimit) {
  httplib::Client client("127.0.0.1", server().port());
  client.set_compress(true);
  const auto result = client.Post("/render", body_of_size(32 * most_bytes), "application/json");
  ASSERT_TRUE(result);
  EXPECT_TRUE(result->status == 413 || result->status == 415) << result->status;
}

}  // namespace
}  // namespace tia::test
