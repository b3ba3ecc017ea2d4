// What ends and what darkens paths, and how both are told.
#include "tests/core/integrators/paths.h"

namespace tia {
namespace {

using namespace test;

Picture traced(const Scene& scene, int max_depth, double clamp = Rules{}.clamp) {
  RenderOptions options;
  options.integrator = IntegratorName::path;
  options.max_depth = max_depth, options.samples = 8, options.clamp = clamp;
  return picture(scene, 8, 6, options);
}

// In a closed ball that sends light on every path goes on until it is cut; where nothing sends it
// on, none does, and none is cut where paths leave.
TEST(PathLimits, CutPathsAreCounted) {
  Scene scene;
  scene.objects = {object(Sphere{{0, 0, 0}, 3}, glowing(1, 0.5))};
  EXPECT_EQ(traced(scene, 3).rays.cut, 8 * 6 * 8);
  scene.objects = {object(Sphere{{0, 0, 0}, 3}, glowing(1))};
  EXPECT_EQ(traced(scene, 0).rays.cut, 0);
  scene.objects = {object(Plane{{0, 0, -5}, {0, 0, 1}}, matt(0.5))};
  EXPECT_EQ(traced(scene, 1).rays.cut, 0);
  EXPECT_EQ(traced(scene, 0).rays.cut, 8 * 6 * 8);
  // Fog cuts what it would have scattered, too: all that never comes through.
  scene.objects.clear();
  scene.fog = Fog{1, {0.9, 0.9, 0.9}, 0, {}};
  EXPECT_EQ(traced(scene, 2).rays.cut, 8 * 6 * 8);
}

TEST(PathLimits, ClampDarkensSamplesAndKeepsTheirColour) {
  Scene scene;
  Finish lamp = glowing(1);
  lamp.emission = {4, 2, 1};
  scene.objects = {object(Sphere{{0, 0, -5}, 1}, lamp)};
  scene.background = {0.25, 0.5, 0.125};
  const Image free = traced(scene, 2).image, narrow = traced(scene, 2, 1).image;
  EXPECT_EQ(bits_of(free), bits_of(traced(scene, 2, 4).image));
  const std::size_t middle = 3 * (3 * 8 + 4);
  EXPECT_EQ(free.rgb[middle], 4);
  EXPECT_EQ(narrow.rgb[middle], 1);
  EXPECT_EQ(narrow.rgb[middle + 1], 0.5F);
  EXPECT_EQ(narrow.rgb[middle + 2], 0.25F);
  EXPECT_EQ(narrow.rgb[0], 0.25F);
}

}  // namespace
}  // namespace tia
