// Laws of a chunked body's decoder (RFC 9112, 7.1).
#include "server/http/chunks.h"

#include "server/contract/problem.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

struct Decoded {
  std::string body, rest;
  bool ended = false;
};

Decoded decode(std::string_view bytes) {
  Decoded out;
  out.ended = ChunkDecoder({1 << 30}).decode(bytes, out.body);
  out.rest = bytes;
  return out;
}

std::string fault_of_chunks(std::string_view bytes) {
  try {
    decode(bytes);
  } catch (const HttpError& error) {
    return std::string(error.type());
  }
  return "";
}

TEST(Chunks, EndAtTheirEmptyLineAndLeaveWhatFollows) {
  const Decoded out = decode("3\r\nabc\r\n2\r\nde\r\n0\r\n\r\nGET /");
  EXPECT_TRUE(out.ended);
  EXPECT_EQ(out.body, "abcde");
  EXPECT_EQ(out.rest, "GET /");
}

TEST(Chunks, DataComesOutBeforeItsChunkIsWhole) {
  ChunkDecoder decoder({1 << 30});
  std::string body;
  std::string_view bytes = "ff\r\nabc";
  EXPECT_FALSE(decoder.decode(bytes, body));
  EXPECT_EQ(body, "abc");
  EXPECT_EQ(bytes, "");
}

TEST(Chunks, ALineIsKeptUntilItIsWhole) {
  for (const char* start : {"", "f", "f;x", "f;x\r"}) {
    const Decoded out = decode(start);
    EXPECT_FALSE(out.ended);
    EXPECT_EQ(out.rest, start);
  }
}

TEST(Chunks, ASizeIsReadInEitherCaseAndWithZeros) {
  for (const char* size : {"1a", "1A", "001a", "000000000000000001A"})
    EXPECT_EQ(decode(std::string(size) + "\r\n" + std::string(26, 'x')).body.size(), 26U) << size;
}

TEST(Chunks, ALineOfTheLimitIsReadAndOneByteMoreIsNot) {
  const auto line = [](std::size_t bytes) { return "1;" + std::string(bytes - 4, 'a') + "\r\nx"; };
  EXPECT_EQ(decode(line(ChunkDecoder::longest_line)).body, "x");
  EXPECT_EQ(fault_of_chunks(line(ChunkDecoder::longest_line + 1)), "malformed");
}

TEST(Chunks, ATrailerOfTheLimitIsReadAndOneByteMoreIsNot) {
  const auto trailer = [](std::size_t bytes) {  // from the last size's line end on
    return "0\r\nX: " + std::string(bytes - 9, 'a') + "\r\n\r\n";
  };
  EXPECT_TRUE(decode(trailer(ChunkDecoder::most_trailer)).ended);
  EXPECT_EQ(fault_of_chunks(trailer(ChunkDecoder::most_trailer + 1)), "header-too-large");
}

TEST(Chunks, ATrailersFieldsAreNotAddedToTheBody) {
  EXPECT_EQ(decode("1\r\nx\r\n0\r\nContent-Length: 5\r\n\r\n").body, "x");
}

TEST(Chunks, NoLineWithALoneCrOrLfIsRead) {
  for (const char* bytes :
       {"1\nx", "1\rx", "1\r\r\nx", "1;a\r\r\nx", "1;a\nb\r\nx", "1\r\nx\n", "1\r\nx\r\r\n", "0\n",
        "0\r\n\n", "0\r\n\r\r\n", "0\r\nA: b\n\r\n", "0\r\nA: b\r\r\n\r\n"})
    EXPECT_EQ(fault_of_chunks(bytes), "malformed") << testing::PrintToString(bytes);
}

}  // namespace
}  // namespace tia::test
