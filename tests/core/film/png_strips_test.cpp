// Large pictures: what is compressed in strips is one stream, whoever compresses which.
#include <gtest/gtest.h>

#include "core/film/png.h"
#include "core/parallel/stopped.h"
#include "tests/core/film/png_chunks.h"
#include "tests/core/png/inflate.h"

namespace tia::test {
namespace {

// What the chunks' stream unpacks to; checks its Adler-32, which stb_image does not look at.
std::string unpacked(const std::string& png, std::size_t bytes) {
  std::string stream;
  for (const Chunk& chunk : chunks_of(png))
    if (chunk.type == "IDAT") stream += chunk.data;
  return inflated(stream, bytes);
}

TEST(PngInStrips, SameRowsComeOut) {
  // 21845 pixels are a quarter of a strip, 87381 a whole one.
  const std::pair<int, int> sizes[] = {{1, 1},       {21845, 3}, {21845, 4}, {21845, 5},
                                       {87381, 1},   {87382, 1}, {87381, 2}, {87380, 3},
                                       {1, 100'000}, {640, 480}, {601, 701}, {350'000, 2}};
  for (const auto& [width, height] : sizes) {
    SCOPED_TRACE(std::to_string(width) + " x " + std::to_string(height));
    for (const Image8& image :
         {noise(width, height, 123), ramp(width, height), Image8(width, height)}) {
      const Scanlines lines = scanlines_of(image);
      const std::string png = encode_png(lines);
      EXPECT_TRUE(unpacked(png, lines.size()) ==
                  std::string(reinterpret_cast<const char*>(lines.data()), lines.size()));
    }
  }
}

TEST(PngInStrips, WhoCompressesWhichStripChangesNoByte) {
  const Scanlines lines = scanlines_of(ramp(701, 603));
  const std::string png = encode_png(lines);
  EXPECT_EQ(encode_png(lines, Workers([](int count, const auto& task) {
                         for (int i = count; i-- > 0;) task(i);
                       })),
            png);
  Pool pool(5);
  for (const int threads : {1, 2, 5}) EXPECT_EQ(encode_png(lines, pool.workers(threads)), png);
}

TEST(PngInStrips, AStripCostsFewBytes) {
  const Image8 image = ramp(1920, 1080);
  constexpr std::size_t strips = 24;
  EXPECT_LT(encode_png(scanlines_of(image)).size(), encode_png(image).size() + 64 * strips);
}

TEST(PngInStrips, ToldToStopNoFurtherStripIsCompressed) {
  const Scanlines lines = scanlines_of(ramp(1920, 1080));
  Pool pool(1);
  std::stop_source source;
  int done = 0;
  EXPECT_THROW(encode_png(lines, Workers([&](int count, const auto& task) {
                            pool.for_each(count, 1, source.get_token(), [&](int i) {
                              task(i);
                              if (++done == 3) source.request_stop();
                            });
                          })),
               Stopped);
  EXPECT_EQ(done, 3);
}

TEST(PngInStrips, AreForMoreThanAMebibyte) {
  EXPECT_FALSE(is_cut_in_strips(640, 480));
  EXPECT_FALSE(is_cut_in_strips(349'525, 1));  // 1 + 3 x 349525 = 2^20
  EXPECT_TRUE(is_cut_in_strips(349'526, 1));
  EXPECT_TRUE(is_cut_in_strips(1 << 14, 1 << 14));
}

}  // namespace
}  // namespace tia::test
