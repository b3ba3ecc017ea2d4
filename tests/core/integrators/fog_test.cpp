// Fog, by closed forms and by integrals along the ray that the tests sum up themselves.
#include "tests/core/integrators/paths.h"
#include "tests/core/integrators/quadrature.h"

namespace tia {
namespace {

using namespace test;

double phase_of(double g, double cosine) {
  return (1 - g * g) / (4 * pi * std::pow(1 + g * g - 2 * g * cosine, 1.5));
}
Fog fog_of(double density, double albedo, double g = 0) {
  return {density, {albedo, albedo, albedo}, g, {}};
}
Fog in_box(Fog fog, const Vec3d& min, const Vec3d& max) {
  fog.bounds = Bounds{min, max, {}, {}};
  return fog;
}
// Bouguer's law, which needs no chance where nothing is scattered: of a lamp seen, and of a wall
// that a point light lights.
TEST(Fog, LetsLightThroughByItsLength) {
  Random random(912);
  for (int round = 0; round < 8; ++round) {
    const double density = random.in(0.05, 0.5), distance = random.in(1, 9);
    Scene scene;
    scene.fog = fog_of(density, 0);
    scene.objects = {object(Sphere{{0, 0, -distance - 1}, 1}, glowing(2))};
    Mean mean = light_from(scene, {0, 0, 0}, {0, 0, -1}, 16, 0, 2);
    EXPECT_NEAR(mean.value, 2 * std::exp(-density * distance), 1e-5);
    scene.fog = in_box(*scene.fog, {-1, -1, -0.75 * distance}, {1, 1, -0.25 * distance});
    mean = light_from(scene, {0, 0, 0}, {0, 0, -1}, 16, 4, 2);
    EXPECT_NEAR(mean.value, 2 * std::exp(-density * distance / 2), 1e-5);
    scene.fog->bounds = Bounds{{}, {}, Vec3d{0, 0, -distance / 2}, distance / 8};
    mean = light_from(scene, {0, 0, 0}, {0, 0, -1}, 16, 4, 2);
    EXPECT_NEAR(mean.value, 2 * std::exp(-density * distance / 4), 1e-5);
    // Of light that nothing gives back and that comes from beyond infinite fog nothing is seen.
    scene.fog = fog_of(density, 0);
    scene.objects.clear();
    scene.background = {1, 1, 1};
    EXPECT_EQ(light_from(scene, {0, 0, 0}, {0, 0, -1}, 16, 4, 2).value, 0);
    const double height = random.in(0.5, 3), aside = random.in(0.5, 3);
    scene.objects = {object(Plane{{0, 0, 0}, {0, 1, 0}}, matt(1))};
    scene.lights = {point_light({0, height, 0}, {5, 5, 5})};
    mean = light_from(scene, {aside, distance, 0}, {aside, 0, 0}, 16, 1, 2);
    const double square = height * height + aside * aside, way = std::sqrt(square);
    EXPECT_NEAR(mean.value,
                5 / pi * height / (square * way) * std::exp(-density * (way + distance)), 1e-5);
  }
}

// Glass keeps it out.
TEST(Fog, IsNotWithinBodies) {
  Scene scene;
  scene.fog = fog_of(0.3, 0);
  scene.objects = {object(Sphere{{0, 0, -5}, 2}, clear_glass(1)),
                   object(Sphere{{0, 0, -11}, 1}, glowing(1))};
  const Mean mean = light_from(scene, {0, 0, 0}, {0, 0, -1}, 16, 8, 2);
  EXPECT_NEAR(mean.value, std::exp(-0.3 * 6), 1e-5);
}

// Light that is scattered once: along the ray, by the angle at which the light sees it, so that the
// inverse square falls out of the integral. `strength`: that of a direction from the lamp.
double evenly(const Vec3d&) { return 1; }
template <class F = decltype(evenly)>
double scattered_once(const Fog& fog, double intensity, const Vec3d& lamp, const Vec3d& eye,
                      const Vec3d& w, double near, double far, F strength = evenly,
                      int halves = 2000) {
  const double foot = dot(lamp - eye, w), away = length(eye + w * foot - lamp);
  const auto at = [&](double angle) {
    const double t = foot + away * std::tan(angle), r = away / std::cos(angle);
    const Vec3d to_lamp = (lamp - (eye + w * t)) * (1 / r);
    return std::exp(-fog.density * ((t - near) + r)) * phase_of(fog.g, dot(w, to_lamp)) *
           strength(-to_lamp);
  };
  const double end = far < infinity ? std::atan2(far - foot, away) : pi / 2 - 1e-9;
  return fog.density * rgb_of(fog.albedo).x * intensity / away *
         simpson(std::atan2(near - foot, away), end, halves, at);
}
TEST(Fog, ScattersAPointLightsLightOnce) {
  Random random(913);
  for (int round = 0; round < 6; ++round) {
    const Fog fog = fog_of(std::pow(10, random.in(-2, 0)), random.in(0.3, 1), random.in(-0.7, 0.7));
    Scene scene;
    scene.fog = fog;
    const Vec3d eye = random.point(1), lamp = random.point(4);
    Vec3d w = normalize(lamp - eye + random.direction() * (round % 2 == 0 ? 0.4 : 3.0));
    scene.lights = {point_light(lamp, {10, 10, 10})};
    expect_mean(light_from(scene, eye, eye + w, 1024, 1, 1),
                scattered_once(fog, 10, lamp, eye, w, 0, infinity), 1e-4);
    // Up to a wall that sends nothing back.
    const double far = random.in(1, 6);
    scene.objects = {object(Plane{eye + w * far, -w}, matt(0))};
    if (dot(lamp - eye, w) < far - 0.1)
      expect_mean(light_from(scene, eye, eye + w, 1024, 1, 1),
                  scattered_once(fog, 10, lamp, eye, w, 0, far), 1e-4);
  }
}

// A spot's cone, narrow or wider than half of space.
SpotLight random_spot(Random& random, const Vec3d& lamp, const Vec3d& seen, bool wide) {
  SpotLight spot;
  spot.position = lamp, spot.point_at = seen;
  spot.falloff_degrees = wide ? random.in(95, 150) : std::pow(10, random.in(0.3, 1.6));
  spot.radius_degrees = random.in(0.2, 0.9) * spot.falloff_degrees;
  return spot;
}
double strength_of_spot(const SpotLight& spot, const Vec3d& wi) {
  const double cosine = dot(normalize(spot.point_at - *spot.position), wi);
  const double inner = std::cos(spot.radius_degrees * pi / 180),
               outer = std::cos(spot.falloff_degrees * pi / 180);
  const double x = std::clamp((cosine - outer) / (inner - outer), 0.0, 1.0);
  return x * x * (3 - 2 * x);
}
TEST(Fog, ScattersASpotsLightOnce) {
  Random random(916);
  for (int round = 0; round < 6; ++round) {
    const Fog fog = fog_of(std::pow(10, random.in(-2, 0)), random.in(0.3, 1), random.in(-0.7, 0.7));
    Scene scene;
    scene.fog = fog;
    const Vec3d eye = random.point(1), w = random.direction();
    const Vec3d seen = eye + w * random.in(1, 3);
    const Vec3d lamp = seen + cross(w, random.direction()) * random.in(1, 3);
    const SpotLight spot = random_spot(random, lamp, seen, round % 3 == 2);
    Light light = light_of(spot);
    light.intensity = 10;
    scene.lights = {light};
    const double expected = scattered_once(
        fog, 10, lamp, eye, w, 0, infinity,
        [&](const Vec3d& wi) { return strength_of_spot(spot, wi); }, 40000);
    expect_mean(light_from(scene, eye, eye + w, 1024, 1, 1), expected, 1e-4);
    // A pixel that has just enough samples has met the beam, however narrow.
    RenderOptions options = by_paths(4096, 1);
    options.noise = 0.004;
    options.tone = {Transfer::linear, std::log2(0.3 / expected)};
    expect_mean(colors_from(scene, eye, eye + w, options, 4)[0], expected, 1e-4);
  }
}

// Of all lights the sum, whichever is asked for.
TEST(Fog, ScattersTheLightOfMany) {
  Random random(914);
  const Fog fog = fog_of(0.2, 0.9, 0.3);
  Scene scene;
  scene.fog = fog;
  const Vec3d eye{0, 0, 0}, w{0, 0, -1};
  double sum = 0;
  for (int i = 0; i < 12; ++i) {
    const Vec3d lamp = Vec3d{0, 0, -4} + random.point(3);
    const double intensity = random.in(1, 9);
    scene.lights.push_back(point_light(lamp, {intensity, intensity, intensity}));
    sum += scattered_once(fog, intensity, lamp, eye, w, 0, infinity);
  }
  expect_mean(light_from(scene, eye, w, 1024, 1), sum, 1e-4);
}

// A luminous ball is found by asking and by scattering; together they count it once. Seen from a
// point, it fills a cone; along each of its directions light comes from where that meets it.
TEST(Fog, ScattersABallsLightOnce) {
  for (const double g : {0.6}) {
    const Fog fog = fog_of(0.25, 0.8, g);
    Scene scene;
    scene.fog = fog;
    const Vec3d middle{0.6, 0, -2};
    scene.objects = {object(Sphere{middle, 0.5}, glowing(3))};
    const auto come = [&](const Vec3d& p) {
      const Vec3d way = middle - p;
      const double d = length(way), cos_most = std::sqrt(1 - 0.25 / (d * d));
      const Onb frame = onb_around(way * (1 / d));
      return simpson(cos_most, 1, 12, [&](double c) {
        const double s = std::sqrt(std::max(0.0, 1 - c * c));
        const double r = d * c - std::sqrt(std::max(0.0, 0.25 - d * d * s * s));
        const double around = simpson(0, 2 * pi, 12, [&](double phi) {
          const Vec3d wi =
              frame.u * (s * std::cos(phi)) + frame.v * (s * std::sin(phi)) + frame.n * c;
          return phase_of(g, -wi.z);
        });
        return 3 * std::exp(-fog.density * r) * around;
      });
    };
    const double expected = simpson(0, 60, 1500, [&](double t) {
      return fog.density * 0.8 * std::exp(-fog.density * t) * come({0, 0, -t});
    });
    expect_mean(light_from(scene, {0, 0, 0}, {0, 0, -1}, 4096, 1), expected, 1e-3);
  }
}

// What is infinitely far lights fog that ends.
TEST(Fog, OfABoxScattersParallelLight) {
  const Fog fog = in_box(fog_of(0.4, 0.7), {-1, -1, -3}, {1, 1, -1});
  Scene scene;
  scene.fog = fog;
  Light sun;
  sun.kind = DirectionalLight{.direction = Vec3d{0, -1, 0}};
  sun.intensity = 2;
  scene.lights = {sun};
  // Light comes down through 1 - y of it, at y = 0; the eye looks through t of it.
  const double expected = 2 * 0.7 / (4 * pi) * std::exp(-0.4) * (1 - std::exp(-0.4 * 2));
  expect_mean(light_from(scene, {0, 0, 0}, {0, 0, -1}, 256, 1), expected, 1e-4);
}

// Where all is equally bright, white fog cannot be seen, whatever way it scatters.
TEST(Fog, WhiteInAWhiteSkyCannotBeSeen) {
  // Paths that end by chance count much where few are left: as many where sanitizers watch.
  const int times = sanitized() ? 4 : 1;
  for (const double g : {-0.5, 0.0, 0.9}) {
    Scene scene;
    scene.fog = in_box(fog_of(0.4, 1, g), {-1, -1, -1}, {1, 1, 1});
    scene.background = {1, 1, 1};
    expect_mean(light_from(scene, {0, 0.3, 4}, {0.1, 0, 0}, times * 256, 64), 1, 1e-4);
    scene.background = {};
    scene.fog = fog_of(0.2, 1, g);
    scene.objects = {object(Sphere{{0, 0, 0}, 1}, glowing(0.8, 0.2))};
    expect_mean(light_from(scene, {0.5, 0.2, 0.1}, {2, 1, 0}, times * 512, 64), 1, 2e-4);
  }
}

TEST(Fog, NeitherThreadsNorTilesNorLanesChangeAByte) {
  Scene scene;
  scene.fog = in_box(fog_of(0.3, 0.9, 0.4), {-9, -9, -9}, {9, 9, 9});
  scene.background = {0.1, 0.2, 0.3};
  scene.objects = {object(Sphere{{0, 0, -5}, 1}, matt(0.7)),
                   object(Sphere{{2, 1, -4}, 0.3}, glowing(4)),
                   object(Sphere{{-2, 0, -5}, 1}, glass(1.5))};
  scene.lights = {point_light({0, 3, -3}, {9, 9, 9})};
  scene.camera.fov_degrees = 60;
  RenderOptions options;
  options.integrator = IntegratorName::path;
  options.samples = 4;
  const auto usual = bits_of(picture(scene, 37, 29, options).image);
  options.threads = 7, options.tile = 8;
  EXPECT_EQ(bits_of(picture(scene, 37, 29, options).image), usual);
  options.scalar = Scalar::narrow;
  EXPECT_EQ(bits_of(picture(scene, 37, 29, options).image), usual);
}

}  // namespace
}  // namespace tia
