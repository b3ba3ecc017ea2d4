#include "core/film/exr.h"

#include <gtest/gtest.h>

#include <cstdlib>
#include <numeric>

#include "core/film/half.h"
#include "tests/core/film/exr_reader.h"
#include "tests/core/support.h"

namespace tia::test {
namespace {

double half_number(float x) { return number_of_half(half_of(x)); }

TEST(Half, EveryHalfIsItself) {
  for (unsigned bits = 0; bits < 0x10000; ++bits) {
    const double number = number_of_half(bits);
    if (std::isnan(number)) EXPECT_TRUE(std::isnan(half_number(static_cast<float>(number))));
    else ASSERT_EQ(half_of(static_cast<float>(number)), bits) << number;
  }
}

// Of neighbours the middle goes to the even one, and what is beside it to the nearer one. All are
// floats: a half has 11 digits, a middle 12. From the largest half, 65504, on infinity is the next
// one, as if it were 65536 (IEEE 754-2019, 4.3.1).
TEST(Half, IsTheNearestAndOfTwoTheEvenOne) {
  for (unsigned bits = 0; bits < 0x7C00; ++bits) {
    const auto low = static_cast<float>(number_of_half(bits));
    const auto high = bits == 0x7BFF ? 65536.0F : static_cast<float>(number_of_half(bits + 1));
    const float middle = (low + high) / 2;
    const unsigned even = bits % 2 == 0 ? bits : bits + 1;
    ASSERT_EQ(half_of(middle), even) << middle;
    ASSERT_EQ(half_of(-middle), even | 0x8000U) << middle;
    ASSERT_EQ(half_of(std::nextafter(middle, 0.0F)), bits) << middle;
    ASSERT_EQ(half_of(std::nextafter(middle, 1e9F)), bits + 1) << middle;
  }
  EXPECT_EQ(half_of(1e30F), 0x7C00);
  EXPECT_EQ(half_of(-std::numeric_limits<float>::infinity()), 0xFC00);
  EXPECT_EQ(half_of(1e-30F), 0);
}

/// Random: planes, what they are called, and where the picture has them.
struct RandomPicture {
  Planes planes;
  ExrHead head;

  RandomPicture(int width, int height, double noise, std::uint64_t seed)
      : planes(width, height, 4),
        head{.width = width + 9,
             .height = height + 5,
             .x0 = 7,
             .y0 = 3,
             .channels = {{"object", ExrType::uint, 0},
                          {"Z", ExrType::real, 1},
                          {"A", ExrType::half, 2},
                          {"direct.R", ExrType::real, 3}},
             .texts = {{"tia:recipe", "{\"a\":\"\xC3\xBC\"}"}, {"tia:version", "1"}}} {
    Random random(seed);
    FilmTile tile;
    for (tile.y = 0; tile.y < height; tile.y += FilmTile::size)
      for (tile.x = 0; tile.x < width; tile.x += FilmTile::size) {
        tile.width = std::min(FilmTile::size, width - tile.x);
        tile.height = std::min(FilmTile::size, height - tile.y);
        for (int plane = 0; plane < 4; ++plane) {
          for (float& number : tile.r) {
            const double drawn = random.in(-noise, noise);
            number = plane == 0 ? static_cast<float>(static_cast<int>(std::fabs(drawn)))
                                : static_cast<float>(std::sqrt(2.0) + drawn);
          }
          planes.put(tile, tile.r, plane);
        }
      }
  }
  double at(int plane, std::size_t pixel) const {
    const auto width = static_cast<std::size_t>(planes.width());
    return static_cast<double>(planes.row(plane, static_cast<int>(pixel / width))[pixel % width]);
  }
  void expect_read(const ExrFile& read) const {
    const int width = planes.width(), height = planes.height();
    EXPECT_EQ(read.data, (ExrFile::Box{7, 3, 6 + width, 2 + height}));
    EXPECT_EQ(read.display, (ExrFile::Box{0, 0, width + 8, height + 4}));
    EXPECT_EQ(read.attributes.at("tia:recipe"), "{\"a\":\"\xC3\xBC\"}");
    EXPECT_EQ(read.attributes.at("tia:version"), "1");
    ASSERT_EQ(read.types,
              (std::map<std::string, int>{{"A", 1}, {"Z", 2}, {"direct.R", 2}, {"object", 0}}));
    for (std::size_t i = 0; i < static_cast<std::size_t>(width * height); ++i) {
      ASSERT_EQ(read.numbers.at("object").at(i), at(0, i));
      ASSERT_EQ(read.numbers.at("Z").at(i), at(1, i));
      // A half has 11 binary digits.
      ASSERT_NEAR(read.numbers.at("A").at(i), at(2, i), std::fabs(at(2, i)) * 0x1p-11);
      ASSERT_EQ(read.numbers.at("direct.R").at(i), at(3, i));
    }
  }
};

TEST(Exr, IsReadAsTheFormatSays) {
  const std::pair<int, int> sizes[] = {{1, 1}, {1, 40}, {40, 1}, {33, 16}, {37, 17}, {64, 70}};
  for (const auto& [width, height] : sizes) {
    SCOPED_TRACE(testing::Message() << width << " x " << height);
    const RandomPicture picture(width, height, 1000, 5);
    const ExrFile read = read_exr(encode_exr(picture.head, picture.planes, {}));
    picture.expect_read(read);
    EXPECT_EQ(read.plain_blocks + read.packed_blocks, (height + 15) / 16);
  }
}

TEST(Exr, BlocksThatDoNotBecomeShorterStayAsTheyAre) {
  // Twelve bytes of noise: zlib would add its head and its sum.
  const RandomPicture noisy(1, 1, 1e6, 7);
  EXPECT_EQ(read_exr(encode_exr(noisy.head, noisy.planes, {})).plain_blocks, 1);
  const RandomPicture smooth(64, 32, 0, 8);
  const std::string file = encode_exr(smooth.head, smooth.planes, {});
  EXPECT_EQ(read_exr(file).packed_blocks, 2);
  EXPECT_LT(file.size(), 1500U);
}

TEST(Exr, SameBytesWhoeverWorksAndInWhicheverOrder) {
  const RandomPicture picture(50, 100, 10, 9);
  const std::string expected = encode_exr(picture.head, picture.planes, {});
  const Workers backwards([](int count, const Workers::Task& task) {
    for (int i = count; i-- > 0;) task(i);
  });
  EXPECT_EQ(encode_exr(picture.head, picture.planes, backwards), expected);
  ExrHead other = picture.head;
  std::ranges::reverse(other.channels);
  EXPECT_EQ(encode_exr(other, picture.planes, {}), expected);
}

TEST(Exr, EndsWhereItIsAskedTo) {
  const RandomPicture picture(8, 40, 1, 10);
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(encode_exr(picture.head, picture.planes, Workers(source.get_token())), Stopped);
}

// The library's own programs read what is ours, all pixels of it, and write them anew.
TEST(Exr, OpenExrsOwnLibraryReadsTheSame) {
  const RandomPicture picture(45, 50, 100, 11);
  const std::string mine = testing::TempDir() + "tia_exr_test.exr",
                    theirs = testing::TempDir() + "tia_exr_test_tiled.exr";
  std::ofstream(mine, std::ios::binary) << encode_exr(picture.head, picture.planes, {});
  const std::string command = "exrmaketiled -o -z none -t 64 64 " + mine + " " + theirs;
  ASSERT_EQ(std::system(command.c_str()), 0) << command;
  std::ostringstream read;
  read << std::ifstream(theirs, std::ios::binary).rdbuf();
  picture.expect_read(read_exr(read.str()));
}

}  // namespace
}  // namespace tia::test
