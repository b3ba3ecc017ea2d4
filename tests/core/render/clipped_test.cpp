// Near and far planes, depths along the view's axis and labels, in closed form.
#include <gtest/gtest.h>

#include <cmath>

#include "core/render/explain.h"
#include "core/scene/pinhole.h"
#include "tests/core/accel/worlds.h"

namespace tia {
namespace {

using test::picture;
using test::Random;

constexpr float nothing = std::numeric_limits<float>::infinity();

RenderOptions clipped_options(IntegratorName integrator, Scalar scalar = Scalar::wide) {
  RenderOptions options;
  options.integrator = integrator;
  options.scalar = scalar;
  return options;
}
Image numbers_of(const Scene& scene, IntegratorName integrator, int width, int height) {
  return picture(scene, width, height, clipped_options(integrator)).image;
}

Object wall_at(double z, const Material& material) {
  return {"", Disc{{0, 0, z}, {0, 0, 1}, 100}, {}, MaterialRef(material)};
}
Material pane_of_alpha(double alpha) {
  Principled pane;
  pane.alpha_mode = AlphaMode::blend;
  pane.alpha = alpha;
  return Material{pane};
}

// Three walls across the view that shine and scatter nothing; and a pane between the first two that
// is not there, so that rays pass it.
const Color shines[] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
Scene walls(double near, double far, bool has_pane) {
  Scene scene;
  std::vector<Object> objects;
  for (int i = 0; i < 3; ++i) objects.push_back(wall_at(-2 - 2 * i, test::matte({}, shines[i])));
  if (has_pane) objects.push_back(wall_at(-3, pane_of_alpha(0)));
  scene.objects = objects;
  scene.background = {0.25, 0.5, 0.125};
  scene.camera.fov_degrees = 70;
  if (near > 0) scene.camera.near = near;
  if (far > 0) scene.camera.far = far;
  return scene;
}

// What is seen between two planes: the number of a wall, or none.
struct ClippedCase {
  double near, far;
  int wall;
};
constexpr ClippedCase clipped_cases[] = {{0, 0, 0},      {2.5, 0, 1}, {4.5, 0, 2},
                                         {7, 0, -1},     {0, 1, -1},  {0, 2.5, 0},
                                         {2.5, 3.5, -1}, {2.5, 5, 1}, {4.5, 5.5, -1}};

TEST(Clipped, OnlyWhatLiesBetweenNearAndFarIsSeen) {
  for (const bool has_pane : {false, true})
    for (const bool orthographic : {false, true})
      for (const auto& [near, far, wall] : clipped_cases) {
        Scene scene = walls(near, far, has_pane);
        if (orthographic) {
          scene.camera.projection = Projection::orthographic;
          scene.camera.fov_degrees = Camera{}.fov_degrees;
          scene.camera.height = 3;
        }
        const float expected = wall < 0 ? nothing : static_cast<float>(2 + 2 * wall);
        for (const float number : numbers_of(scene, IntegratorName::planar_depth, 13, 9).rgb)
          if (wall < 0) ASSERT_EQ(number, nothing) << near << ' ' << far;
          else ASSERT_NEAR(number, expected, 1e-5) << near << ' ' << far;
      }
}

TEST(Clipped, LightComesFromWhatIsSeenElseFromTheBackground) {
  for (const IntegratorName integrator : {IntegratorName::whitted, IntegratorName::path})
    for (const bool has_pane : {false, true})
      for (const bool has_backdrop : {false, true})
        for (const auto& [near, far, wall] : clipped_cases) {
          Scene scene = walls(near, far, has_pane);
          if (has_backdrop) scene.backdrop = Backdrop{Color{0.75, 0.5, 0.25}};
          const Color expected = wall >= 0      ? shines[wall]
                                 : has_backdrop ? *scene.backdrop->color
                                                : scene.background;
          const Image image = numbers_of(scene, integrator, 5, 3);
          for (std::size_t i = 0; i < image.rgb.size(); i += 3) {
            ASSERT_NEAR(image.rgb[i], expected.r, 1e-6) << near << ' ' << far << has_pane;
            ASSERT_NEAR(image.rgb[i + 1], expected.g, 1e-6) << near << ' ' << far << has_backdrop;
            ASSERT_NEAR(image.rgb[i + 2], expected.b, 1e-6);
          }
        }
}

// Rays that go straight on from a pane are the camera's still: nothing behind far is seen by them.
TEST(Clipped, BehindAPaneTheFarPlaneHoldsToo) {
  Scene scene = walls(2.5, 3.5, false);
  scene.objects.edit().push_back(wall_at(-3, pane_of_alpha(0.5)));
  const Image image = numbers_of(scene, IntegratorName::whitted, 3, 3);
  EXPECT_NEAR(image.rgb[0], 0.5 * scene.background.r, 1e-6);
  EXPECT_NEAR(image.rgb[1], 0.5 * scene.background.g, 1e-6);
}

TEST(Clipped, AHalvedBallShowsItsInside) {
  Scene scene;
  scene.objects = {test::ball({0, 0, -5}, 2, test::matte({1, 1, 1}))};
  scene.camera.near = 5;
  scene.lights = {test::point_light({0, 0, 0})};
  EXPECT_NEAR(numbers_of(scene, IntegratorName::depth, 1, 1).rgb[0], 7, 1e-5);
  // A world of few balls is traced in its own way where nothing is clipped.
  EXPECT_GT(numbers_of(scene, IntegratorName::normal, 1, 1).rgb[2], 0.99F);
  scene.camera.far = 6;
  EXPECT_EQ(numbers_of(scene, IntegratorName::depth, 1, 1).rgb[0], nothing);
  scene.background = {0.5, 0.5, 0.5};
  EXPECT_EQ(numbers_of(scene, IntegratorName::whitted, 1, 1).rgb[0], 0.5F);
}

TEST(Clipped, WideEqualsNarrowBitForBitAndExplanationsAreThePictures) {
  Random random(320);
  Scene scene = test::mixed_scene(random, 60, 1);
  scene.camera.location = {3, 4, 25};
  scene.camera.look_at = Vec3d{0, -1, 0};
  scene.camera.near = 22;
  scene.camera.far = 29;
  scene.lights = {test::point_light({9, 20, 20})};
  for (const IntegratorName integrator :
       {IntegratorName::whitted, IntegratorName::path, IntegratorName::planar_depth,
        IntegratorName::label, IntegratorName::object}) {
    const auto wide = picture(scene, 37, 23, clipped_options(integrator));
    const auto narrow = picture(scene, 37, 23, clipped_options(integrator, Scalar::narrow));
    EXPECT_TRUE(test::bits_of(wide.image) == test::bits_of(narrow.image)) << int(integrator);
  }
  const auto options = clipped_options(IntegratorName::whitted);
  const Image image = picture(scene, 37, 23, options).image;
  const View view = view_of(scene.camera, 37, 23);
  for (const auto& [x, y] : {std::pair(3, 4), {18, 11}, {22, 9}, {30, 20}}) {
    const Vec3f told = explain(scene, compile(scene), view, x, y, 0, options).tree->color;
    const float* drawn = image.at(x, y);
    EXPECT_EQ(told, (Vec3f{drawn[0], drawn[1], drawn[2]}));
  }
}

// A plane n p = d is met by the way (x, y, -1) s at s = d / (n (x, y, -1)), which is the depth.
TEST(PlanarDepth, OfASlantedPlaneIsTheClosedForm) {
  Random random(321);
  for (int k = 0; k < 20; ++k) {
    const int width = 40, height = 30;
    const Pinhole pinhole{random.in(20, 60), random.in(20, 60), random.in(0, 40), random.in(0, 30)};
    const Vec3d n = normalize(Vec3d{random.in(-0.3, 0.3), random.in(-0.3, 0.3), 1});
    const double d = -random.in(0.5, 20);
    Scene scene;
    scene.objects = {{"", Plane{n * d, n}, {}, MaterialRef(test::matte({1, 1, 1}))}};
    scene.camera = seen_through(pinhole, Camera{}, width, height);
    const Image image = numbers_of(scene, IntegratorName::planar_depth, width, height);
    for (int j = 0; j < height; ++j)
      for (int i = 0; i < width; ++i) {
        const Vec3d way{(i + 0.5 - pinhole.center_x) / pinhole.focal_x,
                        (pinhole.center_y - j - 0.5) / pinhole.focal_y, -1};
        const double across = dot(n, way), s = d / across;
        if (std::fabs(across) < 1e-2) continue;  // grazing
        if (s > 0) ASSERT_NEAR(image.at(i, j)[0], s, 1e-6 * s * length(way) / std::fabs(across));
        else ASSERT_EQ(image.at(i, j)[0], nothing);
      }
  }
}

TEST(Label, IsTheBaseColourWhateverElseTheMaterialIs) {
  Principled metal;
  metal.base_color = Color{13 / 255.0, 200 / 255.0, 1};
  metal.metallic = 1.0;
  metal.emissive = {1, 1, 1};
  Principled checked = metal;
  checked.texture = Texture{Checker{}};
  Finish finish;
  finish.color = {13 / 255.0, 200 / 255.0, 1};
  finish.diffuse = 0.25;
  for (const Material& material : {Material{metal}, Material{checked}, Material{finish}}) {
    Scene scene;
    scene.objects = {{"", Disc{{0, 0, -2}, {0, 0, 1}, 0.2}, {}, MaterialRef(material)}};
    const Image image = numbers_of(scene, IntegratorName::label, 9, 9);
    const float* inside = image.at(4, 4);
    EXPECT_EQ(std::lround(inside[0] * 255.0F), 13);
    EXPECT_EQ(std::lround(inside[1] * 255.0F), 200);
    EXPECT_EQ(inside[2], 1);
    for (int c = 0; c < 3; ++c) EXPECT_EQ(image.at(0, 0)[c], 1);
  }
}

}  // namespace
}  // namespace tia
