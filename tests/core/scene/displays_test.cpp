// The views of displays, against formulas written out by hand.
#include "core/scene/displays/display.h"

#include <gtest/gtest.h>

#include <cmath>

#include "core/scene/views.h"
#include "tests/core/faults.h"
#include "tests/core/random_scene.h"

namespace tia {
namespace {

using test::Random;

Camera camera_of(const std::string& json) { return read_described<Camera>(parse_json(json)); }
Camera with_display(Camera camera, const char* json) {
  camera.display = read_described<Display>(parse_json(json));
  return camera;
}
Ray<double> ray_at(const View& view, double x, double y) {  // of a point in pixels
  return seen_ray<double>(view, 0, 0, {x - 0.5, y - 0.5, 0, 0}).ray;
}

// Where a flat view sees a point: on the picture from -1 to 1, by Cramer's rule.
Vec2d seen_at(const View& view, const Vec3d& p) {
  const auto det = [](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
    return dot(a, cross(b, c));
  };
  const Vec3d to = p - view.origin;  // t (forward + sx right + sy up), parallel rays: sums
  if (view.orthographic()) {
    const double all = det(view.forward, view.right, view.up);
    return {det(view.forward, to, view.up) / all, det(view.forward, view.right, to) / all};
  }
  const double t = det(to, view.right, view.up) / det(view.forward, view.right, view.up);
  const Vec3d rest = to * (1 / t) - view.forward;
  const Vec3d normal = cross(view.right, view.up);
  const double all = dot(normal, normal);
  return {dot(cross(rest, view.up), normal) / all, dot(cross(view.right, rest), normal) / all};
}

// A camera before a random window, its axes and the distance.
struct Stand {
  Camera camera;
  Vec3d right, up, ahead;
  double distance, half_width, half_height;

  explicit Stand(Random& random, int width, int height) {
    camera.location = random.point(3);
    distance = random.in(0.5, 20);
    ahead = random.direction();
    camera.look_at = camera.location + ahead * distance;
    camera.up = random.direction();
    camera.fov_degrees = random.in(10, 90);
    right = normalize(cross(ahead, camera.up));
    up = cross(right, ahead);
    half_height = distance * std::tan(camera.fov_degrees / 2 * pi / 180);
    half_width = half_height * width / height;
  }
  Vec3d point(double x, double y, double depth) const {
    return camera.location + right * x + up * y + ahead * depth;
  }
};

// ---- cube ---------------------------------------------------------------------------------------

// The face and the place on it of a direction. Source: OpenGL 4.6, table 8.19: sc, tc, ma.
struct Texel {
  int face;
  double s, t;
};
Texel looked_up(double rx, double ry, double rz) {
  const double ax = std::fabs(rx), ay = std::fabs(ry), az = std::fabs(rz);
  int face = 0;
  double sc = 0, tc = 0, ma = 0;
  if (ax >= ay && ax >= az) face = rx > 0 ? 0 : 1, sc = rx > 0 ? -rz : rz, tc = -ry, ma = ax;
  else if (ay >= az) face = ry > 0 ? 2 : 3, sc = rx, tc = ry > 0 ? rz : -rz, ma = ay;
  else face = rz > 0 ? 4 : 5, sc = rz > 0 ? rx : -rx, tc = -ry, ma = az;
  return {face, (sc / ma + 1) / 2, (tc / ma + 1) / 2};
}

TEST(Cube, FacesAreWhereOpenGLLooksDirectionsUp) {
  Random random(270);
  const int size = 16;
  for (int k = 0; k < 300; ++k) {
    Camera camera;
    camera.location = random.point(3);
    camera.direction = random.direction();
    camera.up = random.direction();
    const ViewGrid grid = views_of(with_display(camera, R"({"type":"cube"})"), size, size);
    ASSERT_EQ(grid.views.size(), 6U);
    const Vec3d z = normalize(*camera.direction), x = normalize(cross(z, camera.up));
    const Vec3d way = random.direction();
    const Texel at = looked_up(dot(way, x), dot(way, cross(x, z)), dot(way, z));
    const GridView& face = grid.views[static_cast<std::size_t>(at.face)];
    EXPECT_EQ(face.column, at.face % 3);
    EXPECT_EQ(face.row, at.face / 3);
    const Ray<double> ray = ray_at(face.view, at.s * size, at.t * size);
    EXPECT_LT(length(ray.direction - way), 1e-12);
    EXPECT_EQ(ray.origin, camera.location);
  }
}

TEST(Cube, SolidAnglesOfPixelsSumToTheSphere) {
  const ViewGrid grid = views_of(with_display({}, R"({"type":"cube"})"), 8, 8);
  double sum = 0;
  for (const GridView& face : grid.views)
    for (int y = 0; y < 8; ++y)
      for (int x = 0; x < 8; ++x) {
        const auto corner = [&](int i, int j) { return ray_at(face.view, x + i, y + j).direction; };
        const auto angle = [](const Vec3d& a, const Vec3d& b, const Vec3d& c) {
          return 2 *
                 std::atan2(std::fabs(dot(a, cross(b, c))), 1 + dot(a, b) + dot(b, c) + dot(c, a));
        };
        sum += angle(corner(0, 0), corner(1, 0), corner(1, 1)) +
               angle(corner(0, 0), corner(1, 1), corner(0, 1));
      }
  EXPECT_NEAR(sum, 4 * pi, 1e-6);
}

// ---- eyes that share a window -------------------------------------------------------------------

TEST(Stereo, DisparityIsThatOfSimilarTriangles) {
  Random random(271);
  for (int k = 0; k < 200; ++k) {
    const Stand stand(random, 40, 30);
    Camera camera = with_display(stand.camera, R"({"type":"stereo","separation":0.3})");
    const double d = stand.distance, depth = d * random.in(0.3, 4);
    const double x = random.in(-1, 1), y = random.in(-1, 1);
    const ViewGrid grid = views_of(camera, 40, 30);
    const Vec3d p = stand.point(x, y, depth);
    for (const double side : {-1.0, 1.0}) {
      // From the eye at side * 0.15 the window, at d, is crossed at e + (x - e) d / depth.
      const double e = side * 0.15;
      const Vec2d at = seen_at(grid.views[side < 0 ? 0 : 1].view, p);
      EXPECT_NEAR(at.u, (e + (x - e) * d / depth) / stand.half_width, 1e-9);
      EXPECT_NEAR(at.v, y * d / depth / stand.half_height, 1e-9);
    }
    const Vec3d there = stand.point(x, y, d);
    EXPECT_NEAR(seen_at(grid.views[0].view, there).u, seen_at(grid.views[1].view, there).u, 1e-9);
  }
}

TEST(Stereo, LayoutsPutTheEyesWhereTheySay) {
  const auto places = [](const char* layout) {
    const Camera camera = camera_of(std::string(R"({"look_at":[0,0,-2],"display":{"type":"stereo",
        "layout":")") + layout + R"("}})");
    const ViewGrid grid = views_of(camera, 4, 4);
    EXPECT_LT(grid.views[0].view.origin.x, 0) << "the left eye first";
    return std::array{grid.columns,         grid.rows,
                      grid.views[0].column, grid.views[0].row,
                      grid.views[1].column, grid.views[1].row};
  };
  EXPECT_EQ(places("side_by_side"), (std::array{2, 1, 0, 0, 1, 0}));
  EXPECT_EQ(places("cross_eyed"), (std::array{2, 1, 1, 0, 0, 0}));
  EXPECT_EQ(places("top_bottom"), (std::array{1, 2, 0, 0, 0, 1}));
  EXPECT_EQ(places("anaglyph"), (std::array{1, 1, 0, 0, 0, 0}));
}

TEST(Quilt, ThePlaneInFocusStaysAndOthersMoveAsTheFormulaSays) {
  Random random(272);
  for (int k = 0; k < 60; ++k) {
    const Stand stand(random, 30, 40);
    Camera camera = with_display(stand.camera, R"({"type":"quilt","columns":5,"rows":3})");
    std::get<Quilt>(camera.display->kind).cone_degrees = random.in(1, 170);
    const double cone = std::get<Quilt>(camera.display->kind).cone_degrees * pi / 180;
    const ViewGrid grid = views_of(camera, 30, 40);
    const double d = stand.distance, x = random.in(-1, 1), y = random.in(-1, 1);
    const double behind = d * random.in(-0.7, 3);
    const Vec2d middle = seen_at(view_of(stand.camera, 30, 40), stand.point(x, y, d + behind));
    for (int i = 0; i < 15; ++i) {
      const GridView& of = grid.views[static_cast<std::size_t>(i)];
      EXPECT_EQ(of.column, i % 5);
      EXPECT_EQ(of.row, 2 - i / 5) << "from the bottom";
      const double o = d * std::tan((i / 14.0 - 0.5) * cone);
      EXPECT_LT(length(of.view.origin - stand.point(o, 0, 0)), 1e-9 * (1 + std::fabs(o)));
      const Vec2d focused = seen_at(of.view, stand.point(x, y, d));
      EXPECT_NEAR(focused.u, x / stand.half_width, 1e-6);
      EXPECT_NEAR(focused.v, y / stand.half_height, 1e-6);
      // Against the view in the middle: on the window by o behind / (d + behind).
      const Vec2d at = seen_at(of.view, stand.point(x, y, d + behind));
      EXPECT_NEAR((at.u - middle.u) * stand.half_width, o * behind / (d + behind),
                  1e-8 * (1 + std::fabs(o)));
      EXPECT_NEAR(at.v, middle.v, 1e-8);
    }
    EXPECT_EQ(grid.suffix, "qs5x3a0.75");
  }
}

TEST(Quilt, ParallelRaysAreShearedAboutThePlaneInFocus) {
  Random random(273);
  Stand stand(random, 30, 40);
  stand.camera.projection = Projection::orthographic;
  stand.camera.fov_degrees = Camera{}.fov_degrees;
  stand.camera.height = 2;
  const Camera camera = with_display(stand.camera, R"({"type":"quilt","columns":4,"rows":1})");
  for (const GridView& of : views_of(camera, 30, 40).views) {
    EXPECT_NEAR(length(of.view.forward), 1, 1e-12);
    const Vec2d at = seen_at(of.view, stand.point(0.3, -0.2, stand.distance));
    EXPECT_NEAR(at.u, 0.3 / 0.75, 1e-9);
    EXPECT_NEAR(at.v, -0.2, 1e-9);
  }
}

TEST(Interlace, ASubpixelHasTheRayOfTheViewThatItsLensShows) {
  Random random(274);
  for (int k = 0; k < 40; ++k) {
    const Stand stand(random, 50, 40);
    Camera camera = with_display(stand.camera, R"({"type":"quilt","columns":3,"rows":3})");
    const ViewGrid grid = views_of(camera, 50, 40);
    Interlace& lenses = camera.interlace.emplace();
    lenses = {random.in(2, 40),  random.in(-1, 1), random.in(-2, 2), random.in(-0.1, 0.1), {},
              random.chance(0.5)};
    const ViewGrid colors = views_of(camera, 50, 40);
    const int x = random.below(50), y = random.below(40), c = random.below(3);
    const double z =
        ((x + 0.5) / 50 + (c - 1) / 150.0 + (1 - (y + 0.5) / 40) * lenses.tilt) * lenses.pitch -
        lenses.center + (c - 1) * lenses.fringe;
    const double share = (z - std::floor(z)) * 9;
    if (std::fabs(share - std::round(share)) < 1e-6) continue;  // between two views
    const int shown = lenses.invert ? 8 - static_cast<int>(share) : static_cast<int>(share);
    const auto got = seen_ray<double>(colors.views[static_cast<std::size_t>(c)].view, x, y, {});
    const Ray<double> ray =
        ray_at(grid.views[static_cast<std::size_t>(shown)].view, x + 0.5, y + 0.5);
    EXPECT_LT(length(got.ray.origin - ray.origin), 1e-12 * (1 + length(ray.origin)));
    EXPECT_LT(length(got.ray.direction - ray.direction), 1e-12);
  }
}

TEST(TwoPlane, EveryEyeSeesTheWindowFromEdgeToEdge) {
  Random random(275);
  const Stand stand(random, 20, 10);
  Camera camera = stand.camera;
  camera.fov_degrees = Camera{}.fov_degrees;
  camera = with_display(camera, R"({"type":"two_plane","st":[4,2],
                                    "uv":{"columns":3,"rows":2,"spacing":0.5}})");
  const ViewGrid grid = views_of(camera, 20, 10);
  ASSERT_EQ(grid.views.size(), 6U);
  EXPECT_EQ(grid.views[1].name, "out_00_01_0.25_0");
  for (const GridView& of : grid.views) {
    const Vec3d eye = stand.point((of.column - 1) * 0.5, (0.5 - of.row) * 0.5, 0);
    EXPECT_LT(length(of.view.origin - eye), 1e-12 * (1 + length(eye)));
    for (const double x : {-2.0, 2.0})
      for (const double y : {-1.0, 1.0}) {
        const Vec2d at = seen_at(of.view, stand.point(x, y, stand.distance));
        EXPECT_NEAR(at.u, x / 2, 1e-9);
        EXPECT_NEAR(at.v, y, 1e-9);
      }
  }
}

// ---- all around with two eyes -------------------------------------------------------------------

TEST(Omnistereo, RaysStartOnTheCircleOfTheEyesTangentially) {
  const ViewGrid grid =
      views_of(with_display({}, R"({"type":"omnistereo","separation":0.4})"), 36, 18);
  EXPECT_EQ(std::pair(grid.columns, grid.rows), std::pair(1, 2));
  for (const double side : {-1.0, 1.0})
    for (int x = 0; x < 36; ++x)
      for (int y = 0; y < 18; ++y) {
        const Ray<double> ray = ray_at(grid.views[side < 0 ? 0 : 1].view, x + 0.5, y + 0.5);
        const Vec3d ahead{ray.direction.x, 0, ray.direction.z};
        EXPECT_NEAR(length(ray.origin), 0.2, 1e-12);
        EXPECT_EQ(ray.origin.y, 0);
        EXPECT_NEAR(dot(ray.origin, ahead), 0, 1e-12) << "tangential";
        EXPECT_GT(side * dot(cross(ahead, {0, 1, 0}), ray.origin), 0) << "on its side of the head";
      }
}

// ---- walls of projectors ------------------------------------------------------------------------

struct Wall {
  double width = 3, height = 2, behind, distance, eye_height;
  Camera camera;
  Vec3d right, up, out;  // the display's frame, z towards the viewers

  explicit Wall(Random& random)
      : behind(random.in(0.2, 2)), distance(random.in(1, 6)), eye_height(random.in(-0.5, 0.5)) {
    Stand stand(random, 4, 3);
    camera = stand.camera;
    camera.fov_degrees = Camera{}.fov_degrees;
    right = stand.right, up = stand.up, out = -stand.ahead;
  }
  ViewGrid grid(const std::vector<double>& modules, int width_px, int height_px,
                std::vector<Warp> warp = {}) const {
    Modules display;
    display.screen = {width, height};
    display.modules.at = modules;
    display.behind = behind;
    display.observer = {distance, eye_height};
    display.warp = std::move(warp);
    Camera with = camera;
    with.display = Display{display};
    return views_of(with, width_px, height_px);
  }
  Vec3d local(const Vec3d& p) const {
    const Vec3d from = p - *camera.look_at;
    return {dot(from, right), dot(from, up), dot(from, out)};
  }
};

// The line of a ray where z is as told, in the display's frame.
Vec3d line_at(const Wall& wall, const Ray<double>& ray, double z) {
  const Vec3d a = wall.local(ray.origin), b = wall.local(ray.origin + ray.direction);
  return a + (b - a) * ((z - a.z) / (b.z - a.z));
}

TEST(Modules, RaysPassTheScreensPointTheModuleAndTheObservers) {
  Random random(276);
  for (int k = 0; k < 30; ++k) {
    const Wall wall(random);
    const std::vector<double> at{-1.2, 0.1, 0.7};
    const ViewGrid grid = wall.grid(at, 12, 8);
    for (std::size_t m = 0; m < at.size(); ++m)
      for (int i = 0; i < 12; i += 3) {
        double column_x[2] = {};
        for (int j = 0; j < 8; ++j) {
          const Ray<double> ray = ray_at(grid.views[m].view, i + 0.5, j + 0.5);
          const double x = ((i + 0.5) / 12 - 0.5) * 3, y = (0.5 - (j + 0.5) / 8) * 2;
          EXPECT_LT(length(line_at(wall, ray, 0) - Vec3d{x, y, 0}), 1e-9) << "the screen";
          EXPECT_NEAR(line_at(wall, ray, -wall.behind).x, at[m], 1e-9) << "the module";
          const Vec3d eye = line_at(wall, ray, wall.distance);
          EXPECT_NEAR(eye.y, wall.eye_height, 1e-9) << "the observers' line";
          EXPECT_LT(length(wall.local(ray.origin) - eye), 1e-9) << "where it starts";
          EXPECT_LT(dot(ray.direction, wall.out), 0);
          // All of a column lie in one vertical plane: x is the same at each z.
          const double here[2] = {line_at(wall, ray, 1).x, line_at(wall, ray, -2).x};
          for (int n = 0; n < 2; ++n) {
            if (j > 0) EXPECT_NEAR(here[n], column_x[n], 1e-9);
            column_x[n] = here[n];
          }
        }
      }
  }
}

TEST(Modules, TheSliceOfAViewerIsThePinholePictureFromThere) {
  Random random(277);
  for (int k = 0; k < 30; ++k) {
    const Wall wall(random);
    const double x0 = random.in(-1, 1);  // the viewer, on the line
    const double x = random.in(-1.5, 1.5), y = random.in(-1, 1);
    const double module = x - (x0 - x) * wall.behind / wall.distance;
    const ViewGrid grid = wall.grid({module, module + 1}, 30, 20);
    const Ray<double> ray =
        ray_at(grid.views[0].view, (x / wall.width + 0.5) * 30, (0.5 - y / wall.height) * 20);
    const Vec3d eye{x0, wall.eye_height, wall.distance};
    EXPECT_LT(length(wall.local(ray.origin) - eye), 1e-9);
    EXPECT_LT(length(line_at(wall, ray, 0) - Vec3d{x, y, 0}), 1e-9);
  }
}

Warp warp_of(const Wall& wall, int columns, int rows, double shift, double growth) {
  Warp warp{columns, rows, {}};
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) {
      const double u = static_cast<double>(i) / (columns - 1);
      const double v = static_cast<double>(j) / (rows - 1);
      warp.points.push_back(
          {(u - 0.5) * wall.width * growth + shift, (0.5 - v) * wall.height * growth});
    }
  return warp;
}

TEST(Modules, AWarpMovesTheScreensPointsAndThatOfIdentityNoBit) {
  Random random(278);
  const Wall wall(random);
  const std::vector<double> at{-0.4, 0.4};
  const ViewGrid plain = wall.grid(at, 9, 7);
  const ViewGrid same = wall.grid(at, 9, 7, {warp_of(wall, 5, 4, 0, 1)});
  const ViewGrid moved =
      wall.grid(at, 9, 7, {warp_of(wall, 3, 3, 0, 1), warp_of(wall, 4, 6, 0.2, 1.1)});
  for (int i = 0; i < 9; ++i)
    for (int j = 0; j < 7; ++j) {
      const Ray<double> ray = ray_at(plain.views[1].view, i + 0.5, j + 0.5);
      const Ray<double> of_identity = ray_at(same.views[1].view, i + 0.5, j + 0.5);
      EXPECT_EQ(ray.origin, of_identity.origin);
      EXPECT_EQ(ray.direction, of_identity.direction);
      const Vec3d before = line_at(wall, ray, 0);
      const Vec3d after = line_at(wall, ray_at(moved.views[1].view, i + 0.5, j + 0.5), 0);
      EXPECT_NEAR(after.x, before.x * 1.1 + 0.2, 1e-9);
      EXPECT_NEAR(after.y, before.y * 1.1, 1e-9);
      EXPECT_EQ(ray_at(moved.views[0].view, i + 0.5, j + 0.5).origin,
                ray_at(plain.views[0].view, i + 0.5, j + 0.5).origin);
    }
}

// ---- what does not fit --------------------------------------------------------------------------

TEST(Displays, OfCamerasThatDoNotFitAreFaults) {
  using test::Expected;
  constexpr FaultKind conflict = FaultKind::conflict, range = FaultKind::out_of_range,
                      missing = FaultKind::missing;
  const std::pair<const char*, std::vector<Expected>> cases[] = {
      {R"({"projection":"fisheye","aperture":1})", {{conflict, "/aperture", "1", "perspective"}}},
      {R"({"projection":"fisheye","near":1})", {{conflict, "/near", "1", "perspective"}}},
      {R"({"projection":"equirectangular","fov_degrees":40})",
       {{conflict, "/fov_degrees", "40", "projection perspective"}}},
      {R"({"projection":"equirectangular","angle_degrees":90})",
       {{conflict, "/angle_degrees", "90", "fisheye or cylindrical"}}},
      {R"({"projection":"fisheye","height":1})", {{conflict, "/height", "1", "cylindrical"}}},
      {R"({"projection":"cylindrical","right":[1,0,0]})",
       {{conflict, "/right", "[1,0,0]", "view plane"}}},
      {R"({"projection":"fisheye","look_at":[0,0,-1],"display":{"type":"quilt"}})",
       {{conflict, "/projection", R"("fisheye")", "perspective or orthographic"}}},
      {R"({"display":{"type":"quilt"}})", {{missing, "/display/focus_distance", "", "look_at"}}},
      {R"({"display":{"type":"stereo"}})", {{missing, "/display/convergence", "", "look_at"}}},
      {R"({"look_at":[0,0,-1],"display":{"type":"quilt","columns":1,"rows":1}})",
       {{range, "/display/columns", "1", "at least 2 views"}}},
      {R"({"look_at":[0,0,-1],"display":{"type":"quilt","cone_degrees":171}})",
       {{range, "/display/cone_degrees", "171", "170"}}},
      {R"({"display":{"type":"quilt","focus_distance":0}})",
       {{range, "/display/focus_distance", "0", "above 0"}}},
      {R"({"display":{"type":"stereo","convergence":-1}})",
       {{range, "/display/convergence", "-1", "above 0"}}},
      {R"({"display":{"type":"cube"},"fov_degrees":40})",
       {{conflict, "/fov_degrees", "40", "says itself"}}},
      {R"({"display":{"type":"omnistereo"},"near":1})", {{conflict, "/near", "1", "says itself"}}},
      {R"({"display":{"type":"cube"},"aperture":1,"focus_distance":2})",
       {{conflict, "/aperture", "1", "no lens"}}},
      {R"({"display":{"type":"modules","screen":[1,1],"modules":3,"pitch":1,"behind":1,
                      "observer":{"distance":1}}})",
       {{missing, "/look_at", "", "window"}}},
      {R"({"look_at":[0,0,-1],"display":{"type":"modules","screen":[1,1],"modules":1,"pitch":1,
           "behind":0,"observer":{"distance":-1}}})",
       {{range, "/display/modules", "1", "from 2 to 1024"},
        {range, "/display/behind", "0", "above 0"},
        {range, "/display/observer/distance", "-1", "above 0"}}},
      {R"({"look_at":[0,0,-1],"display":{"type":"modules","screen":[1,1],"modules":[2,1],
           "behind":1,"observer":{"distance":1}}})",
       {{range, "/display/modules/1", "1", "left to right"}}},
      {R"({"interlace":{"pitch":3}})",
       {{conflict, "/interlace", R"({"pitch":3})", "display quilt"}}},
      {R"({"look_at":[0,0,-1],"display":{"type":"stereo","matrix":"dubois"}})",
       {{conflict, "/display/matrix", R"("dubois")", "anaglyph"}}},
  };
  for (const auto& [text, expected] : cases) {
    SCOPED_TRACE(text);
    test::expect_faults(test::faults_of([&, json = text] { camera_of(json); }), expected);
  }
}

}  // namespace
}  // namespace tia
