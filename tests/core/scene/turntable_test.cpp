// Turntables: several views of a model on one sheet, framed alike.
#include "core/scene/still.h"
#include "tests/core/scene/stills.h"
#include "tests/core/tree.h"

namespace tia {
namespace {

using namespace test;

constexpr double fills = 0.9;  // of the picture, from its centre to its side

// ---- the scene ----------------------------------------------------------------------------------

// A white cube of side 2 about the origin.
StillBody turned_cube() {
  StillBody body;
  body.objects = {object(Box{{-1, -1, -1}, {1, 1, 1}}, Finish{})};
  for (const double x : {-1.0, 1.0})
    for (const double y : {-1.0, 1.0})
      for (const double z : {-1.0, 1.0}) body.points.corners.push_back({x, y, z});
  return body;
}

// A view of a sheet is the single still from there but for where the eye stands: its light is that
// still's, to the last number, and its camera one of those that see all alike.
TEST(Turntable, IsASheetOfViewsAtEqualAzimuths) {
  StillRequest request;
  request.orbit = {-100, 35};
  request.turntable = 5;
  for (const Studio studio : {Studio::soft, Studio::headlight, Studio::sun})
    for (const double fov : {0.0, 40.0}) {
      request.studio = studio;
      request.fov = fov;
      const Scene scene = still_scene(request, turned_cube(), 0.75);
      ASSERT_TRUE(scene.sheet);
      EXPECT_EQ(scene.sheet->columns, 3);
      EXPECT_EQ(scene.sheet->rows(), 2);
      ASSERT_EQ(scene.sheet->views.size(), 5U);
      EXPECT_EQ(scene.camera, scene.sheet->views[0].camera);
      EXPECT_EQ(scene.lights, scene.sheet->views[0].lights);
      for (int i = 0; i < 5; ++i) {
        StillRequest single = request;
        single.turntable.reset();
        single.orbit[0] += 72 * i;
        const Scene alone = still_scene(single, turned_cube(), 0.75);
        const SheetView& view = scene.sheet->views[static_cast<std::size_t>(i)];
        EXPECT_EQ(view.lights, alone.lights);
        EXPECT_EQ(view.camera.direction, alone.camera.direction);
        EXPECT_EQ(view.camera.up, alone.camera.up);
        EXPECT_EQ(view.camera.fov_degrees, alone.camera.fov_degrees);
      }
    }
  request.columns = 5;
  EXPECT_EQ(still_scene(request, turned_cube(), 1).sheet->rows(), 1);
}

// ---- the sheet
// -------------------------------------------------------------------------------------

TEST(SheetText, IsReadAndChecked) {
  const auto fault_of = [](const std::string& sheet) {
    try {
      read_scene(R"({"sheet":)" + sheet + "}");
    } catch (const InputError& error) {
      return error.faults().front().pointer;
    }
    return std::string("none");
  };
  EXPECT_EQ(fault_of(R"({"views":[{}]})"), "none");
  EXPECT_EQ(fault_of(R"({"columns":2,"views":[{},{},{}]})"), "none");
  EXPECT_EQ(fault_of("{}"), "/sheet/views");
  EXPECT_EQ(fault_of(R"({"views":[]})"), "/sheet/views");
  EXPECT_EQ(fault_of(R"({"views":[{"camera":{"fov_degrees":0}}]})"),
            "/sheet/views/0/camera/fov_degrees");
  EXPECT_EQ(fault_of(R"({"columns":2,"views":[{}]})"), "/sheet/columns");
  EXPECT_EQ(fault_of(R"({"columns":0,"views":[{}]})"), "/sheet/columns");
  EXPECT_EQ(fault_of(R"({"views":[{},{"lights":[{"type":"point"}]}]})"),
            "/sheet/views/1/lights/0/position");
  std::string many = "{}";
  for (int i = 1; i < 64; ++i) many += ",{}";
  EXPECT_EQ(fault_of(R"({"views":[)" + many + "]}"), "none");
  many += ",{}";
  EXPECT_EQ(fault_of(R"({"views":[)" + many + "]}"), "/sheet/views");
}

// ---- several frames -----------------------------------------------------------------------------

// Whether a tip is so near that the eye has gone back from where it would touch.
bool has_gone_back(const StillPoints& points, const Camera& camera) {
  double nearest = 1e300;
  for (const Vec3d& p : points.corners)
    nearest = std::min(nearest, dot(p - camera.location, *camera.direction));
  return nearest < 1.001e-3 * ball_around(points).radius;
}

// By the definition of a camera's picture alone: all eyes are as far from the middle of the points'
// box and look at it, no point is outside of the frame, and in one picture one touches it.
TEST(FramedAlike, ViewsFillTheFrameInTheWidest) {
  Random random(2207);
  int back = 0;
  for (int i = 0; i < 200; ++i) {
    const StillPoints points = cloud(random, random.whole(4, 60));
    const Vec3d middle = ball_around(points).center;
    const StillFrame frame = random_frame(random, i % 4 == 0 ? 0 : random.in(1, 120));
    std::vector<Basis> axes;
    for (int k = 0; k < 6; ++k)
      axes.push_back(orbit_basis(random.in(-360, 360), random.in(-90, 90)));
    const std::vector<Camera> cameras = framed_alike(points, axes, frame);
    ASSERT_EQ(cameras.size(), axes.size());
    double widest = 0;
    bool goes = false;
    for (std::size_t k = 0; k < cameras.size(); ++k) {
      const Vec3d way = middle - cameras[k].location;
      EXPECT_NEAR(length(way), length(middle - cameras[0].location), 1e-9 * length(way));
      EXPECT_LT(length(unit(way) - *cameras[k].direction), 1e-9);
      EXPECT_EQ(cameras[k].up, axes[k].v);
      const SeenBox box = seen_box(points, cameras[k], frame.aspect);
      widest = std::max({widest, box.across(), box.along()});
      goes = goes || has_gone_back(points, cameras[k]);
    }
    back += goes;
    if (goes) {
      EXPECT_LT(widest, fills + 1e-9);
    } else {
      EXPECT_NEAR(widest, fills, 1e-9);
    }
  }
  EXPECT_LT(back, 20);
}

TEST(FramedAlike, ZoomNarrowsAllViewsAlike) {
  Random random(2208);
  const StillPoints points = cloud(random, 20);
  const std::vector<Basis> axes{orbit_basis(10, 20), orbit_basis(190, 20)};
  for (const double fov : {0.0, 50.0}) {
    const std::vector<Camera> usual = framed_alike(points, axes, {{}, fov, 1, 1.25}),
                              near = framed_alike(points, axes, {{}, fov, 2, 1.25});
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const SeenBox whole = seen_box(points, usual[i], 1.25),
                    large = seen_box(points, near[i], 1.25);
      EXPECT_NEAR(large.across(), 2 * whole.across(), 1e-9);
      EXPECT_NEAR(large.up, 2 * whole.up, 1e-9);
      EXPECT_EQ(near[i].location, usual[i].location);
    }
  }
}

}  // namespace
}  // namespace tia
