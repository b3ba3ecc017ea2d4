// Bytes that are no request: a 4xx or a close, and the server lives.
#include "tests/server/socket_support.h"

namespace tia::test {
namespace {

void expect_alive() {
  EXPECT_EQ(exchange(shared_server().port(), "GET /healthz HTTP/1.1\r\nHost: x\r\n\r\n").status,
            200);
}

struct Raw {
  const char* law;
  std::string bytes;
};
void PrintTo(const Raw& raw, std::ostream* out) { *out << raw.law; }

class RawBytes : public testing::TestWithParam<Raw> {};

TEST_P(RawBytes, AreRefusedAndTheNextRequestGetsItsAnswer) {
  const Response response = exchange(shared_server().port(), GetParam().bytes);
  const bool unknown = response.status == 501 || response.status == 505;  // parts of HTTP
  EXPECT_TRUE(response.status == 0 || response.status / 100 == 4 || unknown) << response.status;
  if (response.status != 0) problem_of(response);
  expect_alive();
}

std::string all_bytes() {
  std::string bytes;
  for (int i = 255; i >= 0; --i) bytes += static_cast<char>(i);
  return bytes + "\r\n\r\n";
}
const std::string host_field = "Host: x\r\n\r\n";
const Raw raws[] = {
    {"EveryByte", all_bytes()},
    {"EmptyLines", "\r\n\r\n\r\n"},
    {"Words", "hello there\r\n\r\n"},
    {"TlsHello", std::string("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03", 11) + "\r\n\r\n"},
    {"Http2Preface", "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n"},
    {"NoVersion", "GET /healthz\r\n" + host_field},
    {"UnknownVersion", "GET /healthz HTTP/9.9\r\n" + host_field},
    {"UnknownMethod", "BREW /render HTTP/1.1\r\n" + host_field},
    {"LowerCaseMethod", "get /healthz HTTP/1.1\r\n" + host_field},
    {"FourWords", "GET /healthz and HTTP/1.1\r\n" + host_field},
    {"NulInTheTarget", std::string("GET /hea\0lthz HTTP/1.1\r\n", 24) + host_field},
    {"NoSlash", "GET healthz HTTP/1.1\r\n" + host_field},
    {"LongTarget", "GET /" + std::string(100'000, 'a') + " HTTP/1.1\r\n" + host_field},
    {"LongMethod", std::string(100'000, 'A') + " / HTTP/1.1\r\n" + host_field},
    {"LongHeader",
     "GET /healthz HTTP/1.1\r\nX: " + std::string(100'000, 'a') + "\r\n" + host_field},
    {"BadPercentInThePath", "GET /scenes/%zz HTTP/1.1\r\n" + host_field},
    {"BadPercentInTheQuery", "GET /render?key=%z HTTP/1.1\r\n" + host_field},
    {"BadChunk", "POST /render HTTP/1.1\r\nTransfer-Encoding: chunked\r\n" + host_field +
                     "zz\r\n{}\r\n0\r\n\r\n"},
    {"Trace", "TRACE /render HTTP/1.1\r\n" + host_field},
    {"Connect", "CONNECT x:80 HTTP/1.1\r\n" + host_field},
};
INSTANTIATE_TEST_SUITE_P(Of, RawBytes, testing::ValuesIn(raws), law_of);

TEST(RawBytes, AnAbandonedConnectionCostsNothing) {
  for (const char* bytes : {"", "G", "GET /healthz HTTP/1.1\r\nHost", "GET / HTTP/1.1\r\n",
                            "POST /render HTTP/1.1\r\nContent-Length: 99\r\n\r\n{",
                            "GET /render HTTP/1.1\r\nHost: x\r\n\r\n"}) {
    { Connection(shared_server().port()).send(bytes); }
    expect_alive();
  }
}

TEST(RawBytes, AUrlOfAnyLengthIs414NamingThePostForm) {
  for (const std::size_t bytes : {4097U, 8000U, 9000U, 60'000U}) {
    const Response response =
        exchange(shared_server().port(),
                 "GET /render?" + std::string(bytes - 8, 'a') + " HTTP/1.1\r\n" + host_field);
    EXPECT_EQ(response.status, 414) << bytes;
    EXPECT_THAT(problem_of(response).detail, testing::HasSubstr("POST /render")) << bytes;
  }
}

TEST(RawBytes, AMethodThatNoPathTakesIs405) {
  for (const char* method : {"PUT", "PATCH", "DELETE", "TRACE"}) {
    const Response response =
        exchange(shared_server().port(),
                 std::string(method) + " /render HTTP/1.1\r\nContent-Length: 0\r\n" + host_field);
    EXPECT_EQ(response.status, 405) << method;
    EXPECT_EQ(header(response, "Allow"), "GET, HEAD, POST, OPTIONS") << method;
  }
}

TEST(RawBytes, AMethodThatNobodyKnowsIs405AndLeavesTheConnectionToTheNext) {
  Connection connection(shared_server().port());
  for (const char* method : {"FOO", "get", "post", "PROPFIND"}) {
    connection.send(std::string(method) + " /render HTTP/1.1\r\n" + host_field);
    const Response response = connection.receive();
    EXPECT_EQ(response.status, 405) << method;
    EXPECT_EQ(header(response, "Allow"), "GET, HEAD, POST, OPTIONS") << method;
  }
  connection.send("GET /healthz HTTP/1.1\r\n" + host_field);
  EXPECT_EQ(connection.receive().status, 200);
}

TEST(RawBytes, ABadRequestLeavesTheConnectionToTheNext) {
  const std::string good = "GET /healthz HTTP/1.1\r\n" + host_field;
  for (const std::string& bad :
       {"GET /render?width=0 HTTP/1.1\r\n" + host_field, "GET /nowhere HTTP/1.1\r\n" + host_field,
        "DELETE /render HTTP/1.1\r\nContent-Length: 0\r\n" + host_field,
        "GET /render?key=%zz HTTP/1.1\r\n" + host_field,
        "GET /render?" + std::string(4100, 'a') + " HTTP/1.1\r\n" + host_field,
        "POST /render HTTP/1.1\r\nContent-Length: 2\r\n" + host_field + "{]",
        "POST /render HTTP/1.1\r\nContent-Length: 5\r\n" + host_field + "key=a",
        "POST /healthz HTTP/1.1\r\nContent-Length: 5\r\n" + host_field + "key=a"}) {
    SCOPED_TRACE(bad.substr(0, 60));
    Connection connection(shared_server().port());
    connection.send(bad);
    EXPECT_EQ(connection.receive().status / 100, 4);
    connection.send(good);
    EXPECT_EQ(connection.receive().status, 200);
  }
}

TEST(RawBytes, ARangeIsDroppedAndThePictureWhole) {
  const std::string picture = shared_server().host().get("/render?width=8&height=8").body;
  for (const char* range :
       {"bytes=0-3", "bytes=0-,0-,0-", "bytes=-1", "bytes=99999-", "bytes=abc", "bytes=5-2"}) {
    const Response response =
        exchange(shared_server().port(), "GET /render?width=8&height=8 HTTP/1.1\r\nRange: " +
                                             std::string(range) + "\r\n" + host_field);
    EXPECT_EQ(response.status, 200) << range;
    EXPECT_TRUE(response.body == picture) << range;
  }
}

}  // namespace
}  // namespace tia::test
