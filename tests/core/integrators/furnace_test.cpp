// White furnaces in path: what loses no light cannot be seen before light that comes from all
// around, and in a closed space light adds up to a geometric series.
#include "tests/core/integrators/paths.h"

namespace tia {
namespace {

using namespace test;

Scene luminous_ball(const Vec3d& center, double radius, double albedo, double emitted) {
  Scene scene;
  Finish wall = matt(albedo);
  wall.emission = {emitted, emitted, emitted};
  scene.objects = {object(Sphere{center, radius}, wall)};
  return scene;
}
Light white_sky() {
  Image8 white(4, 2);
  for (auto& code : white.rgb) code = 255;
  return image_light(encode_png(white));
}

// In a closed ball every path goes on: the light is that of the first, second, ... wall, each the
// albedo darker.
TEST(Furnace, CutAfterSomeEventsIsThePartialSum) {
  Random random(820);
  for (int depth = 0; depth < 5; ++depth) {
    const double albedo = random.in(0.2, 0.9), emitted = random.in(0.5, 2);
    const Scene scene = luminous_ball(random.point(3), 9, albedo, emitted);
    const double expected = emitted * (1 - std::pow(albedo, depth + 1)) / (1 - albedo);
    const Mean mean = light_from(scene, {0, 0, 0}, random.direction(), 64, depth, 2);
    EXPECT_NEAR(mean.value, expected, 1e-5 * expected) << depth;
  }
}
TEST(Furnace, IsTheWholeSumWhereverPathsEndByChance) {
  Random random(837);
  for (int i = 0; i < rounds(4, 4); ++i) {
    const double albedo = random.in(0.2, 0.8), emitted = random.in(0.5, 2);
    const Scene scene = luminous_ball({0, 0, 0}, 2, albedo, emitted);
    expect_mean(light_from(scene, random.vector(0, 1.9), random.vector(2, 3), 1024, 64),
                emitted / (1 - albedo));
  }
}

// Where the scene has no light, only what surfaces draw finds those that shine.
TEST(Furnace, OfABoxNeedsNoLight) {
  Scene scene;
  Finish wall = matt(0.5);
  wall.emission = {1, 1, 1};
  scene.objects = {object(Box{{-1, -1, -1}, {1, 1, 1}}, wall)};
  const Mean mean = light_from(scene, {0, 0, 0}, {0.2, 1, 0.1}, 64, 3, 2);
  EXPECT_NEAR(mean.value, 1.875, 1e-5);
}

// What a ball sends to an eye that sees it at the cosine mu, lit by what it draws alone, or by what
// is drawn of the sky as well.
Mean of_white_ball(const Material& material, double mu, int samples, Random& random) {
  Scene scene;
  scene.background = {1, 1, 1};
  scene.objects = {{"", Sphere{{0, 0, 0}, 1}, {}, MaterialRef(material)}};
  if (random.chance(0.5)) scene.lights = {white_sky()};
  const Onb frame = onb_around(random.direction());
  const Vec3d wo = frame.n * mu + frame.u * std::sqrt(1 - mu * mu);
  return colors_from(scene, frame.n + wo * 4.0, frame.n, by_paths(samples, 64), 2)[1];
}
constexpr double five_angles[] = {0.05, 0.25, 0.5, 0.75, 1};

TEST(Furnace, FinishesThatLoseNoLightCannotBeSeen) {
  Random random(821);
  Finish shiny = matt(1);
  shiny.reflection = 0.5;
  for (const Finish& finish :
       {matt(1), mirror(1), shiny, glass(1.5), glass(0.7), glass(2.4), clear_glass(1.5)})
    for (const double mu : five_angles)
      expect_mean(of_white_ball({finish}, mu, 512, random), 1, 1e-4);
}

// Every lobe, alone and over others.
struct WhiteKind {
  const char* name;
  int samples;
  void (*set)(Principled&);
};
const WhiteKind white_kinds[] = {
    {"plastic", 64, [](Principled&) {}},
    {"metal", 64, [](Principled& p) { p.metallic = 1; }},
    {"glass", 256, [](Principled& p) { p.transmission = 1; }},
    {"prism", 512, [](Principled& p) { p.transmission = 1, p.dispersion = 0.5; }},
    {"pane", 128, [](Principled& p) { p.transmission = 1, p.thin = true; }},
    {"coated", 64,
     [](Principled& p) {
       p.clearcoat = 1, p.clearcoat_roughness = std::get<double>(p.roughness) / 2;
     }},
    {"cloth", 128,
     [](Principled& p) {
       p.sheen_color = {1, 1, 1}, p.sheen_roughness = p.roughness;
     }},
    {"mixed", 64, [](Principled& p) { p.metallic = 0.5; }}};

// Within 1 % at every roughness and angle: a path in rough glass counts what its chances make it,
// so that only all of a kind's together are known to a quarter of a percent.
TEST(Furnace, PrincipledMaterialsThatLoseNoLightCannotBeSeen) {
  Random random(834);
  for (const WhiteKind& kind : white_kinds) {
    // The prism takes two fifths of the time, for what is the glass's but for its index.
    if (sanitized() && kind.samples > 256) continue;
    double sum = 0, variance = 0;
    for (const double roughness : {0.0, 0.25, 0.5, 0.75, 1.0})
      for (const double mu : five_angles) {
        Principled principled;
        principled.roughness = roughness;
        kind.set(principled);
        const Mean mean = of_white_ball({principled}, mu, kind.samples, random);
        EXPECT_NEAR(mean.value, 1, 0.01 + 4 * mean.error)
            << kind.name << ' ' << roughness << ' ' << mu;
        sum += mean.value / 25, variance += mean.error * mean.error / (25 * 25);
      }
    expect_mean({sum, std::sqrt(variance)}, 1, 0.01);
  }
}

}  // namespace
}  // namespace tia
