// The path tracer, by closed forms.
#include "tests/core/integrators/paths.h"

namespace tia {
namespace {

using namespace test;

// In a closed ball every path goes on: the light is that of the first, second, ... wall, each the
// albedo darker.
TEST(Path, FurnaceCutAfterSomeEventsIsThePartialSum) {
  Random random(820);
  for (int depth = 0; depth < 5; ++depth) {
    const double albedo = random.in(0.2, 0.9), emitted = random.in(0.5, 2);
    Scene scene;
    Finish wall = matt(albedo);
    wall.emission = {emitted, emitted, emitted};
    scene.objects = {object(Sphere{random.point(3), 9}, wall)};
    const double expected = emitted * (1 - std::pow(albedo, depth + 1)) / (1 - albedo);
    const Mean mean = light_from(scene, {0, 0, 0}, random.direction(), 64, depth, 2);
    EXPECT_NEAR(mean.value, expected, 1e-5 * expected) << depth;
  }
}
TEST(Path, FurnaceIsTheWholeSumWhereverPathsEndByChance) {
  for (const double albedo : {0.3, 0.7}) {
    Scene scene;
    Finish wall = matt(albedo);
    wall.emission = {1, 1, 1};
    scene.objects = {object(Sphere{{0, 0, 0}, 2}, wall)};
    expect_mean(light_from(scene, {0.5, 0.2, 0.1}, {2, 1, 0}, 2048, 64), 1 / (1 - albedo));
  }
}

// Where the scene has no light, only what surfaces draw finds those that shine.
TEST(Path, FurnaceOfABoxNeedsNoLight) {
  Scene scene;
  Finish wall = matt(0.5);
  wall.emission = {1, 1, 1};
  scene.objects = {object(Box{{-1, -1, -1}, {1, 1, 1}}, wall)};
  const Mean mean = light_from(scene, {0, 0, 0}, {0.2, 1, 0.1}, 64, 3, 2);
  EXPECT_NEAR(mean.value, 1.875, 1e-5);
}

// Whatever loses no light is as bright as the sky around it.
TEST(Path, WhiteBodiesInAWhiteSkyCannotBeSeen) {
  Random random(821);
  Finish mirror;
  mirror.diffuse = 0, mirror.reflection = 1;
  Finish half = matt(1);
  half.reflection = 0.5;
  for (const Finish& finish : {matt(1), mirror, half, glass(1.5), glass(0.7), clear_glass(1.5)}) {
    Scene scene;
    scene.background = {1, 1, 1};
    scene.objects = {object(Sphere{{0, 0, 0}, 1}, finish)};
    const Vec3d aside = random.direction() * 0.9;
    const Mean mean = light_from(scene, random.direction() * 5.0, aside, 1024, 64);
    expect_mean(mean, 1, 1e-4);
  }
}

TEST(Path, RoughWhiteBodiesInAWhiteSkyCannotBeSeenEither) {
  Random random(834);
  for (const double roughness : {0.2, 0.6, 1.0})
    for (int kind = 0; kind < 6; ++kind) {
      Principled principled;
      principled.roughness = roughness;
      principled.metallic = kind == 1 ? 1 : 0;
      principled.transmission = kind == 2 || kind == 3 || kind == 5 ? 1 : 0;
      principled.thin = kind == 3;
      principled.dispersion = kind == 5 ? 0.5 : 0;
      principled.clearcoat = kind == 4 ? 1 : 0;
      principled.clearcoat_roughness = roughness / 2;
      Scene scene;
      scene.background = {1, 1, 1};
      scene.objects = {object(Sphere{{0, 0, 0}, 1}, Finish{})};
      scene.objects[0].material = Boxed<Material>(Material{principled});
      const Vec3d aside = random.direction() * 0.9;
      const Mean mean = light_from(scene, random.direction() * 5.0, aside, 256, 64, 4);
      EXPECT_NEAR(mean.value, 1, 0.01 + 4 * mean.error) << roughness << ' ' << kind;
    }
}

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

// Where nothing is chance: matt surfaces under parallel light, once. Whitted's has no 1 / pi.
TEST(Path, AgreesWithWhittedUnderParallelLight) {
  Random random(836);
  Scene scene;
  scene.objects = {object(Plane{{0, -2, 0}, {0, 1, 0}}, matt(0.5))};
  for (int i = 0; i < 12; ++i)
    scene.objects.push_back(
        object(Sphere{random.point(2), random.in(0.2, 0.6)}, matt(random.in(0.2, 1))));
  DirectionalLight sun;
  sun.direction = {0.4, -1, -0.3};
  scene.lights = {Light{}};
  scene.lights[0].kind = sun;
  scene.lights[0].intensity = 2;
  scene.camera.location = {0, 0, 8};
  scene.camera.direction = {0, 0, -1};
  const World world = compile(scene);
  RenderOptions options;
  const auto drawn = [&](IntegratorName integrator) {
    options.integrator = integrator;
    options.max_depth = 1;
    return picture(world, view_of(scene.camera, 96, 72), {0, 0, 96, 72}, options).image;
  };
  const Image path = drawn(IntegratorName::path), whitted = drawn(IntegratorName::whitted);
  double lit = 0;
  for (std::size_t i = 0; i < path.rgb.size(); ++i) {
    lit += static_cast<double>(whitted.rgb[i]);
    ASSERT_NEAR(path.rgb[i] * pi, whitted.rgb[i], 1e-5) << i;
  }
  EXPECT_GT(lit, 1000);
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

// A ball of radiance L above the horizon: E = pi L (r / d)^2 cos.
// Source: Howell, "A catalog of radiation heat transfer configuration factors", B-43.
TEST(Path, BallsLightIsItsFormFactor) {
  Random random(823);
  for (int i = 0; i < 6; ++i) {
    const Onb frame = onb_around(random.direction());
    const double d = random.in(2, 5), r = random.in(0.2, 0.9), slant = random.in(0, 0.9);
    const Vec3d up = normalize(frame.n + frame.u * slant);
    Scene scene;
    scene.objects = {object(Plane{{0, 0, 0}, frame.n}, matt(0.7))};
    scene.lights = {sphere_light(up * d, r)};
    const double irradiance = pi * r * r / (d * d) * dot(up, frame.n);
    ASSERT_GT(d * dot(up, frame.n), r);
    expect_mean(light_from(scene, frame.n * 2.0 - frame.u, {0, 0, 0}, 256, 1),
                0.7 / pi * irradiance);
  }
}

TEST(Path, QuadsLightIsLambertsFormula) {
  Random random(824);
  for (int i = 0; i < 6; ++i) {
    const Vec3d n = random.direction();
    const Onb frame = onb_around(n);
    const Vec3d corner =
        frame.n * random.in(1, 3) + frame.u * random.in(-2, 1) + frame.v * random.in(-2, 1);
    const Vec3d u = frame.u * random.in(0.5, 2) + frame.n * random.in(0, 0.5);
    const Vec3d v = frame.v * random.in(0.5, 2) + frame.n * random.in(0, 0.5);
    Scene scene;
    scene.objects = {object(Plane{{0, 0, 0}, n}, matt(0.6))};
    Light light;
    light.kind = QuadLight{corner, u, v};
    scene.lights = {light};
    const double irradiance =
        polygon_irradiance({corner, corner + u, corner + u + v, corner + v}, n);
    expect_mean(light_from(scene, frame.n * 0.5 - frame.u - frame.v, {0, 0, 0}, 1024, 1),
                0.6 / pi * irradiance);
  }
}

// In an integrating sphere all that is scattered, wherever from, lights each point of the wall
// alike: E = direct + Phi a / (4 pi R^2 (1 - a)).
// Source: Jacquez, Kuppenheim, "Theory of the integrating sphere", JOSA 45 (1955).
TEST(Path, IntegratingSphereSpreadsWhatItScatters) {
  Random random(825);
  for (int i = 0; i < 4; ++i) {
    const double radius = random.in(1, 3), albedo = random.in(0.3, 0.8);
    Scene scene;
    scene.objects = {object(Sphere{{0, 0, 0}, radius}, matt(albedo))};
    const Vec3d light = random.point(0.5 * radius);
    scene.lights = {point_light(light)};
    const Vec3d wall = random.direction() * radius, to = light - wall;
    const double direct = dot(normalize(to), normalize(wall) * -1.0) / dot(to, to);
    const double spread = albedo / (radius * radius * (1 - albedo));
    expect_mean(light_from(scene, {0, 0, 0}, wall, 1024, 64), albedo / pi * (direct + spread));
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
             drawn = light_from(found, eye, {0, 0, 0}, 16384, 2);
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
