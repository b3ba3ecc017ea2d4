// Scene -> canonical text -> the same scene.
#include <gtest/gtest.h>

#include "core/scene/read_scene.h"
#include "tests/core/random_scene.h"

namespace tia {
namespace {

using test::Random;

Finish random_finish(Random& random) {
  Finish finish;
  finish.color = test::random_color(random);
  finish.diffuse = random.unit();
  finish.ambient = random.unit();
  finish.transmission = random.unit();
  finish.ior = 1 + random.unit();
  finish.fresnel = random.chance(0.5);
  finish.absorption = test::random_color(random);
  return finish;
}

// A random scene with everything else that a scene can hold.
Scene dressed_scene(std::uint64_t seed) {
  Scene scene = test::random_scene(seed);
  Random random(seed + 1000);
  const std::string names[] = {"a", "\xC3\xA9", "with/slash~", "\xF0\x9F\x98\x80", "\"quoted\"\n"};
  const auto name = [&] { return names[random.below(5)]; };
  if (random.chance(0.7)) scene.title = name();
  if (random.chance(0.5)) scene.description = name();
  for (int i = random.below(4); i > 0; --i)
    scene.materials[name()] = Material{random_finish(random)};
  for (Object& object : scene.objects.edit()) {
    if (random.chance(0.5)) object.name = name();
    if (random.chance(0.3)) object.material.reset();
    else if (!scene.materials.empty() && random.chance(0.5))
      object.material = scene.materials.begin()->first;
  }
  for (int i = random.below(4); i > 0; --i) {
    if (random.chance(0.7)) scene.keys[name()] = random.point(1e9);
    else scene.keys[name()] = Value(Value::Object{{"background", 1}, {"title", Value()}});
  }
  if (random.chance(0.3)) scene.key_light = Light{SphereLight{std::nullopt, random.unit() + 1e-9}};
  if (random.chance(0.5)) scene.options.transfer = static_cast<Transfer>(random.below(4));
  if (random.chance(0.5)) scene.options.exposure = random.in(-32, 32);
  if (random.chance(0.5)) scene.options.white_balance_kelvin = random.in(1000, 25'000);
  if (random.chance(0.5))
    scene.options.seed = static_cast<std::int64_t>(random.unit() * SceneOptions::last_seed);
  return scene;
}

TEST(CanonicalScene, RandomScenesReadBackEqual) {
  for (std::uint64_t seed = 0; seed < 500; ++seed) {
    const Scene scene = dressed_scene(seed);
    const std::string text = canonical_text(scene);
    ASSERT_EQ(read_scene(text), scene) << text;
    ASSERT_EQ(canonical_text(read_scene(text)), text);
  }
}

TEST(CanonicalScene, FieldsAtTheirDefaultsAreLeftOut) {
  EXPECT_EQ(canonical_text(Scene{}), "{}");
  EXPECT_EQ(canonical_text(read_scene(R"({
    "title": "", "description": "", "background": [0,0,0], "materials": {}, "objects": [],
    "lights": [], "keys": {}, "options": {"transfer": "srgb", "seed": 0},
    "camera": {"location": [0,0,0], "up": [0,1,0], "fov_degrees": 25}})")),
            "{}");
}

TEST(CanonicalScene, TextIsSortedShortestAndWithoutSpaces) {
  const Scene scene = read_scene(R"({
    "options": {"transfer": "linear"},
    "objects": [
      {"type": "sphere", "radius": 4.0, "center": [0, 0, -2e1], "name": "ball", "material": "m"},
      {"type": "sphere", "radius": 10000, "center": [0,-10004,-20],
       "material": {"color": 0.2, "type": "finish", "diffuse": 1}}],
    "materials": {"m": {"type": "finish", "color": [1, 1, 1]}},
    "lights": [{"type": "point", "position": [1, 2, 3], "intensity": 1}],
    "keys": {"a": {"light": [-20, 20, -10]}},
    "camera": {"look_at": [0, 0, -1], "fov_degrees": 25.0}})");
  EXPECT_EQ(canonical_text(scene),
            R"({"camera":{"look_at":[0,0,-1]},"keys":{"a":{"light":[-20,20,-10]}},)"
            R"("lights":[{"position":[1,2,3],"type":"point"}],"materials":{"m":{}},)"
            R"("objects":[{"center":[0,0,-20],"material":"m","name":"ball","radius":4,)"
            R"("type":"sphere"},{"center":[0,-10004,-20],"material":{"color":[0.2,0.2,0.2]},)"
            R"("radius":10000,"type":"sphere"}],"options":{"transfer":"linear"}})");
}

TEST(CanonicalScene, OrderAndSpellingDoNotMatter) {
  const char* spellings[] = {
      R"({"title":"\u00e9","background":[0.5,0.5,0.5],"camera":{"up":[0,2,0],"location":[0,0,1]}})",
      "{ \"camera\": {\"location\": [-0, 0.0, 1e0], \"up\": [0, 20e-1, 0]},\n"
      "  \"background\": 0.50, \"title\": \"\xC3\xA9\", \"objects\": [] }"};
  EXPECT_EQ(canonical_text(read_scene(spellings[0])), canonical_text(read_scene(spellings[1])));
  EXPECT_EQ(read_scene(spellings[0]), read_scene(spellings[1]));
}

TEST(CanonicalScene, OrderOfAPatchsMembersDoesNotMatter) {
  const Scene a = read_scene(R"({"keys":{"k":{"title":"x","background":1}}})");
  const Scene b = read_scene(R"({"keys":{"k":{"background":1,"title":"x"}}})");
  EXPECT_EQ(canonical_text(a), canonical_text(b));
  EXPECT_EQ(a, b) << "equal text, equal scenes";
}

TEST(CanonicalScene, WhatDiffersReadsDifferent) {
  Scene scene = test::thesis_scene();
  const std::string text = canonical_text(scene);
  std::get<Sphere>(scene.objects[0].shape).radius = std::nextafter(4.0, 5.0);
  EXPECT_NE(canonical_text(scene), text);
  scene = test::thesis_scene();
  std::swap(scene.objects[0], scene.objects[1]);  // at equal distance the earlier object wins
  EXPECT_NE(canonical_text(scene), text);
}

}  // namespace
}  // namespace tia
