// Text in PNG files: put in, read back, and refused where the file is not whole.
#include "core/film/png_text.h"

#include <gmock/gmock.h>

#include "core/film/png.h"
#include "core/input/errors.h"
#include "tests/core/film/files.h"
#include "tests/core/film/png_chunks.h"
#include "tests/core/png/inflate.h"

namespace tia::test {
namespace {

using namespace std::literals;

constexpr std::string_view word = "Recipe";
constexpr std::size_t plenty = 1 << 20;

std::string small_png() { return encode_png(ramp(5, 4)); }

// The kind of fault that text_in finds, or nothing.
std::optional<FaultKind> fault_of(const std::string& file, std::size_t most = plenty) {
  try {
    text_in(file, word, most);
  } catch (const InputError& error) {
    return error.faults().front().kind;
  }
  return std::nullopt;
}

std::string joined(const std::vector<Chunk>& chunks) {
  std::string file("\x89PNG\r\n\x1A\n");
  for (const Chunk& each : chunks) file += png_chunk(each.type, each.data);
  return file;
}
// The file with one more chunk behind its header.
std::string with_chunk(const std::string& file, std::string_view type, std::string_view data) {
  std::vector<Chunk> chunks = chunks_of(file);
  chunks.insert(chunks.begin() + 1, {std::string(type), std::string(data)});
  return joined(chunks);
}

TEST(PngText, IsReadBackAndLeavesAllElseAsItWas) {
  Random random(11);
  for (const std::size_t size : std::vector<std::size_t>{0, 1, 2, 60, 1000, 70'000}) {
    std::string text;
    while (text.size() < size) text += static_cast<char>('a' + random.below(7));
    for (const std::string& file : {small_png(), encode_png(noise(40, 30, size))}) {
      const std::string made = with_text(file, word, text);
      EXPECT_EQ(text_in(made, word, plenty), text);
      std::vector<Chunk> chunks = chunks_of(made);
      ASSERT_EQ(chunks.at(1).type, "iTXt");
      chunks.erase(chunks.begin() + 1);
      EXPECT_TRUE(joined(chunks) == file);
    }
  }
}

// W3C PNG (third edition), 11.3.3.4: keyword, 0, flag, method, language, 0, keyword, 0, text.
TEST(PngText, StandsInAChunkAsTheStandardHasIt) {
  const std::string data = chunks_of(with_text(small_png(), word, "h\xC3\xA9!")).at(1).data;
  ASSERT_EQ(data.substr(0, 11), "Recipe\0\1\0\0\0"sv);
  EXPECT_EQ(inflated(data.substr(11), 5), "h\xC3\xA9!");
}

TEST(PngText, ThatAnotherProgramHasWrittenPlainIsReadToo) {
  const std::string file = with_chunk(small_png(), "iTXt", "Recipe\0\0\0vi\0C\xC3\xB4ng\0abc"sv);
  EXPECT_EQ(text_in(file, word, plenty), "abc");
}

TEST(PngText, IsCompressedOrPlain) {  // 0x80 is neither, whether a char has a sign or not
  for (const char flag : {'\2', '\x7f', '\x80', '\xff'}) {
    const std::string data = "Recipe\0"s + flag + "\0vi\0C\0abc"s;
    EXPECT_EQ(fault_of(with_chunk(small_png(), "iTXt", data)), FaultKind::malformed) << int{flag};
  }
}

TEST(PngText, OfAnotherKeywordIsNotMeant) {
  EXPECT_EQ(text_in(small_png(), word, plenty), std::nullopt);
  EXPECT_EQ(text_in(with_text(small_png(), "Recipes", "abc"), word, plenty), std::nullopt);
  EXPECT_EQ(text_in(with_text(with_text(small_png(), "Recip", "x"), word, "y"), word, plenty), "y");
}

TEST(PngText, IsNotReadOutOfAFileThatIsCutShortOrGoesOn) {
  const std::string file = with_text(small_png(), word, "abc");
  for (std::size_t size = 0; size < file.size(); ++size)
    EXPECT_EQ(fault_of(file.substr(0, size)), FaultKind::malformed) << size;
  EXPECT_EQ(fault_of(file + '\0'), FaultKind::malformed);
  EXPECT_EQ(fault_of(file), std::nullopt);
}

TEST(PngText, IsNotReadOutOfAFileOfWhichOneBitIsWrong) {
  const std::string file = with_text(small_png(), word, "abc");
  for (std::size_t bit = 0; bit < 8 * file.size(); ++bit) {
    std::string wrong = file;
    wrong[bit / 8] = static_cast<char>(wrong[bit / 8] ^ (1 << bit % 8));
    EXPECT_EQ(fault_of(wrong), FaultKind::malformed) << bit;
  }
}

TEST(PngText, ThatStandsThereTwiceOrBrokenIsRefused) {
  EXPECT_EQ(fault_of(with_text(with_text(small_png(), word, "a"), word, "a")),
            FaultKind::malformed);
  for (const std::string_view data :
       {"Recipe"sv, "Recipe\0"sv, "Recipe\0\0"sv, "Recipe\0\2\0\0\0abc"sv, "Recipe\0\0\1\0\0abc"sv,
        "Recipe\0\0\0vi"sv, "Recipe\0\0\0vi\0no end"sv, "Recipe\0\1\0\0\0no zlib"sv,
        "Recipe\0\1\0\0\0"sv})
    EXPECT_EQ(fault_of(with_chunk(small_png(), "iTXt", data)), FaultKind::malformed);
  EXPECT_EQ(fault_of(joined({{"IDAT", ""}, {"IEND", ""}})), FaultKind::malformed);
  EXPECT_EQ(fault_of(joined({{"IEND", ""}})), FaultKind::malformed);
}

TEST(PngText, MayBeAsLongAsIsAllowedAndNoLonger) {
  for (const std::size_t size : std::vector<std::size_t>{100, 5000}) {
    const std::string text(size, 'x');  // which compresses to little: it must not unpack further
    const std::string plain = "Recipe\0\0\0\0\0"s + text;
    for (const std::string& file :
         {with_text(small_png(), word, text), with_chunk(small_png(), "iTXt", plain)}) {
      EXPECT_EQ(text_in(file, word, size), text);
      EXPECT_EQ(fault_of(file, size - 1), FaultKind::limit);
      EXPECT_EQ(fault_of(file, 0), FaultKind::limit);
    }
  }
}

}  // namespace
}  // namespace tia::test
