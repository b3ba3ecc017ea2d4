// Pictures of several views, held to others of the same scene: what a viewer sees of a wall of
// projectors to a pinhole picture, the faces of a cube to a panorama.
#include "core/scene/views.h"

#include <gtest/gtest.h>

#include "tests/core/accel/worlds.h"

namespace tia {
namespace {

using test::Random;

const char* const bodies = R"("background":[0.1,0.2,0.3],"objects":[
    {"type":"sphere","center":[-0.6,0.2,-1],"radius":0.7,
     "material":{"color":[0.2,0.5,0.8],"ambient":0.2,"diffuse":0.8}},
    {"type":"box","min":[0,-1,-0.4],"max":[0.6,0.1,0.4],"transform":[{"rotate_degrees":[0,30,0]}],
     "material":{"color":[0.8,0.7,0.6],"ambient":0.2}},
    {"type":"sphere","center":[0.3,0.5,1.2],"radius":0.3,"material":{"color":[0.9,0.3,0.1]}}],
    "lights":[{"type":"directional","direction":[1,-2,-2]}])";

Image drawn(const World& world, const View& view, Scalar scalar = Scalar::wide) {
  RenderOptions options;
  options.integrator = IntegratorName::whitted;
  options.scalar = scalar;
  return test::picture(world, view, {0, 0, view.width, view.height}, options).image;
}

TEST(Views, OfEveryKindAreTheSameBytesWithoutAnIndexAndRayByRay) {
  Random random(280);
  Scene scene = test::mixed_scene(random, 40, 1);
  scene.lights = {test::point_light({9, 20, 20})};
  const World world = compile(scene), plain = test::without_index(compile(scene));
  const std::string wall =
      R"("modules","screen":[20,9],"modules":3,"pitch":4,"behind":5,"observer":{"distance":20})";
  for (const std::string& camera :
       {std::string(R"("projection":"orthographic","height":20)"),
        std::string(R"("projection":"fisheye")"), std::string(R"("projection":"equirectangular")"),
        std::string(R"("projection":"cylindrical")"), std::string(R"("display":{"type":"cube"})"),
        std::string(R"("display":{"type":"stereo","separation":2})"),
        std::string(R"("display":{"type":"omnistereo","separation":2})"),
        std::string(R"("display":{"type":"quilt","columns":2,"rows":2})"),
        std::string(R"("display":{"type":"quilt"},"interlace":{"pitch":5})"),
        R"("display":{"type":)" + wall + "}", R"("display":{"type":)" + wall + R"(,"slice":3})",
        std::string(R"("display":{"type":"two_plane","st":[20,9],"uv":{"columns":2,"rows":1,
            "spacing":1}})")}) {
    const auto of = read_described<Camera>(
        parse_json(R"({"location":[3,4,22],"look_at":[0,0,0],)" + camera + "}"));
    for (const GridView& each : views_of(of, 21, 21).views)
      EXPECT_EQ(test::bits_of(drawn(world, each.view)),
                test::bits_of(drawn(plain, each.view, Scalar::narrow)))
          << camera << ' ' << each.name;
  }
}

// A wall whose modules stand so that the viewers that it is for have one behind each column of
// pixels: what column i shows a viewer at X is the module at x_i - (X - x_i) behind / distance, and
// such places are `gap` apart.
struct AlignedWall {
  static constexpr int width = 40, height = 24, viewers = 4;
  double behind, distance, eye_height, first;  // of the first viewer's first module
  double screen = 3, gap;

  explicit AlignedWall(Random& random)
      : behind(random.in(0.5, 2)), distance(random.in(3, 5)), eye_height(random.in(-0.5, 0.5)) {
    gap = screen / width * (1 + behind / distance);
    first = x_of(0) - (random.in(-1, 1) - x_of(0)) * behind / distance;
  }
  double x_of(int column) const { return ((column + 0.5) / width - 0.5) * screen; }
  // Each next viewer sees each column's next module.
  double viewer(int number) const {
    return x_of(0) - (first + number * gap - x_of(0)) * distance / behind;
  }
  std::string text(std::optional<int> slice) const {
    std::string at;
    for (int m = 0; m < width + viewers - 1; ++m)
      at += (m > 0 ? "," : "") + to_json(Value(first + m * gap));
    return R"({"camera":{"location":[0,0,9],"look_at":[0,0,0],"display":{"type":"modules",
        "screen":[3,2],"modules":[)" +
           at + R"(],"behind":)" + to_json(Value(behind)) + R"(,"observer":{"distance":)" +
           to_json(Value(distance)) + R"(,"height":)" + to_json(Value(eye_height)) + "}" +
           (slice ? R"(,"slice":)" + to_json(Value(viewer(*slice))) : "") + "}}," + bodies + "}";
  }
  std::string pinhole(int number) const {
    const double x = viewer(number);
    const auto point = [](double a, double b, double c) {
      return to_json(write_value(Vec3d{a, b, c}));
    };
    return R"({"camera":{"location":)" + point(x, eye_height, distance) + R"(,"direction":)" +
           point(-x, -eye_height, -distance) + R"(,"right":[1.5,0,0],"up":[0,1,0]},)" + bodies +
           "}";
  }
};

TEST(ModuleWall, ASliceIsPutTogetherOfTheModulesImagesAndIsThePinholePicture) {
  Random random(281);
  int apart = 0, pixels = 0;
  for (int k = 0; k < 3; ++k) {
    const AlignedWall wall(random);
    const Scene scene = read_scene(wall.text({}));
    const World world = compile(scene);
    const ViewGrid grid = views_of(scene.camera, wall.width, wall.height);
    std::vector<Image> images;
    for (const GridView& of : grid.views) images.push_back(drawn(world, of.view));
    for (int v = 0; v < wall.viewers; ++v) {
      const ViewGrid seen = views_of(read_scene(wall.text(v)).camera, wall.width, wall.height);
      ASSERT_EQ(seen.views.size(), 1U);
      const Image slice = drawn(world, seen.views[0].view);
      const Image pinhole =
          drawn(world, view_of(read_scene(wall.pinhole(v)).camera, wall.width, wall.height));
      for (int y = 0; y < wall.height; ++y)
        for (int x = 0; x < wall.width; ++x, ++pixels) {
          const float* here = slice.at(x, y);
          const float* module = images[static_cast<std::size_t>(v + x)].at(x, y);
          float off = 0;
          for (int c = 0; c < 3; ++c) {
            EXPECT_EQ(here[c], module[c]);
            off = std::max(off, std::fabs(here[c] - pinhole.at(x, y)[c]));
          }
          apart += off > 1e-5F;
        }
    }
  }
  EXPECT_LE(apart, pixels / 1000) << "of " << pixels << ", at silhouettes";
}

TEST(ModuleWall, AViewerWhoSeesPastTheModulesSeesNothingThere) {
  // By similar triangles: from (0, 0, 1) the point x of the screen is in line with 2 x at the
  // modules; those at -1, 0 and 1 are seen up to half a gap beyond the outermost, |x| <= 0.75.
  const Camera camera = read_described<Camera>(parse_json(R"({"look_at":[0,0,-1],"display":{
      "type":"modules","screen":[2,1],"modules":3,"pitch":1,"behind":1,"slice":0,
      "observer":{"distance":1}}})"));
  const View view = views_of(camera, 80, 2).views[0].view;
  for (int x = 0; x < 80; ++x) {
    const double at = (x + 0.5) / 40 - 1;
    const SeenRay<double> seen = seen_ray<double>(view, x, 0, {});
    EXPECT_EQ(seen.seen, std::fabs(at) <= 0.75);
    if (!seen.seen) continue;
    // The module nearest to 2 at sends through the screen's point: x + (x - m) at the line of eyes.
    const double module = std::floor(2 * at + 0.5);
    EXPECT_NEAR(seen.ray.origin.x, at + (at - module), 1e-12);
  }
}

// The face of a cube map and the place on it of a direction: OpenGL 4.6, table 8.19.
struct CubePlace {
  std::size_t face;
  double s, t;
};
CubePlace place_of(const Vec3d& r) {
  const double x = std::fabs(r.x), y = std::fabs(r.y), z = std::fabs(r.z);
  const auto place = [](std::size_t face, double s, double t, double m) {
    return CubePlace{face, (s / m + 1) / 2, (t / m + 1) / 2};
  };
  if (x >= y && x >= z) return r.x > 0 ? place(0, -r.z, -r.y, x) : place(1, r.z, -r.y, x);
  if (y >= z) return r.y > 0 ? place(2, r.x, r.z, y) : place(3, r.x, -r.z, y);
  return r.z > 0 ? place(4, r.x, -r.y, z) : place(5, -r.x, -r.y, z);
}

// Linear between four pixels of one face, and beyond the outermost ones' middles.
double looked_up(const Image& face, double s, double t, int channel) {
  const double x = s * face.width - 0.5, y = t * face.height - 0.5;
  const int i = std::clamp(static_cast<int>(std::floor(x)), 0, face.width - 2);
  const int j = std::clamp(static_cast<int>(std::floor(y)), 0, face.height - 2);
  const auto at = [&](int dx, int dy) {
    return static_cast<double>(face.at(i + dx, j + dy)[channel]);
  };
  const double u = x - i, v = y - j;
  return (at(0, 0) * (1 - u) + at(1, 0) * u) * (1 - v) + (at(0, 1) * (1 - u) + at(1, 1) * u) * v;
}

// Within a ball, where light changes smoothly: what is linear between pixels is off by the second
// difference, which falls to a quarter with pixels half as wide. A face that stood half a pixel
// beside its place would leave as much as light changes over that, half as much as before.
TEST(CubeMap, FacesMeetWithoutASeamAndAgreeWithAPanorama) {
  const Scene scene = read_scene(R"({"camera":{"location":[0.2,-0.1,0.3],"direction":[1,2,-3],
      "up":[0.3,1,0],"display":{"type":"cube"}},"ambient_light":[0,0,0],
      "objects":[{"type":"sphere","center":[0,0,0],"radius":2,"material":{"diffuse":1}}],
      "lights":[{"type":"point","position":[0.5,0.8,-0.2],"color":[1,0,0]},
                {"type":"point","position":[-0.9,0.1,0.4],"color":[0,1,0]},
                {"type":"point","position":[0.1,-0.9,-0.5],"color":[0,0,1]}]})");
  const World world = compile(scene);
  Camera around = scene.camera;
  around.display.reset();
  around.projection = Projection::equirectangular;
  const View panorama = view_of(around, 72, 36);
  const Image samples = drawn(world, panorama);
  const auto most_off = [&](int size) {
    std::vector<Image> faces;
    const ViewGrid grid = views_of(scene.camera, size, size);
    for (const GridView& face : grid.views) faces.push_back(drawn(world, face.view));
    const View& px = grid.views[0].view;  // its axis, up and, negated, right are x, y and z
    double most = 0;
    for (int y = 0; y < 36; ++y)
      for (int x = 0; x < 72; ++x) {
        const Vec3d way = seen_ray<double>(panorama, x, y, {}).ray.direction;
        const CubePlace at = place_of({dot(way, px.axis), dot(way, px.up), -dot(way, px.right)});
        for (int c = 0; c < 3; ++c)
          most = std::max(most, std::fabs(looked_up(faces[at.face], at.s, at.t, c) -
                                          static_cast<double>(samples.at(x, y)[c])));
      }
    return most;
  };
  const double coarse = most_off(16), fine = most_off(32);
  EXPECT_LT(fine, 4e-3);
  EXPECT_LT(fine, coarse / 3);
}

}  // namespace
}  // namespace tia
