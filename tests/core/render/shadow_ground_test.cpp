// Shadows on a ground that is not there: alpha is 1 - E / E0, whatever the rest of the picture is.
#include <mutex>

#include "tests/core/integrators/paths.h"

namespace tia {
namespace {

using namespace test;

constexpr int ground_size = 24;

struct Rgba {
  float r, g, b, alpha;
  bool operator==(const Rgba&) const = default;
};
struct Shadowed {
  std::vector<Rgba> pixels;
  Rendered told;
  double mean_alpha() const {
    double sum = 0;
    for (const Rgba& pixel : pixels) sum += static_cast<double>(pixel.alpha);
    return sum / static_cast<double>(pixels.size());
  }
};

Shadowed shadowed(const Scene& scene, const RenderOptions& options, int size = ground_size) {
  Pool pool(options.threads);
  Shadowed all{std::vector<Rgba>(static_cast<std::size_t>(size * size)), {}};
  std::mutex mutex;
  all.told = render(compile(scene), view_of(scene.camera, size, size), {0, 0, size, size}, options,
                    pool, {}, [&](const FilmTile& tile) {
                      const std::lock_guard lock(mutex);
                      for (int y = 0; y < tile.height; ++y)
                        for (int x = 0; x < tile.width; ++x) {
                          const std::size_t i = FilmTile::index(x, y);
                          const auto to =
                              static_cast<std::size_t>((tile.y + y) * size + tile.x + x);
                          all.pixels[to] = {tile.r[i], tile.g[i], tile.b[i], tile.alpha[i]};
                        }
                    });
  return all;
}

RenderOptions shadows_by(IntegratorName integrator, int samples) {
  RenderOptions options;
  options.integrator = integrator;
  options.samples = samples;
  options.max_depth = 5;
  return options;
}

// A disc of radius 1 above y = 0, before nothing.
Scene disc_above_ground(double height, const Finish& finish) {
  Scene scene;
  scene.backdrop = Backdrop{};
  scene.shadow_ground = ShadowGround{{7, 0, -3}, {0, 2, 0}};
  scene.objects = {object(Disc{{0, height, 0}, {0, 1, 0}, 1}, finish)};
  return scene;
}
// All of the picture is that point of the ground, seen from a side that the disc does not hide.
Scene seen_at(Scene scene, double x) {
  scene.camera.location = {x - 40, 3, 0};
  scene.camera.direction = Vec3d{x, 0, 0} - scene.camera.location;
  scene.camera.fov_degrees = 1e-3;
  return scene;
}
Light directional(const Vec3d& direction, const Color& color) {
  Light light;
  light.kind = DirectionalLight{direction};
  light.color = color;
  return light;
}

constexpr std::array shading_kinds{IntegratorName::whitted, IntegratorName::thesis,
                                   IntegratorName::path};

// ---- in closed form -----------------------------------------------------------------------------

// Under a sky of one radiance a disc takes from E what it fills of the hemisphere, by the cosine:
//   F = (1 - (d^2 + h^2 - 1) / sqrt((d^2 + h^2 + 1)^2 - 4 d^2)) / 2
// at the distance d from below its centre. What is white sends nothing of it back, for what it
// sees is the black ground.
// Source: Howell, "A catalog of radiation heat transfer configuration factors", B-13, an element
// parallel to a disc.
TEST(ShadowGround, UnderADiscBeforeASkyIsTheShareThatItHides) {
  const int samples = rounds(1024, 16);
  for (const double height : {0.5, 2.0})
    for (const double albedo : {0.0, 1.0})
      for (const double d : {0.0, 0.8, 3.0}) {
        Scene scene = seen_at(disc_above_ground(height, matt(albedo)), d);
        scene.lights = {Light{}};
        scene.lights[0].kind = SkyLight{};
        const double q = d * d + height * height;
        const double hidden = (1 - (q - 1) / std::sqrt((q + 1) * (q + 1) - 4 * d * d)) / 2;
        const double n = 16.0 * samples;  // as if independent: 5 standard errors
        EXPECT_NEAR(shadowed(scene, shadows_by(IntegratorName::path, samples), 4).mean_alpha(),
                    hidden, 5 * std::sqrt(hidden * (1 - hidden) / n) + 1e-4)
            << height << ' ' << albedo << ' ' << d;
      }
}

// The light from above is missing, the ambient light is there: by luminance.
TEST(ShadowGround, UnderADiscInLightFromAboveIsTheShareOfThatLight) {
  Scene scene = seen_at(disc_above_ground(1, matt(1)), 0.5);
  scene.ambient_light = {0.5, 0.25, 0};
  scene.lights = {directional({0, -1, 0}, {1, 0, 2}), directional({1, -0.25, 0}, {0, 3, 0})};
  const double ambient = 0.2126 * 0.5 + 0.7152 * 0.25;
  const double above = 0.2126 * 1 + 0.0722 * 2, aside = 0.7152 * 3 * 0.25 / std::sqrt(1.0625);
  for (const IntegratorName integrator : {IntegratorName::whitted, IntegratorName::thesis})
    EXPECT_NEAR(shadowed(scene, shadows_by(integrator, 4), 4).mean_alpha(),
                above / (ambient + above + aside), 1e-5);
  const double by_path = above / (above + aside);  // which knows no ambient light
  EXPECT_NEAR(shadowed(scene, shadows_by(IntegratorName::path, 256), 4).mean_alpha(), by_path,
              0.05);
}

// ---- where there is none ------------------------------------------------------------------------

// A black ball in light from above, seen at a slant.
Scene ball_on_ground() {
  Scene scene;
  scene.camera.location = {0, 4, 8};
  scene.camera.direction = Vec3d{0, -0.4, -1};
  scene.camera.fov_degrees = 40;
  scene.backdrop = Backdrop{};
  scene.shadow_ground = ShadowGround{{0, -1, 0}, {0, 1, 0}};
  scene.objects = {object(Sphere{{0, 0, 0}, 1}, matt(0))};
  scene.lights = {directional({0.5, -1, 0}, {1, 1, 1}),
                  light_of(QuadLight{Vec3d{-9, 9, -3}, {3, 0, 0}, {0, 0, 3}}, {5, 5, 5})};
  return scene;
}

TEST(ShadowGround, IsNothingToTheBitWhereNoLightIsMissing) {
  Scene scene = ball_on_ground();
  scene.objects.edit()[0].transform = {};
  scene.lights.pop_back();
  for (const IntegratorName integrator : shading_kinds) {
    int clear = 0, dark = 0;
    for (const Rgba& pixel : shadowed(scene, shadows_by(integrator, 8)).pixels) {
      clear += pixel.alpha == 0;
      dark += pixel.alpha == 1;
    }
    EXPECT_GT(clear, 250) << "all but the ball and its shadow, which the ground does not reach to";
    EXPECT_GT(dark, 25);
    EXPECT_GT(clear + dark, 490) << "but for edges";
  }
}

TEST(ShadowGround, IsNotSeenFromBelow) {
  Scene scene = ball_on_ground();
  scene.camera.location = {0, -5, 8};
  scene.camera.direction = Vec3d{0, 0.5, -1};
  const std::vector<Rgba> with = shadowed(scene, shadows_by(IntegratorName::path, 4)).pixels;
  scene.shadow_ground.reset();
  EXPECT_EQ(shadowed(scene, shadows_by(IntegratorName::path, 4)).pixels, with);
}

TEST(ShadowGround, ChangesNoObject) {
  Scene scene = ball_on_ground();
  scene.objects.edit()[0].material = MaterialRef(Material{matt(0.7)});
  for (const IntegratorName integrator : shading_kinds) {
    const RenderOptions options = shadows_by(integrator, 1);
    const std::vector<Rgba> with = shadowed(scene, options).pixels;
    Scene bare = scene;
    bare.shadow_ground.reset();
    const std::vector<Rgba> without = shadowed(bare, options).pixels;
    int met = 0;
    for (std::size_t i = 0; i < with.size(); ++i) {
      met += without[i].alpha == 1;
      if (without[i].alpha == 1) {
        EXPECT_EQ(with[i], without[i]);
      } else {
        EXPECT_EQ((std::array{with[i].r, with[i].g, with[i].b}), (std::array<float, 3>{}));
      }
    }
    EXPECT_GT(met, 20);
  }
}

// ---- the picture --------------------------------------------------------------------------------

TEST(ShadowGround, OverAColourIsThePictureBeforeThatColour) {
  Scene scene = ball_on_ground();
  const std::array<float, 3> color{0.25F, 0.5F, 1};
  for (const IntegratorName integrator : shading_kinds)
    for (const int samples : {1, 16}) {
      const RenderOptions options = shadows_by(integrator, samples);
      scene.backdrop = Backdrop{};
      const std::vector<Rgba> clear = shadowed(scene, options).pixels;
      scene.backdrop = Backdrop{Color{0.25, 0.5, 1}};
      const std::vector<Rgba> colored = shadowed(scene, options).pixels;
      int between = 0;
      for (std::size_t i = 0; i < clear.size(); ++i) {
        const Rgba &own = clear[i], &over = colored[i];
        EXPECT_EQ(own.alpha, over.alpha);
        between += own.alpha > 0 && own.alpha < 1;
        EXPECT_NEAR(own.r + (1 - own.alpha) * color[0], over.r, 1e-6);
        EXPECT_NEAR(own.g + (1 - own.alpha) * color[1], over.g, 1e-6);
        EXPECT_NEAR(own.b + (1 - own.alpha) * color[2], over.b, 1e-6);
      }
      EXPECT_GT(between, samples == 1 ? -1 : 10);
    }
}

TEST(ShadowGround, IsTheSameInEveryWidthTileAndByRounds) {
  Scene scene = ball_on_ground();
  scene.backdrop = Backdrop{Color{1, 0.5, 0.25}};
  for (const IntegratorName integrator : shading_kinds)
    for (const int samples : {1, 32}) {
      RenderOptions options = shadows_by(integrator, samples);
      const std::vector<Rgba> wide = shadowed(scene, options).pixels;
      options.scalar = Scalar::narrow;
      options.tile = 7;
      options.threads = 3;
      EXPECT_EQ(shadowed(scene, options).pixels, wide);
      options.scalar = Scalar::wide;
      options.budget.emplace();
      if (integrator == IntegratorName::path) {
        EXPECT_EQ(shadowed(scene, options).pixels, wide);
      }
    }
}

// The disc is black: but for its shadow all that is shown is 0 in every sample.
TEST(ShadowGround, IsSampledUntilItsNoiseIsSettled) {
  Scene scene = seen_at(disc_above_ground(1, matt(0)), 0.5);
  scene.lights = {Light{}};
  scene.lights[0].kind = SkyLight{};
  RenderOptions options = shadows_by(IntegratorName::path, 256);
  options.noise = 0.03;
  const Shadowed picture = shadowed(scene, options, 4);
  ASSERT_TRUE(picture.told.reached);
  EXPECT_GT(picture.told.reached->least, 32);
  EXPECT_LT(picture.told.reached->noise, 0.03);
}

TEST(ShadowGround, IsTheSameFarFromTheOrigin) {
  const auto mean = [](const Vec3d& move) {
    Scene scene = ball_on_ground();
    scene.camera.location = scene.camera.location + move;
    scene.shadow_ground->point = scene.shadow_ground->point + move;
    std::get<Sphere>(scene.objects.edit()[0].shape).center = move;
    scene.lights.pop_back();
    return shadowed(scene, shadows_by(IntegratorName::whitted, 4)).mean_alpha();
  };
  EXPECT_NEAR(mean({1 << 24, -(1 << 23), 1 << 22}), mean({}), 1e-3);
}

// ---- as text ------------------------------------------------------------------------------------

TEST(ShadowGroundText, IsReadAndNeedsABackdrop) {
  const std::string json =
      R"({"backdrop":"transparent","shadow_ground":{"normal":[1,0,0],"point":[0,2,0]}})";
  EXPECT_EQ(read_scene(json).shadow_ground, (ShadowGround{{0, 2, 0}, {1, 0, 0}}));
  EXPECT_EQ(canonical_text(read_scene(json)), json);
  const auto fault_of = [](const std::string& text) {
    try {
      read_scene(text);
    } catch (const InputError& error) {
      return error.faults().front().pointer;
    }
    return std::string("none");
  };
  EXPECT_EQ(fault_of(R"({"shadow_ground":{"point":[0,0,0]}})"), "/shadow_ground");
  EXPECT_EQ(fault_of(R"({"backdrop":1,"shadow_ground":{}})"), "/shadow_ground/point");
  EXPECT_EQ(fault_of(R"({"backdrop":1,"shadow_ground":{"point":[0,0,0],"normal":[0,0,0]}})"),
            "/shadow_ground/normal");
}

}  // namespace
}  // namespace tia
