// Where path and whitted are both exact: one point light on matt surfaces, without a bounce.
#include "tests/core/integrators/paths.h"

namespace tia {
namespace {

using namespace test;

Scene matt_balls(Random& random, const Vec3d& lamp) {
  const auto color = [&] { return random.in(0.2, 1); };
  Scene scene;
  for (int i = 0; i < 6; ++i) {
    Finish finish = matt(random.in(0.3, 1));
    finish.color = {color(), color(), color()};
    scene.objects.push_back(
        object(Sphere{Vec3d{0, 0, -6} + random.point(2), random.in(0.3, 1)}, finish));
  }
  scene.objects.push_back(object(Plane{{0, -2, 0}, {0, 1, 0.2}}, matt(0.8)));
  scene.lights = {point_light(lamp, {color(), color(), color()})};
  scene.camera.fov_degrees = 50;
  return scene;
}

// What whitted takes for the light at a surface is to path an intensity, and a surface's colour
// what it scatters to all sides.
TEST(Lambert, PathIsWhittedOverPiAndTheSquareOfTheDistance) {
  Random random(917);
  constexpr int width = 32, height = 24;
  int lit = 0, apart = 0;
  for (int round = 0; round < rounds(6, 6); ++round) {
    const Vec3d lamp{random.in(-3, 3), random.in(1, 5), random.in(-4, 1)};
    const Scene scene = matt_balls(random, lamp);
    const World world = compile(scene);
    const View view = view_of(scene.camera, width, height);
    RenderOptions options;
    options.integrator = IntegratorName::path, options.max_depth = 1;
    const Image image = picture(world, view, {0, 0, width, height}, options).image;
    for (int i = 0; i < width * height; ++i) {
      const auto at = 3 * static_cast<std::size_t>(i);
      const auto told = explain(scene, world, view, i % width, i / width, 0, at_depth(0));
      const RayNode& node = *told.tree;
      const Vec3d way = lamp - world.origin - static_cast<Vec3d>(node.point);
      const Vec3d expected = static_cast<Vec3d>(node.color) * (1 / (pi * dot(way, way)));
      const Vec3d found{double(image.rgb[at]), double(image.rgb[at + 1]),
                        double(image.rgb[at + 2])};
      lit += node.color.x > 0 ? 1 : 0;
      apart += length(found - expected) > 2e-5 * length(expected) ? 1 : 0;
    }
  }
  EXPECT_GT(lit, rounds(1500, 6));
  EXPECT_LE(apart, lit / 500) << "but for the edges of shadows, where rounding decides";
}

}  // namespace
}  // namespace tia
