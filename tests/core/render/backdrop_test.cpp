// Pictures before a backdrop: what they show where no object is, and the alpha of what is.
#include <map>
#include <mutex>

#include "tests/core/integrators/paths.h"

namespace tia {
namespace {

using namespace test;

constexpr int backdrop_size = 24;

// A tile's light with alpha. Shape: height x width x 4.
std::vector<float> with_alpha(const Scene& scene, const RenderOptions& options) {
  Pool pool(options.threads);
  const int size = backdrop_size;
  std::vector<float> all(std::size_t{4} * size * size);
  std::mutex mutex;
  render(compile(scene), view_of(scene.camera, size, size), {0, 0, size, size}, options, pool, {},
         [&](const FilmTile& tile) {
           const std::lock_guard lock(mutex);
           for (int y = 0; y < tile.height; ++y)
             for (int x = 0; x < tile.width; ++x) {
               const std::size_t from = FilmTile::index(x, y);
               float* to = &all[4 * static_cast<std::size_t>((tile.y + y) * size + tile.x + x)];
               to[0] = tile.r[from], to[1] = tile.g[from], to[2] = tile.b[from];
               to[3] = tile.alpha[from];
             }
         });
  return all;
}

// A ball between the eye and a lit panel, another panel before it, all before a bright sky.
Scene panels_and_ball() {
  Scene scene;
  scene.camera.location = {0, 0, 5};
  scene.camera.direction = Vec3d{0, 0, -1};
  scene.camera.fov_degrees = 40;
  scene.background = {2, 0, 0};
  scene.objects = {object(Sphere{{0, 0, 0}, 1}, matt(0.5))};
  scene.lights = {light_of(QuadLight{Vec3d{-9, -9, -3}, {18, 0, 0}, {0, 18, 0}}, {0, 3, 0}),
                  light_of(QuadLight{Vec3d{-2, -2, 2}, {2, 0, 0}, {0, 4, 0}}, {0, 0, 3})};
  return scene;
}
RenderOptions gathering(IntegratorName integrator, int samples) {
  RenderOptions options;
  options.integrator = integrator;
  options.samples = samples;
  options.max_depth = 4;
  return options;
}

constexpr std::array lit_kinds{IntegratorName::whitted, IntegratorName::thesis,
                               IntegratorName::path, IntegratorName::ambient_occlusion};

// By the first hits alone: the picture of `object` without lights.
TEST(BackdropPicture, ShowsLightsAndSkyNowhereAndItsColourWhereNoObjectIs) {
  Scene scene = panels_and_ball();
  Scene bare = scene;
  bare.lights.clear();
  const Image objects =
      picture(bare, backdrop_size, backdrop_size, gathering(IntegratorName::object, 1)).image;
  scene.backdrop = Backdrop{Color{0.25, 0.5, 0.75}};
  for (const IntegratorName integrator : lit_kinds) {
    const std::vector<float> all = with_alpha(scene, gathering(integrator, 1));
    for (std::size_t i = 0; i < all.size() / 4; ++i) {
      const bool here = objects.rgb[3 * i] > 0;
      EXPECT_EQ(all[4 * i + 3], here ? 1 : 0);
      if (!here) {
        EXPECT_EQ((std::array{all[4 * i], all[4 * i + 1], all[4 * i + 2]}),
                  (std::array{0.25F, 0.5F, 0.75F}));
      }
    }
  }
}

// What numbers the camera rays find is what they would without lights.
TEST(BackdropPicture, FeaturesAreThoseOfObjectsAlone) {
  Scene scene = panels_and_ball(), bare = scene;
  bare.lights.clear();
  scene.backdrop = Backdrop{};
  for (const IntegratorName feature : {IntegratorName::object, IntegratorName::depth,
                                       IntegratorName::normal, IntegratorName::albedo})
    EXPECT_EQ(picture(scene, 24, 16, gathering(feature, 1)).image.rgb,
              picture(bare, 24, 16, gathering(feature, 1)).image.rgb);
}

TEST(BackdropPicture, ObjectsAreLitAsWithoutIt) {
  Scene scene = panels_and_ball();
  scene.lights.pop_back();  // the panel before the ball
  for (const IntegratorName integrator : lit_kinds) {
    const RenderOptions options = gathering(integrator, 1);
    scene.backdrop.reset();
    const Image before = picture(scene, backdrop_size, backdrop_size, options).image;
    scene.backdrop = Backdrop{};
    const std::vector<float> all = with_alpha(scene, options);
    int met = 0;
    for (std::size_t i = 0; i < all.size() / 4; ++i) {
      if (all[4 * i + 3] == 0) continue;
      ++met;
      for (std::size_t k = 0; k < 3; ++k) EXPECT_EQ(all[4 * i + k], before.rgb[3 * i + k]);
    }
    EXPECT_GT(met, 50);
  }
}

// A transparent picture over a colour is, pixel by pixel, the picture before that colour.
TEST(BackdropPicture, OverAColourIsThePictureBeforeThatColour) {
  Scene scene = panels_and_ball();
  const std::array<float, 3> color{0.25F, 0.5F, 1};
  for (const IntegratorName integrator : lit_kinds) {
    RenderOptions options = gathering(integrator, 16);
    scene.backdrop = Backdrop{};
    const std::vector<float> clear = with_alpha(scene, options);
    scene.backdrop = Backdrop{Color{0.25, 0.5, 1}};
    const std::vector<float> colored = with_alpha(scene, options);
    int edges = 0;
    for (std::size_t i = 0; i < clear.size(); i += 4) {
      const float alpha = clear[i + 3];
      EXPECT_EQ(colored[i + 3], alpha);
      edges += alpha > 0 && alpha < 1;
      for (std::size_t k = 0; k < 3; ++k)
        EXPECT_NEAR(clear[i + k] + (1 - alpha) * color[k], colored[i + k], 1e-6);
    }
    EXPECT_GT(edges, 20);
  }
}

// The share of a pixel that a half plane's edge leaves.
TEST(BackdropPicture, AlphaIsTheShareOfSamplesThatMeetAnObject) {
  Scene scene;
  scene.camera.location = {0, 0, 5};
  scene.camera.direction = Vec3d{0, 0, -1};
  scene.camera.projection = Projection::orthographic;
  scene.camera.height = backdrop_size;
  scene.backdrop = Backdrop{};
  // Columns of one unit each: of the one from 3 to 4 it covers 0.3.
  scene.objects = {object(Box{{-100, -100, -1}, {3.3, 100, 0}}, matt(1))};
  const std::vector<float> all = with_alpha(scene, gathering(IntegratorName::whitted, 400));
  for (int x = 0; x < backdrop_size; ++x) {
    const double left = x - backdrop_size / 2;
    EXPECT_NEAR(all[4 * static_cast<std::size_t>(x) + 3], std::clamp(3.3 - left, 0.0, 1.0), 0.05);
  }
}

TEST(BackdropPicture, IsTheSameInEveryWidthAndTile) {
  Scene scene = panels_and_ball();
  scene.backdrop = Backdrop{};
  for (const int samples : {1, 8})
    for (const IntegratorName integrator : lit_kinds) {
      RenderOptions options = gathering(integrator, samples);
      const std::vector<float> wide = with_alpha(scene, options);
      options.scalar = Scalar::narrow;
      EXPECT_EQ(with_alpha(scene, options), wide);
      options.tile = 7;
      options.threads = 3;
      EXPECT_EQ(with_alpha(scene, options), wide);
    }
}

TEST(BackdropPicture, FewBallsAreDrawnBeforeItToo) {
  Scene scene = thesis_scene('d');
  ASSERT_TRUE(compile(scene).few_balls);
  scene.backdrop = Backdrop{};
  EXPECT_FALSE(compile(scene).few_balls);
  const std::vector<float> all = with_alpha(scene, gathering(IntegratorName::thesis, 1));
  std::map<float, int> alphas;
  for (std::size_t i = 3; i < all.size(); i += 4) ++alphas[all[i]];
  EXPECT_EQ(alphas.size(), 2U);
  EXPECT_GT(alphas[1], 10);
  EXPECT_GT(alphas[0], 10);
}

}  // namespace
}  // namespace tia
