// POST /render as Drake's RenderEngineGltfClient sends it: what each pixel is, in closed form.
#include <cmath>
#include <limits>

#include "server/stores/digest.h"
#include "tests/core/film/tiff_reader.h"
#include "tests/core/support.h"
#include "tests/server/drake_support.h"
#include "tests/server/picture_support.h"
#include "tests/server/socket_support.h"

namespace tia::test {
namespace {

constexpr int width = 64, height = 48;
constexpr double near = 0.01, far = 10, focal_x = 50, focal_y = 40, center_x = 31.5,
                 center_y = 20.25;

Vec3d way_of(int i, int j) {
  return {(i + 0.5 - center_x) / focal_x, (center_y - j - 0.5) / focal_y, -1};
}

// A wall's depth along a way, by Moeller and Trumbore; nothing where the way goes by; NaN where it
// goes so near to an edge that rounding decides.
std::optional<double> depth_of(const DrakeWall& wall, const Vec3d& way) {
  const Vec3d e = wall.b - wall.a, f = wall.c - wall.a, p = cross(way, f), t = wall.a * -1.0;
  const double det = dot(e, p), u = dot(t, p) / det, v = dot(way, cross(t, e)) / det;
  const double inside = std::min({u, v, 1 - u - v}), depth = dot(f, cross(t, e)) / det;
  if (std::fabs(inside) < 1e-4) return std::nan("");
  if (inside < 0 || depth <= 0) return std::nullopt;
  return depth;
}

struct Expected {
  const DrakeWall* wall = nullptr;
  double depth = std::numeric_limits<double>::infinity();
  bool is_open = false;  // rounding decides
};
Expected expected_at(const std::vector<DrakeWall>& walls, int i, int j) {
  Expected expected;
  for (const DrakeWall& wall : walls) {
    const auto depth = depth_of(wall, way_of(i, j));
    if (!depth) continue;
    if (std::isnan(*depth)) expected.is_open = true;
    for (const double plane : {near, far, expected.depth})
      if (std::fabs(*depth - plane) < 1e-4) expected.is_open = true;
    if (*depth > near && *depth < far && *depth < expected.depth)
      expected.wall = &wall, expected.depth = *depth;
  }
  return expected;
}

// Triangles of all sizes, some nearer than near, some beyond far.
std::vector<DrakeWall> random_walls(Random& random) {
  std::vector<DrakeWall> walls;
  for (int n = 0; n < 12; ++n) {
    const Vec3d middle{random.in(-3, 3), random.in(-3, 3), -random.in(0.005, 13)};
    DrakeWall wall{middle + random.point(3), middle + random.point(3), middle + random.point(3),
                   random.below(255),        random.below(255),        random.below(255)};
    walls.push_back(wall);
  }
  return walls;
}
DrakeSensor random_sensor(Random& random) {
  DrakeSensor sensor;
  sensor.back = random.direction();
  sensor.right = normalize(cross(random.direction(), sensor.back));
  sensor.up = cross(sensor.back, sensor.right);
  sensor.location = random.point(4);
  return sensor;
}

TEST(Drake, LabelsAreExactAtProjectedPoints) {
  Random random(330);
  int seen = 0, open = 0;
  for (int k = 0; k < 6; ++k) {
    const auto walls = random_walls(random);
    const Response picture =
        send_drake(drake_fields("label"), drake_scene(walls, random_sensor(random)));
    ASSERT_EQ(picture.status, 200) << picture.body;
    EXPECT_EQ(picture.content_type, "image/png");
    const auto codes = decode_png(picture.body);
    for (int j = 0; j < height; ++j)
      for (int i = 0; i < width; ++i) {
        const auto [wall, depth, is_open] = expected_at(walls, i, j);
        if (is_open && ++open != 0) continue;
        seen += wall != nullptr;
        ASSERT_EQ(codes.at(i, j, 0), wall != nullptr ? wall->red : 255) << i << ' ' << j;
        ASSERT_EQ(codes.at(i, j, 1), wall != nullptr ? wall->green : 255);
        ASSERT_EQ(codes.at(i, j, 2), wall != nullptr ? wall->blue : 255);
      }
  }
  EXPECT_GT(seen, 3000);
  EXPECT_LT(open, 600);
}

TEST(Drake, DepthsAreMetresAlongTheAxisWithinTheSensorsRange) {
  Random random(331);
  constexpr double least = 2, most = 5;
  int within = 0;
  for (int k = 0; k < 4; ++k) {
    const auto walls = random_walls(random);
    const Response picture =
        send_drake(drake_fields("depth"), drake_scene(walls, random_sensor(random)));
    ASSERT_EQ(picture.status, 200) << picture.body;
    EXPECT_EQ(picture.content_type, "image/tiff");
    const TiffPicture depths = read_tiff(picture.body);
    ASSERT_EQ(depths.channels, 1U);
    for (std::size_t j = 0; j < height; ++j)
      for (std::size_t i = 0; i < width; ++i) {
        const auto [wall, depth, is_open] =
            expected_at(walls, static_cast<int>(i), static_cast<int>(j));
        if (is_open || std::fabs(depth - least) < 1e-4 || std::fabs(depth - most) < 1e-4) continue;
        const float got = depths.at(i, j);
        if (depth < least) ASSERT_EQ(got, 0);
        else if (depth > most) ASSERT_EQ(got, std::numeric_limits<float>::infinity());
        else ASSERT_NEAR(got, depth, 1e-4) << i << ' ' << j;
        within += depth >= least && depth <= most;
      }
  }
  EXPECT_GT(within, 500);
}

TEST(Drake, ColourIsLitFromTheSensorBeforeDrakesBackground) {
  const Response picture = send_drake(drake_fields("color"), plain_scene(), "?samples=4");
  ASSERT_EQ(picture.status, 200) << picture.body;
  const auto codes = decode_png(picture.body);
  ASSERT_EQ(codes.width, width);
  ASSERT_EQ(codes.height, height);
  for (const auto& [x, y] : {std::pair(0, 0), {63, 0}, {0, 47}, {63, 47}}) {
    EXPECT_EQ(codes.at(x, y, 0), 204);
    EXPECT_EQ(codes.at(x, y, 1), 229);
    EXPECT_EQ(codes.at(x, y, 2), 255);
  }
  // The middle of the wall: pixel (31.5, 20.25) looks along (0, 0, -1).
  EXPECT_GT(codes.at(31, 22, 2), codes.at(31, 22, 0));
  EXPECT_GT(codes.at(31, 22, 0), 0);
  const Response whitted = send_drake(drake_fields("color"), plain_scene(), "?integrator=whitted");
  ASSERT_EQ(whitted.status, 200) << whitted.body;
  EXPECT_EQ(decode_png(whitted.body).at(0, 0, 1), 229);
}

TEST(Drake, ItsPicturesDrawThemselvesAgainWhereTheModelIsKept) {
  Host own;
  for (const char* image_type : {"color", "label"}) {
    const Response picture = own.post(
        "/render?samples=1", drake_form(drake_fields(image_type), plain_scene()), drake_type());
    ASSERT_EQ(picture.status, 200) << picture.body;
    if (std::string(image_type) == "color") {
      EXPECT_EQ(own.post("/render", picture.body, "image/png").status, 422) << "nothing was kept";
      ASSERT_EQ(own.post("/models", plain_scene(), "model/gltf+json").status, 201);
    }
    const Response again = own.post("/render", picture.body, "image/png");
    ASSERT_EQ(again.status, 200) << again.body;
    EXPECT_TRUE(again.body == picture.body) << image_type;
  }
}

// ---- over a socket ------------------------------------------------------------------------------

TEST(Drake, FormsMayBeAsLongAsModels) {
  Config config;
  config.max_model_bytes = 12'345'678;
  const auto limit = [&](const std::string& target, const std::string& type) {
    return body_limit({"POST", target, {{"Content-Type", type}}, "", Host::id}, config);
  };
  ASSERT_TRUE(limit("/render", drake_type()));
  EXPECT_EQ(limit("/render", drake_type())->most_bytes, 12'345'678);
  EXPECT_FALSE(limit("/render", "application/json"));
  EXPECT_FALSE(limit("/scenes", drake_type()));
}

// The request as libcurl sends it for Drake.
TEST(Drake, ItsClientIsAnsweredOverASocket) {
  const std::string& scene = plain_scene();
  for (const char* image_type : {"color", "depth", "label"}) {
    DrakeFields fields = drake_fields(image_type);
    set_field(fields, "scene_sha256", sha256_hex(scene));
    const std::string body = drake_form(fields, scene);
    const std::string port = std::to_string(shared_server().port());
    const Response answer =
        exchange(shared_server().port(),
                 "POST /render HTTP/1.1\r\nHost: 127.0.0.1:" + port +
                     "\r\nAccept: */*\r\nContent-Length: " + std::to_string(body.size()) +
                     "\r\nContent-Type: " + drake_type() + "\r\n\r\n" + body);
    ASSERT_EQ(answer.status, 200) << answer.body;
    EXPECT_EQ(answer.content_type, std::string(image_type) == "depth" ? "image/tiff" : "image/png");
    if (answer.content_type == "image/tiff") EXPECT_EQ(read_tiff(answer.body).width, 64U);
    else EXPECT_EQ(decode_png(answer.body).width, 64);
  }
}

}  // namespace
}  // namespace tia::test
