// The tests' own reader of PNG files: it reads what it should, and takes nothing else for a
// picture.
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <memory>
#include <stdexcept>

#include "core/film/png.h"
#include "tests/core/film/files.h"
#include "tests/core/film/png_chunks.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

// What is wrong with a file; "" = nothing.
std::string fault_of(std::string_view file) {
  try {
    read_png(file);
    return "";
  } catch (const std::runtime_error& error) {
    return error.what();
  }
}

constexpr std::string_view signature = "\x89PNG\r\n\x1A\n";
const std::string four_rows = std::string(1, '\0') + "abcdef" + '\1' + "abcdef" + '\2' + "abcdef" +
                              '\3' + "abcdef" + '\4' + "abcdef";

std::string head(std::uint32_t width, std::uint32_t height, const std::string& rest) {
  return png_chunk("IHDR", big_endian(width) + big_endian(height) + rest);
}
const std::string ihdr = head(2, 5, std::string("\x08\x02\0\0\0", 5));
const std::string idat = png_chunk("IDAT", zlib(four_rows)), iend = png_chunk("IEND", "");
std::string file(const std::string& chunks) { return std::string(signature) + chunks; }

TEST(PngReader, ReadsWhatTheEncoderIsGiven) {
  for (const auto& [width, height] : {std::pair{1, 1}, {31, 33}, {333, 217}, {701, 601}})
    for (const Image8& image : {noise(width, height, 1), ramp(width, height)})
      for (const std::string& bytes : {encode_png(image), encode_png(scanlines_of(image))}) {
        const Png png = read_png(bytes);
        EXPECT_EQ(png.width, width);
        EXPECT_EQ(png.height, height);
        EXPECT_TRUE(png.rgb == std::string(image.rgb.begin(), image.rgb.end()));
      }
}

// Worked out by hand: 'a' is 97 = 0x61.
TEST(PngReader, KnowsEveryFilter) {
  const std::string rgb = read_png(file(ihdr + idat + iend)).rgb;
  EXPECT_EQ(rgb.substr(0, 6), "abcdef");                     // none
  EXPECT_EQ(rgb.substr(6, 6), "abc\xC5\xC7\xC9");            // the pixel to the left
  EXPECT_EQ(rgb.substr(12, 6), "\xC2\xC4\xC6\x29\x2C\x2F");  // the one above
  EXPECT_EQ(rgb.substr(18, 6), "\xC2\xC4\xC6\xD9\xDD\xE0");  // half of both
  EXPECT_EQ(rgb.substr(24, 6), "\x23\x26\x29\x87\x8B\x8F");  // Paeth's
}

TEST(PngReader, KnowsEveryKindOfBlock) {
  const std::string text = four_rows;
  for (int level = 0; level <= 12; ++level) {
    SCOPED_TRACE(level);
    const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
        libdeflate_alloc_compressor(level), libdeflate_free_compressor);
    const Image8 image = level % 2 == 0 ? ramp(97, 31) : noise(97, 31, 2);
    const Scanlines lines = scanlines_of(image);
    std::string stream(libdeflate_zlib_compress_bound(compressor.get(), lines.size()), '\0');
    stream.resize(libdeflate_zlib_compress(compressor.get(), lines.data(), lines.size(),
                                           stream.data(), stream.size()));
    EXPECT_TRUE(read_png(file(head(97, 31, std::string("\x08\x02\0\0\0", 5)) +
                              png_chunk("IDAT", stream) + iend))
                    .rgb == std::string(image.rgb.begin(), image.rgb.end()));
  }
}

TEST(PngReader, ReadsTexts) {
  const std::string plain = std::string("Recipe\0\0\0en\0Rezept\0", 19) + "\u00E4\u20AC\U0001F600",
                    packed = std::string("Recipe\0\1\0\0\0", 11) + zlib("packed");
  const Png png = read_png(file(ihdr + png_chunk("iTXt", plain) + png_chunk("iTXt", packed) + idat +
                                png_chunk("tEXt", std::string("Title\0t", 7)) + iend));
  ASSERT_EQ(png.texts.size(), 3U);
  EXPECT_EQ(png.texts[0].keyword, "Recipe");
  EXPECT_EQ(png.texts[0].text, "\u00E4\u20AC\U0001F600");
  EXPECT_EQ(png.texts[1].text, "packed");
  EXPECT_EQ(png.texts[2].keyword, "Title");
  EXPECT_EQ(png.texts[2].text, "t");
}

TEST(PngReader, FindsEveryCut) {
  for (const std::string& whole :
       {encode_png(ramp(9, 7)), encode_png(scanlines_of(ramp(9, 7))), file(ihdr + idat + iend)}) {
    EXPECT_EQ(fault_of(whole), "");
    for (std::size_t size = 0; size < whole.size(); ++size)
      EXPECT_NE(fault_of(std::string_view(whole).substr(0, size)), "") << size;
    EXPECT_NE(fault_of(whole + '\0'), "");
  }
}

TEST(PngReader, FindsEveryFlippedBit) {
  for (std::string bytes : {encode_png(ramp(9, 7)), encode_png(scanlines_of(noise(9, 7, 3)))})
    for (std::size_t bit = 0; bit < 8 * bytes.size(); ++bit) {
      const char before = bytes[bit / 8];
      bytes[bit / 8] = static_cast<char>(before ^ 1 << bit % 8);
      EXPECT_NE(fault_of(bytes), "") << bit;
      bytes[bit / 8] = before;
    }
}

// A flipped bit of the stream under a sum that fits the chunk: the stream's own sum is left.
TEST(PngReader, FindsEveryFlippedBitUnderARightSumUnlessThePixelsAreTheSame) {
  for (const std::string& rows : {four_rows, std::string(35, '\0')}) {
    std::string stream = zlib(rows);
    const std::string rgb = read_png(file(ihdr + png_chunk("IDAT", stream) + iend)).rgb;
    int same = 0;
    for (std::size_t bit = 0; bit < 8 * stream.size(); ++bit) {
      const char before = stream[bit / 8];
      stream[bit / 8] = static_cast<char>(before ^ 1 << bit % 8);
      try {
        EXPECT_EQ(read_png(file(ihdr + png_chunk("IDAT", stream) + iend)).rgb, rgb) << bit;
        ++same;
      } catch (const std::runtime_error&) {
      }
      stream[bit / 8] = before;
    }
    EXPECT_LT(same, 8);  // bits behind the last block's end
  }
}

struct Broken {
  const char* law;
  std::string file;
  const char* says;
};
void PrintTo(const Broken& broken, std::ostream* out) { *out << broken.law; }

class BrokenPng : public testing::TestWithParam<Broken> {};

TEST_P(BrokenPng, IsNoPicture) {
  EXPECT_THAT(fault_of(GetParam().file), HasSubstr(GetParam().says));
}

std::string text(const char* type, const std::string& data) {
  return file(ihdr + png_chunk(type, data) + idat + iend);
}
std::string streamed(const std::string& stream) {
  return file(ihdr + png_chunk("IDAT", stream) + iend);
}

std::vector<Broken> broken_files() {
  const std::string gamma = png_chunk("gAMA", big_endian(45455)), stream = zlib(four_rows);
  const std::string raw = stream.substr(2, stream.size() - 6),
                    sum = stream.substr(stream.size() - 4);
  const std::string rgb8("\x08\x02\0\0\0", 5);
  std::string row(1, '\0');  // of which no part comes twice
  for (int i = 0; i < 300; ++i) row += static_cast<char>(i % 256 ^ i / 256);
  const std::string twice = zlib(row + row);  // from 301 bytes away, beyond a window of 256
  return {
      {"NoSignature", "\x89PNG\n" + ihdr + idat + iend, "ASCII conversion"},
      {"NoHeader", file(idat + iend), "Missing IHDR"},
      {"HeaderTwice", file(ihdr + ihdr + idat + iend), "IHDR: out of place"},
      {"LongHeader", file(head(2, 5, rgb8 + "x") + idat + iend), "IHDR: invalid"},
      {"NoWidth", file(head(0, 5, rgb8) + idat + iend), "width is zero"},
      {"NoHeight", file(head(2, 0, rgb8) + idat + iend), "height is zero"},
      {"Grey", file(head(2, 5, std::string("\x08\0\0\0\0", 5)) + idat + iend), "not 8 bits"},
      {"Interlaced", file(head(2, 5, std::string("\x08\2\0\0\1", 5)) + idat + iend), "not 8 bits"},
      {"NoPixels", file(ihdr + iend), "IEND: out of place"},
      {"NoEnd", file(ihdr + idat), "cut short"},
      {"AnEndWithBytes", file(ihdr + idat + png_chunk("IEND", "x")), "IEND: invalid"},
      {"PixelsParted", file(ihdr + idat + png_chunk("tiAx", "") + idat + iend), "Too many IDATs"},
      {"UnknownButNeeded", file(ihdr + png_chunk("TIAx", "") + idat + iend), "TIAx"},
      {"ReservedName", file(ihdr + png_chunk("tiax", "") + idat + iend), "name"},
      {"NoName", file(ihdr + png_chunk("t Ax", "") + idat + iend), "invalid chunk type"},
      {"GammaTwice", file(ihdr + gamma + gamma + idat + iend), "gAMA: duplicate"},
      {"LateGamma", file(ihdr + idat + gamma + iend), "gAMA: out of place"},
      {"NoKeyword", text("iTXt", std::string("\0\0\0\0\0x", 6)), "keyword"},
      {"KeywordWithoutEnd", text("iTXt", "Recipe"), "iTXt: truncated"},
      {"LongKeyword", text("tEXt", std::string(80, 'k') + '\0'), "keyword"},
      {"TextOfUnknownCompression", text("iTXt", std::string("k\0\2\0\0\0x", 7)),
       "bad compression info"},
      {"TextThatIsNoUtf8", text("iTXt", std::string("k\0\0\0\0\0\xC0\x80", 8)), "UTF-8"},
      {"TextOfASurrogate", text("iTXt", std::string("k\0\0\0\0\0\xED\xA0\x80", 9)), "UTF-8"},
      {"NoStream", streamed("x"), "Not enough image data"},
      {"UnknownMethod", streamed("\x79\x18" + raw + sum), "unknown compression method"},
      {"WrongZlibHeader", streamed("\x78\x02" + raw + sum), "incorrect header check"},
      {"Dictionary", streamed("\x78\x20" + raw + sum), "dictionary"},
      {"WrongSum", streamed("\x78\x01" + raw + "sum."), "incorrect data check"},
      {"NoSum", streamed("\x78\x01" + raw), "Not enough image data"},
      {"BytesAfterTheSum", streamed(stream + "x"), "Extra compressed data"},
      {"UnknownBlock", streamed("\x78\x01\x07" + sum), "invalid block type"},
      {"DistanceBeyondTheStart", streamed("\x78\x01" + std::string("\x03\x02\x00", 3) + sum),
       "distance too far back"},
      {"DistanceBeyondTheWindow",
       file(head(100, 2, rgb8) + png_chunk("IDAT", "\x08\x1D" + twice.substr(2)) + iend),
       "distance too far back"},
      {"TooFewPixels", streamed(zlib(four_rows.substr(7))), "Not enough image data"},
      {"TooManyPixels", streamed(zlib(four_rows + "x")), "Too much image data"},
      {"UnknownFilter", streamed(zlib('\5' + four_rows.substr(1))), "filter"},
  };
}
INSTANTIATE_TEST_SUITE_P(Of, BrokenPng, testing::ValuesIn(broken_files()),
                         [](const auto& one) { return std::string(one.param.law); });

}  // namespace
}  // namespace tia::test
