// Laws of the reader: however the bytes are cut, the same requests come out; limits are exact.
#include "server/http/request_reader.h"

#include "tests/server/http/reader_support.h"
#include "tests/server/http/request_corpus.h"
#include "tests/server/http/request_forms.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

using State = RequestReader::State;

const std::string next_request = forms::get("X-Request-Id: next\r\n");

// ---- cutting --------------------------------------------------------------------------------

void expect_no_cut_matters(const std::string& bytes) {
  const ReadOut whole = read_whole(bytes);
  EXPECT_EQ(read_pieces(single_bytes(bytes)), whole) << "byte by byte";
  std::mt19937 random(1);
  for (int i = 0; i < 20; ++i)
    EXPECT_EQ(read_pieces(random_pieces(bytes, random)), whole) << "random pieces " << i;
  if (bytes.size() > 2000) return;
  const std::string_view text = bytes;
  for (std::size_t cut = 1; cut < bytes.size(); ++cut)
    ASSERT_EQ(read_pieces({text.substr(0, cut), text.substr(cut)}), whole) << "cut at " << cut;
}

class GoodBytes : public testing::TestWithParam<GoodRequest> {};
class BadBytes : public testing::TestWithParam<BadRequest> {};

TEST_P(GoodBytes, AreReadAndSoIsTheNextRequest) {
  const GoodRequest& good = GetParam();
  const ReadOut read = read_whole(good.bytes + next_request);
  EXPECT_EQ(read.status, 0) << read.type;
  ASSERT_EQ(read.requests.size(), 2U);
  const std::string& text = read.requests[0];
  EXPECT_EQ(text.substr(0, text.find('\n')), good.line);
  EXPECT_EQ(text.substr(text.find("\n\n") + 2), good.body);
  EXPECT_EQ(read.requests[1], read_whole(next_request).requests.at(0));
  EXPECT_EQ(read.state, State::idle);
}
TEST_P(GoodBytes, AreReadTheSameHoweverTheyAreCut) {
  expect_no_cut_matters(GetParam().bytes + next_request);
}

TEST_P(BadBytes, AreRefusedAndNothingAfterThemIsRead) {
  const ReadOut read = read_whole(GetParam().bytes + next_request);
  EXPECT_EQ(read.status, GetParam().status) << read.type;
  EXPECT_EQ(read.requests.size(), 0U);
}
TEST_P(BadBytes, AreRefusedTheSameHoweverTheyAreCut) {
  expect_no_cut_matters(GetParam().bytes + next_request);
}

INSTANTIATE_TEST_SUITE_P(Of, GoodBytes, testing::ValuesIn(good_requests()), law_of);
INSTANTIATE_TEST_SUITE_P(Of, BadBytes, testing::ValuesIn(bad_requests()), law_of);

TEST(RequestReader, AHundredRequestsInAnyPiecesAreAHundred) {
  std::string bytes;
  std::size_t count = 0;
  for (int i = 0; i < 2; ++i)
    for (const GoodRequest& good : good_requests()) bytes += good.bytes, ++count;
  const ReadOut whole = read_whole(bytes);
  EXPECT_EQ(whole.requests.size(), count);
  EXPECT_EQ(read_pieces(single_bytes(bytes)), whole);
  std::mt19937 random(2);
  for (int i = 0; i < 50; ++i) EXPECT_EQ(read_pieces(random_pieces(bytes, random)), whole);
}

TEST(RequestReader, TwoRequestsAtOnceAreTwoWithTheirOwnBodies) {
  const ReadOut read = read_whole(forms::sized(" 3", "GET") + forms::chunks("1\r\nx\r\n0\r\n\r\n"));
  ASSERT_EQ(read.requests.size(), 2U);
  EXPECT_THAT(read.requests[0], testing::EndsWith("\n\nGET"));
  EXPECT_THAT(read.requests[1], testing::EndsWith("\n\nx"));
}

// ---- states ---------------------------------------------------------------------------------

TEST(RequestReader, TellsHowFarARequestHasCome) {
  RequestReader reader(ordinary_body);
  EXPECT_EQ(reader.read(), State::idle);
  reader.feed("P");
  EXPECT_EQ(reader.read(), State::head);
  reader.feed(forms::sized(" 2", "").substr(1));
  EXPECT_EQ(reader.read(), State::body);
  reader.feed("{");
  EXPECT_EQ(reader.read(), State::body);
  reader.feed("}G");
  EXPECT_EQ(reader.read(), State::whole);
  EXPECT_EQ(reader.read(), State::whole);  // until it is taken
  EXPECT_EQ(reader.take().body, "{}");
  EXPECT_EQ(reader.state(), State::idle);
  EXPECT_EQ(reader.read(), State::head);  // the G
}

TEST(RequestReader, WantsContinueOnceAndOnlyWhereItIsAskedFor) {
  const std::string expect = "Expect: 100-continue\r\n";
  for (const std::string& framing :
       {std::string("Content-Length: 2\r\n"), std::string("Transfer-Encoding: chunked\r\n")}) {
    RequestReader reader(ordinary_body);
    reader.feed(forms::post(expect + framing));
    EXPECT_EQ(reader.read(), State::body);
    EXPECT_TRUE(reader.wants_continue());
    EXPECT_FALSE(reader.wants_continue());
    EXPECT_EQ(reader.read(), State::body);
    EXPECT_FALSE(reader.wants_continue());
  }
  for (const std::string& bytes :
       {forms::sized(" 2", ""), forms::post(expect + "Content-Length: 2\r\n", "{"),
        forms::post(expect + "Transfer-Encoding: chunked\r\n", "2"),
        forms::post(expect + "Content-Length: 0\r\n"),
        forms::line("POST / HTTP/1.0", expect + "Content-Length: 2\r\n")}) {
    RequestReader reader(ordinary_body);
    reader.feed(bytes);
    reader.read();
    EXPECT_FALSE(reader.wants_continue()) << bytes;
  }
}

TEST(RequestReader, KnowsTheRequestOfARefusedBody) {  // for the log and the answer's id
  RequestReader reader(1000);
  reader.feed(forms::post("X-Request-Id: abc\r\nContent-Length: 1001\r\n"));
  EXPECT_THROW(reader.read(), HttpError);
  EXPECT_EQ(reader.request().method, "POST");
  EXPECT_EQ(reader.request().target, "/render");
  EXPECT_EQ(reader.request().id, "abc");
}

// By method and path, whatever type is declared.
TEST(RequestReader, SomeRequestsHaveALimitOfTheirOwn) {
  const auto is_taken = [](const std::string& length) {
    BodyLimits limits(1000);
    limits.own = [](const Request& request) -> std::optional<BodyLimit> {
      if (request.target != "/render") return std::nullopt;
      return BodyLimit{2000, "TIA_OWN"};
    };
    RequestReader reader(limits);
    reader.feed(forms::post("Content-Type: image/png\r\nContent-Length: " + length + "\r\n"));
    try {
      return reader.read() == State::body;
    } catch (const HttpError& error) {
      EXPECT_THAT(error.detail(), testing::HasSubstr("2000 bytes (option TIA_OWN)"));
      return false;
    }
  };
  EXPECT_TRUE(is_taken("2000"));
  EXPECT_FALSE(is_taken("2001"));
}

TEST(RequestReader, HoldsNoMoreThanABodyIsLong) {
  RequestReader reader(ordinary_body);
  const std::size_t length = (2 << 20) + 9;  // a string that doubles would end at 4 MiB
  const std::string all = forms::sized(' ' + std::to_string(length), std::string(length, ' '));
  constexpr std::size_t piece = 64 << 10;
  for (std::size_t at = 0; at < all.size(); at += piece) {
    reader.feed(std::string_view(all).substr(at, piece));
    reader.read();
  }
  EXPECT_EQ(reader.state(), State::whole);
  EXPECT_EQ(reader.request().body.size(), length);
  EXPECT_LE(reader.request().body.capacity(), length);
}

TEST(RequestReader, HoldsNothingOfARequestThatHasBeenTaken) {
  RequestReader reader(ordinary_body);
  reader.feed(forms::sized(" 1000000", std::string(1'000'000, ' ')));
  ASSERT_EQ(reader.read(), State::whole);
  EXPECT_GE(reader.held(), 1'000'000U);
  reader.take();
  EXPECT_LT(reader.held(), 100U);
}

// ---- limits ---------------------------------------------------------------------------------

// A head of exactly so many bytes, its empty line included.
std::string head_of_size(std::size_t bytes) {
  const std::string rest = forms::get("X: \r\n");
  return forms::get("X: " + std::string(bytes - rest.size(), 'a') + "\r\n");
}

TEST(RequestReader, AHeadOfExactlyTheLimitIsReadAndOneByteMoreIs431) {
  for (const std::string& fit :
       {head_of_size(Head::most_bytes), head_of_size(Head::most_bytes - 1)}) {
    EXPECT_EQ(read_whole(fit).requests.size(), 1U) << fit.size();
    expect_no_cut_matters(fit);
  }
  for (std::size_t more = 1; more <= 5; ++more) {
    const std::string unfit = head_of_size(Head::most_bytes + more);
    ASSERT_EQ(unfit.size(), Head::most_bytes + more);
    EXPECT_EQ(read_whole(unfit).status, 431) << more;
    expect_no_cut_matters(unfit);
  }
}

TEST(RequestReader, ALongHeadIsRefusedBeforeItEnds) {
  RequestReader reader(ordinary_body);
  reader.feed(forms::get("").substr(0, 20) + "\r\nX: ");
  reader.read();
  const std::string piece(1000, 'a');
  std::size_t fed = 0;
  EXPECT_THROW(
      for (; fed < 100'000; fed += piece.size()) {
        reader.feed(piece);
        reader.read();
      },
      HttpError);
  EXPECT_LE(fed, Head::most_bytes);
}

TEST(RequestReader, TheFirstFaultCountsHoweverManyBytesComeAtOnce) {
  const std::string start = forms::get("").substr(0, 32) + "X: ";
  for (const std::string& bytes :
       {start + std::string(20'000, 'a') + '\0',                              // 431, then a NUL
        "GET /" + std::string(5'000, 'a') + '\0',                             // 414, then a NUL
        "GET /" + std::string(5'000, 'a') + std::string(20'000, 'b'),         // 414, then 431
        forms::chunks("400001\r\n" + std::string(0x400001, ' ') + "bad")}) {  // 413, then no CR LF
    const ReadOut whole = read_whole(bytes);
    EXPECT_NE(whole.status, 0);
    Pieces pieces;
    for (std::size_t at = 0; at < bytes.size(); at += 1000)
      pieces.push_back(std::string_view(bytes).substr(at, 1000));
    EXPECT_EQ(read_pieces(pieces), whole);
  }
}

TEST(RequestReader, AHundredFieldsAreReadAndOneMoreIs431) {
  EXPECT_EQ(read_whole(forms::get(forms::fields(99))).requests.size(), 1U);  // and Host
  EXPECT_EQ(read_whole(forms::get(forms::fields(100))).status, 431);
}

// Up to 4096 bytes of target are for the routes; what is a little longer they refuse with 414.
TEST(RequestReader, AFirstLineThatFitsNoTargetIs414HoweverItIsCut) {
  for (std::size_t bytes = 4090; bytes < 4180; ++bytes) {
    const std::string text = forms::line("GET /" + std::string(bytes - 1, 'a') + " HTTP/1.1");
    const ReadOut whole = read_whole(text);
    if (bytes <= 4096) EXPECT_EQ(whole.requests.size(), 1U) << bytes;
    else EXPECT_TRUE(whole.requests.size() == 1 || whole.status == 414) << bytes;
    ASSERT_EQ(read_pieces(single_bytes(text)), whole) << bytes;
  }
}

TEST(RequestReader, ABodyOfExactlyTheLimitIsReadAndOneByteMoreIs413) {
  for (const std::size_t most : {1000U, 4096U, 70'000U}) {
    const auto body = [&](std::size_t size) { return std::string(size, '0'); };
    const auto sized = [&](std::size_t size) {
      return forms::sized(" " + std::to_string(size), body(size));
    };
    const auto chunked = [&](std::size_t size) {  // of two chunks
      char line[20];
      std::snprintf(line, sizeof line, "%zx\r\n", size - 1);
      return forms::chunks("1\r\n0\r\n" + (line + body(size - 1)) + "\r\n0\r\n\r\n");
    };
    const auto limit = static_cast<std::int64_t>(most);
    for (const std::string& fit : {sized(most), chunked(most)}) {
      EXPECT_EQ(read_whole(fit, limit).requests.size(), 1U) << most;
      EXPECT_EQ(read_pieces(single_bytes(fit), limit).requests.size(), 1U) << most;
    }
    for (const std::string& unfit : {sized(most + 1), chunked(most + 1)}) {
      EXPECT_EQ(read_whole(unfit, limit).status, 413) << most;
      EXPECT_EQ(read_pieces(single_bytes(unfit), limit).status, 413) << most;
    }
  }
}

TEST(RequestReader, ABodyThatIsAnnouncedTooLongIsRefusedBeforeItComes) {
  for (const std::string& head : {forms::sized(" 1001", ""), forms::chunks("3e9\r\n")})
    EXPECT_EQ(read_whole(head, 1000).status, 413) << head;
}

// ---- ids ------------------------------------------------------------------------------------

TEST(RequestId, IsTheClientsWhereItIsFitForALogElse16RandomDigits) {
  for (const char* fit : {"a", "trace-1_a.B", "0"}) EXPECT_EQ(request_id(fit), fit);
  for (const char* unfit : {"", "a b", "a\r\nb", "\xc3\xa4", "<x>", "a\"b"}) {
    EXPECT_THAT(request_id(unfit), testing::MatchesRegex("[0-9a-f]{16}")) << unfit;
    EXPECT_NE(request_id(unfit), request_id(unfit));
  }
  EXPECT_EQ(request_id(std::string(64, 'x')), std::string(64, 'x'));
  EXPECT_EQ(request_id(std::string(65, 'x')).size(), 16U);
}

}  // namespace
}  // namespace tia::test
