// What lights do to a surface, by closed forms: highlights, brilliance, spots, fading, areas.
#include <gtest/gtest.h>

#include "tests/core/tree.h"

namespace tia {
namespace {

using namespace test;

// A floor at y = 0 with that finish, seen from straight above the point (x, 0, 0).
struct Floor {
  Scene scene;
  explicit Floor(const Finish& finish = {}) {
    scene.objects = {object(Plane{{0, 0, 0}, {0, 1, 0}}, finish)};
  }
  Vec3f at(double x, double z = 0) const { return tree(scene, {x, 5, z}, {0, -1, 0})->color; }
};

TEST(Lights, BrillianceIsThePowerOfTheCosine) {
  Random random(420);
  for (int i = 0; i < 100; ++i) {
    Finish finish;
    finish.brilliance = random.in(0, 6);
    Floor floor(finish);
    const double x = random.in(0, 5), h = random.in(1, 5);
    floor.scene.lights = {point_light({x, h, 0})};
    EXPECT_NEAR(double(floor.at(0).x), std::pow(h / std::hypot(x, h), finish.brilliance), 2e-6);
  }
}

TEST(Lights, HighlightIsThePowerOfTheMirroredCosineTintedByTheLightOnly) {
  Random random(421);
  for (int i = 0; i < 100; ++i) {
    Finish finish = dark();
    finish.color = {0, 1, 0};
    finish.specular = random.in(0.1, 1);
    finish.roughness = random.in(0.01, 1);
    Floor floor(finish);
    // Seen from straight above, the mirrored ray goes straight up: r.l is the light's cosine.
    const double x = random.in(0, 1), h = random.in(1, 5), c = h / std::hypot(x, h);
    floor.scene.lights = {point_light({x, h, 0}, {1, 0.5, 0.25})};
    const double highlight = finish.specular * std::pow(c, 1 / finish.roughness);
    expect_near(floor.at(0), {highlight, 0.5 * highlight, 0.25 * highlight}, 2e-5);
  }
}

TEST(Lights, NothingShinesFromBelowTheSurface) {
  Finish finish;
  finish.specular = 1;
  finish.brilliance = 0;
  Floor floor(finish);
  floor.scene.lights = {point_light({0.1, -1, 0})};
  expect_near(floor.at(0), {0, 0, 0}, 0);
}

TEST(Lights, AmbientLightIsSharedByFinishAndScene) {
  Finish finish = dark();
  finish.color = {0.5, 1, 0.25};
  finish.ambient = 0.3;
  Floor floor(finish);
  floor.scene.ambient_light = {1, 0.5, 2};
  expect_near(floor.at(0), {0.15, 0.15, 0.15}, 1e-7);
}

TEST(Lights, DirectionalLightHasOneCosineEverywhere) {
  Random random(422);
  for (int i = 0; i < 50; ++i) {
    Vec3d way = random.direction();
    way.y = -std::fabs(way.y);
    Floor floor;
    floor.scene.lights = {light_of(DirectionalLight{way * 7.0})};
    const double x = random.in(-9, 9);
    EXPECT_NEAR(double(floor.at(x, random.in(-9, 9)).x), -way.y / length(way), 1e-6);
  }
}

TEST(Lights, SpotIsFullInsideNoneOutsideAndSmoothInCosineBetween) {
  SpotLight spot;
  spot.position = Vec3d{0, 2, 0};
  spot.point_at = {0, 0, 0};
  spot.radius_degrees = 20;
  spot.falloff_degrees = 40;
  const double inner = std::cos(20 * pi / 180), outer = std::cos(40 * pi / 180);
  for (const double tightness : {0.0, 3.0}) {
    spot.tightness = tightness;
    Floor floor;
    floor.scene.lights = {light_of(spot)};
    for (const double degrees : {0.0, 10.0, 19.9, 25.0, 30.0, 35.0, 39.9, 40.1, 60.0}) {
      const double angle = degrees * pi / 180, c = std::cos(angle);
      const double s = std::clamp((c - outer) / (inner - outer), 0.0, 1.0);
      const double expected = s * s * (3 - 2 * s) * std::pow(c, tightness) * c;
      EXPECT_NEAR(double(floor.at(2 * std::tan(angle)).x), expected, 2e-5) << degrees;
    }
  }
}

TEST(Lights, SpotOfEqualAnglesHasAHardEdge) {
  SpotLight spot;
  spot.position = Vec3d{0, 1, 0};
  spot.radius_degrees = spot.falloff_degrees = 45;
  Floor floor;
  floor.scene.lights = {light_of(spot)};
  EXPECT_NEAR(double(floor.at(0.99).x), 1 / std::hypot(0.99, 1), 1e-6);
  EXPECT_EQ(floor.at(1.01).x, 0.0F);
}

TEST(Lights, FadingIsPovRaysFormula) {
  Random random(423);
  for (int i = 0; i < 100; ++i) {
    Floor floor;
    Light light = point_light({0, random.in(0.5, 9), 0});
    light.fade_distance = random.in(0.5, 5);
    light.fade_power = random.in(0, 4);
    const double d = light.place()->y;
    floor.scene.lights = {light};
    EXPECT_NEAR(double(floor.at(0).x),
                2 / (1 + std::pow(d / *light.fade_distance, light.fade_power)), 2e-6);
  }
}

TEST(Lights, LightsAddUp) {
  Finish finish;
  finish.specular = 0.4;
  finish.roughness = 0.1;
  Floor floor(finish);
  floor.scene.objects.push_back(ball({1, 1, 0}, 0.3));
  const Light a = point_light({2, 3, 1}, {0.2, 0.4, 0.6}), b = point_light({-1, 2, 1});
  for (const double x : {-1.0, 0.0, 0.7}) {
    floor.scene.lights = {a};
    const Vec3f first = floor.at(x);
    floor.scene.lights = {b};
    const Vec3f second = floor.at(x);
    floor.scene.lights = {a, b};
    expect_near(floor.at(x), static_cast<Vec3d>(first + second), 1e-6);
    floor.scene.lights = {a, a};
    const Vec3f twice = floor.at(x);
    floor.scene.lights = {a};
    floor.scene.lights[0].intensity = 2;
    expect_near(floor.at(x), static_cast<Vec3d>(twice), 1e-6);
  }
}

// ---- areas --------------------------------------------------------------------------------------

// A ball of radius r at height h under a luminous ball of radius R at height H: on the floor the
// umbra is where no line to the light misses the ball, the penumbra where one hits it. Both edges
// lie on lines that touch both balls; in the plane through their centres the inner tangents bound
// the penumbra, the outer ones the umbra. Source: similar triangles.
TEST(Lights, UmbraAndPenumbraOfABallEndWhereTangentsMeetTheFloor) {
  const double big = 0.5, small = 1, top = 10, low = 4, gap = top - low;
  Floor floor;
  SphereLight light;
  light.position = Vec3d{0, top, 0};
  light.radius = big;
  light.samples = 256;
  floor.scene.lights = {light_of(light)};
  floor.scene.objects.push_back(ball({0, low, 0}, small, matte({0, 0, 0})));
  // A tangent's angle to the axis: sin = (r - R) / gap for the outer, (r + R) / gap for the inner.
  // It meets the axis r / sin above the ball's centre.
  const auto edge = [&](double sum) {
    const double a = std::asin(sum / gap);
    return (low + small / std::sin(a)) * std::tan(a);
  };
  const double umbra = edge(small - big), penumbra = edge(small + big);
  const auto visible = [&](double x) {
    const auto node = tree(floor.scene, {x, 1, 0.01}, {0, -1, 0});
    return term(*node, TermName::diffuse)->light.visible;
  };
  EXPECT_EQ(visible(umbra * 0.98), 0.0F);
  EXPECT_GT(visible(umbra * 1.04), 0.0F);
  EXPECT_LT(visible(penumbra * 0.96), 1.0F);
  EXPECT_EQ(visible(penumbra * 1.02), 1.0F);
}

TEST(Lights, QuadOfManyPlacesConvergesToItsMeanCosine) {
  // Straight above the floor's point: the mean over the quad of h / |(x, h, z)|.
  QuadLight quad;
  quad.corner = Vec3d{-1, 2, -1};
  quad.u = {2, 0, 0};
  quad.v = {0, 0, 2};
  quad.samples = 1024;
  Floor floor;
  floor.scene.lights = {light_of(quad)};
  double mean = 0;
  constexpr int n = 400;
  for (int i = 0; i < n; ++i)
    for (int k = 0; k < n; ++k) {
      const double x = -1 + 2 * (i + 0.5) / n, z = -1 + 2 * (k + 0.5) / n;
      mean += 2 / std::sqrt(x * x + z * z + 4) / (n * n);
    }
  const auto node = tree(floor.scene, {0, 1, 0}, {0, -1, 0});
  EXPECT_NEAR(double(node->color.x), mean, 2e-3);
}

TEST(Lights, BallLightOfManyPlacesIsTheMeanCosineOfItsCone) {
  // Over a cone of half angle a around the normal the mean cosine is (1 + cos a) / 2.
  SphereLight light;
  light.position = Vec3d{0, 3, 0};
  light.radius = 1.5;
  light.samples = 1024;
  Floor floor;
  floor.scene.lights = {light_of(light)};
  const auto node = tree(floor.scene, {0, 1, 0}, {0, -1, 0});
  EXPECT_NEAR(double(node->color.x), (1 + std::cos(std::asin(0.5))) / 2, 2e-3);
}

TEST(Lights, LuminousQuadIsSeenMirroredAndBlocksOthersButNotItself) {
  QuadLight quad;
  quad.corner = Vec3d{-1, 2, -1};
  quad.u = {2, 0, 0};
  quad.v = {0, 0, 2};
  Floor floor;
  floor.scene.lights = {light_of(quad, {0.5, 0.25, 1})};
  expect_near(tree(floor.scene, {0, 1, 0}, {0, 1, 0})->color, {0.5, 0.25, 1}, 1e-7);
  expect_near(tree(floor.scene, {0.2, 1, 0.2}, {0, -1, 0})->color,
              Vec3d{0.5, 0.25, 1} * (2 / std::sqrt(4.08)), 1e-6);
  floor.scene.lights.push_back(point_light({0, 4, 0}));
  expect_near(tree(floor.scene, {0.2, 1, 0.2}, {0, -1, 0})->color,
              Vec3d{0.5, 0.25, 1} * (2 / std::sqrt(4.08)), 1e-6);
}

TEST(Lights, SkyIsSeenWhereRaysLeaveAndLightsNothing) {
  Floor floor;
  floor.scene.background = {1, 0, 0};
  Light sky = light_of(SkyLight{}, {0.2, 0.4, 0.8});
  sky.intensity = 0.5;
  floor.scene.lights = {sky};
  expect_near(tree(floor.scene, {0, 1, 0}, {0, 1, 0})->color, {0.1, 0.2, 0.4}, 1e-7);
  expect_near(floor.at(0), {0, 0, 0}, 0);
}

TEST(Lights, TransparentShadowsTakeEachSurfacesShare) {
  Finish pane = dark();
  pane.transmission = 0.5;
  Floor floor;
  floor.scene.lights = {point_light({0, 10, 0})};
  floor.scene.objects.push_back(object(Box{{-1, 2, -1}, {1, 3, 1}}, pane));
  const auto seen = [&] { return double(tree(floor.scene, {0, 1, 0}, {0, -1, 0})->color.x); };
  EXPECT_EQ(seen(), 0);
  floor.scene.options.transparent_shadows = true;
  EXPECT_NEAR(seen(), 0.25, 1e-6) << "in and out of the box";
  floor.scene.objects.push_back(object(Sphere{{0, 5, 0}, 1}, dark()));
  EXPECT_EQ(seen(), 0);
}

}  // namespace
}  // namespace tia
