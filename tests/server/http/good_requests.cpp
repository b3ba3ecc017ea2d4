#include "tests/server/http/good_requests.h"

#include <ostream>

#include "tests/server/http/request_forms.h"

namespace tia::test {

void PrintTo(const GoodRequest& good, std::ostream* out) { *out << good.law; }

const std::vector<GoodRequest>& good_requests() {
  using namespace forms;
  const Text got = "GET /healthz 1.1 keep", posted = "POST /render 1.1 keep";
  static const std::vector<GoodRequest> all{
      {"Get", get(""), got},
      {"AfterAnEmptyLine", "\r\n" + get(""), got},
      {"NoSpaceAfterTheColon", host("x"), got},
      {"SpacesAroundAValue", host(" \t x \t "), got},
      {"EmptyHost", host(""), got},
      {"HostWithAPort", host(" x:80"), got},
      {"HostOfIPv4", host(" 127.0.0.1:8080"), got},
      {"HostOfIPv6", host(" [::1]:8080"), got},
      {"HostInLowerCase", line("GET /healthz HTTP/1.1", "host: x\r\n"), got},
      {"EmptyValue", get("X:\r\n"), got},
      {"ValueBeyondAscii", get("X: \xc3\xa4\xff\r\n"), got},
      {"TabInAValue", get("X: a\tb\r\n"), got},
      {"NameOfMarks", get("!#$%&'*+-.^_`|~09aZ: x\r\n"), got},
      {"TheSameFieldTwice", get("Accept: a\r\nAccept: b\r\n"), got},
      {"LengthOfNothingOfAGet", get("Content-Length: 0\r\n"), got},
      {"Fields100", get(fields(99)), got},
      {"Query", line("GET /render?a=b&c=%20?/ HTTP/1.1"), "GET /render?a=b&c=%20?/ 1.1 keep"},
      {"TwoSlashes", line("GET //x/../y HTTP/1.1"), "GET //x/../y 1.1 keep"},
      {"Absolute", line("GET http://x:80/healthz HTTP/1.1"), got},
      {"AbsoluteOfTls", line("GET https://x/healthz HTTP/1.1"), got},
      {"AbsoluteInUpperCase", line("GET HTTP://X/healthz HTTP/1.1"), got},
      {"AbsoluteWithoutAPath", line("GET http://x HTTP/1.1"), "GET / 1.1 keep"},
      {"AbsoluteWithOnlyAQuery", line("GET http://x?a=b HTTP/1.1"), "GET /?a=b 1.1 keep"},
      {"StarOfOptions", line("OPTIONS * HTTP/1.1"), "OPTIONS * 1.1 keep"},
      {"UnknownMethod", line("BREW /tea HTTP/1.1", "Host: x\r\nContent-Length: 0\r\n"),
       "BREW /tea 1.1 keep"},
      {"UnknownMethodWithoutALength", line("BREW /tea HTTP/1.1"), "BREW /tea 1.1 keep"},
      {"UnknownMethodOfHttp10", line("BREW /tea HTTP/1.0"), "BREW /tea 1.0 close"},
      {"MethodInLowerCase", line("get /healthz HTTP/1.1"), "get /healthz 1.1 keep"},
      {"Close", get("Connection: close\r\n"), "GET /healthz 1.1 close"},
      {"CloseInAList", get("Connection: X, CLOSE\r\n"), "GET /healthz 1.1 close"},
      {"CloseInASecondField", get("Connection: x\r\nConnection: close\r\n"),
       "GET /healthz 1.1 close"},
      {"NotQuiteClose", get("Connection: closed, enclose\r\n"), got},
      {"Http10", line("GET /healthz HTTP/1.0", ""), "GET /healthz 1.0 close"},
      {"Sized", sized(" 2"), posted, "{}"},
      {"SizedZero", sized(" 0", ""), posted},
      {"SizedWithZeros", sized(" 0002"), posted, "{}"},
      {"SizedWithoutSpace", sized("2\t"), posted, "{}"},
      {"SizedLineEnds", sized(" 6", "\r\n\r\n\n\r"), posted, "\r\n\r\n\n\r"},
      {"SizedNuls", sized(" 3", zeros(3)), posted, zeros(3)},
      {"SizedIdentity", post("Content-Encoding: identity\r\nContent-Length: 2\r\n", "{}"), posted,
       "{}"},
      {"SizedOfHttp10", line("POST /render HTTP/1.0", "Content-Length: 2\r\n") + "{}",
       "POST /render 1.0 close", "{}"},
      {"Expecting", post("Expect: 100-Continue\r\nContent-Length: 2\r\n", "{}"), posted, "{}"},
      {"Chunked", chunks("2\r\n{}\r\n0\r\n\r\n"), posted, "{}"},
      {"ChunkedInUpperCase", coded(" CHUNKED"), posted, "{}"},
      {"ChunkedWithoutSpace", coded("chunked\t"), posted, "{}"},
      {"ChunkedOfNothing", chunks("0\r\n\r\n"), posted},
      {"ChunkedManyZeros", chunks("0002\r\n{}\r\n0000\r\n\r\n"), posted, "{}"},
      {"ChunkedEveryByte", chunks("1\r\n{\r\n1\r\n}\r\n0\r\n\r\n"), posted, "{}"},
      {"ChunkedHexadecimal", chunks("A\r\n0123456789\r\na\r\n0123456789\r\n0\r\n\r\n"), posted,
       "01234567890123456789"},
      {"ChunkedLineEnds", chunks("4\r\n\r\n\r\n\r\n0\r\n\r\n"), posted, "\r\n\r\n"},
      {"ChunkedExtensions", chunks("2;a=b;c=\"d e\"\r\n{}\r\n0;x\r\n\r\n"), posted, "{}"},
      {"ChunkedTrailer", chunks("2\r\n{}\r\n0\r\nX: y\r\nZ:\r\n\r\n"), posted, "{}"},
  };
  return all;
}

}  // namespace tia::test
