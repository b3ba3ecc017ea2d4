// Rays by kind: how many a picture takes is known beforehand.
#include <gtest/gtest.h>

#include "tests/core/tree.h"

namespace tia {
namespace {

using namespace test;

constexpr int pixel_columns = 37, pixel_rows = 23,
              pixel_count = pixel_columns * pixel_rows;  // no whole packets

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
Object floor_object(const Finish& finish) { return object(Plane{{0, 0, 0}, {0, 1, 0}}, finish); }
Object plate(const Finish& finish) { return object(Box{{-9, 1, -9}, {9, 2, 9}}, finish); }

RayCounts rays(const Scene& scene, int depth, Scalar scalar = Scalar::wide, int samples = 1) {
  RenderOptions options = at_depth(depth);
  options.scalar = scalar;
  options.samples = samples;
  return picture(scene, pixel_columns, pixel_rows, options).rays;
}

TEST(RayCounts, OneShadowRayForEachPlaceOfALightThatIsBeforeTheSurface) {
  Scene scene = from_above({floor_object({})});
  // Beside the view, lest the lights themselves be seen.
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
              (RayCounts{.primary = pixel_count, .shadow = pixel_count * (1 + 7 + 5)}));
    EXPECT_EQ(rays(scene, 5, scalar, 3),
              (RayCounts{.primary = 3 * pixel_count, .shadow = 3 * pixel_count * (1 + 7 + 5)}));
  }
}

TEST(RayCounts, PlateTakesTwoRefractedRaysAndWithFresnelOneMirroredAtEachFace) {
  Finish clear = glass(1.5);
  clear.fresnel = false;
  for (const Scalar scalar : {Scalar::wide, Scalar::narrow, Scalar::exact}) {
    const Scene plain = from_above({plate(clear), floor_object(dark())});
    EXPECT_EQ(rays(plain, 0, scalar), (RayCounts{.primary = pixel_count}));
    EXPECT_EQ(rays(plain, 1, scalar),
              (RayCounts{.primary = pixel_count, .refraction = pixel_count}));
    for (const int depth : {2, 5})
      EXPECT_EQ(rays(plain, depth, scalar),
                (RayCounts{.primary = pixel_count, .refraction = 2 * pixel_count}));
    // One is mirrored before the plate; inside each face primitives the ray in one that leaves and
    // one that stays. To the depth d these are d refracted and 1 + (d - 1) mirrored ones.
    const Scene parted = from_above({plate(glass(1.5)), floor_object(dark())});
    for (int depth = 1; depth <= 6; ++depth)
      EXPECT_EQ(rays(parted, depth, scalar), (RayCounts{.primary = pixel_count,
                                                        .reflection = depth * pixel_count,
                                                        .refraction = depth * pixel_count}))
          << depth;
  }
}

TEST(RayCounts, FacingMirrorsTakeOneRayForEachOrder) {
  Scene scene =
      from_above({floor_object(mirror(1)), object(Plane{{0, 9, 0}, {0, -1, 0}}, mirror(1))});
  for (const int depth : {0, 1, 2, 5, 64})
    EXPECT_EQ(rays(scene, depth),
              (RayCounts{.primary = pixel_count, .reflection = depth * pixel_count}));
  // Each point on the way also asks for its light.
  scene.lights = {point_light({0.3, 4, 0.2})};
  EXPECT_EQ(rays(scene, 4),
            (RayCounts{
                .primary = pixel_count, .shadow = 5 * pixel_count, .reflection = 4 * pixel_count}));
}

TEST(RayCounts, TotalReflectionTakesAMirroredRayInTheRefractedOnesPlace) {
  // From within, straight up and past the critical angle at the roof of a prism of 90 degrees.
  Finish clear = glass(1.5);
  clear.fresnel = false;
  const double half = std::sqrt(0.5);
  Scene scene = from_above({object(Plane{{0, 0, 0}, {half, half, 0}}, clear)});
  scene.camera.location = {-4, -4, 0};
  scene.camera.direction = Vec3d{0, 1, 0};
  EXPECT_EQ(rays(scene, 3), (RayCounts{.primary = pixel_count, .reflection = pixel_count}));
}

TEST(RayCounts, ThesisTakesNoneButPrimaryAndShadowRays) {
  Scene scene = from_above({floor_object(mirror(1)), plate(glass(1.5))});
  std::get<Finish>(std::get<Boxed<Material>>(*scene.objects[1].material)->kind).diffuse = 1;
  scene.lights = {point_light({0, 9, 0})};
  RenderOptions options;
  options.integrator = IntegratorName::thesis;
  options.max_depth = 9;
  EXPECT_EQ(picture(scene, pixel_columns, pixel_rows, options).rays,
            (RayCounts{.primary = pixel_count, .shadow = pixel_count}));
}

}  // namespace
}  // namespace tia
