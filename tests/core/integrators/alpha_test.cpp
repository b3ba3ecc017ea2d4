// What alpha means: masks, and surfaces that are there in part, by what is left of all behind them.
#include <gtest/gtest.h>

#include <array>

#include "tests/core/integrators/alphas.h"
#include "tests/core/random_scene.h"
#include "tests/sanitizer.h"

namespace tia {
namespace {

using namespace test;

// ---- a stack of sheets --------------------------------------------------------------------------

// Glowing sheets one below the other, before a background.
struct Sheets {
  Scene scene;
  std::vector<double> alphas;
  std::vector<Vec3d> lights;  // the last is the background's

  Sheets(Random& random, int count) {
    for (int i = 0; i < count; ++i) {
      alphas.push_back(random.unit());
      const Vec3d light = random.point(1) + Vec3d{1, 1, 1};
      lights.push_back(light);
      scene.objects.push_back(wearing_principled(
          plane_at(-i), glowing({light.x / 2, light.y / 2, light.z / 2}, alphas.back())));
      lights.back() = light * 0.5;
    }
    lights.push_back({0.3, 0.5, 0.7});
    scene.background = {0.3, 0.5, 0.7};
    scene.camera = camera_above(1);
  }
  // alpha_i times all 1 - alpha_j before it. Source: Porter and Duff, "Compositing digital images"
  // (1984), the operator over.
  std::vector<double> weights() const {
    std::vector<double> all;
    double left = 1;
    for (const double alpha : alphas) all.push_back(left * alpha), left *= 1 - alpha;
    all.push_back(left);
    return all;
  }
  Vec3d mean() const {
    Vec3d sum{};
    for (std::size_t i = 0; i < lights.size(); ++i) sum = sum + lights[i] * weights()[i];
    return sum;
  }
};

TEST(Alpha, BlendedSheetsWeighWhatIsLeftOfAllBeforeThem) {
  Random random(2201);
  for (int i = 0; i < 40; ++i) {
    const Sheets sheets(random, random.whole(1, 12));
    const double angle = random.in(0, 1.2);
    expect_near(tree(sheets.scene, slanted(angle) * -2.0, slanted(angle))->color, sheets.mean(),
                2e-6);
  }
}

TEST(Alpha, PathsMeetOneSheetEachByChanceAndTheirMeanIsTheSum) {
  Random random(2202);
  for (int i = 0; i < 6; ++i) {
    const Sheets sheets(random, random.whole(1, 6));
    const Image one = seen_by(sheets.scene, IntegratorName::path);
    for (std::size_t k = 0; k < one.rgb.size(); k += 3) {
      const auto is_seen = [&](const Vec3d& light) {
        return std::fabs(one.rgb[k] - light.x) < 1e-6 && std::fabs(one.rgb[k + 1] - light.y) < 1e-6;
      };
      EXPECT_TRUE(std::any_of(sheets.lights.begin(), sheets.lights.end(), is_seen));
    }
    constexpr int samples = 256;
    const Image many = seen_by(sheets.scene, IntegratorName::path, samples);
    double mean = 0, square = 0;
    for (std::size_t k = 0; k < many.rgb.size(); k += 3) mean += many.rgb[k];
    mean /= alpha_cells * alpha_cells;
    for (std::size_t k = 0; k < sheets.lights.size(); ++k)
      square += sheets.weights()[k] * std::pow(sheets.lights[k].x - sheets.mean().x, 2);
    const double error = std::sqrt(square / (samples * alpha_cells * alpha_cells));
    EXPECT_NEAR(mean, sheets.mean().x, 4 * error + 1e-6);
  }
}

// 1 - (1 - a)^64 of them, and the 65th whole.
TEST(Alpha, BehindSixtyFourSheetsTheNextCountsAsWhole) {
  Scene scene;
  for (int i = 0; i < 80; ++i) {
    const double light = i < 64 ? 0 : i == 64 ? 1 : 0.5;
    scene.objects.push_back(wearing_principled(plane_at(-i), glowing({light, light, light}, 0.01)));
  }
  const double left = std::pow(0.99, 64);
  expect_near(tree(scene, {0, 2, 0}, {0, -1, 0})->color, Vec3d{left, left, left}, 1e-5);
}

TEST(Alpha, WhatIsThereInPartMirrorsAndScattersInPart) {
  Random random(2203);
  for (int i = 0; i < 40; ++i) {
    Principled p;
    p.metallic = random.unit(), p.roughness = random.unit();
    p.emissive = {0.5, 0.25, 1};
    Scene scene;
    scene.background = {0.2, 0.3, 0.4};
    scene.lights = {point_light({1, 3, 2})};
    scene.objects = {wearing_principled(plane_at(0), p)};
    const Vec3d from = slanted(0.7) * -2.0, way = slanted(0.7);
    const auto whole = tree(scene, from, way);
    const double alpha = random.in(0.1, 0.9);
    p.alpha = alpha, p.alpha_mode = AlphaMode::blend;
    scene.objects = {wearing_principled(plane_at(0), p)};
    const auto part = tree(scene, from, way);
    for (const TermName name : {TermName::emission, TermName::diffuse, TermName::reflection})
      EXPECT_NEAR(term(*part, name)->weight, alpha * double(term(*whole, name)->weight), 1e-6);
    EXPECT_NEAR(term(*part, TermName::straight)->weight, 1 - alpha, 1e-6);
    EXPECT_EQ(child(*part, TermName::straight)->depth, 0);
    const Vec3d behind{0.2, 0.3, 0.4};
    const Vec3d mean = static_cast<Vec3d>(whole->color) * alpha + behind * (1 - alpha);
    expect_near(part->color, mean, 2e-6);
  }
}

// ---- what changes nothing -----------------------------------------------------------------------

TEST(Alpha, OfWhatIsOpaqueOrOneChangesNoByte) {
  Random random(2204);
  Scene scene;
  scene.background = {0.3, 0.4, 0.6};
  scene.camera.location = {0, 1, 6};
  scene.camera.look_at = Vec3d{0, 0, 0};
  scene.lights = {point_light({3, 5, 4}, {20, 20, 20})};
  std::vector<Principled> all;
  for (int i = 0; i < 6; ++i) all.push_back(random_principled(random));
  const auto drawn = [&](IntegratorName integrator, const NumberOrTexture& alpha, AlphaMode mode) {
    scene.objects.edit().clear();
    for (std::size_t i = 0; i < all.size(); ++i) {
      Principled p = all[i];
      p.alpha = alpha, p.alpha_mode = mode;
      scene.objects.push_back(wearing_principled(Sphere{{double(i) - 2.5, 0, 0}, 0.6}, p));
    }
    RenderOptions options;
    options.integrator = integrator;
    options.samples = 2;
    return bits_of(picture(scene, 21, 17, options).image);
  };
  for (const auto integrator : {IntegratorName::path, IntegratorName::whitted}) {
    const auto usual = drawn(integrator, 1, AlphaMode::opaque);
    EXPECT_EQ(drawn(integrator, 0.25, AlphaMode::opaque), usual);
    EXPECT_EQ(drawn(integrator, 1, AlphaMode::blend), usual);
    EXPECT_EQ(drawn(integrator, 0.5, AlphaMode::mask), usual);
    EXPECT_EQ(drawn(integrator, checkered(1, 1), AlphaMode::blend), usual);
    EXPECT_NE(drawn(integrator, 0.5, AlphaMode::blend), usual);
    EXPECT_NE(drawn(integrator, 0.25, AlphaMode::mask), usual);
  }
}

TEST(Alpha, NeitherThreadsNorTilesNorLanesChangeAByte) {
  Random random(2205);
  Scene scene;
  scene.background = {0.3, 0.4, 0.6};
  scene.camera.location = {0, 0, 5};
  scene.camera.look_at = Vec3d{0, 0, 0};
  scene.lights = {point_light({3, 5, 4}, {20, 20, 20}), sphere_light({-3, 3, 1}, 0.5, {5, 5, 5})};
  for (int i = 0; i < 12; ++i) {
    Principled p = random_principled(random);
    p.alpha_mode = random.chance(0.5) ? AlphaMode::mask : AlphaMode::blend;
    const double alpha = random.unit();
    p.alpha = random.chance(0.5) ? NumberOrTexture(checkered(0.2, 0.9)) : NumberOrTexture(alpha);
    p.double_sided = random.chance(0.5);
    scene.objects.push_back(wearing_principled(Sphere{random.point(1.5), random.in(0.2, 0.8)}, p));
  }
  const int width = test::sanitized() ? 15 : 37;
  for (const bool transparent : {false, true})
    for (const auto integrator : {IntegratorName::path, IntegratorName::whitted,
                                  IntegratorName::ambient_occlusion, IntegratorName::depth}) {
      scene.options.transparent_shadows = transparent;
      RenderOptions options;
      options.integrator = integrator;
      options.samples = 3;
      const auto usual = bits_of(picture(scene, width, 29, options).image);
      options.scalar = Scalar::narrow;
      options.threads = 3, options.tile = 7;
      EXPECT_EQ(bits_of(picture(scene, width, 29, options).image), usual);
    }
}

TEST(Alpha, ExplainedPixelsHaveThePicturesColour) {
  Random random(2206);
  Scene scene;
  scene.camera.location = {0, 0, 5};
  scene.camera.look_at = Vec3d{0, 0, 0};
  scene.background = {0.3, 0.4, 0.6};
  scene.lights = {point_light({3, 5, 4}, {20, 20, 20})};
  for (int i = 0; i < 8; ++i) {
    Principled p = random_principled(random);
    p.alpha_mode = i % 2 == 0 ? AlphaMode::mask : AlphaMode::blend;
    p.alpha = checkered(0.2, 0.9);
    scene.objects.push_back(wearing_principled(Sphere{random.point(1), random.in(0.3, 0.9)}, p));
  }
  const RenderOptions options = at_depth(3);
  const View view = view_of(scene.camera, 12, 9);
  const Image image = picture(scene, 12, 9, options).image;
  int parts = 0;
  for (int y = 0; y < 9; ++y)
    for (int x = 0; x < 12; ++x) {
      const auto told = explain(scene, compile(scene), view, x, y, 0, options);
      const Vec3f color = told.tree->color;
      EXPECT_EQ((std::array{color.x, color.y, color.z}),
                (std::array{image.at(x, y)[0], image.at(x, y)[1], image.at(x, y)[2]}));
      parts += term(*told.tree, TermName::straight) != nullptr;
      if (told.tree->hit.primitive < 0) continue;
      ASSERT_FALSE(told.hits.empty());
      EXPECT_EQ(told.hits.front().primitive, static_cast<int>(told.tree->hit.primitive));
      EXPECT_NEAR(told.hits.front().t, told.tree->hit.t, 1e-4);
    }
  EXPECT_GT(parts, 10);
}

}  // namespace
}  // namespace tia
