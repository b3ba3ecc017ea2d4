// Meshes far larger than what is seen of them: float keeps their places to some 1e-7 of their size,
// and what that leaves open is settled in double.
#include <gtest/gtest.h>

#include "tests/core/accel/worlds.h"

namespace tia {
namespace {

using test::object_of;
using test::Random;

// The picture of a ground that a point light and a ball's shadow fall on, seen from 1.7 above it.
Image ground_picture(Object ground) {
  Scene scene;
  ground.material = Material{};
  scene.objects.push_back(std::move(ground));
  scene.objects.push_back(object_of(Sphere{{-0.3, 0.5, -3}, 0.5}));
  scene.lights.push_back(test::point_light({2.5, 6, -1}));
  scene.camera.location = {0.3, 1.7, 0.2};
  scene.camera.look_at = Vec3d{0, 0.2, -4};
  return test::picture(scene, 96, 72).image;
}

Object ground_quad(const Vec3d& middle, double half, double scale) {
  Mesh mesh;
  const Vec3d corners[] = {{-half, 0, -half}, {half, 0, -half}, {half, 0, half}, {-half, 0, half}};
  for (const Vec3d& corner : corners) {
    const Vec3d p = (middle + corner) * (1 / scale);
    mesh.positions.values.insert(mesh.positions.values.end(), {p.x, p.y, p.z});
  }
  mesh.indices.values = {0, 2, 1, 0, 3, 2};
  TransformSteps placement;
  placement.steps = {Scale{scale}};
  Object object = object_of(mesh);
  object.transform = placement;
  return object;
}

// How many pixels differ by more than a code; the ends of both are far apart at the horizon.
int differing_pixels(const Image& a, const Image& b) {
  int different = 0;
  for (int y = 24; y < a.height; ++y)
    for (int x = 0; x < a.width; ++x)
      different += std::fabs(a.at(x, y)[0] - b.at(x, y)[0]) > 1 / 255.0F;
  return different;
}

TEST(LargeMesh, GroundIsLitAndShadowedAsAPlaneIs) {
  const Image plane = ground_picture(object_of(Plane{{0, 0, 0}, {0, 1, 0}}));
  for (const double half : {20.0, 1e3, 1e4, 1e5}) {
    for (const double scale : {1.0, half}) {
      const Image mesh = ground_picture(ground_quad({0, 0, 0}, half, scale));
      EXPECT_LE(differing_pixels(mesh, plane), 2) << half << " " << scale;
    }
  }
}

// A tile below the eye, in a mesh whose other triangles are high above.
TEST(LargeMesh, TileFarFromItsMeshsMiddleIsLitAsAPlaneIs) {
  const Image plane = ground_picture(object_of(Plane{{0, 0, 0}, {0, 1, 0}}));
  Object object = ground_quad({0, 0, 0}, 20, 1);
  Mesh& mesh = std::get<Mesh>(object.shape);
  mesh.positions.values.insert(mesh.positions.values.end(), {0, 900, 0, 5, 901, 0, 0, 902, 5});
  mesh.indices.values.insert(mesh.indices.values.end(), {4, 5, 6});
  EXPECT_LE(differing_pixels(ground_picture(object), plane), 2);
}

// What is settled late must not let the order decide in which things are tried: balls that touch
// the ground and a second ground within what float tells apart, by packets, ray by ray, and by
// brute force.
TEST(LargeMesh, IsMetAlikeInWhateverOrderThingsAreTried) {
  Random random(420);
  for (const double half : {100.0, 1e4}) {
    Scene scene;
    scene.objects.push_back(ground_quad({0, 0, 0}, half, 1));
    scene.objects.push_back(ground_quad({0, half * 1e-8, 0}, half, half));
    for (int i = 0; i < 30; ++i) {
      const Vec3d at = random.point(3);
      scene.objects.push_back(object_of(Sphere{{at.x, 0.2, at.z}, 0.2 * random.in(1, 1 + 1e-6)}));
    }
    const World world = compile(scene), brute = test::without_index(world);
    for (int i = 0; i < 300; ++i) {
      std::vector<Ray<float>> rays;
      const Vec3d eye = random.point(2) + Vec3d{0, 2, 0};
      for (std::size_t k = 0; k < Wide::size; ++k) {
        const Vec3d target = random.point(i % 2 == 0 ? 0.3 : 3);
        rays.push_back(test::ray_in<float>(
            Ray<double>{eye, normalize(Vec3d{target.x, -0.01, target.z} - eye)}));
      }
      const Hit<Wide> wide = test::hit_of(world, test::packed(rays));
      for (int k = 0; k < lanes<Wide>; ++k) {
        const Ray<float>& ray = rays[static_cast<std::size_t>(k)];
        const auto expected = test::all_of(test::hit_of(brute, ray));
        ASSERT_EQ(test::all_of(test::hit_of(world, ray)), expected) << half << " " << i << " " << k;
        ASSERT_EQ(test::all_of(test::lane_of(wide, k)), expected) << half << " " << i << " " << k;
      }
    }
  }
}

}  // namespace
}  // namespace tia
