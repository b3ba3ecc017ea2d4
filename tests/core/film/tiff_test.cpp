#include "core/film/tiff.h"

#include <limits>

#include "core/parallel/stopped.h"
#include "tests/core/film/tiff_reader.h"
#include "tests/core/support.h"

namespace tia {
namespace {

using test::read_tiff;
using test::TiffPicture;

Image random_numbers(std::uint64_t seed, int width, int height) {
  test::Random random(seed);
  Image image(width, height);
  for (float& number : image.rgb)
    number = random.chance(0.1) ? std::numeric_limits<float>::infinity()
                                : static_cast<float>(random.in(-1e9, 1e9));
  return image;
}

TEST(Tiff, HoldsEveryNumberAsItIs) {
  for (const auto& [width, height] : {std::pair(1, 1), {1, 7}, {31, 1}, {64, 48}, {33, 17}})
    for (const int channels : {1, 3}) {
      const Image image = random_numbers(7, width, height);
      const TiffPicture picture = read_tiff(encode_tiff(image, channels));
      ASSERT_EQ(picture.width, static_cast<std::size_t>(width));
      ASSERT_EQ(picture.height, static_cast<std::size_t>(height));
      ASSERT_EQ(picture.channels, static_cast<std::size_t>(channels));
      for (int y = 0; y < height; ++y)
        for (int x = 0; x < width; ++x)
          for (int c = 0; c < channels; ++c)
            ASSERT_EQ(picture.at(static_cast<std::size_t>(x), static_cast<std::size_t>(y),
                                 static_cast<std::size_t>(c)),
                      image.at(x, y)[c]);
    }
}

// The fields that section 4 (and 6 for RGB) requires, and SampleFormat, without which the numbers
// are integers.
TEST(Tiff, HasTheTagsThatReadersNeed) {
  using Values = std::vector<std::uint32_t>;
  for (const std::uint32_t channels : {1U, 3U}) {
    auto tags = read_tiff(encode_tiff(Image(5, 3), static_cast<int>(channels))).tags;
    EXPECT_EQ(tags[258], Values(channels, 32));
    EXPECT_EQ(tags[259], Values{1});
    EXPECT_EQ(tags[262], Values{channels == 1 ? 1U : 2U});
    EXPECT_EQ(tags[274], Values{1});
    EXPECT_EQ(tags[278], Values{3});
    EXPECT_EQ(tags[279], Values{5 * 3 * 4 * channels});
    EXPECT_EQ(tags[282], (Values{1, 1}));
    EXPECT_EQ(tags[283], (Values{1, 1}));
    EXPECT_EQ(tags[284], Values{1});
    EXPECT_EQ(tags[296], Values{1});
    EXPECT_EQ(tags[339], Values(channels, 3));
  }
}

TEST(Tiff, EndsWhenAsked) {
  std::stop_source source;
  source.request_stop();
  EXPECT_THROW(encode_tiff(Image(2, 2), 1, source.get_token()), Stopped);
}

}  // namespace
}  // namespace tia
