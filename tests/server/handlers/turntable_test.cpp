// GET /still with a turntable: several views on one sheet.
#include "core/scene/read_scene.h"
#include "tests/server/still_support.h"

namespace tia::test {
namespace {

using testing::HasSubstr;

using Turntables = Stills;

// View i of the sheet is what /render draws of the scene with that view's camera and lights; where
// the last row has none, the background is.
TEST_F(Turntables, StandRowByRow) {
  for (const std::string query : {"&integrator=whitted", "&noise=0.5", "&fov=0"}) {
    const std::string all =
        "&width=40&height=36&samples=4&turntable=5&columns=2&format=pfm&background=0.5" + query;
    const Response picture = still(all);
    ASSERT_EQ(picture.status, 200) << picture.body;
    const Pixels<float> sheet = decode_pfm(picture.body);
    EXPECT_EQ(sheet.width, 80);
    EXPECT_EQ(sheet.height, 108);
    const Scene scene = read_scene(this->scene(all));
    ASSERT_EQ(scene.sheet->views.size(), 5U);
    for (int i = 0; i < 5; ++i) {
      Scene single = scene;
      single.camera = scene.sheet->views[static_cast<std::size_t>(i)].camera;
      single.lights = scene.sheet->views[static_cast<std::size_t>(i)].lights;
      single.sheet.reset();
      const Response own =
          own_.post("/render", R"({"format":"pfm","width":40,"height":36,"scene":)" +
                                   canonical_text(single) + "}");
      ASSERT_EQ(own.status, 200) << own.body;
      const int x = i % 2 * 40, y = i / 2 * 36;
      EXPECT_TRUE(sheet.window(x, y, x + 40, y + 36) == decode_pfm(own.body)) << i;
    }
    const Pixels<float> rest = sheet.window(40, 72, 80, 108);
    EXPECT_TRUE(std::ranges::all_of(rest.rgb, [](float light) { return light == 0.5F; }));
  }
}

TEST_F(Turntables, AreNearlySquareAndCountAsOnePicture) {
  const Response picture = still("&width=40&height=30&samples=1&integrator=whitted&turntable=5");
  ASSERT_EQ(picture.status, 200) << picture.body;
  const Png png = read_png(picture.body);
  EXPECT_EQ(png.width, 120);
  EXPECT_EQ(png.height, 60);
  for (std::size_t y = 30; y < 60; ++y)
    for (std::size_t x = 80; x < 120; ++x) EXPECT_EQ(png.rgba[4 * (120 * y + x) + 3], 0);
  const Response large = still("&width=2000&height=2000&samples=1&turntable=9");
  EXPECT_EQ(large.status, 422);
  EXPECT_THAT(large.body, HasSubstr("6000"));
  EXPECT_EQ(still("&samples=1&integrator=normal&turntable=3&width=8&height=8").status, 200);
}

}  // namespace
}  // namespace tia::test
