// What a finish and a light make of a point, by closed forms at random angles, places and numbers.
#include <gtest/gtest.h>

#include "tests/core/random_scene.h"
#include "tests/core/tree.h"

namespace tia {
namespace {

using namespace test;

// A floor at y = 0 with that finish.
Scene scene_of_floor(const Finish& finish) {
  Scene scene;
  scene.objects = {object(Plane{{0, 0, 0}, {0, 1, 0}}, finish)};
  return scene;
}
Finish shiny(double specular, double roughness) {
  Finish finish = dark();
  finish.specular = specular;
  finish.roughness = roughness;
  return finish;
}
Vec3d above(Random& random, double least) {
  for (;;) {
    const Vec3d way = random.direction();
    if (way.y > least) return way;
  }
}
// What the ray sees that comes down to the origin from there.
Vec3f color_from(const Scene& scene, const Vec3d& way) {
  return tree(scene, way * 3.0, -way)->color;
}

// Phong's: the cosine between the light and the mirrored ray, at slanting views too, where it is
// neither n.l nor Blinn's n.h. Source: Phong, "Illumination for computer generated pictures", 1975.
TEST(Highlight, IsThePowerOfTheCosineToTheMirroredRayFromEverySide) {
  Random random(450);
  int bright = 0;
  for (int i = 0; i < 2000; ++i) {
    const Vec3d eye = above(random, 0.05);
    Vec3d to_lamp = above(random, 0.05);
    const Vec3d mirrored{-eye.x, eye.y, -eye.z};
    if (random.chance(0.5)) to_lamp = normalize(mirrored + random.direction() * 0.3);
    if (to_lamp.y < 0.05) continue;
    const double specular = random.in(0.1, 1), exponent = random.in(1, 40);
    Scene scene = scene_of_floor(shiny(specular, 1 / exponent));
    scene.lights = {point_light(to_lamp * random.in(1, 9), {1, 0.5, 0.25})};
    const double cosine = std::max(0.0, dot(mirrored, to_lamp));
    const double highlight = specular * std::pow(cosine, exponent);
    expect_near(color_from(scene, eye), Vec3d{1, 0.5, 0.25} * highlight, 3e-5);
    bright += highlight > 0.1;
  }
  EXPECT_GT(bright, 300);
}

TEST(Highlight, RoughnessIsOneOverTheExponentToItsLeast) {
  // At 1e-5 the exponent is 100 000: half as bright at 3.7e-3 from the mirrored ray.
  const double half = std::acos(std::pow(0.5, 1e-5));
  Scene scene = scene_of_floor(shiny(1, 1e-5));
  const auto at = [&](double angle) {
    scene.lights = {point_light({std::sin(angle), std::cos(angle), 0})};
    return double(color_from(scene, {0, 1, 0}).x);
  };
  EXPECT_NEAR(at(0), 1, 1e-2);
  EXPECT_NEAR(at(half), 0.5, 1e-2);
  EXPECT_LT(at(10 * half), 1e-9);
}

// ---- spots --------------------------------------------------------------------------------------

TEST(Spot, FollowsItsFormulaAtAnyAxisAndAngles) {
  Random random(451);
  int rims = 0;
  for (int i = 0; i < 3000; ++i) {
    SpotLight spot;
    spot.position = above(random, 0.2) * random.in(1, 5);
    spot.point_at = *spot.position + random.vector(0.1, 9);
    spot.radius_degrees = random.in(0, 120);
    spot.falloff_degrees = random.in(spot.radius_degrees + 5, 180);
    spot.tightness = random.chance(0.5) ? 0 : random.in(0.2, 20);
    Scene scene = scene_of_floor(Finish{});
    scene.lights = {light_of(spot)};
    const Vec3d way = normalize(-*spot.position);
    const double c = dot(way, normalize(spot.point_at - *spot.position));
    const double inner = std::cos(spot.radius_degrees * pi / 180);
    const double outer = std::cos(spot.falloff_degrees * pi / 180);
    const double s = std::clamp((c - outer) / (inner - outer), 0.0, 1.0);
    const double expected = -way.y * s * s * (3 - 2 * s) *
                            (spot.tightness > 0 ? std::pow(std::max(c, 0.0), spot.tightness) : 1);
    EXPECT_NEAR(double(color_from(scene, {0, 1, 0}).x), expected, 3e-5);
    rims += s > 0 && s < 1;
  }
  EXPECT_GT(rims, 500);
}

// Full within the radius, nothing beyond the falloff, to 1e-4 of a radian on either side.
TEST(Spot, EdgesStandAtTheirAngles) {
  Random random(452);
  for (int i = 0; i < 300; ++i) {
    SpotLight spot;
    spot.position = Vec3d{0, random.in(0.5, 3), 0};
    spot.radius_degrees = random.in(5, 40);
    spot.falloff_degrees = random.chance(0.3) ? spot.radius_degrees : random.in(45, 70);
    Scene scene = scene_of_floor(Finish{});
    scene.lights = {light_of(spot)};
    const auto strength = [&](double angle) {
      const double x = spot.position->y * std::tan(angle);
      return double(tree(scene, {x, 1, 0}, {0, -1, 0})->color.x) / std::cos(angle);
    };
    const double radius = spot.radius_degrees * pi / 180;
    const double falloff = spot.falloff_degrees * pi / 180;
    EXPECT_NEAR(strength(radius - 1e-4), 1, 2e-6);
    EXPECT_EQ(strength(falloff + 1e-4), 0);
    if (falloff == radius) continue;
    EXPECT_LT(strength(radius + 0.02), 1);
    EXPECT_GT(strength(falloff - 0.02), 0);
  }
}

// ---- fading -------------------------------------------------------------------------------------

TEST(Fading, IsByTheDistanceAndAlikeForAllThatStandSomewhere) {
  Random random(453);
  for (int i = 0; i < 500; ++i) {
    const Vec3d place = above(random, 0.1) * random.in(0.2, 20);
    Light light = point_light(place);
    SpotLight spot;
    spot.position = place;
    spot.radius_degrees = 90;
    spot.falloff_degrees = 120;
    QuadLight quad;
    quad.corner = place - Vec3d{0.01, 0, 0.01};
    quad.u = {0.02, 0, 0};
    quad.v = {0, 0, 0.02};
    switch (i % 4) {
      case 1: light.kind = spot; break;
      case 2: light.kind = SphereLight{place, 0.01}; break;
      case 3: light.kind = quad; break;
      default: break;
    }
    light.fade_distance = random.in(0.1, 20);
    light.fade_power = random.in(0, 10);
    Scene scene = scene_of_floor(shiny(0, 1));
    std::get<Finish>(std::get<Boxed<Material>>(*scene.objects[0].material)->kind).diffuse = 1;
    scene.lights = {light};
    const double d = length(place);
    const double factor = 2 / (1 + std::pow(d / *light.fade_distance, light.fade_power));
    EXPECT_NEAR(double(color_from(scene, {0, 1, 0}).x), place.y / d * factor, 2e-5 * factor + 1e-7);
  }
}

TEST(Fading, DimsHighlightsToo) {
  Scene scene = scene_of_floor(shiny(0.5, 0.1));
  scene.lights = {point_light({0, 6, 0})};
  scene.lights[0].fade_distance = 3;
  EXPECT_NEAR(double(color_from(scene, {0, 1, 0}).x), 0.5 * 2 / 5, 1e-6) << "2 / (1 + 2^2)";
}

// ---- sums ---------------------------------------------------------------------------------------

// Scattered light of k equal lights is that of one of k times the intensity: bit for bit where k is
// a power of two, for x + x and 2 x are the same float.
TEST(Superposition, TwoEqualLampsAreOneOfTwiceTheIntensityBitForBit) {
  Random random(454);
  for (int i = 0; i < 200; ++i) {
    Finish finish;
    finish.color = random_color(random);
    finish.brilliance = random.in(0.5, 3);
    Scene scene = scene_of_floor(finish);
    const Light light = point_light(above(random, 0.1) * random.in(1, 9), random_color(random));
    const Vec3d eye = above(random, 0.1);
    scene.lights = {light};
    scene.lights[0].intensity = 2;
    const Vec3f one = color_from(scene, eye);
    scene.lights = {light, light};
    EXPECT_GT(one.x + one.y + one.z, 0.0F);
    EXPECT_EQ(color_from(scene, eye), one);
  }
}

TEST(Superposition, PictureOfManyLampsIsTheSumOfTheirPictures) {
  Random random(455);
  for (int i = 0; i < 5; ++i) {
    Scene scene = random_scene(456 + static_cast<std::uint64_t>(i));
    for (Object& each : scene.objects.edit()) {
      Finish& finish = std::get<Finish>(std::get<Boxed<Material>>(*each.material)->kind);
      finish.emission = {};
      finish.specular = random.unit();
      finish.reflection = random.unit();
    }
    scene.background = {};
    scene.key_light.reset();
    std::vector<Light> lights;
    for (int k = 0; k < 4; ++k)
      lights.push_back(point_light(random.point(20), random_color(random)));
    scene.lights = lights;
    const Image all = picture(scene, 60, 40, at_depth(3)).image;
    std::vector<double> sum(all.rgb.size());
    for (const Light& light : lights) {
      scene.lights = {light};
      const Image one = picture(scene, 60, 40, at_depth(3)).image;
      for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += double(one.rgb[k]);
    }
    for (std::size_t k = 0; k < sum.size(); ++k)
      ASSERT_NEAR(double(all.rgb[k]), sum[k], 2e-6 * (1 + sum[k]));
  }
}

}  // namespace
}  // namespace tia
