// Masks: what is there where alpha reaches the cutoff, and nowhere else; and what is behind alpha
// before a backdrop.
#include <gtest/gtest.h>

#include "tests/core/integrators/alphas.h"

namespace tia {
namespace {

using namespace test;

TEST(AlphaMask, NothingIsThereWhereAlphaIsBelowTheCutoffAndAllWhereItIsNot) {
  Random random(2207);
  for (int i = 0; i < 10; ++i) {
    const double cutoff = random.in(0.05, 0.95);
    const bool at_cutoff = i % 2 == 0;
    Principled p = glowing({1, 1, 1}, {}, AlphaMode::mask);
    p.alpha_cutoff = cutoff;
    p.alpha = checkered(at_cutoff ? cutoff : random.in(cutoff, 1), random.in(0, cutoff * 0.999));
    Scene scene;
    scene.camera = camera_above(2);
    scene.objects = {wearing_principled(plane_at(0), p),
                     wearing_principled(plane_at(-3), glowing({0.5, 0.5, 0.5}))};
    const auto expect = [&](IntegratorName integrator, double there, double behind) {
      const Image image = seen_by(scene, integrator);
      for (int y = 0; y < alpha_cells; ++y)
        for (int x = 0; x < alpha_cells; ++x)
          EXPECT_NEAR(image.at(x, y)[0], (x + y) % 2 == 1 ? there : behind, 1e-5) << x << ' ' << y;
    };
    expect(IntegratorName::whitted, 1, 0.5);
    expect(IntegratorName::path, 1, 0.5);
    expect(IntegratorName::depth, 2, 5);
    expect(IntegratorName::object, 1, 2);
  }
}

// Of the checker's cells every other is there, so half of the area, whatever the place.
TEST(AlphaMask, CoversAsMuchOfAPictureAsItsCheckerHas) {
  Random random(2208);
  Principled p = glowing({1, 1, 1}, checkered(0, 1), AlphaMode::mask);
  Scene scene;
  scene.objects = {wearing_principled(plane_at(0), p)};
  scene.camera = camera_above(2);
  scene.camera.location = {random.unit(), 2, random.unit()};
  double sum = 0;
  const Image image = seen_by(scene, IntegratorName::whitted, 256);
  for (std::size_t k = 0; k < image.rgb.size(); k += 3) sum += image.rgb[k];
  EXPECT_NEAR(sum / (alpha_cells * alpha_cells), 0.5, 2e-3);
}

TEST(AlphaMask, MirrorsAndWhatIsBehindThemSeeThroughIt) {
  Scene scene;
  Principled p = glowing({1, 1, 1}, 0.25, AlphaMode::mask);
  scene.objects = {wearing_principled(plane_at(4), p), object(plane_at(0), mirror(1))};
  scene.background = {0.25, 0.5, 0.75};
  expect_near(tree(scene, {0, 2, 0}, slanted(0.3))->color, Vec3d{0.25, 0.5, 0.75}, 1e-6);
  const auto node = tree(scene, {0, 2, 0}, slanted(0.3));
  EXPECT_LT(child(*node, TermName::reflection)->hit.primitive, 0);
}

// ---- pictures before a backdrop -----------------------------------------------------------------

TEST(AlphaBackdrop, RaysThatGoStraightOnFindNoLight) {
  Scene scene;
  scene.camera = camera_above(2);
  scene.objects = {wearing_principled(plane_at(0), glowing({}, 0.5))};
  scene.lights = {light_of(QuadLight{Vec3d{-9, -2, -9}, {18, 0, 0}, {0, 0, 18}}, {1, 1, 1})};
  EXPECT_GT(seen_by(scene, IntegratorName::whitted).rgb[0], 0.1F);
  scene.backdrop = Backdrop{Color{0.25, 0.25, 0.25}};
  EXPECT_EQ(seen_by(scene, IntegratorName::whitted).rgb[0], 0);
  // By path those that pass are the backdrop's, half of them.
  double sum = 0;
  const Image image = seen_by(scene, IntegratorName::path, 256);
  for (std::size_t k = 0; k < image.rgb.size(); k += 3) sum += image.rgb[k];
  EXPECT_NEAR(sum / (alpha_cells * alpha_cells), 0.125, 4 * 0.125 / 128);
}

}  // namespace
}  // namespace tia
