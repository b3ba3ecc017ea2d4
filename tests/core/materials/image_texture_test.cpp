// Pictures on surfaces, against texels that are known exactly; what is refused.
#include "core/film/decode.h"
#include "core/film/png.h"
#include "tests/core/film/files.h"
#include "tests/core/materials/textures.h"

namespace tia {
namespace {

using test::base64;
using test::expect_color;
using test::expect_faults;
using test::texture_faults;
using test::texture_form;
using test::to_text;

// Three by two pixels; the upper row is red, green, blue, the lower white, grey, black.
Image8 six_pixels() {
  Image8 image(3, 2);
  image.rgb = {255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255, 128, 128, 128, 0, 0, 0};
  return image;
}
const Vec3d red_texel{1, 0, 0}, green_texel{0, 1, 0}, blue_texel{0, 0, 1}, white_texel{1, 1, 1},
    black_texel{0, 0, 0};

std::string image_json(const Image8& image, const std::string& more = "") {
  return R"({"type":"image","data":")" + base64(encode_png(image)) + "\"" + more + "}";
}
std::string data_json(std::string_view file) {
  return R"({"type":"image","data":")" + base64(file) + "\"}";
}
Vec3d texel_at(const TextureForm& form, double u, double v) {
  return color_at(form, {}, {u, v}, 0);
}

TEST(ImageTexture, NearestIsThePixelThatTheCoordinatesLieIn) {
  const TextureForm form = texture_form(image_json(six_pixels(), R"(,"filter":"nearest")"));
  EXPECT_EQ(texel_at(form, 0.1, 0.9), red_texel);
  EXPECT_EQ(texel_at(form, 0.5, 0.9), green_texel);
  EXPECT_EQ(texel_at(form, 0.9, 0.51), blue_texel);
  EXPECT_EQ(texel_at(form, 0.1, 0.49), white_texel);
  EXPECT_EQ(texel_at(form, 0.9, 0.1), black_texel);
  EXPECT_EQ(texel_at(form, 0, 0), white_texel) << "u to the right, v up";
}

TEST(ImageTexture, StandsBesideItself) {
  for (const char* filter : {"nearest", "bilinear"}) {
    const TextureForm form =
        texture_form(image_json(six_pixels(), std::string(R"(,"filter":")") + filter + "\""));
    for (int i = 0; i < 300; ++i) {
      const double u = i % 20 / 32.0, v = i % 15 / 16.0;  // exact, and so is what they are added to
      for (const auto& [right, up] : {std::pair{1.0, 0.0}, {-1.0, 2.0}, {5.0, -7.0}})
        EXPECT_EQ(texel_at(form, u + right, v + up), texel_at(form, u, v)) << filter;
    }
  }
}

TEST(ImageTexture, RepeatsWithinTheSurface) {
  const TextureForm form =
      texture_form(image_json(six_pixels(), R"(,"filter":"nearest","repeat":[4,2])"));
  for (int i = 0; i < 4; ++i) {
    EXPECT_EQ(texel_at(form, (i + 0.1) / 4, 0.95), red_texel);
    EXPECT_EQ(texel_at(form, (i + 0.9) / 4, 0.45), blue_texel);
  }
  const TextureForm mirrored =
      texture_form(image_json(six_pixels(), R"(,"filter":"nearest","repeat":[-1,1])"));
  EXPECT_EQ(texel_at(mirrored, 0.1, 0.9), blue_texel);
  EXPECT_EQ(texel_at(mirrored, 0.9, 0.9), red_texel);
}

TEST(ImageTexture, SrgbCodesBecomeLinearLight) {
  const TextureForm form = texture_form(image_json(six_pixels(), R"(,"filter":"nearest")"));
  const double grey = srgb_to_linear(128 / 255.0);
  EXPECT_NEAR(grey, 0.2158605, 1e-7);
  EXPECT_EQ(texel_at(form, 0.5, 0.25), (Vec3d{grey, grey, grey}));
  const TextureForm linear =
      texture_form(image_json(six_pixels(), R"(,"filter":"nearest","transfer":"linear")"));
  EXPECT_EQ(texel_at(linear, 0.5, 0.25), (Vec3d{128 / 255.0, 128 / 255.0, 128 / 255.0}));
}

TEST(ImageTexture, EveryCodeOfAPictureComesBack) {
  Image8 ramp(256, 1);
  for (std::size_t i = 0; i < ramp.rgb.size(); ++i) ramp.rgb[i] = static_cast<std::uint8_t>(i / 3);
  const TextureForm form = texture_form(image_json(ramp, R"(,"filter":"nearest")"));
  for (int code = 0; code < 256; ++code) {
    const Vec3d light = texel_at(form, (code + 0.5) / 256, 0.5);
    EXPECT_EQ(encode_srgb(static_cast<float>(light.x)), code);
    EXPECT_EQ(light.x, light.z);
  }
}

TEST(ImageTexture, BilinearIsThePixelInItsMiddleAndTheMeanBetween) {
  const TextureForm form = texture_form(image_json(six_pixels()));
  expect_color(texel_at(form, 1 / 6.0, 0.75), red_texel, 1e-15);
  expect_color(texel_at(form, 3 / 6.0, 0.75), green_texel, 1e-15);
  expect_color(texel_at(form, 5 / 6.0, 0.25), black_texel, 1e-15);
  expect_color(texel_at(form, 2 / 6.0, 0.75), {0.5, 0.5, 0}, 1e-15);
  expect_color(texel_at(form, 1 / 6.0, 0.5), {1, 0.5, 0.5}, 1e-15);
  expect_color(texel_at(form, 1 / 6.0 + 0.25 / 3, 0.75), {0.75, 0.25, 0}, 1e-15);
  // Across the borders: blue is beside red, white above red.
  expect_color(texel_at(form, 0, 0.75), {0.5, 0, 0.5}, 1e-15);
  expect_color(texel_at(form, 1, 0.75), {0.5, 0, 0.5}, 1e-15);
  expect_color(texel_at(form, 1 / 6.0, 0), {1, 0.5, 0.5}, 1e-15);
}

TEST(ImageTexture, LightIsMeantNotCodes) {
  Image8 two(2, 1);
  two.rgb = {255, 255, 255, 0, 0, 0};
  expect_color(texel_at(texture_form(image_json(two)), 0.5, 0.5), {0.5, 0.5, 0.5}, 1e-15);
}

TEST(ImageTexture, AnyCoordinatesGiveAColour) {
  for (const char* more : {"", R"(,"filter":"nearest")", R"(,"repeat":[1e6,-1e6])"}) {
    const TextureForm form = texture_form(image_json(six_pixels(), more));
    for (const double u : {-1e-300, -1e-17, 1e-17, 1.0, std::nextafter(1.0, 0.0), -0.0, 1e9, -1e9,
                           1e300, HUGE_VAL, std::nan("")}) {
      const Vec3d light = texel_at(form, u, u);
      EXPECT_TRUE(light.x >= 0 && light.x <= 1) << u << more;
    }
  }
}

TEST(ImageTexture, JpegsAreReadToo) {
  const TextureForm form = texture_form(R"({"type":"image","transfer":"linear","data":")" +
                                        base64(to_text(test::flat_jpeg({51}))) + R"("})");
  expect_color(texel_at(form, 0.3, 0.3), {0.2, 0.2, 0.2}, 1e-15);
}

TEST(ImageTexture, CopiesShareTheirPixels) {
  const Texture texture = test::texture(image_json(six_pixels()));
  const Texture copy = texture;
  EXPECT_EQ(copy, texture);
  EXPECT_EQ(std::get<ImageTexture>(copy.kind).data.pixels,
            std::get<ImageTexture>(texture.kind).data.pixels);
  EXPECT_EQ(test::texture(image_json(six_pixels())), texture) << "the text is what counts";
  EXPECT_FALSE(test::texture(image_json(Image8(3, 2))) == texture);
}

// ---- faults ---------------------------------------------------------------------------------

TEST(ImageTexture, WhatCannotBeDecodedIsRefusedWhereItStands) {
  const auto wrong = FaultKind::wrong_type, limit = FaultKind::limit;
  expect_faults(texture_faults(R"({"type":"image"})"),
                {{FaultKind::missing, "/data", "", "in base64"}});
  expect_faults(texture_faults(R"({"type":"image","data":5})"),
                {{wrong, "/data", "5", "a PNG or JPEG file in base64"}});
  expect_faults(texture_faults(R"({"type":"image","data":"AAAA!AAA"})"),
                {{wrong, "/data", "\"!AAA\"", "not from its character 4 on"}});
  expect_faults(texture_faults(R"({"type":"image","data":""})"),
                {{wrong, "/data", "\"bytes that begin like neither\"", "PNG or JPEG picture"}});
  expect_faults(texture_faults(data_json(encode_png(six_pixels()).substr(0, 60))),
                {{wrong, "/data", "\"bytes that cannot be decoded\"", "a whole PNG or JPEG"}});
  expect_faults(texture_faults(data_json(test::png_file({5000, 5000, 8, test::grey}, "x", ""))),
                {{limit, "/data", "\"5000 x 5000 pixels\"", "at most 4194304 pixels"}});
  expect_faults(texture_faults(data_json(std::string(most_picture_bytes + 1, 'x'))),
                {{limit, "/data", "\"1048577 bytes\"", "at most 1048576 bytes"}});
  expect_faults(texture_faults(data_json(std::string(most_picture_bytes + 3, 'x'))),
                {{limit, "/data", "\"1398108 digits of base64\"", "at most 1048576 bytes"}});
}

TEST(ImageTexture, OtherFieldsHaveTheirRangesAndPatternsTheirs) {
  const auto range = FaultKind::out_of_range;
  expect_faults(texture_faults(image_json(six_pixels(), R"(,"repeat":[0,1])")),
                {{range, "/repeat/0", "0", "not 0"}});
  expect_faults(
      texture_faults(image_json(six_pixels(), R"(,"filter":"linear")")),
      {{FaultKind::unknown_name, "/filter", "\"linear\"", "bilinear, nearest", "bilinear"}});
  expect_faults(texture_faults(image_json(six_pixels(), R"(,"scale":2)")),
                {{FaultKind::unknown_name, "/scale", "\"scale\"", "data", ""}});
}

// 2048 x 2048 pixels of one bit are few bytes: five files of a kilobyte would be 60 MiB.
TEST(ImageTexture, AllPicturesOfAnInputTogetherAreBounded) {
  const test::Bytes file = test::png({2048, 2048, 1, test::grey}, std::string(2048 * 256, '\0'));
  EXPECT_LT(file.size(), 2000U);
  std::string list;
  for (int i = 0; i < 5; ++i) list += (i > 0 ? "," : "") + data_json(to_text(file));
  Faults faults;
  std::vector<Texture> textures;
  read_value(parse_json("[" + list + "]"), Place{}, Spec{}, faults, textures);
  expect_faults(faults.list(), {{FaultKind::limit, "/4/data", "\"4194304 pixels more\"",
                                 "at most 16777216 pixels together"}});
}

// A scan without a byte of its own still goes over all pixels: a kilobyte could take seconds.
TEST(ImageTexture, ScansOfAllPicturesTogetherAreBounded) {
  test::Bytes file = test::flat_jpeg({100}, test::JpegKind::progressive);
  const test::Bytes size{8, 0, 8, 0, 8};  // eight bits, eight by eight pixels
  const auto at = std::search(file.begin(), file.end(), size.begin(), size.end());
  at[1] = at[3] = 8;  // 2056 by 2056
  at[2] = at[4] = 0;  // 2048 by 2048
  for (int i = 2; i < 16; ++i) file.insert(file.end(), {0xFF, 0xDA});
  std::string list;
  for (int i = 0; i < 3; ++i) list += (i > 0 ? "," : "") + data_json(to_text(file));
  Faults faults;
  std::vector<Texture> textures;
  read_value(parse_json("[" + list + "]"), Place{}, Spec{}, faults, textures);
  ASSERT_FALSE(faults.empty());
  const Fault& last = faults.list().back();
  EXPECT_EQ(last.pointer, "/2/data");
  EXPECT_EQ(last.kind, FaultKind::limit);
  EXPECT_THAT(last.allowed,
              testing::HasSubstr("134217728 pixels together, a JPEG's with each of its scans"));
}

TEST(ImageTexture, NoPictureIsReadForWhoHasLeft) {
  std::stop_source source;
  source.request_stop();
  Faults faults(source.get_token());
  Texture texture;
  EXPECT_THROW(read_value(parse_json(image_json(six_pixels())), Place{}, Spec{}, faults, texture),
               Stopped);
}

}  // namespace
}  // namespace tia
