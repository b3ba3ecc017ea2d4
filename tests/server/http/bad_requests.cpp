#include "tests/server/http/bad_requests.h"

#include <ostream>

#include "tests/server/http/request_forms.h"

namespace tia::test {

void PrintTo(const BadRequest& bad, std::ostream* out) { *out << bad.law; }

namespace {

using namespace forms;
using Bad = std::vector<BadRequest>;

Bad first_lines() {
  return {
      {"Http09", "GET /\r\n\r\n", 400},
      {"Http09WithFields", line("GET /healthz"), 400},
      {"Http2Preface", "PRI * HTTP/2.0\r\n\r\nSM\r\n\r\n", 505},
      {"Http12", line("GET / HTTP/1.2"), 505},
      {"Http3", line("GET / HTTP/3.0"), 505},
      {"VersionOfTwoDigits", line("GET / HTTP/1.10"), 400},
      {"VersionInLowerCase", line("GET / http/1.1"), 400},
      {"VersionWithoutAPoint", line("GET / HTTP/11"), 400},
      {"AnotherProtocol", line("GET / HTTPS/1.1"), 400},
      {"TlsHello", Text("\x16\x03\x01\x02\x00\x01\x00\x01\xfc\x03\x03", 11), 400},
      {"Words", "hello there\r\n\r\n", 400},
      {"Nothing", "\r\n\r\n\r\n", 400},
      {"TwoEmptyLinesFirst", "\r\n\r\n" + get(""), 400},
      {"SpaceFirst", " " + get(""), 400},
      {"FieldFirst", "Host: x\r\n" + get(""), 400},
      {"MethodWithAColon", line("GET: / HTTP/1.1"), 400},
      {"MethodOfAQuote", line("\"GET\" / HTTP/1.1"), 400},
      {"MethodBeyondAscii", line("G\xc3\x89T / HTTP/1.1"), 400},
      {"NoMethod", line(" / HTTP/1.1"), 400},
      {"NoTarget", line("GET HTTP/1.1"), 400},
      {"EmptyTarget", line("GET  HTTP/1.1"), 400},
      {"TwoSpaces", line("GET  /healthz HTTP/1.1"), 400},
      {"TabsForSpaces", line("GET\t/healthz\tHTTP/1.1"), 400},
      {"SpaceInTheTarget", line("GET /healthz /version HTTP/1.1"), 400},
      {"SpaceAtTheEnd", line("GET /healthz HTTP/1.1 "), 400},
      {"TargetBeyondAscii", line("GET /\xc3\xa4 HTTP/1.1"), 400},
      {"NulInTheTarget", line("GET /hea" + zeros(1) + "lthz HTTP/1.1"), 400},
      {"DeleteInTheTarget", line("GET /\x7f HTTP/1.1"), 400},
      {"EscapeInTheTarget", line("GET /\x1b[0m HTTP/1.1"), 400},
      {"TargetWithoutASlash", line("GET healthz HTTP/1.1"), 400},
      {"StarOfAGet", line("GET * HTTP/1.1"), 400},
      {"AuthorityOfAConnect", line("CONNECT x:80 HTTP/1.1"), 400},
      {"AbsoluteOfAnotherScheme", line("GET file:///etc/passwd HTTP/1.1"), 400},
      {"AbsoluteWithoutAHost", line("GET http:///healthz HTTP/1.1"), 400},
      {"AbsoluteOfAUser", line("GET http://x@y/healthz HTTP/1.1"), 400},
      {"BareCrAfterTheVersion", "GET / HTTP/1.1\rHost: x\r\n\r\n", 400},
      {"CrCrLfAfterTheVersion", "GET / HTTP/1.1\r\r\nHost: x\r\n\r\n", 400},
      {"BareLfAfterTheVersion", "GET / HTTP/1.1\nHost: x\r\n\r\n", 400},
      {"LongTarget", line("GET /" + Text(100'000, 'a') + " HTTP/1.1"), 414},
      {"LongTargetWithoutEnd", "GET /" + Text(100'000, 'a'), 414},
  };
}

Bad field_lines() {
  return {
      {"NoHost", line("GET / HTTP/1.1", ""), 400},
      {"TwoHosts", get("Host: y\r\n"), 400},
      {"TheSameHostTwice", get("Host: x\r\n"), 400},
      {"TwoHostsInOne", host(" x, y"), 400},
      {"HostWithASpace", host(" x y"), 400},
      {"HostWithATab", host(" x\ty"), 400},
      {"HostWithAPath", host(" x/y"), 400},
      {"HostWithAUser", host(" x@y"), 400},
      {"HostWithAQuery", host(" x?y"), 400},
      {"HostBeyondAscii", host(" \xc3\xa4"), 400},
      {"HostWithAPortOfLetters", host(" x:y"), 400},
      {"HostWithTwoPorts", host(" x:1:2"), 400},
      {"HostWithAnOpenBracket", host(" [::1"), 400},
      {"SpaceBeforeTheColon", get("X : y\r\n"), 400},
      {"TabBeforeTheColon", get("X\t: y\r\n"), 400},
      {"SpaceBeforeTheName", line("GET / HTTP/1.1", " Host: x\r\n"), 400},
      {"Folded", get("X: a\r\n b\r\n"), 400},
      {"FoldedWithATab", get("X: a\r\n\tb\r\n"), 400},
      {"FoldedHost", line("GET / HTTP/1.1", "Host:\r\n x\r\n"), 400},
      {"FieldWithoutAColon", get("X\r\n"), 400},
      {"FieldWithoutAName", get(": x\r\n"), 400},
      {"NameWithASlash", get("X/Y: z\r\n"), 400},
      {"NameBeyondAscii", get("X\xc3\xa4: z\r\n"), 400},
      {"BareLfInAField", get("X: a\nTransfer-Encoding: chunked\r\n"), 400},
      {"BareLfEndsTheHead", "GET / HTTP/1.1\r\nHost: x\r\n\n", 400},
      {"OnlyBareLfs", "GET / HTTP/1.1\nHost: x\n\n", 400},
      {"BareCrInAField", get("X: a\rTransfer-Encoding: chunked\r\n"), 400},
      {"CrCrLfInTheMiddle", "GET / HTTP/1.1\r\nX: a\r\r\nHost: x\r\n\r\n", 400},
      {"CrCrLfAtTheEnd", "GET / HTTP/1.1\r\nHost: x\r\nX: a\r\r\n\r\n", 400},
      {"NulInAValue", get("X: a" + zeros(1) + "b\r\n"), 400},
      {"NulInAName", get("X" + zeros(1) + ": b\r\n"), 400},
      {"VerticalTabInAValue", get("X: a\vb\r\n"), 400},
      {"DeleteInAValue", get("X: a\x7f\r\n"), 400},
      {"TwoExpectations",
       post("Content-Length: 2\r\nExpect: 100-continue\r\n"
            "Expect: 100-continue\r\n",
            "{}"),
       400},
      {"AnotherExpectation", post("Content-Length: 2\r\nExpect: 200-ok\r\n", "{}"), 417},
      {"Fields101", "GET / HTTP/1.1\r\nHost: x\r\n" + fields(100) + "\r\n", 431},
      {"Fields200000", "GET / HTTP/1.1\r\nHost: x\r\n" + fields(200'000), 431},
      {"LongField", get("X: " + Text(100'000, 'a') + "\r\n"), 431},
      {"LongName", get(Text(100'000, 'a') + ": x\r\n"), 431},
  };
}

Bad framings() {
  const Text te = "Transfer-Encoding: chunked\r\n", cl = "Content-Length: 2\r\n";
  const Text five = "5\r\nhello\r\n0\r\n\r\n";
  return {
      {"ClTe", post(cl + te, "0\r\n\r\n"), 400},
      {"TeCl", post(te + cl, five), 400},
      {"ClZeroTe", post("Content-Length: 0\r\n" + te, five), 400},
      {"TeTe", post(te + te, five), 400},
      {"TeOtherTe", post(te + "Transfer-Encoding: identity\r\n", five), 400},
      {"TeUnknownTe", post("Transfer-encoding: x\r\n" + te, five), 400},
      {"TeOfHttp10", line("POST / HTTP/1.0", te) + five, 400},
      {"TeOfAGet", get(te) + five, 400},
      {"XChunked", coded(" xchunked"), 501},
      {"ChunkedX", coded(" chunkedx"), 501},
      {"ChunkedIdentity", coded(" chunked, identity"), 501},
      {"IdentityChunked", coded(" identity, chunked"), 501},
      {"GzipChunked", coded(" gzip, chunked"), 501},
      {"ChunkedChunked", coded(" chunked, chunked"), 501},
      {"ChunkedComma", coded(" chunked,"), 501},
      {"CommaChunked", coded(" ,chunked"), 501},
      {"ChunkedParameter", coded(" chunked;q=1"), 501},
      {"QuotedChunked", coded(" \"chunked\""), 501},
      {"ChunkedWithoutALetter", coded(" chunke"), 501},
      {"EmptyTe", coded(""), 501},
      {"Identity", coded(" identity"), 501},
      {"HighByteChunked",
       coded(" \xa0"
             "chunked"),
       501},
      {"VerticalTabChunked", coded(" \vchunked"), 400},
      {"FormFeedChunked", coded(" chunked\f"), 400},
      {"NulChunked", coded(" chunked" + zeros(1)), 400},
      {"FoldedChunked", coded("\r\n chunked"), 400},
      {"CrChunked", coded(" x\r chunked"), 400},
      {"SpacedTe", post("Transfer-Encoding : chunked\r\n", five), 400},
      {"IndentedTe", post(cl + " Transfer-Encoding: chunked\r\n", five), 400},
      {"LfTe", post("X: y\nTransfer-Encoding: chunked\r\n" + cl, five), 400},
      {"TwoLengths", post("Content-Length: 2\r\nContent-Length: 5\r\n", "hello"), 400},
      {"TheSameLengthTwice", post(cl + cl, "{}"), 400},
      {"ListOfLengths", sized(" 2, 2"), 400},
      {"ListOfTwoLengths", sized(" 2, 5"), 400},
      {"NegativeLength", sized(" -2"), 400},
      {"PlusLength", sized(" +2"), 400},
      {"HexadecimalLength", sized(" 0x2"), 400},
      {"FractionalLength", sized(" 2.0"), 400},
      {"ExponentLength", sized(" 2e0"), 400},
      {"LengthWithAUnit", sized(" 2b"), 400},
      {"LengthWithASpace", sized(" 1 2"), 400},
      {"LengthWithAnUnderscore", sized(" 1_0"), 400},
      {"EmptyLength", sized(""), 400},
      {"QuotedLength", sized(" \"2\""), 400},
      {"LengthOfOtherDigits", sized(" \xd9\xa2"), 400},
      {"LengthBeyond64Bits", sized(" 18446744073709551618"), 400},
      {"LengthBeyond63Bits", sized(" 9223372036854775808"), 400},
      {"LengthBeyondTheLimit", sized(" 4194305"), 413},
      {"LengthOfTerabytes", sized(" 9223372036854775807"), 413},
      {"SpacedLength", post("Content-Length : 2\r\n", "{}"), 400},
      {"NoLength", post("", "{}"), 411},
      {"NoLengthOfAPut", line("PUT /render HTTP/1.1"), 411},
      {"NoLengthOfAPatch", line("PATCH /render HTTP/1.1"), 411},
      {"NoLengthOfHttp10", line("POST /render HTTP/1.0"), 411},
      {"BodyOfAGet", get(cl) + "{}", 400},
      {"BodyOfAHead", line("HEAD / HTTP/1.1", "Host: x\r\n" + cl) + "{}", 400},
      {"GzipBody", post("Content-Encoding: gzip\r\n" + cl, "\x1f\x8b"), 415},
      {"BrotliBody", post("Content-Encoding: br\r\n" + cl, "{}"), 415},
      {"IdentityAndGzip", post("Content-Encoding: identity, gzip\r\n" + cl, "{}"), 415},
      {"GzipChunks", post("Content-Encoding: gzip\r\n" + te, five), 415},
  };
}

Bad bad_chunks() {
  const Text end = "\r\n0\r\n\r\n";
  return {
      {"NegativeSize", chunks("-2\r\n{}" + end), 400},
      {"PlusSize", chunks("+2\r\n{}" + end), 400},
      {"SizeWith0x", chunks("0x2\r\n{}" + end), 400},
      {"SizeOfLetters", chunks("zz\r\n{}" + end), 400},
      {"EmptySize", chunks("\r\n{}" + end), 400},
      {"SpaceBeforeTheSize", chunks(" 2\r\n{}" + end), 400},
      {"SpaceAfterTheSize", chunks("2 \r\n{}" + end), 400},
      {"SizeThenGarbage", chunks("2g\r\n{}" + end), 400},
      {"SizeThenComma", chunks("2,2\r\n{}" + end), 400},
      {"SizeWithAPoint", chunks("2.0\r\n{}" + end), 400},
      {"SizeBeyond64Bits", chunks("10000000000000002\r\n{}" + end), 400},
      {"SizeOfAllOnes", chunks("ffffffffffffffff\r\n{}" + end), 400},
      {"BareLfAfterTheSize", chunks("2\n{}" + end), 400},
      {"BareCrAfterTheSize", chunks("2\r{}" + end), 400},
      {"CrCrLfAfterTheSize", chunks("2\r\r\n{}" + end), 400},
      {"BareLfInAnExtension", chunks("2;a\nb\r\n{}" + end), 400},
      {"CrCrLfAfterAnExtension", chunks("2;a\r\r\n{}" + end), 400},
      {"NulInAnExtension", chunks("2;" + zeros(1) + "\r\n{}" + end), 400},
      {"LongExtension", chunks("2;" + Text(300, 'a') + "\r\n{}" + end), 400},
      {"LongExtensionWithoutEnd", chunks("2;" + Text(300, 'a')), 400},
      {"DataLongerThanItsSize", chunks("2\r\n{}}" + end), 400},
      {"DataShorterThanItsSize", chunks("5\r\n{}" + end), 400},
      {"BareLfAfterTheData", chunks("2\r\n{}\n0\r\n\r\n"), 400},
      {"BareCrAfterTheData", chunks("2\r\n{}\r0\r\n\r\n"), 400},
      {"NoLineEndAfterTheData", chunks("2\r\n{}0\r\n\r\n"), 400},
      {"BareLfAtTheEnd", chunks("2\r\n{}\r\n0\n\n"), 400},
      {"BareLfAfterTheLastSize", chunks("2\r\n{}\r\n0\r\n\n"), 400},
      {"TrailerWithoutAColon", chunks("0\r\nX\r\n\r\n"), 400},
      {"TrailerFolded", chunks("0\r\nX: a\r\n b\r\n\r\n"), 400},
      {"TrailerOfARequest", chunks("0\r\nGET /version HTTP/1.1\r\n\r\n"), 400},
      {"TrailerWithBareLf", chunks("0\r\nX: a\nY: b\r\n\r\n"), 400},
      {"TrailerWithCrCrLf", chunks("0\r\nX: a\r\r\n\r\n"), 400},
      {"LongTrailer", chunks("0\r\nX: " + Text(5000, 'a') + "\r\n\r\n"), 431},
      {"TrailerOf101Fields", chunks("0\r\n" + fields(101) + "\r\n"), 431},
      {"ChunkBeyondTheLimit", chunks("400001\r\n"), 413},
      {"ChunkOfGigabytes", chunks("ffffffff\r\n"), 413},
  };
}

}  // namespace

const std::vector<BadRequest>& bad_requests() {
  static const std::vector<BadRequest> all = [] {
    std::vector<BadRequest> list;
    for (const auto& part : {first_lines(), field_lines(), framings(), bad_chunks()})
      list.insert(list.end(), part.begin(), part.end());
    return list;
  }();
  return all;
}

}  // namespace tia::test
