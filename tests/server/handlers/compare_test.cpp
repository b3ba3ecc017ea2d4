// /compare: two pictures held against each other as they are shown.
#include <cmath>

#include "tests/server/picture_support.h"
#include "tests/server/support.h"

namespace tia::test {
namespace {

std::string comparison_of(const std::string& a, const std::string& b,
                          const std::string& more = "") {
  const std::string size = R"("width":48,"height":36)";
  return R"({"a":{)" + size + a + R"(},"b":{)" + size + b + "}" + more + "}";
}
Value compared(const std::string& body) {
  const Response response = host().post("/compare", body);
  EXPECT_EQ(response.status, 200) << response.body;
  return parse_json(response.body);
}
bool is_null(const Value& value) { return to_json(value) == "null"; }

TEST(Compare, OfEqualPicturesHasNoNoise) {
  const Value told =
      compared(comparison_of(R"(,"key":"a")", R"(,"key":"a")", R"(,"gaze":[24,18])"));
  EXPECT_EQ(number_at(told, "mse"), 0);
  EXPECT_EQ(number_at(told, "max"), 0);
  EXPECT_TRUE(is_null(at(told, "psnr_db")));
  EXPECT_NEAR(number_at(told, "ssim"), 1, 1e-12);
}

// What is shown is what a PNG's codes round.
TEST(Compare, TellsTheErrorOfWhatIsShown) {
  const std::string query = "/render?width=48&height=36";
  const auto a = decode_png(host().get(query).body),
             b = decode_png(host().get(query + "&key=a").body);
  double sum = 0;
  for (std::size_t i = 0; i < a.rgb.size(); ++i) sum += std::pow((a.rgb[i] - b.rgb[i]) / 255.0, 2);
  const double mse = sum / static_cast<double>(a.rgb.size());
  const Value told = compared(comparison_of("", R"(,"key":"a")"));
  EXPECT_NEAR(number_at(told, "mse"), mse, 0.01 * mse);
  EXPECT_NEAR(number_at(told, "psnr_db"), -10 * std::log10(number_at(told, "mse")), 1e-9);
  EXPECT_LT(number_at(told, "ssim"), 0.999);
  EXPECT_TRUE(at(told, "bands").as<Value::Array>()->empty());
}

TEST(Compare, OfFeaturesComparesWhatTheyShow) {
  const Value told =
      compared(comparison_of(R"(,"integrator":"normal")", R"(,"integrator":"normal","seed":3)"));
  EXPECT_EQ(number_at(told, "mse"), 0);
  const Value depth =
      compared(comparison_of(R"(,"integrator":"depth")", R"(,"integrator":"depth","key":"a")"));
  EXPECT_EQ(number_at(depth, "max"), 0);
}

TEST(Compare, TellsBandsThatShareThePictureOut) {
  const std::string wide = R"(,"camera":{"fov_degrees":80},"scene":"whitted")";
  const Value told =
      compared(comparison_of(wide, wide + R"(,"gaze":[12,9],"acuity":{"slope":0.2})"));
  const Value::Array& bands = *at(told, "bands").as<Value::Array>();
  ASSERT_EQ(bands.size(), 4U);
  double pixels = 0, squares = 0;
  for (const Value& band : bands) {
    pixels += number_at(band, "pixels");
    squares += number_at(band, "pixels") * number_at(band, "mse");
  }
  EXPECT_EQ(pixels, 48 * 36);
  EXPECT_NEAR(squares / pixels, number_at(told, "mse"), 1e-12);
  EXPECT_EQ(number_at(bands[0], "from"), 0);
  EXPECT_EQ(number_at(bands[3], "to"), 180);
  EXPECT_LT(number_at(bands[0], "mse"), number_at(told, "mse"));
}

TEST(Compare, RefusesAtTheirPlaces) {
  const auto pointer_of = [](const std::string& body) {
    const Response response = host().post("/compare", body);
    EXPECT_EQ(response.status, 422) << response.body;
    return only_error(response).pointer;
  };
  EXPECT_EQ(pointer_of(R"({"a":{"width":0},"b":{}})"), "/a/width");
  EXPECT_EQ(pointer_of(R"({"a":{"width":20},"b":{}})"), "/b/width");
  EXPECT_EQ(pointer_of(R"({"a":{}})"), "/b");
  EXPECT_EQ(pointer_of(R"({"a":{},"b":{"scene":"thesys"}})"), "/b/scene");
  EXPECT_EQ(pointer_of(R"({"a":{},"b":{"crop":[3,3,3,9]}})"), "/b/crop");
  EXPECT_EQ(pointer_of(R"({"a":{"gaze_rays":5},"b":{}})"), "/a/gaze_rays");
  EXPECT_EQ(pointer_of(R"({"a":{"gaze":[1,2],"frame_ms":5},"b":{}})"), "/a/frame_ms");
  EXPECT_EQ(pointer_of(R"({"a":{},"b":{"format":"pfm"}})"), "/b/format");
  EXPECT_EQ(pointer_of(R"({"a":{"width":16777216},"b":{}})"), "/a/width");
  EXPECT_EQ(host().get("/compare").status, 405);
}

}  // namespace
}  // namespace tia::test
