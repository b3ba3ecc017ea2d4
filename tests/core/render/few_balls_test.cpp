// The thesis' pictures of few balls are traced in a way of their own: to the byte as any other
// picture is.
#include <gtest/gtest.h>

#include <numeric>

#include "core/render/trace_tile.h"
#include "tests/core/accel/worlds.h"

namespace tia {
namespace {

using namespace test;

// The picture of a world as it is, or with its way for few balls closed.
Picture traced(World world, const Scene& scene, bool fast, const RenderOptions& options) {
  world.few_balls = world.few_balls && fast;
  constexpr int width = 75, height = 51;
  Pool pool(1);
  LinearFilm film(width, height);
  const RayCounts rays = render(world, view_of(scene.camera, width, height), {0, 0, width, height},
                                options, pool, {}, [&](const FilmTile& tile) { film.put(tile); })
                             .rays;
  return {film.image(), rays};
}

RenderOptions as_thesis() {
  RenderOptions options;
  options.integrator = IntegratorName::thesis;
  return options;
}

// The first of so many, or a tenth of them under a sanitizer.
std::vector<std::uint64_t> seeds(std::uint64_t first, int count) {
  std::vector<std::uint64_t> all(static_cast<std::size_t>(rounds(count, 10)));
  std::iota(all.begin(), all.end(), first);
  return all;
}

void expect_same_bytes(const Scene& scene, const RenderOptions& options) {
  const World world = compile(scene);
  ASSERT_TRUE(world.few_balls);
  for (const Scalar scalar : {Scalar::wide, Scalar::narrow, Scalar::exact}) {
    RenderOptions own = options;
    own.scalar = scalar;
    const Picture fast = traced(world, scene, true, own), slow = traced(world, scene, false, own);
    EXPECT_EQ(fast.rays, slow.rays);
    EXPECT_TRUE(bits_of(fast.image) == bits_of(slow.image));
  }
}

TEST(FewBalls, PicturesAreTheSameBytesWithoutTheFastWay) {
  for (const std::uint64_t seed : seeds(0, 60)) {
    SCOPED_TRACE(seed);
    expect_same_bytes(random_scene(seed), as_thesis());
  }
  for (const char key : {'\0', 'a', 'd', 's', 'w'})
    expect_same_bytes(thesis_scene(key), as_thesis());
}

TEST(FewBalls, SoAreThoseOfManySamplesAndOfALens) {
  for (const std::uint64_t seed : seeds(100, 10)) {
    SCOPED_TRACE(seed);
    Scene scene = random_scene(seed);
    RenderOptions options = as_thesis();
    options.samples = 3;
    options.seed = static_cast<std::int64_t>(seed);
    if (seed % 2 == 0) options.threshold = 0.02;
    expect_same_bytes(scene, options);
    scene.camera = Camera{};
    scene.camera.aperture = 0.5;
    scene.camera.focus_distance = 20;
    expect_same_bytes(scene, options);
  }
}

TEST(FewBalls, SoAreThoseOfWhitted) {
  for (const std::uint64_t seed : seeds(500, 20)) {
    SCOPED_TRACE(seed);
    RenderOptions options = as_thesis();
    options.integrator = IntegratorName::whitted;
    expect_same_bytes(random_scene(seed), options);
  }
}

Finish& finish_of(Object& object) {
  return std::get<Finish>(std::get<Boxed<Material>>(*object.material)->kind);
}

// What does more than scatter light is not plain.
TEST(FewBalls, OfOtherFinishesAreTracedAsTheRest) {
  const Scene plain = random_scene(200);
  ASSERT_TRUE(compile(plain).few_balls);
  const std::vector<void (*)(Finish&)> more = {
      [](Finish& f) { f.ambient = 0.1; },      [](Finish& f) { f.brilliance = 2; },
      [](Finish& f) { f.specular = 0.1; },     [](Finish& f) { f.reflection = 0.1; },
      [](Finish& f) { f.transmission = 0.1; }, [](Finish& f) { f.texture = Texture{Checker{}}; }};
  for (const auto change : more) {
    Scene scene = plain;
    change(finish_of(scene.objects.front()));
    EXPECT_FALSE(compile(scene).few_balls);
  }
}

// The thesis is the preset of whitted without depth, with one point a light.
TEST(FewBalls, TheThesisIsWhittedWithItsSettingsFixed) {
  for (const std::uint64_t seed : seeds(200, 30)) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Scene scene = random_scene(seed);
    for (Object& each : scene.objects.edit()) {
      Finish& finish = finish_of(each);
      finish.ambient = random.unit();
      finish.brilliance = random.in(0, 9);
      finish.specular = random.unit();
      finish.reflection = random.unit();
      finish.transmission = random.chance(0.5) ? random.unit() : 0;
    }
    RenderOptions whitted = as_thesis();
    whitted.integrator = IntegratorName::whitted;
    whitted.max_depth = 0;
    const Image expected = traced(compile(scene), scene, true, whitted).image;
    for (Light& light : scene.lights)
      if (auto* ball = std::get_if<SphereLight>(&light.kind)) ball->samples = 1 + random.below(20);
    RenderOptions thesis = as_thesis();
    thesis.max_depth = 7;
    EXPECT_TRUE(bits_of(traced(compile(scene), scene, true, thesis).image) == bits_of(expected));
  }
}

// Inside of balls, at their surfaces, and at the lights.
TEST(FewBalls, SoAreThoseFromPlacesThatAreHardToTell) {
  for (const std::uint64_t seed : seeds(300, 30)) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Scene scene = random_scene(seed);
    const Sphere& in = std::get<Sphere>(scene.objects.front().shape);
    scene.camera.location =
        in.center + random.direction() * (in.radius * (seed % 2 == 0 ? 1 : random.unit()));
    scene.camera.look_at.reset();
    if (!scene.camera.right) scene.camera.direction = random.direction();
    if (!scene.lights.empty())
      scene.lights.front().move_to(in.center + random.direction() * in.radius, {});
    expect_same_bytes(scene, as_thesis());
  }
}

// Transparent shadows are the slides': the thesis' settings are fixed.
TEST(FewBalls, TheThesisHasNoTransparentShadows) {
  for (const std::uint64_t seed : seeds(400, 20)) {
    SCOPED_TRACE(seed);
    Random random(seed);
    Scene scene = random_scene(seed);
    for (Object& each : scene.objects.edit()) finish_of(each).transmission = random.unit();
    const World opaque = compile(scene);
    scene.options.transparent_shadows = true;
    EXPECT_TRUE(bits_of(traced(compile(scene), scene, false, as_thesis()).image) ==
                bits_of(traced(opaque, scene, false, as_thesis()).image));
  }
}

// A picture of it and what explains its pixels go different ways.
TEST(FewBalls, ExplainedPixelsHaveThePicturesColour) {
  for (const std::uint64_t seed : seeds(200, 20)) {
    Random random(seed);
    const Scene scene = random_scene(seed);
    const Image image = traced(compile(scene), scene, true, as_thesis()).image;
    const View view = view_of(scene.camera, image.width, image.height);
    for (int i = 0; i < 100; ++i) {
      const int x = random.below(image.width), y = random.below(image.height);
      const float* pixel = image.at(x, y);
      EXPECT_EQ(explain(scene, compile(scene), view, x, y, 0, as_thesis()).tree->color,
                (Vec3f{pixel[0], pixel[1], pixel[2]}))
          << seed << ": " << x << " " << y;
    }
  }
}

// By so many lights a ray takes so long that its work is counted.
TEST(FewBalls, UnderManyLightsAreTracedAsTheRest) {
  Scene scene;
  scene.objects.push_back(ball({0, 0, 0}, 1, matte({1, 1, 1})));
  for (int i = 0; i < 64; ++i) scene.lights.push_back(test::point_light({1.0 * i, 9, 0}));
  EXPECT_TRUE(compile(scene).few_balls);
  scene.lights.push_back(test::point_light({0, 9, 9}));
  EXPECT_FALSE(compile(scene).few_balls);
}

}  // namespace
}  // namespace tia
