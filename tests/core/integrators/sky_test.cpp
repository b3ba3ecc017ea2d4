// Skies and the sun in the path tracer and in whitted, by closed forms.
#include "core/film/hdr.h"
#include "core/lights/sun.h"
#include "tests/core/integrators/paths.h"

namespace tia {
namespace {

using namespace test;

SkyForm form_of(const Light& light) {
  return std::visit(
      []<class Kind>(const Kind& kind) {
        if constexpr (PaintsSky<Kind>) return sky_of(kind);
        else return SkyForm{};
      },
      light.kind);
}
Image bumpy(Random& random) {
  Image image(16, 8);
  for (float& light : image.rgb)
    light = static_cast<float>(random.chance(0.1) ? random.in(5, 20) : random.in(0, 1));
  return image;
}
// What a white matt surface would send back of what is seen of a sky, without shadows.
double matt_light(const SkyForm& sky, const Vec3d& n, int fine = 256) {
  double sum = 0;
  for (int y = 0; y < fine; ++y)
    for (int x = 0; x < 2 * fine; ++x) {
      const Vec3d wi = sky_direction((x + 0.5) / (2 * fine), 2 * (y + 0.5) / fine - 1);
      const double cosine = dot(wi, n);
      if (cosine > 0) sum += cosine * double{sky.map->radiance(wi, sky.turn).x};
    }
  return sum * 4 / (2.0 * fine * fine);
}
Scene floor_under(const Light& light, const Vec3d& n, double albedo) {
  Scene scene;
  scene.objects = {object(Plane{{0, 0, 0}, n}, matt(albedo))};
  scene.lights = {light};
  return scene;
}
Mean floor_light(const Light& light, const Vec3d& n, double albedo, int samples) {
  const Onb frame = onb_around(n);
  return light_from(floor_under(light, n, albedo), n * 2.0 + frame.u, {0, 0, 0}, samples, 1);
}

TEST(Sky, WhiteImageIsTheWhiteFurnace) {
  Image8 white(4, 2);
  for (auto& code : white.rgb) code = 255;
  Random random(920);
  for (const Finish& finish : {matt(1), glass(1.5)}) {
    Scene scene;
    scene.lights = {image_light(encode_png(white))};
    scene.objects = {object(Sphere{{0, 0, 0}, 1}, finish)};
    const Vec3d aside = random.direction() * 0.9;
    expect_mean(light_from(scene, random.direction() * 5.0, aside, 1024, 64), 1, 1e-4);
  }
}

TEST(Sky, ConstantImageIsAConstantSky) {
  Image image(8, 4);
  for (float& light : image.rgb) light = 0.5F;
  Scene scene;
  scene.objects = {object(Sphere{{0, 0, 0}, 1}, matt(0.6)),
                   object(Sphere{{0.5, 1.5, 0}, 0.8}, matt(0.2))};
  scene.lights = {image_light(encode_hdr(image))};
  const Mean by_image = light_from(scene, {2, 4, 5}, {0, 0.9, 0.3}, 1024, 4);
  scene.lights = {light_of(SkyLight{}, {0.5, 0.5, 0.5})};
  const Mean plain = light_from(scene, {2, 4, 5}, {0, 0.9, 0.3}, 1024, 4);
  expect_equal(by_image, plain, 1e-4);
}

// The hat over one texel fills as much of the sphere as the texel, but for the sine's curve.
TEST(Sky, OneTexelIsADirectionalLightOfItsIrradiance) {
  constexpr int width = 512, height = 256;
  Random random(921);
  for (int i = 0; i < rounds(3, 1); ++i) {
    const int x = random.below(width), y = random.whole(40, 80);
    Image image(width, height);
    std::fill_n(image.at(x, y), 3, 1024.0F);
    const double theta = pi * (y + 0.5) / height, turn = (x + 0.5) / width - 0.5;
    const Vec3d wi = sky_direction(turn, std::cos(theta));
    const double solid_angle = 2 * pi / width * pi / height * std::sin(theta);
    const Vec3d n = normalize(wi + random.direction() * 0.5);
    const double irradiance = 1024 * solid_angle * dot(wi, n);
    const Mean mean = floor_light(image_light(encode_hdr(image)), n, 0.8, 2048);
    expect_mean(mean, 0.8 / pi * irradiance, 2e-3);
    const Light far = light_of(DirectionalLight{wi * -1.0});
    const double as_directional = floor_light(far, n, 0.8, 1).value * 1024 * solid_angle;
    expect_mean(mean, as_directional, 2e-3);
  }
}

// By the directions that the sky draws, by those that the surface draws, and by both.
TEST(Sky, LightsAndSurfacesDirectionsAgree) {
  Random random(922);
  for (int i = 0; i < rounds(4, 1); ++i) {
    const Light light = image_light(encode_hdr(bumpy(random)), random.in(-360, 360));
    const SkyForm sky = form_of(light);
    const Vec3d n = random.direction();
    const double whole = matt_light(sky, n);
    double sum = 0, squares = 0;
    constexpr int count = 1 << 15;
    for (int k = 0; k < count; ++k) {
      const double u = random.unit();
      const auto sample = sky.map->sample(u, random.unit(), sky.turn);
      const double one = std::max(0.0, dot(sample.wi, n)) / pi / sample.pdf *
                         double{sky.map->radiance(sample.wi, sky.turn).x};
      sum += one, squares += one * one;
    }
    const double mean = sum / count, error = std::sqrt((squares / count - mean * mean) / count);
    EXPECT_NEAR(mean, whole, 4 * error) << "by the sky's alone";
    Scene scene = floor_under(light, n, 1);
    expect_mean(floor_light(light, n, 1, 1024), whole, 1e-3);
    // By the surface's alone: a pane of clear glass hides the sky from questions, and what is drawn
    // passes.
    scene.objects.push_back(object(Sphere{{0, 0, 0}, 0.5}, clear_glass(1)));
    const Mean drawn = light_from(scene, n * 0.3, {0, 0, 0}, 1024, 3);
    expect_mean(drawn, whole, 1e-3);
  }
}

TEST(Sky, SunLightsAPlaneByTheSineOfItsElevation) {
  Random random(923);
  for (int i = 0; i < rounds(4, 1); ++i) {
    SunLight sun;
    sun.elevation_degrees = random.in(5, 90);
    sun.azimuth_degrees = random.in(-180, 180);
    sun.turbidity = random.in(1, 4);
    const double direct = tint(sun).x * std::sin(*sun.elevation_degrees * pi / 180);
    const double dome = matt_light(sky_of(sun), {0, 1, 0});
    EXPECT_GT(direct, dome * 0.1);
    expect_mean(floor_light(light_of(sun), {0, 1, 0}, 0.7, 1024), 0.7 * (direct + dome), 5e-4);
  }
}

TEST(Sky, SunsDiscIsSeenAndHasItsIrradiance) {
  SunLight sun;
  sun.elevation_degrees = 30;
  sun.azimuth_degrees = 90;
  Scene scene;
  scene.lights = {light_of(sun)};
  const auto seen = [&](double elevation) {
    const double e = elevation * pi / 180;
    return light_from(scene, {0, 0, 0}, {std::cos(e), std::sin(e), 0}, 1, 1, 2).value;
  };
  const double sine = std::sin(0.2665 * pi / 180), dome = seen(30.3);
  EXPECT_LT(dome, 10);
  for (const double elevation : {29.75, 30.0, 30.25})
    EXPECT_NEAR(seen(elevation), tint(sun).x / (sine * sine) + dome,
                0.02 * tint(sun).x / (sine * sine));
  EXPECT_NEAR(seen(29.7), dome, 0.05 * dome);
}

TEST(Sky, WhittedSeesTheDomeAndIsLitByTheSunsMiddle) {
  SunLight sun;
  sun.elevation_degrees = 40;
  Scene scene = floor_under(light_of(sun), {0, 1, 0}, 1);
  const Vec3f floor = tree(scene, {0, 2, 0}, {0, -1, 0})->color;
  EXPECT_NEAR(double{floor.x}, tint(sun).x * std::sin(40 * pi / 180), 1e-5);
  const Vec3d up = normalize(Vec3d{0.3, 1, 0.2});
  const SkyForm sky = sky_of(sun);
  expect_near(tree(scene, {0, 2, 0}, up)->color,
              static_cast<Vec3d>(sky.map->radiance(up, sky.turn)), 1e-5);
  sun.elevation_degrees = -1;
  scene.lights = {light_of(sun)};
  EXPECT_EQ(tree(scene, {0, 2, 0}, {0, -1, 0})->color.x, 0.0F);
}

TEST(Sky, WideLanesEqualNarrowOnes) {
  Random random(924);
  Scene scene = floor_under(light_of(SunLight{}), {0, 1, 0}, 0.5);
  scene.objects.push_back(object(Sphere{{0, 1, 0}, 1}, glass(1.5)));
  scene.lights.push_back(image_light(encode_hdr(bumpy(random))));
  scene.camera.location = {0, 2, 6};
  scene.camera.look_at = Vec3d{0, 1, 0};
  for (const auto name : {IntegratorName::path, IntegratorName::whitted}) {
    RenderOptions options;
    options.integrator = name;
    options.samples = 4;
    const auto wide = bits_of(picture(scene, 37, 21, options).image);
    options.scalar = Scalar::narrow;
    options.threads = 2;
    EXPECT_EQ(bits_of(picture(scene, 37, 21, options).image), wide);
  }
}

}  // namespace
}  // namespace tia
