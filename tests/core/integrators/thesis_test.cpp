#include "core/integrators/whitted.h"

#include <gtest/gtest.h>

#include "tests/core/random_scene.h"
#include "tests/core/tree.h"

namespace tia {
namespace {

using test::ball;
using test::expect_near;
using test::light_along;
using test::matte;
using test::point_light;
using test::Random;
using test::sphere_light;

const Material black_matte = matte({0, 0, 0}), white_matte = matte({1, 1, 1});

// One ball, seen at the point where its normal is n, from an eye straight above that point.
struct SeenBall {
  Scene scene;
  Vec3d n, p;
  explicit SeenBall(const Sphere& sphere, const Vec3d& normal,
                    const Material& material = white_matte)
      : n(normal), p(sphere.center + normal * sphere.radius) {
    scene.background = {9, 9, 9};  // never mistaken for a shaded value
    scene.objects.push_back(ball(sphere.center, sphere.radius, material));
  }
  Vec3f light() const { return light_along(scene, p + n * 2.0, -n); }
};

TEST(Thesis, RayThatHitsNothingSeesTheBackground) {
  Scene scene;
  scene.background = {0.1, 0.2, 0.3};
  EXPECT_EQ(light_along(scene, {0, 0, 0}, {0, 0, -1}), (Vec3f{0.1F, 0.2F, 0.3F}));
  scene.objects.push_back(ball({0, 0, 5}, 1));  // behind
  EXPECT_EQ(light_along(scene, {0, 0, 0}, {0, 0, -1}), (Vec3f{0.1F, 0.2F, 0.3F}));
}

TEST(Thesis, LambertIsTheCosineOfAPythagoreanTriangle) {
  // n = z at p = (0,0,4). A light 3 aside and 4 above has n.l = 4/5, one 4 aside and 3 above 3/5.
  SeenBall seen({{0, 0, 0}, 4}, {0, 0, 1});
  seen.scene.lights = {point_light({3, 0, 8})};
  expect_near(seen.light(), {0.8, 0.8, 0.8}, 3e-7);
  seen.scene.lights = {point_light({0, -40, 34})};
  expect_near(seen.light(), {0.6, 0.6, 0.6}, 3e-7);
  seen.scene.lights = {point_light({0, 0, 104})};  // straight above
  expect_near(seen.light(), {1, 1, 1}, 3e-7);
}

TEST(Thesis, LambertIsTheCosineAtEveryNormalAndDistance) {
  Random random(70);
  int lit = 0;
  for (int i = 0; i < 3000; ++i) {
    const Vec3d n = random.direction(), l = random.direction();
    const Color color = test::random_color(random);
    SeenBall seen({random.point(5), random.in(0.5, 5)}, n, matte(color));
    seen.scene.lights = {point_light(seen.p + l * random.in(0.5, 50))};
    const double cosine = std::max(0.0, dot(n, l));
    if (std::fabs(dot(n, l)) < 1e-4) continue;  // the terminator
    expect_near(seen.light(), Vec3d{color.r, color.g, color.b} * cosine, 1e-5);
    if (cosine == 0) EXPECT_EQ(seen.light(), (Vec3f{0, 0, 0}));
    else ++lit;
  }
  EXPECT_GT(lit, 1000);
}

TEST(Thesis, ValueIsDiffuseTimesColourTimesLightTimesIntensity) {
  SeenBall seen({{0, 0, 0}, 1}, {0, 0, 1});
  seen.scene.objects[0].material = Material{Finish{.color = {0.5, 0.25, 1}, .diffuse = 0.5}};
  Light light = point_light({0, 0, 3}, {1, 0.5, 0.25});
  light.intensity = 3;
  seen.scene.lights = {light};
  expect_near(seen.light(), {0.5 * 0.5 * 3, 0.25 * 0.5 * 0.5 * 3, 0.5 * 0.25 * 3}, 3e-7);
}

TEST(Thesis, LightDoesNotFallOffWithDistance) {
  SeenBall near({{0, 0, 0}, 1}, {0, 0, 1}), far = near;
  near.scene.lights = {point_light({0, 0, 1.5})};
  far.scene.lights = {point_light({0, 0, 1e6})};
  EXPECT_EQ(near.light(), far.light());
}

TEST(Thesis, EmissionAddsToWhatTheLightsGive) {
  SeenBall plain({{0, 0, 0}, 1}, {0, 0, 1}, matte({0.5, 0.5, 0.5}));
  plain.scene.lights = {point_light({3, 1, 4})};
  SeenBall glowing = plain;
  glowing.scene.objects[0].material = matte({0.5, 0.5, 0.5}, {0.125, 0.25, 2});
  const Vec3f lit = plain.light();
  EXPECT_GT(lit.x, 0.1F);
  EXPECT_EQ(glowing.light(), (Vec3f{0.125F, 0.25F, 2.0F}) + lit);
  glowing.scene.lights.clear();  // its own light never lights it from outside
  EXPECT_EQ(glowing.light(), (Vec3f{0.125F, 0.25F, 2.0F}));
}

TEST(Thesis, SeveralLightsSuperpose) {
  Random random(71);
  for (int i = 0; i < 200; ++i) {
    SeenBall seen({random.point(2), 1}, random.direction());
    const Light a = point_light(seen.p + random.point(9), {0.2, 0.4, 0.8});
    const Light b = sphere_light(seen.p + random.direction() * 9.0, 0.1, {0.9, 0.3, 0.1});
    seen.scene.lights = {a};
    const Vec3f only_a = seen.light();
    seen.scene.lights = {b};
    const Vec3f only_b = seen.light();
    seen.scene.lights = {a, b};
    EXPECT_EQ(seen.light(), only_a + only_b);
  }
}

TEST(Thesis, LuminousObjectLightsLikeALightAtItsCentre) {
  SeenBall by_object({{0, 0, 0}, 1}, {0, 0, 1}), by_light = by_object, by_point = by_object;
  by_object.scene.objects.push_back(ball({3, 0, 5}, 0.5, matte({0, 0, 0}, {0.5, 0.75, 1})));
  by_light.scene.lights = {sphere_light({3, 0, 5}, 0.5, {0.5, 0.75, 1})};
  by_point.scene.lights = {point_light({3, 0, 5}, {0.5, 0.75, 1})};
  EXPECT_GT(by_object.light().z, 0.1F);
  EXPECT_EQ(by_object.light(), by_light.light());
  EXPECT_EQ(by_object.light(), by_point.light());
}

TEST(Thesis, LuminousBallIsSeenInItsColourTimesIntensity) {
  Scene scene;
  Light light = sphere_light({0, 0, -5}, 1, {0.25, 0.5, 1});
  light.intensity = 2;
  scene.lights = {light};
  EXPECT_EQ(light_along(scene, {0, 0, 0}, {0, 0, -1}), (Vec3f{0.5F, 1, 2}));
  scene.lights = {point_light({0, 0, -5})};  // a point is never seen
  EXPECT_EQ(light_along(scene, {0, 0, 0}, {0, 0, -1}), (Vec3f{0, 0, 0}));
}

TEST(Thesis, KeyLightWithoutAPlaceLightsNothing) {
  SeenBall seen({{0, 0, 0}, 1}, {0, 0, 1});
  seen.scene.key_light = Light{SphereLight{std::nullopt, 3}, {1, 1, 1}, 1};
  EXPECT_EQ(seen.light(), (Vec3f{0, 0, 0}));
  seen.scene.key_light->move_to({0, 0, 40}, {});
  EXPECT_EQ(seen.light(), (Vec3f{1, 1, 1}));
}

TEST(Thesis, OriginInsideABallLookingAwayFromItsCentreHitsIt) {
  Scene scene;
  scene.background = {9, 9, 9};
  scene.objects.push_back(ball({0, 0, -20}, 4, black_matte));
  EXPECT_EQ(light_along(scene, {0, 0, -22}, {0, 0, -1}), (Vec3f{0, 0, 0}));
}

TEST(Thesis, InsideOfABallIsLitByALightInsideIt) {
  // The surface faces the viewer: at z = -5 the inner normal is +z, the light 3 aside and 4 before.
  Scene scene;
  scene.objects.push_back(ball({0, 0, 0}, 5, white_matte));
  scene.lights = {point_light({3, 0, -1})};
  expect_near(light_along(scene, {0, 0, 0}, {0, 0, -1}), {0.8, 0.8, 0.8}, 3e-7);
  scene.lights = {point_light({0, 0, 50})};  // outside: the near wall stands between
  EXPECT_EQ(light_along(scene, {0, 0, 0}, {0, 0, -1}), (Vec3f{0, 0, 0}));
}

TEST(Thesis, LanesThatAreNotActiveAreNotCounted) {
  const Scene scene = test::thesis_scene('s');
  const World world = compile(scene);
  const View view = view_of(scene.camera, 640, 480);
  for (int active = 0; active <= lanes<Wide>; ++active) {
    FewBallsView world_view{world, {0, 1, 2}};
    const Wide x = Wide(320.0F) + iota<Wide>();
    whitted(world_view, view.ray(x, Wide(100.0F)), iota<Wide>() < Wide(static_cast<float>(active)),
            SamplerState<Wide>{});
    EXPECT_EQ(world_view.rays.primary, active);
    EXPECT_EQ(world_view.rays.shadow, active);  // the ball's upper front: all towards the light
  }
}

}  // namespace
}  // namespace tia
