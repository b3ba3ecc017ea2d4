// Laws of a head: what it says of the request, its body and its connection.
#include "server/http/head.h"

#include "server/contract/problem.h"
#include "tests/server/http/request_corpus.h"
#include "tests/server/http/request_forms.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

std::string fault_of_head(const std::string& text) {
  try {
    read_head(text);
  } catch (const HttpError& error) {
    return std::string(error.type());
  }
  return "";
}

TEST(Head, KeepsFieldsInOrderWithTheirCaseAndWithoutTheSpaceAround) {
  const Head head = read_head(forms::get("B:  x y\t\r\nb: z\r\nA:\r\n"));
  const Headers expected{{"Host", "x"}, {"B", "x y"}, {"b", "z"}, {"A", ""}};
  EXPECT_EQ(head.headers, expected);
}

TEST(Head, HasNoBodyUnlessOneIsAnnounced) {
  EXPECT_EQ(read_head(forms::get("")).body, Head::Body::none);
  EXPECT_EQ(read_head(forms::get("Content-Length: 0\r\n")).length, 0);
}

TEST(Head, TellsHowItsBodyComes) {
  const Head sized = read_head(forms::post("content-length: 0042\r\n"));
  EXPECT_EQ(sized.body, Head::Body::sized);
  EXPECT_EQ(sized.length, 42);
  EXPECT_EQ(read_head(forms::post("transfer-encoding: Chunked\r\n")).body, Head::Body::chunked);
}

TEST(Head, TheLongestLengthIsThatOf63Bits) {
  EXPECT_EQ(read_head(forms::post("Content-Length: 9223372036854775807\r\n")).length, INT64_MAX);
  EXPECT_EQ(fault_of_head(forms::post("Content-Length: 9223372036854775808\r\n")), "malformed");
}

TEST(Head, KeepsAConnectionOfHttp11UnlessItSaysClose) {
  EXPECT_TRUE(read_head(forms::get("")).keep_alive);
  EXPECT_TRUE(read_head(forms::get("Connection: keep-alive, closed\r\n")).keep_alive);
  EXPECT_FALSE(read_head(forms::get("connection: a , Close\r\n")).keep_alive);
  EXPECT_FALSE(read_head(forms::get("Connection: a\r\nConnection: close\r\n")).keep_alive);
  EXPECT_FALSE(read_head(forms::line("GET / HTTP/1.0")).keep_alive);
}

TEST(Head, ExpectsContinueOnlyInHttp11) {
  const std::string expect = "Expect: 100-continue\r\nContent-Length: 2\r\n";
  EXPECT_TRUE(read_head(forms::post(expect)).expects_continue);
  EXPECT_FALSE(read_head(forms::post("Content-Length: 2\r\n")).expects_continue);
  EXPECT_FALSE(read_head(forms::line("POST / HTTP/1.0", expect)).expects_continue);
}

TEST(Head, AnAbsoluteTargetIsItsPathAndQuery) {  // RFC 9112, 3.2.2
  for (const char* target : {"http://x/a?b", "https://x:80/a?b", "HTTP://x/a?b", "/a?b"})
    EXPECT_EQ(read_head(forms::line(std::string("GET ") + target + " HTTP/1.1")).target, "/a?b");
}

TEST(Head, TheHostOfAnAbsoluteTargetCounts) {  // RFC 9112, 3.2.2
  for (const char* target : {"http://other.example:80", "http://other.example:80/a", "/a"}) {
    const Head head = read_head(forms::line(std::string("GET ") + target + " HTTP/1.1"));
    const bool is_absolute = *target != '/';
    int hosts = 0;
    for (const auto& [name, value] : head.headers) {
      if (!same_word(name, "Host")) continue;
      ++hosts;
      EXPECT_EQ(value == "other.example:80", is_absolute) << target << ' ' << value;
    }
    EXPECT_EQ(hosts, 1);
  }
}

TEST(Head, OnlyOptionsMayBeOfAStar) {  // RFC 9112, 3.2.4
  EXPECT_EQ(read_head(forms::line("OPTIONS * HTTP/1.1")).target, "*");
  EXPECT_EQ(fault_of_head(forms::line("GET * HTTP/1.1")), "malformed");
  EXPECT_EQ(fault_of_head(forms::line("OPTIONS *x HTTP/1.1")), "malformed");
}

TEST(Head, NoControlCharacterMayStandAnywhere) {
  for (int code = 0; code < 256; ++code) {
    const auto c = static_cast<char>(code);
    const bool is_control = (code < ' ' && c != '\t') || code == 0x7f;
    if (!is_control) continue;
    SCOPED_TRACE(code);
    const std::string in_value = forms::get("X: a" + std::string(1, c) + "b\r\n");
    EXPECT_THROW(check_lines(in_value), HttpError);
    const std::string at_end = "X: a" + std::string(1, c);
    if (c == '\r') continue;  // a line end may be cut there
    EXPECT_THROW(check_lines(at_end), HttpError);
  }
  EXPECT_NO_THROW(check_lines(forms::get("X: \t \xc3\xa4\xff\r\n")));
}

TEST(Head, EveryByteOfANameMustBeOfAWord) {  // RFC 9110, 5.6.2
  const std::string word =
      "!#$%&'*+-.^_`|~0123456789abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ";
  for (int code = 1; code < 256; ++code) {
    const std::string name(1, static_cast<char>(code));
    if (name == ":" || name == "\r") continue;
    EXPECT_EQ(fault_of_head(forms::get(name + ": x\r\n")),
              word.find(name) != word.npos ? "" : "malformed")
        << code;
  }
}

}  // namespace
}  // namespace tia::test
