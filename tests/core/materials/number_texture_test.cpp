// Textures in the place of numbers, against their closed forms.
#include "core/materials/number_texture.h"

#include "core/film/png.h"
#include "core/materials/material.h"
#include "tests/core/film/files.h"
#include "tests/core/materials/textures.h"

namespace tia {
namespace {

using test::Random;

NumberTextureForm number_form(const std::string& json) {
  return prepare(read_described<NumberTexture>(parse_json(json)));
}
double number_at(const NumberTextureForm& form, const Vec3d& p) {
  return tia::number_at(form, p, {}, 0);
}

TEST(NumberTexture, BlackIsTheFirstOfItsRangeAndWhiteTheSecondInEitherOrder) {
  Random random(850);
  for (int i = 0; i < 200; ++i) {
    const double a = random.unit(), b = random.unit();
    NumberTexture texture;
    texture.range = {a, b};
    const NumberTextureForm form = prepare(texture);  // a checker, white at the origin
    EXPECT_EQ(number_at(form, {0.5, 0.5, 0.5}), b);
    EXPECT_EQ(number_at(form, {1.5, 0.5, 0.5}), a);
  }
}

TEST(NumberTexture, BetweenThemItIsProportionalToTheColour) {
  Random random(851);
  const NumberTextureForm form =
      number_form(R"({"type":"gradient","colors":[0,1],"range":[0.9,0.2]})");
  for (int i = 0; i < 200; ++i) {
    const double x = random.unit();
    EXPECT_NEAR(number_at(form, {x, 0, 0}), 0.9 - 0.7 * x, 1e-15);
  }
}

TEST(NumberTexture, OfARangeOfOneNumberIsThatNumberToTheBit) {
  Random random(852);
  for (const char* type : {"checker", "stripes", "gradient", "noise", "marble", "wood"})
    for (int i = 0; i < 50; ++i) {
      const double number = random.unit();
      NumberTexture texture = read_described<NumberTexture>(
          parse_json(std::string(R"({"type":")") + type + R"(","range":[0,1]})"));
      texture.range = {number, number};
      EXPECT_EQ(number_at(prepare(texture), random.point(9)), number) << type;
    }
}

TEST(NumberTexture, StaysWithinItsRange) {
  Random random(853);
  for (const char* type : {"gradient", "noise", "marble", "wood"}) {
    NumberTextureForm form =
        number_form(std::string(R"({"type":")") + type + R"(","range":[0,1]})");
    for (int i = 0; i < 500; ++i) {
      const double a = random.unit(), b = random.unit();
      form.range = {a, b};
      const double number = number_at(form, random.point(9));
      EXPECT_GE(number, std::min(a, b)) << type;
      EXPECT_LE(number, std::max(a, b)) << type;
    }
  }
}

// Two pixels: codes 51, 102, 153 and 204, 255, 0.
TEST(NumberTexture, OfAPictureIsTheCodeOfOneChannelWithoutACurve) {
  Image8 image(2, 1);
  image.rgb = {51, 102, 153, 204, 255, 0};
  const std::string data = test::base64(encode_png(image));
  const auto at = [&](const std::string& more, double u) {
    const NumberTextureForm form =
        number_form(R"({"type":"image","filter":"nearest","data":")" + data + "\"," + more + "}");
    return tia::number_at(form, {}, {u, 0.5}, 0);
  };
  const std::string whole = R"("range":[0,1])";
  EXPECT_NEAR(at(whole, 0.2), 0.2, 1e-15) << "red where nothing is said";
  EXPECT_NEAR(at(whole + R"(,"channel":"r")", 0.7), 0.8, 1e-15);
  EXPECT_NEAR(at(whole + R"(,"channel":"g")", 0.2), 0.4, 1e-15);
  EXPECT_EQ(at(whole + R"(,"channel":"g")", 0.7), 1);
  EXPECT_NEAR(at(whole + R"(,"channel":"b")", 0.2), 0.6, 1e-15);
  EXPECT_NEAR(at(R"("range":[0.5,0.25],"channel":"g")", 0.2), 0.4, 1e-15);
  EXPECT_EQ(at(whole + R"(,"transfer":"srgb")", 0.2), srgb_to_linear(0.2));
}

TEST(NumberTexture, TellsItsMemory) {
  Principled principled;
  EXPECT_EQ(heap_bytes(prepare(principled)), 0U);
  NumberTexture texture;
  texture.kind = OfNumbers<Noise>{};
  principled.roughness = texture;
  const std::size_t one = heap_bytes(prepare(principled));
  EXPECT_GE(one, sizeof(PrincipledForm::Textured) + 2 * sizeof(Vec3d));
  principled.metallic = texture;
  EXPECT_GE(heap_bytes(prepare(principled)), 2 * one - heap_block);
}

}  // namespace
}  // namespace tia
