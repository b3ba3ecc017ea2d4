// The pictures of a model's images: PNG files that libpng writes, and files put together here.
#include "core/models/images.h"

#include <gmock/gmock.h>
#include <png.h>

#include "tests/core/film/files.h"
#include "tests/core/models/webp_files.h"

namespace tia {
namespace {

using test::Bytes;
using testing::ElementsAre;
using testing::HasSubstr;
using testing::IsEmpty;

struct Pictures {
  std::vector<std::shared_ptr<const ImageRgba8>> images;
  std::vector<Fault> faults;
};
Pictures pictures_of(const std::vector<Bytes>& files, const ModelLimits& limits = {}) {
  Model model;
  for (const Bytes& file : files) model.images.push_back({"", file});
  Faults faults;
  Pictures out;
  out.images = decode_images(model, limits, faults);
  out.faults = faults.list();
  return out;
}
Fault fault_of(const std::vector<Bytes>& files, const ModelLimits& limits = {}) {
  const Pictures pictures = pictures_of(files, limits);
  for (const auto& image : pictures.images) EXPECT_EQ(image, nullptr);
  EXPECT_EQ(pictures.faults.size(), 1U);
  return pictures.faults.empty() ? Fault{} : pictures.faults[0];
}

Bytes libpng_file(int width, int height, const Bytes& rgba) {
  png_image image{};
  image.version = PNG_IMAGE_VERSION;
  image.width = static_cast<png_uint_32>(width);
  image.height = static_cast<png_uint_32>(height);
  image.format = PNG_FORMAT_RGBA;
  png_alloc_size_t size = 0;
  EXPECT_NE(png_image_write_get_memory_size(image, size, 0, rgba.data(), 0, nullptr), 0);
  Bytes file(size);
  EXPECT_NE(png_image_write_to_memory(&image, file.data(), &size, 0, rgba.data(), 0, nullptr), 0);
  file.resize(size);
  return file;
}

Bytes noise_rgba(int width, int height) {
  test::Random random(350);
  Bytes rgba(static_cast<std::size_t>(4 * width * height));
  for (auto& code : rgba) code = static_cast<std::uint8_t>(random.below(256));
  return rgba;
}

TEST(Images, TheCodesOfAPngComeBackWithTheirAlpha) {
  for (const auto& [width, height] : {std::pair{1, 1}, {7, 3}, {64, 65}}) {
    const Bytes rgba = noise_rgba(width, height);
    const Pictures pictures = pictures_of({libpng_file(width, height, rgba)});
    EXPECT_THAT(pictures.faults, IsEmpty());
    ASSERT_NE(pictures.images.at(0), nullptr);
    EXPECT_EQ(pictures.images[0]->width, width);
    EXPECT_EQ(pictures.images[0]->height, height);
    EXPECT_EQ(pictures.images[0]->rgba, rgba);
  }
}

TEST(Images, EachFormatIsDecodedAtItsPlace) {
  const Pictures pictures = pictures_of({test::lossless_webp(1, 1, {1, 2, 3, 4, 5}, "0"),
                                         {},
                                         test::flat_jpeg({100}),
                                         test::png({1, 1, 8, test::rgba}, "\x09\x08\x07\x06")});
  EXPECT_THAT(pictures.faults, IsEmpty());
  ASSERT_EQ(pictures.images.size(), 4U);
  EXPECT_EQ(pictures.images[0]->rgba, (Bytes{1, 2, 4, 5}));
  EXPECT_EQ(pictures.images[1], nullptr);
  EXPECT_EQ(pictures.images[2]->rgba.size(), 256U);
  EXPECT_EQ(pictures.images[3]->rgba, (Bytes{9, 8, 7, 6}));
}

TEST(Images, OnlyThreeFormatsBeginLikeImages) {
  EXPECT_TRUE(is_image(test::png({1, 1, 8, test::grey}, "\x40")));
  EXPECT_TRUE(is_image(test::flat_jpeg({100})));
  EXPECT_TRUE(is_image(test::to_bytes("RIFF....WEBP")));
  EXPECT_FALSE(is_image({}));
  EXPECT_FALSE(is_image(test::to_bytes("\xABKTX 20\xBB\r\n\x1A\n")));
}

TEST(Images, EveryStartOfAFileIsAFaultOrAPicture) {
  for (const Bytes& file : {libpng_file(5, 4, noise_rgba(5, 4)), test::flat_jpeg({100, 140, 150}),
                            test::lossless_webp(3, 2, {10, 20, 200, 30, 40}, "010110")})
    for (std::size_t length = 1; length < file.size(); ++length) {
      const Pictures pictures =
          pictures_of({Bytes(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(length))});
      ASSERT_NE(pictures.faults.empty(), pictures.images.at(0) == nullptr) << length;
      for (const Fault& fault : pictures.faults) {
        EXPECT_EQ(fault.pointer, "/images/0");
        EXPECT_EQ(fault.kind, FaultKind::wrong_type);
      }
    }
}

// ---- limits -------------------------------------------------------------------------------------

TEST(Images, AHeaderOfBillionsOfPixelsCostsNothing) {
  for (const auto& [width, height] : {std::pair{65535U, 65535U}, {16385U, 1U}, {1U, 16385U}}) {
    const Fault fault = fault_of({test::png({width, height, 8, test::rgba}, "x")});
    EXPECT_EQ(fault.kind, FaultKind::limit);
    EXPECT_EQ(fault.pointer, "/images/0");
    EXPECT_EQ(fault.got, Value(std::to_string(width) + " x " + std::to_string(height) + " pixels"));
  }
  EXPECT_THAT(fault_of({test::png({16385, 1, 8, test::rgba}, "x")}).allowed,
              HasSubstr("at most 16384 pixels a side"));
  EXPECT_EQ(fault_of({test::lossless_webp(16384, 16384, {1, 2, 3, 4, 5}, "")}).kind,
            FaultKind::limit);
}

TEST(Images, AllTogetherHaveNoMorePixelsThanTheLimit) {
  ModelLimits limits;
  limits.texture_pixels = 6;
  const Bytes two = test::png({2, 1, 8, test::grey}, "ab");
  const Bytes three = test::lossless_webp(3, 1, {1, 2, 3, 4, 5}, "010");
  EXPECT_THAT(pictures_of({two, two, two}, limits).faults, IsEmpty());
  const Fault fault = fault_of({two, three, two}, limits);
  EXPECT_EQ(fault.kind, FaultKind::limit);
  EXPECT_EQ(fault.pointer, "/images/2");
  EXPECT_EQ(fault.got, Value("2 pixels more"));
  EXPECT_EQ(fault.allowed, "textures of at most 6 pixels together");
}

// Headers are looked at first: of these the first is broken where pixels begin.
TEST(Images, LimitsAreFoundBeforeAnythingIsDecoded) {
  const Bytes broken = test::png({2, 1, 8, test::grey}, "a");
  EXPECT_EQ(fault_of({broken, test::png({20000, 1, 8, test::grey}, "x")}).pointer, "/images/1");
  EXPECT_EQ(fault_of({broken, broken.size() > 2 ? Bytes{'G', 'I', 'F'} : broken}).allowed,
            "a PNG, JPEG or WebP picture");
}

// 8 x 8 pixels are read in a block of 32 x 32, and by a sequential scan four times as slowly.
TEST(Images, TheScansOfJpegsAreLimitedTogether) {
  ModelLimits limits;
  limits.texture_pixels = 4 * 32 * 32 / 16;
  EXPECT_THAT(pictures_of({test::flat_jpeg({100})}, limits).faults, IsEmpty());
  const Fault fault = fault_of({test::flat_jpeg({100}), test::flat_jpeg({100})}, limits);
  EXPECT_EQ(fault.pointer, "/images/1");
  EXPECT_THAT(fault.allowed, HasSubstr("a JPEG's with each of its scans"));
}

TEST(Images, ReadingEndsWhenThatIsAskedFor) {
  Model model;
  model.images.push_back({"", test::flat_jpeg({100})});
  std::stop_source stop;
  stop.request_stop();
  Faults faults(stop.get_token());
  EXPECT_THROW(decode_images(model, {}, faults), Stopped);
}

}  // namespace
}  // namespace tia
