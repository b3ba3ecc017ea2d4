// Pictures in: PNG files of our encoder, and PNG and JPEG files put together here byte by byte.
#include "core/film/decode.h"

#include <gmock/gmock.h>
#include <sys/resource.h>

#include <algorithm>

#include "core/film/png.h"
#include "tests/core/film/files.h"

namespace tia {
namespace {

using test::Bytes;
using test::Random;

Image8 decoded(const Bytes& file) {
  const auto result = decode_picture(file);
  if (const auto* fault = std::get_if<PictureFault>(&result)) {
    ADD_FAILURE() << fault->got << ", allowed: " << fault->allowed;
    return {};
  }
  return std::get<Image8>(result);
}
/// What refuses a file; empty words where nothing does.
PictureFault refusal(const Bytes& file) {
  const auto result = decode_picture(file);
  const auto* fault = std::get_if<PictureFault>(&result);
  return fault != nullptr ? *fault : PictureFault{};
}
void expect_broken(const Bytes& file) {
  EXPECT_FALSE(refusal(file).beyond_limits);
  EXPECT_THAT(refusal(file).allowed, testing::HasSubstr("a whole PNG or JPEG picture"));
}
void expect_beyond(const Bytes& file, const char* got, const char* allowed) {
  EXPECT_TRUE(refusal(file).beyond_limits);
  EXPECT_EQ(refusal(file).got, got);
  EXPECT_THAT(refusal(file).allowed, testing::HasSubstr(allowed));
}

// ---- PNG ------------------------------------------------------------------------------------

TEST(Decode, OwnPngFilesComeBack) {
  Random random(330);
  for (const auto& [width, height] : {std::pair{1, 1}, {2, 3}, {1, 300}, {257, 31}}) {
    Image8 image(width, height);
    for (auto& code : image.rgb) code = static_cast<std::uint8_t>(random.below(256));
    const Image8 back = decoded(test::to_bytes(encode_png(image)));
    EXPECT_EQ(back.width, width);
    EXPECT_EQ(back.height, height);
    EXPECT_EQ(back.rgb, image.rgb);
  }
}

// One pixel a file: each kind that the format has, as RGB.
TEST(Decode, PngsOfEveryKindBecomeRgb) {
  EXPECT_EQ(decoded(test::png({1, 1, 8, test::grey}, "\x40")).rgb, (Bytes{64, 64, 64}));
  EXPECT_EQ(decoded(test::png({1, 1, 1, test::grey}, "\x80")).rgb, (Bytes{255, 255, 255}));
  EXPECT_EQ(decoded(test::png({1, 1, 16, test::grey}, "\x40\x99")).rgb, (Bytes{64, 64, 64}));
  EXPECT_EQ(decoded(test::png({1, 1, 8, test::grey_alpha}, "\x40\x07")).rgb, (Bytes{64, 64, 64}));
  EXPECT_EQ(decoded(test::png({1, 1, 8, test::rgb}, "\x01\x02\x03")).rgb, (Bytes{1, 2, 3}));
  EXPECT_EQ(decoded(test::png({1, 1, 8, test::rgba}, "\x01\x02\x03\x04")).rgb, (Bytes{1, 2, 3}));
  EXPECT_EQ(decoded(test::png({1, 1, 8, test::palette}, "\x01", "\x09\x08\x07\x06\x05\x04")).rgb,
            (Bytes{6, 5, 4}));
}

// Codes that a palette has no colour for are an error of the file, and nobody's memory.
TEST(Decode, ColoursBeyondThePaletteAreBlack) {
  const Bytes file =
      test::png({4, 1, 8, test::palette}, "\x01\x02\x80\xFF", "\x09\x08\x07\x06\x05\x04");
  EXPECT_EQ(decoded(file).rgb, (Bytes{6, 5, 4, 0, 0, 0, 0, 0, 0, 0, 0, 0}));
}

TEST(Decode, EmptyChunksOfPixelsAreNothing) {
  const Bytes file = test::png({1, 1, 8, test::grey}, "\x40");
  const Bytes more = test::with_chunk_before_pixels(file, test::png_chunk("IDAT", ""));
  EXPECT_EQ(decoded(more).rgb, (Bytes{64, 64, 64}));
}

// ---- JPEG -----------------------------------------------------------------------------------

// A block whose only coefficient is the mean: quantised by 8, it is 8 times the mean's distance
// from 128, and each of the 64 pixels is the mean. Source: ITU-T T.81, A.3.3.
TEST(Decode, FlatGreyJpegsAreTheirMean) {
  for (const int mean : {0, 64, 127, 129, 200, 255}) {
    const Image8 image = decoded(test::flat_jpeg({mean}));
    EXPECT_EQ(image.width, 8);
    EXPECT_EQ(image.height, 8);
    EXPECT_THAT(image.rgb, testing::Each(static_cast<std::uint8_t>(mean)));
    EXPECT_EQ(decoded(test::flat_jpeg({mean}, test::JpegKind::progressive)).rgb, image.rgb);
  }
}

// Source: JFIF 1.02, page 4: R = Y + 1.402 (Cr - 128), G = Y - 0.34414 (Cb - 128) - 0.71414 (Cr -
// 128), B = Y + 1.772 (Cb - 128).
TEST(Decode, FlatColouredJpegsAreTheirMean) {
  for (const auto& [y, cb, cr] : {std::tuple{100, 140, 150}, {200, 100, 90}, {255, 128, 129}}) {
    const Image8 image = decoded(test::flat_jpeg({y, cb, cr}));
    ASSERT_EQ(image.rgb.size(), 192U);
    const double expected[] = {y + 1.402 * (cr - 128),
                               y - 0.34414 * (cb - 128) - 0.71414 * (cr - 128),
                               y + 1.772 * (cb - 128)};
    for (std::size_t i = 0; i < 192; ++i)
      EXPECT_NEAR(image.rgb[i], std::clamp(expected[i % 3], 0.0, 255.0), 1.01);
  }
}

// The scan has codes for the first component alone: the others are 0 from the same file each time.
TEST(Decode, ComponentsThatAScanLeavesOutAreTheSameEachTime) {
  Bytes file = test::flat_jpeg({100});
  const Bytes marker{0xFF, 0xC0};
  const auto frame = std::search(file.begin(), file.end(), marker.begin(), marker.end());
  ASSERT_NE(frame, file.end());
  frame[3] = 17;  // three components, and the two that were not there
  frame[9] = 3;
  const Bytes more{2, 0x11, 0, 3, 0x11, 0};
  file.insert(frame + 13, more.begin(), more.end());
  const auto first = decode_picture(file);
  const std::vector<std::vector<char>> dirt(100, std::vector<char>(500, 'x'));
  const auto second = decode_picture(file);
  ASSERT_EQ(first.index(), second.index());
  if (const auto* image = std::get_if<Image8>(&first)) {
    EXPECT_EQ(image->rgb, std::get<Image8>(second).rgb);
  }
}

// ---- what is refused --------------------------------------------------------------------------

TEST(Decode, WhatIsNoPictureIsRefused) {
  expect_broken({});
  expect_broken(test::to_bytes("GIF89a\x01"));
  expect_broken(test::to_bytes("\x89PNG\r\n\x1A\n"));
  expect_broken(test::to_bytes("\xFF\xD8\xFF"));
  expect_broken(test::to_bytes("\xFF\xD8\xFF\xD9"));
  expect_broken(test::to_bytes("BM"));
}

TEST(Decode, EveryStartOfAPngIsRefused) {
  const Bytes file = test::png({3, 3, 8, test::rgb}, std::string(27, 'x'));
  for (std::size_t length = 0; length < file.size(); ++length)
    expect_broken(Bytes(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(length)));
}

TEST(Decode, LargeFilesAndLargePicturesAreRefusedByTheirHeaders) {
  Bytes large = test::png({1, 1, 8, test::grey}, "\x40");
  large.resize(most_picture_bytes + 1);
  expect_beyond(large, "1048577 bytes", "at most 1048576 bytes");
  large.resize(most_picture_bytes);
  EXPECT_EQ(decoded(large).rgb, (Bytes{64, 64, 64})) << "what follows the end is not looked at";
  expect_beyond(test::png({2049, 2048, 1, test::grey}, "x"), "2049 x 2048 pixels",
                "at most 4194304 pixels");
  expect_beyond(test::png({4194305, 1, 8, test::grey}, "x"), "4194305 x 1 pixels", "pixels");
  expect_beyond(test::png({16777216, 16, 1, test::grey}, "x"), "16777216 x 16 pixels", "pixels");
  expect_beyond(test::png({65535, 65535, 8, test::rgba}, "x"), "65535 x 65535 pixels", "pixels");
}

TEST(Decode, ThePixelsOfTheLargestPictureAreRead) {
  const std::string rows(2048 * 256, '\xFF');
  const Image8 image = decoded(test::png({2048, 2048, 1, test::grey}, rows));
  EXPECT_EQ(image.rgb.size(), 3U << 22U);
  EXPECT_THAT(Bytes(image.rgb.end() - 6, image.rgb.end()), testing::Each(255));
}

TEST(Decode, AJpegOfTooManyScansIsRefused) {
  const Bytes scan{0xFF, 0xDA};
  const auto with_scans = [&](Bytes file, int more) {
    for (int i = 0; i < more; ++i) file.insert(file.end(), scan.begin(), scan.end());
    return file;
  };
  const Bytes progressive = test::flat_jpeg({100}, test::JpegKind::progressive);  // of two
  expect_beyond(with_scans(progressive, most_picture_scans - 1), "65 scans",
                "a progressive JPEG of at most 64 scans");
  expect_beyond(with_scans(test::flat_jpeg({100}), most_sequential_scans), "9 scans",
                "a sequential JPEG of at most 8 scans");
  // What only looks like a progressive frame, in a comment, makes it none.
  Bytes commented{0xFF, 0xD8, 0xFF, 0xFE, 0, 6, 0xFF, 0xC2, 0, 0};
  const Bytes rest = with_scans(test::flat_jpeg({100}), most_sequential_scans);
  commented.insert(commented.end(), rest.begin() + 2, rest.end());
  expect_beyond(commented, "9 scans", "a sequential JPEG of at most 8 scans");
}

// The table of one code of length 1 says that it has 16 x 255.
TEST(Decode, AJpegWithTooManyCodesIsRefused) {
  Bytes file = test::flat_jpeg({100});
  const Bytes table{0xFF, 0xC4, 0, 20, 0x10};
  const auto at = std::search(file.begin(), file.end(), table.begin(), table.end());
  ASSERT_NE(at, file.end());
  std::fill_n(at + 5, 16, 255);
  expect_broken(file);
}

std::int64_t peak_bytes() {
  rusage usage{};
  getrusage(RUSAGE_SELF, &usage);
  return std::int64_t{usage.ru_maxrss} * 1024;
}

// Nearly a mebibyte that unpacks to 150, under the header of a single pixel.
TEST(Decode, ZlibBombsTakeNoMemory) {
  const std::string stream = test::zlib_of_zeros(600'000);
  const Bytes file = test::to_bytes(test::png_file({1, 1, 8, test::grey}, stream, ""));
  ASSERT_LT(file.size(), most_picture_bytes);
  const std::int64_t before = peak_bytes();
  expect_broken(file);
  EXPECT_LT(peak_bytes() - before, 16 << 20);
}

// The same stream, short enough for the pixels.
TEST(Decode, ZlibStreamsThatFitAreRead) {
  const std::string stream = test::zlib_of_zeros(4);  // 1 + 4 * 258
  const Bytes file = test::to_bytes(test::png_file({1032, 1, 8, test::grey}, stream, ""));
  EXPECT_THAT(decoded(file).rgb, testing::Each(0));
}

// Whatever bytes come: no crash (a sanitiser's build sees more), and twice the same.
TEST(Decode, DamagedFilesAreTheSameEachTime) {
  Random random(331);
  Image8 image(20, 13);
  for (auto& code : image.rgb) code = static_cast<std::uint8_t>(random.below(256));
  const Bytes files[] = {
      test::to_bytes(encode_png(image)),
      test::png({4, 2, 8, test::palette}, "\x01\x02\x80\xFF\x01\x02\x80\xFF", "\x09\x08\x07"),
      test::flat_jpeg({100, 140, 150}),
      test::flat_jpeg({100, 140, 150}, test::JpegKind::progressive)};
  for (int i = 0; i < 4000; ++i) {
    Bytes file = files[i % 4];
    for (int changes = 1 + random.below(4); changes > 0; --changes)
      file[static_cast<std::size_t>(random.below(static_cast<int>(file.size())))] =
          static_cast<std::uint8_t>(random.below(256));
    if (random.chance(0.2)) file.resize(file.size() / 2);
    const auto first = decode_picture(file), second = decode_picture(file);
    ASSERT_EQ(first.index(), second.index());
    if (const auto* pixels = std::get_if<Image8>(&first)) {
      ASSERT_EQ(pixels->rgb, std::get<Image8>(second).rgb);
    }
  }
}

// Each table's four values look like the start of another segment of tables: 49 000 walks, most of
// them of 3 000 tables.
TEST(Decode, AJpegOfOverlappingTablesIsRefusedBeforeAllAreLookedAt) {
  Bytes file = test::flat_jpeg({100});
  Bytes table(17, 0);
  table[4] = 4;  // codes of length 4
  table.insert(table.end(), {0xFF, 0xC4, 0xFF, 0xFF});
  while (file.size() + table.size() <= most_picture_bytes)
    file.insert(file.end(), table.begin(), table.end());
  expect_broken(file);
}

TEST(Decode, EveryScanOfAJpegGoesOverItsPixels) {
  Bytes file = test::flat_jpeg({100});
  const auto scanned = [&] {
    return std::get<PictureSize>(measure_picture(file)).scanned_pixels();
  };
  EXPECT_EQ(scanned(), 4 * 32 * 32);
  for (int i = 0; i < 7; ++i) file.insert(file.end(), {0xFF, 0xDA});
  EXPECT_EQ(scanned(), 8 * 4 * 32 * 32);
  file = test::flat_jpeg({100}, test::JpegKind::progressive);
  EXPECT_EQ(scanned(), 2 * 32 * 32);
}

// Sampled four by four, a column of pixels is read in blocks of 32 columns.
TEST(Decode, AColumnOfAJpegCostsWhatItsBlocksDo) {
  EXPECT_EQ((PictureSize{1, 65500, 8, false}).scanned_pixels(), 8 * 4 * 32 * 65504);
  EXPECT_EQ((PictureSize{1, 65500}).scanned_pixels(), 65500);
}

}  // namespace
}  // namespace tia
