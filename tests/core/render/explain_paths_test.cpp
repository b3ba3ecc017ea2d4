// Paths that are told are the picture's, and their groups its light, by closed forms.
#include "core/render/explain_paths.h"

#include "core/input/json.h"
#include "tests/core/integrators/paths.h"
#include "tests/core/random_scene.h"

namespace tia::test {
namespace {

PathExplanation told_of(const Scene& scene, const Vec3d& from, const Vec3d& way,
                        const RenderOptions& options) {
  return explain_paths(scene, compile(scene), Ray<double>{from, normalize(way)}, {}, options);
}
RenderOptions so_many(int samples, int max_depth = 16) {
  RenderOptions options;
  options.integrator = IntegratorName::path;
  options.samples = samples;
  options.max_depth = max_depth;
  return options;
}
const PathGroup* group(const PathExplanation& all, const std::string& expression) {
  for (const PathGroup& each : all.groups)
    if (each.expression == expression) return &each;
  return nullptr;
}
double light_by(const PathExplanation& all, const std::string& expression) {
  return group(all, expression) == nullptr ? 0 : group(all, expression)->mean.y;
}

Vec3f summed(const PathRecord& path) {
  Vec3f sum{0, 0, 0};
  for (const PathVertex& vertex : path.vertices)
    for (const GatheredLight& light : vertex.lights) sum = sum + light.value;
  return sum * path.clamp;
}
void expect_groups_add_up(const PathExplanation& all) {
  Vec3d sum{};
  double shares = 0;
  for (const PathGroup& each : all.groups) {
    sum = sum + each.mean, shares += each.share;
    EXPECT_GE(each.paths, 1);
    EXPECT_LE(each.paths, all.count);
  }
  expect_near(all.mean, sum, 1e-6 * std::max({1.0, sum.x, sum.y, sum.z}));
  if (sum.x > 0 && sum.y > 0 && sum.z > 0) {
    EXPECT_NEAR(shares, 1, 1e-5);
  }
}

// ---- the picture's ------------------------------------------------------------------------------

// Of everything that path knows: materials of all kinds, lights of all kinds, fog, clamping.
Scene scene_of_all(int seed) {
  Random random(static_cast<std::uint64_t>(seed) + 700);
  Scene scene = random_scene(static_cast<std::uint64_t>(seed));
  for (int i = 0; i < 6; ++i) {
    const Vec3d center = random.point(8) + Vec3d{0, 0, -18};
    const Material material{random_principled(random)};
    scene.objects.push_back(ball(center, random.in(0.5, 3), material));
  }
  Principled prism;
  prism.transmission = 1.0, prism.roughness = 0.0, prism.dispersion = 0.5;
  scene.objects.push_back(ball(random.point(4) + Vec3d{0, 0, -15}, 2, {prism}));
  Light quad;
  quad.kind = QuadLight{random.point(9), {3, 0, 0}, {0, 0, 3}};
  scene.lights.push_back(light_of(DirectionalLight{random.direction()}));
  scene.lights.push_back(quad);
  if (seed % 3 == 1) scene.fog.emplace().density = 0.03;
  return scene;
}

TEST(ExplainedPaths, AddUpToThePictureBitForBit) {
  Random random(911);
  constexpr int width = 16, height = 12;
  int parted = 0, dimmed = 0;
  for (int seed = 0; seed < 12; ++seed) {
    const Scene scene = scene_of_all(seed);
    const World world = compile(scene);
    const View view = view_of(scene.camera, width, height);
    std::vector<ExplainedPath> before;
    const int x = random.below(width), y = random.below(height);
    for (const int samples : {1, 2, 3, 5, 24}) {
      SCOPED_TRACE(seed * 100 + samples);
      RenderOptions options = so_many(samples);
      options.seed = seed;
      if (seed % 4 == 2) options.clamp = 0.3;
      const Image image = picture(world, view, {x, y, x + 1, y + 1}, options).image;
      const PathExplanation all =
          explain_paths(scene, compile(scene), view, x, y, {0, samples}, options);
      EXPECT_EQ(all.mean, (Vec3f{image.rgb[0], image.rgb[1], image.rgb[2]}));
      EXPECT_EQ(all.count, samples);
      Vec3d sum{};
      for (const auto& [sample, path] : all.paths) {
        EXPECT_EQ(summed(path), path.color);
        sum = sum + static_cast<Vec3d>(path.color);
        parted += path.wave > 0, dimmed += path.clamp < 1;
      }
      EXPECT_EQ(all.mean, static_cast<Vec3f>(sum * (1.0 / samples)));
      expect_groups_add_up(all);
      const std::size_t bytes = to_json(value_of(all)).size();
      EXPECT_LE(bytes, all.ray.most_bytes);
      EXPECT_LE(all.ray.most_bytes, 3 * bytes + 4096);
      // Those of a picture with less samples are its first; one alone goes through the centre.
      for (std::size_t i = 0; i < before.size(); ++i)
        EXPECT_EQ(all.paths[i].path.color, before[i].path.color);
      if (samples > 1) before = {all.paths.begin(), all.paths.end()};
    }
  }
  EXPECT_GT(std::min(parted, dimmed), 0);
}

// ---- shares in closed form ----------------------------------------------------------------------

// Two endless parallel planes, the upper one of emission 1. All that a point of the lower one sees
// is the upper one, so that light comes to it evenly: a floor of albedo f sends on f; of that the
// ceiling, of albedo c, sends back c f, of which the floor sends on c f^2, and so on: only every
// other number of bounces is seen from above the floor.
TEST(ExplainedPaths, SharesBetweenParallelPlanesAreTheirGeometricSeries) {
  const double f = 0.8, c = 0.6;
  Scene scene;
  scene.objects = {object(Plane{{0, 0, 0}, {0, 1, 0}}, matt(f)),
                   object(Plane{{0, 2, 0}, {0, -1, 0}}, glowing(1, c))};
  const PathExplanation all = told_of(scene, {0, 1, 0}, {0.2, -1, 0.1}, so_many(rounds(4096), 64));
  ASSERT_EQ(all.groups.size(), 4U);
  EXPECT_NEAR(light_by(all, "DE"), f, 1e-5);
  EXPECT_NEAR(light_by(all, "DDDE"), f * c * f, 1e-5);
  // Paths end by chance from the fifth vertex on.
  const PathGroup &fifth = *group(all, "DDDDDE"), &longer = *group(all, "*E");
  EXPECT_NEAR(fifth.mean.y, f * c * f * c * f, 4 * fifth.error.y + 1e-5);
  EXPECT_NEAR(longer.mean.y, std::pow(c * f, 3) * f / (1 - c * f), 4 * longer.error.y + 1e-5);
  EXPECT_NEAR(group(all, "DE")->share, 1 - c * f, 0.02);
  EXPECT_EQ(all.groups.front().expression, "DE") << "the greatest is the first";
  expect_groups_add_up(all);
  // All but what comes straight has come over the ceiling, whatever it did before.
  ASSERT_EQ(all.surfaces.size(), 1U);
  const PathSurface& ceiling = all.surfaces[0];
  EXPECT_EQ(ceiling.object, 1);
  EXPECT_NEAR(ceiling.mean.y, f * c * f / (1 - c * f), 4 * ceiling.error.y + 1e-5);
  EXPECT_NEAR(ceiling.share, 1 - group(all, "DE")->share, 1e-5);
}

// Of a wall seen through glass the light came over the wall, not over the glass's other side; of
// what a mirror shows over that.
TEST(ExplainedPaths, WhatLightCameOverIsTheNearestThatDidMoreThanLetItThrough) {
  const auto over = [](const Finish& nearer) {
    Scene scene;
    scene.objects = {object(Sphere{{0, 0, -5}, 1}, nearer),
                     object(Plane{{0, 0, -9}, {0, 0, 1}}, matt(0.5)),
                     object(Plane{{0, 0, 9}, {0, 0, -1}}, glowing(1, 0.5))};
    const PathExplanation all = told_of(scene, {0, 0, 0}, {0, 0, -1}, so_many(256));
    return all.surfaces.empty() ? -1 : all.surfaces.front().object;
  };
  EXPECT_EQ(over(clear_glass(1.5)), 1);
  EXPECT_EQ(over(mirror(0.7)), 2);
}

// Around a furnace of albedo rho and emission 1: 1 is seen, each bounce sends on rho of the one
// before, by its own direction and by asking alike.
TEST(ExplainedPaths, SharesOfAFurnaceAreItsGeometricSeries) {
  const double rho = 0.5;
  Scene furnace;
  furnace.objects = {object(Sphere{{0, 0, 0}, 5}, glowing(1, rho))};
  const PathExplanation all = told_of(furnace, {1, 2, 0}, {1, 0.3, -2}, so_many(rounds(4096), 40));
  std::string bounces;
  for (int i = 0; i < 6; ++i) {
    const PathGroup& way = *group(all, bounces + "E");
    EXPECT_NEAR(way.mean.x, std::pow(rho, i), 4 * way.error.x + 1e-5) << bounces;
    EXPECT_NEAR(way.share, std::pow(rho, i) * (1 - rho), 4 * way.error.x + 0.02) << bounces;
    bounces += 'D';
  }
  const PathGroup& longer = *group(all, "*E");
  EXPECT_NEAR(longer.mean.x, std::pow(rho, 6) / (1 - rho), 4 * longer.error.x + 1e-5);
  EXPECT_EQ(all.groups.size(), 7U);
  const auto by_chance = [](const auto& told) { return told.path.end == PathEnd::roulette; };
  EXPECT_GT(std::ranges::count_if(all.paths, by_chance), 8) << "of 16, in 40 bounces";
}

// In a background of 1, each alone sends all of it on.
TEST(ExplainedPaths, LettersSayWhichWayItCame) {
  const auto seen = [](const Material& material, const Vec3d& way = {0, 0, -1}) {
    Scene scene;
    scene.background = {1, 1, 1};
    scene.objects = {{"", Sphere{{0, 0, -5}, 1}, {}, MaterialRef(material)}};
    return told_of(scene, {0, 0, 0}, way, so_many(64));
  };
  EXPECT_NEAR(light_by(seen({mirror(0.7)}), "SE"), 0.7, 1e-6);
  EXPECT_NEAR(light_by(seen({clear_glass(1.5)}), "TTE"), 1, 1e-5);
  EXPECT_NEAR(light_by(seen({matt(0.4)}), "DE"), 0.4, 1e-6);
  EXPECT_EQ(light_by(seen({matt(0.4)}, {0, 1, 0}), "E"), 1);
  Principled metal;
  metal.metallic = 1.0, metal.roughness = 0.3;
  EXPECT_GT(group(seen({metal}), "GE")->share, 0.9);
  Scene foggy;
  foggy.background = {1, 1, 1};
  foggy.fog.emplace().density = 0.5;
  Bounds& box = foggy.fog->bounds.emplace();
  box.min = Vec3d{-1, -1, -3}, box.max = Vec3d{1, 1, -1};
  const PathExplanation fog = told_of(foggy, {0, 0, 0}, {0, 0, -1}, so_many(256));
  EXPECT_NEAR(light_by(fog, "E"), std::exp(-1.0), 1e-5);
  EXPECT_GT(light_by(fog, "VE"), light_by(fog, "VVE"));
  EXPECT_NEAR(fog.mean.y, 1, 0.05);
  EXPECT_TRUE(fog.surfaces.empty());
}

// ---- a path's vertices --------------------------------------------------------------------------

TEST(ExplainedPaths, EndAsTheyDo) {
  const auto end_of = [](const Material& material, int max_depth) {
    Scene scene;
    scene.background = {1, 1, 1};
    scene.objects = {{"", Plane{{0, 0, 0}, {0, 1, 0}}, {}, MaterialRef(material)}};
    const PathExplanation all = told_of(scene, {0, 1, 0}, {0, -1, 0.1}, so_many(1, max_depth));
    return all.paths.at(0).path.end;
  };
  EXPECT_EQ(end_of({matt(0.5)}, 16), PathEnd::left);
  EXPECT_EQ(end_of({matt(0)}, 16), PathEnd::absorbed);
  EXPECT_EQ(end_of({matt(0.5)}, 0), PathEnd::cut);
  EXPECT_EQ(end_of({matt(0)}, 0), PathEnd::absorbed);
}

// E = I cos / d^2; a matt floor sends on albedo / pi of it, and of two lamps one is asked.
TEST(ExplainedPaths, TellWhichLightWasAskedAndWithWhatChance) {
  const double albedo = 0.6;
  Scene scene;
  scene.objects = {object(Plane{{0, 0, 0}, {0, 1, 0}}, matt(albedo))};
  scene.lights = {point_light({0, 2, 0}, {3, 3, 3}), point_light({0, 2, 4}, {1, 1, 1})};
  const PathExplanation all = told_of(scene, {1, 1, 0}, {-1, -1, 0}, so_many(16));
  double chances = 0;
  for (int which = 0; which < 2; ++which) {
    const GatheredLight* found = nullptr;
    for (const auto& [sample, path] : all.paths) {
      const GatheredLight& light = path.vertices.at(0).lights.at(0);
      if (light.light == which) found = &light;
    }
    ASSERT_NE(found, nullptr);
    const double z = 4.0 * which, square = 4 + z * z, intensity = which == 0 ? 3 : 1;
    EXPECT_TRUE(found->asked);
    EXPECT_EQ(found->event, PathEvent::diffuse);
    EXPECT_NEAR(found->distance, std::sqrt(square), 1e-5);
    EXPECT_NEAR(found->bsdf.x, albedo / pi * 2 / std::sqrt(square), 1e-5);
    EXPECT_NEAR(found->value.x, found->bsdf.x * intensity / square / found->chance, 1e-5);
    EXPECT_EQ(found->pdf, found->chance);
    EXPECT_EQ(found->weight * found->visible, 1);
    chances += found->chance;
  }
  EXPECT_NEAR(chances, 1, 1e-6);
}

// What light counts at a vertex is the product of what the ones before have sent on.
TEST(ExplainedPaths, ThroughputIsTheProductOfWeights) {
  int vertices = 0;
  for (int seed = 0; seed < 6; ++seed) {
    const Scene scene = random_scene(static_cast<std::uint64_t>(seed));
    const View view = view_of(scene.camera, 8, 8);
    const PathExplanation all =
        explain_paths(scene, compile(scene), view, seed, 5, {8, 40}, so_many(64));
    EXPECT_EQ(all.paths.front().sample, 8);
    EXPECT_EQ(all.ray.pixel->sample, 8);
    for (const auto& [sample, path] : all.paths)
      for (std::size_t i = 0; i + 1 < path.vertices.size(); ++i, ++vertices) {
        const PathVertex& at = path.vertices[i];
        const Vec3f sent = at.throughput * at.weight * (1 / at.survival);
        expect_near(path.vertices[i + 1].throughput, static_cast<Vec3d>(sent), 1e-5);
      }
  }
  EXPECT_GT(vertices, 100);
}

}  // namespace
}  // namespace tia::test
