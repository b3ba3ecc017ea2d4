#include "core/scene/keys.h"

#include <gtest/gtest.h>

#include "core/scene/read_scene.h"
#include "tests/core/faults.h"
#include "tests/core/random_scene.h"

namespace tia {
namespace {

using test::Random;

Vec3d place_of(const Light& light) { return light.place().value(); }

// ---- a scene's own keys -----------------------------------------------------------------------

TEST(Keys, OwnBindingPutsTheKeyLightWhereItSays) {
  const Scene scene = test::thesis_scene();
  EXPECT_EQ(keys_of(scene), (std::vector<std::string_view>{"a", "d", "s", "w"}));
  const std::pair<const char*, Vec3d> table[] = {
      {"a", {-20, 20, -10}}, {"d", {20, 20, -10}}, {"s", {0, 20, -5}}, {"w", {0, 25, -35}}};
  for (const auto& [key, place] : table) {
    Scene expected = scene;
    expected.key_light->move_to(place, {});
    EXPECT_EQ(press(scene, key), expected) << key;
  }
}

TEST(Keys, OwnKeysReplaceTheDefaultOnes) {
  const Scene scene = read_scene(R"({"keys":{"x":{"light":[1,2,3]}}})");
  EXPECT_EQ(keys_of(scene), (std::vector<std::string_view>{"x"}));
  EXPECT_EQ(place_of(press(scene, "x").lights.at(0)), (Vec3d{1, 2, 3}));
  EXPECT_THROW(press(scene, "a"), InputError);
}

TEST(Keys, AnyOtherBindingPatchesTheScene) {
  const Scene scene = read_scene(R"({
    "title":"before", "background":[1,1,1], "camera":{"fov_degrees":40,"location":[1,2,3]},
    "lights":[{"type":"point","position":[0,0,0]}],
    "keys":{"n":{"title":"night","background":null,"camera":{"fov_degrees":60},
                 "lights":[{"type":"point","position":[0,9,0],"intensity":2}]}}})");
  const Scene night = press(scene, "n");
  EXPECT_EQ(night.title, "night");
  EXPECT_EQ(night.background, Color{}) << "null: back to the default";
  EXPECT_EQ(night.camera.fov_degrees, 60);
  EXPECT_EQ(night.camera.location, (Vec3d{1, 2, 3})) << "what the patch does not name stays";
  ASSERT_EQ(night.lights.size(), 1U);
  EXPECT_EQ(night.lights[0], (Light{PointLight{Vec3d{0, 9, 0}}, {1, 1, 1}, 2}));
  EXPECT_EQ(night.keys, scene.keys);
  EXPECT_EQ(press(night, "n"), night) << "pressed again, nothing more changes";
}

TEST(Keys, PatchThatLeavesNoSceneIsRefused) {
  const Scene scene = read_scene(R"({"keys":{"k":{"light":[0,0,0],"title":"x"}}})");
  EXPECT_THROW(press(scene, "k"), InputError) << "a scene has no member `light`";
}

TEST(Keys, UnknownKeyIsRefusedWithTheKnownOnes) {
  using enum FaultKind;
  const Scene own = read_scene(R"({"keys":{"left":{"light":[1,2,3]},"right":{"light":[1,2,3]}}})");
  test::expect_faults(test::faults_of([&] { press(own, "lft"); }),
                      {{unknown_name, "/key", "\"lft\"", "one of left, right", "left"}});
  test::expect_faults(test::faults_of([&] { press(Scene{}, "q", "/somewhere"); }),
                      {{unknown_name, "/somewhere", "\"q\"", "one of a, d, s, w"}});
  test::expect_faults(test::faults_of([&] { press(Scene{}, ""); }),
                      {{unknown_name, "/key", "\"\"", "one of a, d, s, w"}});
}

// ---- the default keys, as seen from the camera --------------------------------------------------

// Where a point lies from the point looked at, in the picture's own terms: along the view axis and
// towards the picture's right and upper edge, perpendicular to the axis.
struct Offset {
  double depth, right, up;
};
Offset offset_from(const Camera& camera, const Vec3d& target, const Vec3d& p) {
  const View view = view_of(camera, 100, 100);
  const Vec3d axis = normalize(view.forward), way = p - target;
  const auto across = [&](const Vec3d& side) { return normalize(side - axis * dot(side, axis)); };
  return {dot(way, axis), dot(way, across(view.right)), dot(way, across(view.up))};
}

void expect_default_places(const Scene& scene, const Vec3d& target, double distance) {
  const auto pressed = [&](const char* key) {
    const Scene after = press(scene, key);
    const Vec3d place = place_of(after.key_light ? *after.key_light : after.lights.at(0));
    EXPECT_NEAR(length(place - target), distance, 1e-9 * (1 + distance)) << key;
    return offset_from(scene.camera, target, place);
  };
  const Offset a = pressed("a"), d = pressed("d"), s = pressed("s"), w = pressed("w");
  const double clearly = distance / 10;
  EXPECT_LT(a.right, -clearly) << "a: left";
  EXPECT_GT(d.right, clearly) << "d: right";
  EXPECT_NEAR(a.right, -d.right, 1e-9 * (1 + distance));
  EXPECT_GT(a.up, 0);
  EXPECT_GT(d.up, 0);
  EXPECT_GT(s.up, clearly) << "s: above";
  EXPECT_GT(w.up, clearly) << "w: above";
  EXPECT_LT(s.depth, -clearly) << "s: near the eye";
  EXPECT_GT(w.depth, clearly) << "w: far";
  EXPECT_NEAR(s.right, 0, 1e-9 * (1 + distance));
  EXPECT_NEAR(w.right, 0, 1e-9 * (1 + distance));
}

TEST(Keys, DefaultsAreLeftRightAboveNearAndAboveFarAroundThePointLookedAt) {
  Random random(150);
  for (int i = 0; i < 300; ++i) {
    Scene scene;
    scene.camera.location = random.point(10);
    scene.camera.look_at = random.point(10);
    scene.camera.up = random.direction();
    const Vec3d light = random.point(20);
    scene.lights.push_back(test::point_light(light));
    expect_default_places(scene, *scene.camera.look_at, length(light - *scene.camera.look_at));
  }
}

TEST(Keys, KeyLightMovesBeforeTheFirstLight) {
  Scene scene;
  scene.camera.look_at = Vec3d{0, 0, -20};
  scene.lights.push_back(test::point_light({100, 0, 0}));
  scene.key_light = test::sphere_light({0, 0, -13}, 3);  // 7 from the point looked at
  expect_default_places(scene, {0, 0, -20}, 7);
  EXPECT_EQ(press(scene, "a").lights, scene.lights);
}

TEST(Keys, WithoutALightTheEyesOwnDistanceServes) {
  Scene scene;
  scene.camera.location = {0, 0, 5};
  scene.camera.look_at = Vec3d{0, 0, -20};
  expect_default_places(scene, {0, 0, -20}, 25);
  const Scene after = press(scene, "d");
  ASSERT_EQ(after.lights.size(), 1U);
  EXPECT_TRUE(std::holds_alternative<PointLight>(after.lights[0].kind));
}

TEST(Keys, KeyLightThatWaitsForItsPlaceGoesAtTheEyesDistance) {
  Scene scene;
  scene.camera.look_at = Vec3d{0, 0, -20};
  scene.key_light.emplace().kind = SphereLight{std::nullopt, 3};
  expect_default_places(scene, {0, 0, -20}, 20);
}

TEST(Keys, WithoutAPointLookedAtTheObjectsMeanDepthServes) {
  Random random(151);
  for (int i = 0; i < 100; ++i) {
    Scene scene;
    scene.camera.location = random.point(3);
    scene.camera.direction = random.vector(0.1, 10);
    scene.camera.up = random.direction();
    const Vec3d axis = normalize(*scene.camera.direction);
    const double near = random.in(1, 5), far = random.in(6, 20);
    const Vec3d aside = cross(axis, random.direction());
    scene.objects = {test::ball(scene.camera.location + axis * near + aside, 1),
                     test::ball(scene.camera.location + axis * far - aside, 1)};
    const double depth = (near + far) / 2;
    expect_default_places(scene, scene.camera.location + axis * depth, depth);
  }
}

TEST(Keys, DefaultsFollowAViewPlaneAsItsPictureShowsIt) {
  Scene scene;
  scene.camera.direction = Vec3d{0, 0, -2};
  scene.camera.right = Vec3d{1, 0, 0};
  scene.camera.up = {0, 0.75, 0};
  scene.objects = {test::ball({0, 0, -10}, 1)};
  expect_default_places(scene, {0, 0, -10}, 10);
  scene.camera.right = Vec3d{-1, 0, 0};  // a mirrored picture: its left is the world's right
  expect_default_places(scene, {0, 0, -10}, 10);
  scene.camera.up = {0, -0.75, 0};  // and upside down
  expect_default_places(scene, {0, 0, -10}, 10);
}

TEST(Keys, TellWhetherTheyMoveTheLightAlone) {
  for (const Scene& scene : {Scene{}, test::thesis_scene()})
    for (const std::string_view key : keys_of(scene)) {
      EXPECT_TRUE(moves_light_only(scene, key));
      EXPECT_EQ(press(scene, key).objects, scene.objects);
    }
  Scene scene;
  scene.keys["b"] = Value(Value::Object{{"background", Value::Array{1, 1, 1}}});
  scene.keys["l"] = Vec3d{1, 2, 3};
  EXPECT_FALSE(moves_light_only(scene, "b"));
  EXPECT_TRUE(moves_light_only(scene, "l"));
}

// ---- a light's position -------------------------------------------------------------------------

TEST(WithLight, MovesTheKeyLightElseTheFirstLightElseAddsAPoint) {
  Scene scene;
  const Vec3d place{1, 2, 3};
  const Scene added = with_light(scene, place);
  ASSERT_EQ(added.lights.size(), 1U);
  EXPECT_EQ(added.lights[0], (Light{PointLight{place}, {1, 1, 1}, 1}));

  scene.lights = {test::sphere_light({9, 9, 9}, 2, {0.5, 0, 0}), test::point_light({8, 8, 8})};
  const Scene first = with_light(scene, place);
  EXPECT_EQ(first.lights[0], test::sphere_light(place, 2, {0.5, 0, 0})) << "all else stays";
  EXPECT_EQ(first.lights[1], scene.lights[1]);

  scene.key_light.emplace().kind = SphereLight{std::nullopt, 3};
  const Scene key = with_light(scene, place);
  EXPECT_EQ(key.key_light, test::sphere_light(place, 3));
  EXPECT_EQ(key.lights, scene.lights);
}

TEST(Press, EndsWhenThatIsAskedFor) {
  std::stop_source source;
  source.request_stop();
  Scene scene = test::thesis_scene();
  std::string list = "[";
  for (int i = 0; i < 3000; ++i)
    list += std::string(i > 0 ? "," : "") + R"({"type":"sphere","center":[0,0,0],"radius":1})";
  scene.keys["k"] = Value(Value::Object{{"objects", parse_json(list + "]")}});
  EXPECT_EQ(press(scene, "k", Middles{}).objects.size(), 3000U);
  EXPECT_THROW(press(scene, "k", Middles{}, "/key", source.get_token()), Stopped);
}

}  // namespace
}  // namespace tia
