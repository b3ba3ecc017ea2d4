// Rays by kind: how many a picture takes is known beforehand.
#include <gtest/gtest.h>

#include "tests/core/tree.h"

namespace tia {
namespace {

using namespace test;

constexpr int width = 37, height = 23, pixels = width * height;  // no whole packets

// Seen straight from above, all of it.
Scene from_above(const std::vector<Object>& objects) {
  Scene scene;
  scene.camera.projection = Projection::orthographic;
  scene.camera.height = 2;
  scene.camera.location = {0, 5, 0};
  scene.camera.direction = Vec3d{0, -1, 0};
  scene.camera.up = {0, 0, -1};
  scene.objects = objects;
  return scene;
}
Object floor_of(const Finish& finish) { return object(Plane{{0, 0, 0}, {0, 1, 0}}, finish); }
Object plate(const Finish& finish) { return object(Box{{-9, 1, -9}, {9, 2, 9}}, finish); }

RayCounts rays(const Scene& scene, int depth, Scalar scalar = Scalar::wide, int samples = 1) {
  RenderOptions options = at_depth(depth);
  options.scalar = scalar;
  options.samples = samples;
  return picture(scene, width, height, options).rays;
}

TEST(RayCounts, OneShadowRayForEachPlaceOfALightThatIsBeforeTheSurface) {
  Scene scene = from_above({floor_of({})});
  // Beside the view, lest the lamps themselves be seen.
  Light soft = sphere_light({20, 4, 0}, 0.1), quad;
  std::get<SphereLight>(soft.kind).samples = 7;
  QuadLight shape;
  shape.corner = Vec3d{-20, 3, 0};
  shape.u = {1, 0, 0};
  shape.v = {0, 0, 1};
  shape.samples = 5;
  quad.kind = shape;
  scene.lights = {point_light({3, 3, 3}), point_light({3, -3, 3}), soft, quad};
  for (const Scalar scalar : {Scalar::wide, Scalar::narrow, Scalar::exact}) {
    EXPECT_EQ(rays(scene, 5, scalar),
              (RayCounts{.primary = pixels, .shadow = pixels * (1 + 7 + 5)}));
    EXPECT_EQ(rays(scene, 5, scalar, 3),
              (RayCounts{.primary = 3 * pixels, .shadow = 3 * pixels * (1 + 7 + 5)}));
  }
}

TEST(RayCounts, PlateTakesTwoRefractedRaysAndWithFresnelOneMirroredAtEachFace) {
  Finish clear = glass(1.5);
  clear.fresnel = false;
  for (const Scalar scalar : {Scalar::wide, Scalar::narrow, Scalar::exact}) {
    const Scene plain = from_above({plate(clear), floor_of(dark())});
    EXPECT_EQ(rays(plain, 0, scalar), (RayCounts{.primary = pixels}));
    EXPECT_EQ(rays(plain, 1, scalar), (RayCounts{.primary = pixels, .refraction = pixels}));
    for (const int depth : {2, 5})
      EXPECT_EQ(rays(plain, depth, scalar),
                (RayCounts{.primary = pixels, .refraction = 2 * pixels}));
    // One is mirrored before the plate; inside each face parts the ray in one that leaves and one
    // that stays. To the depth d these are d refracted and 1 + (d - 1) mirrored ones.
    const Scene parted = from_above({plate(glass(1.5)), floor_of(dark())});
    for (int depth = 1; depth <= 6; ++depth)
      EXPECT_EQ(rays(parted, depth, scalar),
                (RayCounts{
                    .primary = pixels, .reflection = depth * pixels, .refraction = depth * pixels}))
          << depth;
  }
}

TEST(RayCounts, FacingMirrorsTakeOneRayForEachOrder) {
  Scene scene = from_above({floor_of(mirror(1)), object(Plane{{0, 9, 0}, {0, -1, 0}}, mirror(1))});
  for (const int depth : {0, 1, 2, 5, 64})
    EXPECT_EQ(rays(scene, depth), (RayCounts{.primary = pixels, .reflection = depth * pixels}));
  // Each point on the way also asks for its light.
  scene.lights = {point_light({0.3, 4, 0.2})};
  EXPECT_EQ(rays(scene, 4),
            (RayCounts{.primary = pixels, .shadow = 5 * pixels, .reflection = 4 * pixels}));
}

TEST(RayCounts, TotalReflectionTakesAMirroredRayInTheRefractedOnesPlace) {
  // From within, straight up and past the critical angle at the roof of a prism of 90 degrees.
  Finish clear = glass(1.5);
  clear.fresnel = false;
  const double half = std::sqrt(0.5);
  Scene scene = from_above({object(Plane{{0, 0, 0}, {half, half, 0}}, clear)});
  scene.camera.location = {-4, -4, 0};
  scene.camera.direction = Vec3d{0, 1, 0};
  EXPECT_EQ(rays(scene, 3), (RayCounts{.primary = pixels, .reflection = pixels}));
}

TEST(RayCounts, ThesisTakesNoneButPrimaryAndShadowRays) {
  Scene scene = from_above({floor_of(mirror(1)), plate(glass(1.5))});
  std::get<Finish>(std::get<Material>(*scene.objects[1].material).kind).diffuse = 1;
  scene.lights = {point_light({0, 9, 0})};
  RenderOptions options;
  options.integrator = IntegratorName::thesis;
  options.max_depth = 9;
  EXPECT_EQ(picture(scene, width, height, options).rays,
            (RayCounts{.primary = pixels, .shadow = pixels}));
}

}  // namespace
}  // namespace tia
