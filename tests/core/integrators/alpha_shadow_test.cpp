// Light through what is there in part: shadows, and what glows and is there in part.
#include <gtest/gtest.h>

#include "tests/core/integrators/alphas.h"

namespace tia {
namespace {

using namespace test;

Light sun_above() {
  DirectionalLight sun;
  sun.direction = {0, -1, 0};
  return light_of(sun);
}
// Black panes over a white floor under a sun, the camera below the panes.
Scene floor_under(const std::vector<Principled>& panes) {
  Scene scene;
  scene.camera = camera_above(1);
  scene.objects = {object(plane_at(0), Finish{})};
  for (std::size_t i = 0; i < panes.size(); ++i)
    scene.objects.push_back(wearing_principled(plane_at(2 + double(i)), panes[i]));
  scene.lights = {sun_above()};
  return scene;
}
double light_below(const std::vector<Principled>& panes, IntegratorName integrator,
                   bool transparent = false) {
  Scene scene = floor_under(panes);
  scene.options.transparent_shadows = transparent;
  return seen_by(scene, integrator, 1, 1).rgb[0];
}

TEST(AlphaShadow, EachPaneLeavesWhatItDoesNotCover) {
  Random random(2211);
  for (const auto integrator : {IntegratorName::whitted, IntegratorName::path}) {
    const double bright = light_below({}, integrator);
    EXPECT_GT(bright, 0.1);
    for (int i = 0; i < 10; ++i) {
      std::vector<Principled> panes;
      double left = 1;
      for (int k = random.whole(1, 5); k > 0; --k) {
        const double alpha = random.unit();
        panes.push_back(glowing({}, alpha));
        left *= 1 - alpha;
      }
      EXPECT_NEAR(light_below(panes, integrator), bright * left, 2e-6);
    }
  }
}

// What is not covered passes, and of what is as much as the pane transmits.
TEST(AlphaShadow, AndWhereShadowsAreTransparentWhatThatTransmits) {
  Random random(2212);
  const double bright = light_below({}, IntegratorName::whitted);
  for (int i = 0; i < 20; ++i) {
    const double alpha = random.unit(), transmission = random.unit();
    Principled pane = glowing({}, alpha);
    pane.transmission = transmission;
    pane.thin = true;
    EXPECT_NEAR(light_below({pane}, IntegratorName::whitted, true),
                bright * (1 - alpha + alpha * transmission), 2e-6);
    EXPECT_NEAR(light_below({pane}, IntegratorName::whitted), bright * (1 - alpha), 2e-6);
  }
}

TEST(AlphaShadow, MasksCastTheirCellsAndAreBlockersThereAlone) {
  const Scene scene = floor_under({glowing({}, checkered(0, 1), AlphaMode::mask)});
  for (const auto integrator : {IntegratorName::whitted, IntegratorName::path}) {
    const Image image = seen_by(scene, integrator, 1, 1);
    for (int y = 0; y < alpha_cells; ++y)
      for (int x = 0; x < alpha_cells; ++x)
        EXPECT_EQ(image.at(x, y)[0] > 0, (x + y) % 2 == 1) << x << ' ' << y;
  }
  for (int x = 0; x < alpha_cells; ++x) {
    const auto floor = tree(scene, {x - 3.5, 1, 0.5}, {0, -1, 0});
    EXPECT_EQ(term(*floor, TermName::diffuse)->light.blocker.has_value(), x % 2 == 0) << x;
  }
}

TEST(AlphaShadow, SkyIsHiddenByAsMuchAsIsThere) {
  Scene scene = floor_under({glowing({}, 0.25)});
  EXPECT_NEAR(seen_by(scene, IntegratorName::ambient_occlusion).rgb[0], 0.75, 1e-6);
  EXPECT_NEAR(seen_by(scene, IntegratorName::shadow).rgb[0], 0.75, 1e-6);
}

// Every ray to the ball meets its surface twice: 1 - (1 - a)^2 of its light comes. A ball of
// radiance L at distance d gives what faces it the irradiance pi L (r / d)^2.
// Source: Nicodemus et al., "Geometrical considerations and nomenclature for reflectance" (1977).
TEST(AlphaLight, GlowingBallGivesWhatIsThereOfIt) {
  for (const double alpha : {0.3, 0.7}) {
    Scene scene;
    scene.camera = camera_above(1);
    scene.camera.height = 0.01;
    scene.objects = {object(plane_at(0), Finish{}),
                     wearing_principled(Sphere{{0, 4, 0}, 2}, glowing({1, 1, 1}, alpha))};
    constexpr int samples = 256, pixels = alpha_cells * alpha_cells;
    double sum = 0, square = 0;
    const Image image = seen_by(scene, IntegratorName::path, samples, 1);
    for (std::size_t k = 0; k < image.rgb.size(); k += 3)
      sum += image.rgb[k], square += double(image.rgb[k]) * image.rgb[k];
    const double mean = sum / pixels, spread = std::sqrt(square / pixels - mean * mean);
    EXPECT_NEAR(mean, (1 - (1 - alpha) * (1 - alpha)) * 0.25, 4 * spread / 8);
    // In whitted it is a light at its middle.
    expect_near(tree(scene, {0, 1, 0}, {0, -1, 0})->color, Vec3d{alpha, alpha, alpha}, 1e-6);
  }
}

}  // namespace
}  // namespace tia
