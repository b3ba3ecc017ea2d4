#include "core/scene/camera.h"

#include <gtest/gtest.h>

#include "core/input/codec.h"
#include "core/math/deterministic.h"
#include "core/scene/view.h"
#include "tests/core/faults.h"
#include "tests/core/random_scene.h"

namespace tia {
namespace {

using test::Random;

Camera camera_of(const char* json) { return read_described<Camera>(parse_json(json)); }

double tan_degrees(double degrees) { return std::tan(degrees * (pi / 180)); }

// The farthest that two views' rays lie apart, over some pixels.
double disagreement(const View& a, const View& b) {
  double worst = length(a.origin - b.origin);
  for (int y = 0; y < a.height; y += 7)
    for (int x = 0; x < a.width; x += 7)
      worst =
          std::max(worst, length(a.ray<double>(x, y).direction - b.ray<double>(x, y).direction));
  return worst;
}

// ---- spellings ------------------------------------------------------------------------------

TEST(Camera, DefaultLooksFromTheOriginAlongMinusZ) {
  const View view = view_of(camera_of("{}"), 3, 3);
  const Ray<double> middle = view.ray<double>(1, 1);
  EXPECT_EQ(middle.origin, (Vec3d{0, 0, 0}));
  EXPECT_EQ(middle.direction, (Vec3d{0, 0, -1}));
  EXPECT_EQ(camera_of("{}").fov_degrees, 25);
}

TEST(Camera, FourSpellingsOfOneViewAgree) {
  Random random(30);
  for (int i = 0; i < 200; ++i) {
    const Vec3d eye = random.point(5), w = random.direction();
    const Vec3d up = normalize(cross(w, random.direction()));
    const double fov = random.in(5, 120);
    Camera look_at, direction, plane, far_plane;
    for (Camera* each : {&look_at, &direction, &plane, &far_plane}) each->location = eye;
    look_at.look_at = eye + w * random.in(0.1, 100);
    direction.direction = w * random.in(1e-3, 1e3);  // any length
    look_at.fov_degrees = direction.fov_degrees = fov;
    look_at.up = up + w * random.in(-2, 2);  // need not be perpendicular, nor of length 1
    direction.up = up * random.in(0.01, 100);
    const double half_height = tan_degrees(fov / 2), half_width = half_height * 640 / 480;
    plane.direction = w;
    plane.up = up * half_height;
    plane.right = cross(w, up) * half_width;
    far_plane.direction = w * 3.0;
    far_plane.up = plane.up * 3.0;
    far_plane.right = *plane.right * 3.0;
    const View view = view_of(look_at, 640, 480);
    EXPECT_LT(disagreement(view, view_of(direction, 640, 480)), 1e-13);
    EXPECT_LT(disagreement(view, view_of(plane, 640, 480)), 1e-13);
    EXPECT_LT(disagreement(view, view_of(far_plane, 640, 480)), 1e-13);
  }
}

TEST(Camera, ViewPlaneIsUsedAsGivenAlsoSkewAndWhateverTheAspect) {
  // The slides: P = eye + direction + sx right + sy up, sx and sy of the pixel's centre.
  Random random(31);
  for (int i = 0; i < 200; ++i) {
    Camera camera;
    camera.location = random.point(5);
    camera.direction = random.direction() * 2.0;
    camera.right = random.direction();
    camera.up = random.direction();
    const int width = 1 + random.below(300), height = 1 + random.below(300);
    const int x = random.below(width), y = random.below(height);
    const double sx = 2 * (x + 0.5) / width - 1, sy = 1 - 2 * (y + 0.5) / height;
    const Vec3d way = *camera.direction + *camera.right * sx + camera.up * sy;
    if (length(way) < 0.1) continue;
    const Ray<double> ray = view_of(camera, width, height).ray<double>(x, y);
    EXPECT_LT(length(ray.direction - normalize(way)), 1e-13);
    EXPECT_EQ(ray.origin, camera.location);
  }
}

TEST(Camera, FieldOfViewIsVertical) {
  for (const auto& [width, height] : {std::pair{640, 480}, {480, 640}, {100, 100}, {7, 333}}) {
    Camera camera;
    camera.fov_degrees = 40;
    const View view = view_of(camera, width, height);
    EXPECT_NEAR(length(view.up), tan_degrees(20), 1e-15);
    EXPECT_NEAR(length(view.right), tan_degrees(20) * width / height, 1e-12);
  }
}

// ---- the pixel's ray ------------------------------------------------------------------------

TEST(Camera, RaysFollowTheThesisFormulaOfThePixel) {
  // xx = (2x+1-W)/W tan(fov/2) W/H, yy = (H-2y-1)/H tan(fov/2), direction = normalize(xx, yy, -1).
  Random random(32);
  const long double half = std::tan(12.5L * std::acos(-1.0L) / 180);
  for (int i = 0; i < 2000; ++i) {
    const int width = 1 + random.below(2000), height = 1 + random.below(2000);
    const int x = random.below(width), y = random.below(height);
    const long double xx = static_cast<long double>(2 * x + 1 - width) / height * half;
    const long double yy = static_cast<long double>(height - 2 * y - 1) / height * half;
    const long double scale = 1 / std::sqrt(xx * xx + yy * yy + 1);
    const Vec3d exact{static_cast<double>(xx * scale), static_cast<double>(yy * scale),
                      static_cast<double>(-scale)};
    const View view = view_of({}, width, height);
    EXPECT_LT(length(view.ray<double>(x, y).direction - exact), 1e-15);
    const auto px = static_cast<float>(x), py = static_cast<float>(y);
    EXPECT_LT(length(widen(view.ray<float>(px, py).direction) - exact), 3e-7);
  }
}

TEST(Camera, RowZeroIsTheTopAndColumnZeroTheLeft) {
  const View view = view_of({}, 640, 480);
  EXPECT_GT(view.ray<double>(0, 0).direction.y, 0);
  EXPECT_LT(view.ray<double>(0, 0).direction.x, 0);
  EXPECT_LT(view.ray<double>(639, 479).direction.y, 0);
  EXPECT_GT(view.ray<double>(639, 479).direction.x, 0);
}

TEST(Camera, RaysAreExactlySymmetricAboutBothAxes) {
  for (const auto& [width, height] : {std::pair{640, 480}, {801, 333}, {3, 1024}}) {
    const View view = view_of({}, width, height);
    for (int y = 0; y < height; y += 5) {
      for (int x = 0; x < width; ++x) {
        const auto fx = static_cast<float>(x), fy = static_cast<float>(y);
        const auto mx = static_cast<float>(width - 1 - x), my = static_cast<float>(height - 1 - y);
        const Vec3f d = view.ray<float>(fx, fy).direction;
        ASSERT_EQ(view.ray<float>(mx, fy).direction, (Vec3f{-d.x, d.y, d.z})) << x << ", " << y;
        ASSERT_EQ(view.ray<float>(fx, my).direction, (Vec3f{d.x, -d.y, d.z})) << x << ", " << y;
      }
    }
  }
}

TEST(Camera, RaysHaveUnitLength) {
  Random random(33);
  for (int i = 0; i < 500; ++i) {
    const View view = view_of(test::random_camera(random), 640, 480);
    const int x = random.below(640), y = random.below(480);
    EXPECT_NEAR(length(view.ray<double>(x, y).direction), 1, 1e-15);
    const auto d = view.ray<float>(static_cast<float>(x), static_cast<float>(y)).direction;
    EXPECT_NEAR(length(widen(d)), 1, 5e-7);
  }
}

// ---- what is refused ------------------------------------------------------------------------

struct Refused {
  const char* json;
  std::vector<test::Expected> faults;
};

TEST(Camera, RefusesWhatGivesNoView) {
  using enum FaultKind;
  const std::vector<Refused> table = {
      {R"({"direction":[0,0,-1e-30],"up":[0,1,0],"right":[1,0,0]})",
       {{out_of_range, "/direction", "[0,0,-1e-30]", "of the view plane's size"}}},
      {R"({"look_at":[0,0,-1],"direction":[0,0,-1]})",
       {{conflict, "/direction", "[0,0,-1]", "look_at or direction"}}},
      {R"({"look_at":[0,0,-1],"right":[1,0,0]})",
       {{conflict, "/look_at", "[0,0,-1]", "right goes with direction and up"}}},
      {R"({"right":[1,0,0],"fov_degrees":40})",
       {{conflict, "/fov_degrees", "40", "right goes without fov_degrees"}}},
      {R"({"look_at":[0,0,-1],"direction":[0,0,-1],"right":[1,0,0],"fov_degrees":40})",
       {{conflict, "/direction", "[0,0,-1]", "look_at or direction"},
        {conflict, "/look_at", "[0,0,-1]", "right goes with direction and up"},
        {conflict, "/fov_degrees", "40", "right goes without fov_degrees"}}},
      {R"({"location":[1,2,3],"look_at":[1,2,3]})",
       {{out_of_range, "/look_at", "[1,2,3]", "a point other than location"}}},
      {R"({"direction":[0,0,0]})", {{out_of_range, "/direction", "[0,0,0]", "some length"}}},
      {R"({"up":[0,0,0]})", {{out_of_range, "/up", "[0,0,0]", "not parallel to the view"}}},
      {R"({"up":[0,0,2]})", {{out_of_range, "/up", "[0,0,2]", "not parallel to the view"}}},
      {R"({"direction":[1,1,0],"up":[-3,-3,0]})",
       {{out_of_range, "/up", "[-3,-3,0]", "not parallel to the view"}}},
      {R"({"look_at":[0,5,0]})",  // straight up, along the default up
       {{out_of_range, "/up", "[0,1,0]", "not parallel to the view"}}},
      {R"({"right":[0,0,0]})", {{out_of_range, "/right", "[0,0,0]", "a view plane of some size"}}},
      {R"({"right":[0,3,0]})", {{out_of_range, "/right", "[0,3,0]", "a view plane of some size"}}},
      {R"({"right":[0,1,-1]})",
       {{out_of_range, "/right", "[0,1,-1]", "a view plane of some size"}}},
      {R"({"height":4})", {{conflict, "/height", "4", "goes with projection orthographic"}}},
      {R"({"distance":1,"pixel_size":2})",
       {{conflict, "/distance", "1", "goes with basis"},
        {conflict, "/pixel_size", "2", "goes with basis"}}},
      {R"({"aperture":0.1})", {{missing, "/focus_distance", "", "that is sharp, for aperture"}}},
      {R"({"aperture":1e9,"focus_distance":0.5})",
       {{out_of_range, "/focus_distance", "0.5", "at least 1e-9 of aperture"}}},
  };
  for (const Refused& each : table) {
    SCOPED_TRACE(each.json);
    test::expect_faults(test::faults_of([&] { camera_of(each.json); }), each.faults);
  }
}

TEST(Camera, OrthographicTakesHeightOrAPlaneAndNoAngleOrLens) {
  using enum FaultKind;
  const std::vector<Refused> table = {
      {R"({"projection":"orthographic","height":3})", {}},
      {R"({"projection":"orthographic","right":[1,0,0]})", {}},
      {R"({"projection":"orthographic","height":3,"aperture":0})", {}},
      {R"({"projection":"orthographic"})", {{missing, "/height", "", "whole picture's height"}}},
      {R"({"projection":"orthographic","height":3,"right":[1,0,0]})",
       {{conflict, "/height", "3", "right goes without height"}}},
      {R"({"projection":"orthographic","height":3,"fov_degrees":30})",
       {{conflict, "/fov_degrees", "30", "with height, without fov_degrees"}}},
      {R"({"projection":"orthographic","height":3,"aperture":0.5,"focus_distance":2})",
       {{conflict, "/aperture", "0.5", "only projection perspective has a lens"},
        {conflict, "/focus_distance", "2", "only projection perspective has a lens"}}},
      {R"({"projection":"ortographic"})",
       {{unknown_name, "/projection", "\"ortographic\"", "perspective, orthographic",
         "orthographic"}}},
      {R"({"projection":"orthographic","height":0})", {{out_of_range, "/height", "0", "above 0"}}},
  };
  for (const Refused& each : table) {
    SCOPED_TRACE(each.json);
    test::expect_faults(test::faults_of([&] { camera_of(each.json); }), each.faults);
  }
}

TEST(Camera, BasisStandsAloneAndIsRightHandedAndOrthonormal) {
  using enum FaultKind;
  const std::string axes = R"("basis":{"u":[1,0,0],"v":[0,1,0],"w":[0,0,1]})";
  const std::string grid = R"("distance":2,"pixel_size":0.1,)" + axes;
  const auto basis = [](const char* u, const char* v, const char* w) {
    return std::string(R"({"distance":2,"pixel_size":0.1,"basis":{"u":)") + u + R"(,"v":)" + v +
           R"(,"w":)" + w + "}}";
  };
  struct Case {
    std::string json;
    std::vector<test::Expected> faults;
  };
  const std::vector<Case> table = {
      {"{" + grid + "}", {}},
      {"{" + grid + R"(,"aperture":0.1,"focus_distance":7})", {}},
      {R"({"projection":"orthographic","pixel_size":0.1,)" + axes + "}", {}},
      {"{" + axes + "}",
       {{missing, "/pixel_size", "", "the side of a pixel"},
        {missing, "/distance", "", "to the grid of pixels"}}},
      {"{" + grid + R"(,"look_at":[0,0,-1],"direction":[0,0,-1],"up":[0,2,0],"right":[1,0,0],)" +
           R"("fov_degrees":30,"height":2})",
       {{conflict, "/look_at", "[0,0,-1]", "basis goes without"},
        {conflict, "/direction", "[0,0,-1]", "basis goes without"},
        {conflict, "/up", "[0,2,0]", "basis goes without"},
        {conflict, "/right", "[1,0,0]", "basis goes without"},
        {conflict, "/fov_degrees", "30", "basis goes without"},
        {conflict, "/height", "2", "goes with projection orthographic"}}},
      {R"({"projection":"orthographic","height":2,)" + grid + "}",
       {{conflict, "/distance", "2", "an orthographic basis goes without distance"},
        {conflict, "/height", "2", "basis goes without height"}}},
      {R"({"distance":1e-3,"pixel_size":1,)" + axes + "}",
       {{out_of_range, "/distance", "0.001", "at least 0.01 of pixel_size"}}},
      {R"({"distance":2,"pixel_size":0.1,"basis":{"u":[1,0,0]}})",
       {{missing, "/basis/v", "", "upwards"}, {missing, "/basis/w", "", "towards the viewer"}}},
      {basis("[1.00001,0,0]", "[0,1,0]", "[0,0,0]"),
       {{out_of_range, "/basis/u", "[1.00001,0,0]", "length 1"},
        {out_of_range, "/basis/w", "[0,0,0]", "length 1"}}},
      {basis("[1,0,0]", "[0.6,0.8,0]", "[0,0,1]"),
       {{out_of_range, "/basis/v", "[0.6,0.8,0]", "perpendicular to u"}}},
      {basis("[1,0,0]", "[0,1,0]", "[0.6,0,0.8]"),
       {{out_of_range, "/basis/w", "[0.6,0,0.8]", "perpendicular to u and v"}}},
      {basis("[1,0,0]", "[0,1,0]", "[0,0,-1]"),
       {{out_of_range, "/basis/w", "[0,0,-1]", "right-handed"}}},
      {basis("[1.0000009,0,0]", "[0,1,9e-7]", "[0,0,1]"), {}},
  };
  for (const Case& each : table) {
    SCOPED_TRACE(each.json);
    test::expect_faults(test::faults_of([&] { camera_of(each.json.c_str()); }), each.faults);
  }
}

TEST(Camera, TextOfEveryFieldReadsBack) {
  const char* texts[] = {
      R"({"aperture":0.5,"focus_distance":7})",
      R"({"basis":{"u":[1,0,0],"v":[0,1,0],"w":[0,0,1]},"distance":2,"pixel_size":0.25})",
      R"({"height":3,"projection":"orthographic"})"};
  for (const char* text : texts) {
    EXPECT_EQ(to_json(write_value(camera_of(text))), text);
    EXPECT_EQ(camera_of(to_json(write_value(camera_of(text))).c_str()), camera_of(text));
  }
}

TEST(Camera, RangesEndWhereTheFieldsSay) {
  using enum FaultKind;
  EXPECT_EQ(camera_of(R"({"fov_degrees":179})").fov_degrees, 179);
  EXPECT_EQ(camera_of(R"({"location":[1e9,-1e9,0],"direction":[1e9,0,0]})").location.x, 1e9);
  const std::vector<Refused> table = {
      {R"({"fov_degrees":0})", {{out_of_range, "/fov_degrees", "0", "above 0, at most 179"}}},
      {R"({"fov_degrees":-1})", {{out_of_range, "/fov_degrees", "-1", "(degrees)"}}},
      {R"({"fov_degrees":179.1})", {{out_of_range, "/fov_degrees", "179.1", "at most 179"}}},
      {R"({"location":[0,1.1e9,0]})",
       {{out_of_range, "/location/1", "1100000000", "from -1000000000 to 1000000000"}}},
      {R"({"up":[0,1]})", {{wrong_type, "/up", "[0,1]", "3 numbers"}}},
  };
  for (const Refused& each : table) {
    SCOPED_TRACE(each.json);
    test::expect_faults(test::faults_of([&] { camera_of(each.json); }), each.faults);
  }
}

}  // namespace
}  // namespace tia
