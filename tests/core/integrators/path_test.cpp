// The path tracer, by closed forms.
#include "tests/core/integrators/paths.h"

namespace tia {
namespace {

using namespace test;

// In the direction of the mirror: D = 1 / (pi alpha^2), f = s D G / (4 cos^2), with the facets that
// light and eye both see G = 1 / sqrt(1 + alpha^2 tan^2), and E = I cos / d^2.
TEST(Path, HighlightIsGgxsPeak) {
  Random random(835);
  for (int i = 0; i < 10; ++i) {
    const double roughness = random.in(0.01, 0.5), s = random.in(0.1, 0.9);
    const double slant = random.in(0.1, 1.2), alpha_2 = 2 / (1 / roughness + 2);
    const Vec3d up{0, 0, 1}, wo{std::sin(slant), 0, std::cos(slant)}, wi{-wo.x, 0, wo.z};
    Finish finish = matt(0);
    finish.specular = s, finish.roughness = roughness;
    Scene scene;
    scene.objects = {object(Plane{{0, 0, 0}, up}, finish)};
    scene.lights = {point_light(wi * 2.0)};
    const double tangent = std::tan(slant);
    const double expected = s / (pi * alpha_2) / std::sqrt(1 + alpha_2 * tangent * tangent) /
                            (4 * wo.z * wo.z) * wo.z / 4;
    EXPECT_NEAR(light_from(scene, wo * 3.0, {0, 0, 0}, 4, 1, 2).value, expected, 2e-3 * expected);
  }
}

// Grain is lines of the surface: behind it eye and light see what they would before it at the
// points that mirror them.
TEST(Path, GrainIsTheSameLinesFromBothSides) {
  Random random(838);
  Principled brushed;
  brushed.metallic = 1, brushed.roughness = 0.4, brushed.anisotropy = 0.7;
  double apart = 0;
  for (int i = 0; i < 10; ++i) {
    const Onb frame = onb_around(random.direction());
    brushed.anisotropy_rotation = random.in(0.2, 1.3);
    Scene scene;
    scene.objects = {object(Disc{{0, 0, 0}, frame.n, 5}, {})};
    scene.objects[0].material = MaterialRef(Material{brushed});
    const Vec3d aside = frame.u * random.in(-3, 3), across = frame.v * random.in(-3, 3);
    const auto seen = [&](double side, double turn) {
      scene.lights = {point_light(aside + across * turn + frame.n * side)};
      return light_from(scene, frame.n * (side * 2) - frame.u, {0, 0, 0}, 1, 1, 1).value;
    };
    EXPECT_NEAR(seen(1, 1), seen(-1, 1), 1e-4 * seen(1, 1));
    apart += std::fabs(seen(1, 1) - seen(1, -1));
  }
  EXPECT_GT(apart, 0.1) << "the grain is turned";
}

// However far the eye is: rays start the farther off a surface, but not beside the light. A disc
// overhead gives E = pi L r^2 / (r^2 + h^2).
TEST(Path, LuminousBodiesDoNotHideThemselvesFromFarEyes) {
  Finish glow = matt(0);
  glow.emission = {1, 1, 1};
  Disc disc;
  disc.center = {0, 0, 1}, disc.normal = {0, 0, -1}, disc.radius = 1;
  for (const double far : {0.5, 4.0, 30.0}) {
    Scene scene;
    scene.objects = {object(Plane{{0, 0, 0}, {0, 0, 1}}, matt(0.5)), object(disc, glow)};
    const Vec3d eye = normalize(Vec3d{1, 0, 0.3}) * far;
    expect_mean(light_from(scene, eye, {0, 0, 0}, 512, 1), 0.25, 1e-3);
  }
}

// Where nothing is chance: matt surfaces under a light from one direction or one point, once.
// Whitted's has no 1 / pi and, where the light does not fade, no inverse square; with a very short
// fade distance f its 2 / (1 + (d / f)^2) is 2 f^2 / d^2.
TEST(Path, AgreesWithWhittedUnderOneLight) {
  Random random(836);
  Scene scene;
  scene.objects = {object(Plane{{0, -2, 0}, {0, 1, 0}}, matt(0.5))};
  for (int i = 0; i < 12; ++i)
    scene.objects.push_back(
        object(Sphere{random.point(2), random.in(0.2, 0.6)}, matt(random.in(0.2, 1))));
  scene.camera.location = {0, 0, 8};
  scene.camera.direction = {0, 0, -1};
  const auto drawn = [&](IntegratorName integrator, const Light& light, double intensity) {
    scene.lights = {light};
    scene.lights[0].intensity = intensity;
    RenderOptions options;
    options.integrator = integrator;
    options.max_depth = 1;
    return picture(scene, 96, 72, options).image;
  };
  const auto expect_alike = [](const Image& path, const Image& whitted) {
    double lit = 0;
    for (std::size_t i = 0; i < path.rgb.size(); ++i) {
      lit += static_cast<double>(whitted.rgb[i]);
      ASSERT_NEAR(path.rgb[i] * pi, whitted.rgb[i], 1e-5 + 1e-5 * double{whitted.rgb[i]}) << i;
    }
    EXPECT_GT(lit, 500);
  };
  const Light sun = light_of(DirectionalLight{Vec3d{0.4, -1, -0.3}});
  expect_alike(drawn(IntegratorName::path, sun, 2), drawn(IntegratorName::whitted, sun, 2));
  for (int i = 0; i < 4; ++i) {
    const Light lamp = point_light({random.in(-3, 3), random.in(2, 4), random.in(2, 6)});
    Light fading = lamp;
    fading.fade_distance = 1e-3, fading.fade_power = 2;
    expect_alike(drawn(IntegratorName::path, lamp, 20),
                 drawn(IntegratorName::whitted, fading, 20 / 2e-6));
  }
}

// E = I cos / d^2, and what leaves is albedo / pi of it.
TEST(Path, PointLightFollowsTheInverseSquare) {
  Random random(822);
  for (int i = 0; i < 10; ++i) {
    const Onb frame = onb_around(random.direction());
    const Vec3d p = random.point(3);
    const double albedo = random.in(0.1, 1), intensity = random.in(1, 50);
    const Vec3d light = p + frame.n * random.in(0.5, 4) + frame.u * random.in(-2, 2);
    Scene scene;
    scene.objects = {object(Plane{p, frame.n}, matt(albedo))};
    scene.lights = {point_light(light)};
    scene.lights[0].intensity = intensity;
    const Vec3d to = light - p;
    const double irradiance = intensity * dot(normalize(to), frame.n) / dot(to, to);
    const Mean mean = light_from(scene, p + frame.n * 2.0 + frame.v, p, 4, 1, 2);
    EXPECT_NEAR(mean.value, albedo / pi * irradiance, 1e-4 * irradiance);
  }
}

// Source: the law of Beer and Lambert; between equal indices nothing bends.
TEST(Path, WhatIsInsideAbsorbsAlongTheChord) {
  Scene scene;
  scene.background = {1, 1, 1};
  Finish tinted = clear_glass(1);
  tinted.absorption = {0.3, 0.3, 0.3};
  scene.objects = {object(Sphere{{0, 0, 0}, 1}, tinted)};
  for (const double aside : {0.0, 0.5, 0.9}) {
    const double chord = 2 * std::sqrt(1 - aside * aside);
    const Mean mean = light_from(scene, {aside, 0, 5}, {aside, 0, 0}, 4, 16, 2);
    EXPECT_NEAR(mean.value, std::exp(-0.3 * chord), 2e-5);
  }
}

// The light that a surface inside asks for, as well as what comes back from it.
TEST(Path, WhatIsInsideAbsorbsOnTheWayFromTheLightToo) {
  Scene scene;
  Finish tinted = clear_glass(1);
  tinted.absorption = {0.5, 0.5, 0.5};
  scene.objects = {object(Sphere{{0, 0, 0}, 3}, tinted),
                   object(Box{{-1, -1, -1}, {1, 1, 0}}, matt(0.8))};
  scene.lights = {point_light({0, 0, 2}, {10, 10, 10})};
  const double expected = 10.0 / 4 * 0.8 / pi * std::exp(-0.5 * 3) * std::exp(-0.5 * 2);
  EXPECT_NEAR(light_from(scene, {0, 0, 5}, {0, 0, 0}, 4, 2, 2).value, expected, 1e-4 * expected);
  // Of a ball of radius 0.3 all at about the same distance, whoever finds it.
  scene.lights = {sphere_light({0, 0, 2}, 0.3, {10, 10, 10})};
  Scene found = scene;
  found.lights.clear();
  Finish glow = dark();
  glow.emission = {10, 10, 10};
  found.objects.push_back(object(Sphere{{0, 0, 2}, 0.3}, glow));
  const Vec3d eye{0, 2, 5};
  const Mean asked = light_from(scene, eye, {0, 0, 0}, 1024, 2),
             drawn = light_from(found, eye, {0, 0, 0}, 8192, 2);
  EXPECT_NEAR(asked.value, drawn.value, 4 * std::hypot(asked.error, drawn.error));
  if (!sanitized()) {
    EXPECT_LT(drawn.error, 0.01 * drawn.value);
  }
}

// But for what surfaces draw, which meets the ceiling: of two at one distance the first of the
// scene.
TEST(Path, LampInTheCeilingIsNotHiddenByIt) {
  Scene scene;
  scene.objects = {object(Plane{{0, 0, 0}, {0, 1, 0}}, matt(0.5)),
                   object(Box{{-9, 2, -9}, {9, 3, 9}}, dark())};
  Light lamp;
  const Vec3d corner{-0.5, 2, -0.5}, u{1, 0, 0}, v{0, 0, 1};
  lamp.kind = QuadLight{corner, u, v};
  scene.lights = {lamp};
  const double irradiance =
      polygon_irradiance({corner, corner + u, corner + u + v, corner + v}, {0, 1, 0});
  const double expected = 0.5 / pi * irradiance;
  EXPECT_NEAR(light_from(scene, {0, 1, 3}, {0, 0, 0}, 256, 1).value, expected, 0.01 * expected);
}

TEST(Path, LightNearlyInfiniteIsNoneLess) {
  Scene scene;
  scene.objects = {object(Plane{{0, 0, 0}, {0, 1, 0}}, matt(0.5))};
  scene.lights = {point_light({0, 2e-5, 0}, {1e6, 1e6, 1e6})};
  scene.lights[0].intensity = 1e6;
  const double expected = 0.5 / pi * 1e12 / 4e-10;
  EXPECT_NEAR(light_from(scene, {0, 1e-5, 0}, {0, 0, 0}, 1, 1, 2).value, expected, 1e-4 * expected);
}

TEST(Path, CountsRaysByWhatSentThem) {
  Scene scene;
  scene.background = {1, 1, 1};
  scene.objects = {object(Sphere{{0, 0, 0}, 1}, clear_glass(1.5))};
  scene.camera.location = {0, 0, 5};
  scene.camera.look_at = Vec3d{0, 0, 0};
  scene.camera.fov_degrees = 1;
  RenderOptions options;
  options.integrator = IntegratorName::path;
  options.samples = 4;
  const RayCounts rays = picture(scene, 8, 8, options).rays;
  EXPECT_EQ(rays, (RayCounts{256, 0, 0, 512}));
}

// All kinds of lights and finishes in one room.
Scene room() {
  Scene scene;
  scene.background = {0.2, 0.3, 0.4};
  scene.camera.location = {0, 1, 6};
  scene.camera.look_at = Vec3d{0, 0, 0};
  Finish glow = matt(0.5);
  glow.emission = {2, 1, 0.5};
  Finish mirror = matt(0.2);
  mirror.reflection = 0.7;
  scene.objects = {
      object(Plane{{0, -1, 0}, {0, 1, 0}}, matt(0.7)), object(Sphere{{-1.2, 0, 0}, 1}, glass(1.5)),
      object(Sphere{{1.2, 0, 0}, 1}, mirror), object(Sphere{{0, -0.7, 1.5}, 0.3}, glow)};
  Light quad;
  quad.kind = QuadLight{Vec3d{-1, 3, -1}, {2, 0, 0}, {0, 0, 2}};
  scene.lights = {point_light({3, 3, 3}), sphere_light({-3, 2, 1}, 0.5), quad};
  return scene;
}

TEST(Path, NeitherThreadsNorTilesNorLanesChangeAByte) {
  RenderOptions options;
  options.integrator = IntegratorName::path;
  options.max_depth = 16;
  options.samples = rounds(40);
  const auto usual = bits_of(picture(room(), 37, 29, options).image);
  for (const int threads : {2, 7}) {
    options.threads = threads;
    options.tile = 5 + threads;
    EXPECT_EQ(bits_of(picture(room(), 37, 29, options).image), usual);
  }
  options.scalar = Scalar::narrow;
  EXPECT_EQ(bits_of(picture(room(), 37, 29, options).image), usual);
}

}  // namespace
}  // namespace tia
