// Meshes leak no ray, neither at edges nor at vertices.
#include <gtest/gtest.h>

#include "core/accel/world/all_hits.h"
#include "tests/core/accel/meshes.h"

namespace tia {
namespace {

using namespace test;

const int rays_a_mesh = sanitized() ? 400 : 4000;

// Some way along one of the mesh's edges, at one of its ends one time in three.
Vec3d point_of_edge(const Mesh& mesh, Random& random) {
  const auto triangle = static_cast<std::size_t>(random.below(static_cast<int>(mesh.triangles())));
  const auto corner = static_cast<std::size_t>(random.below(3));
  const auto& indices = mesh.indices.values;
  const Vec3d a = place(mesh, indices[3 * triangle + corner]);
  const Vec3d b = place(mesh, indices[3 * triangle + (corner + 1) % 3]);
  return random.chance(1.0 / 3) ? a : a + (b - a) * random.unit();
}

struct Closed {
  const char* name;
  Mesh mesh;
};
std::vector<Closed> closed_meshes() {
  return {{"box", box_mesh({1, 1, 1})},
          {"flat box", box_mesh({1, 1e-3, 1})},
          {"ball", ball_mesh(3)},
          {"needles", needles(200)}};
}

// From inside, a closed mesh is hit in every direction; 4 meshes, 3 scales, with and without
// transforms, 4000 rays each: 10^5 in all, in each of the three widths.
TEST(Mesh, RaysAtEdgesAndVerticesFromInsideNeverLeak) {
  Random random(400);
  for (const Closed& closed : closed_meshes()) {
    for (const double scale : {1e-3, 1.0, 1e3}) {
      for (const bool moved : {false, true}) {
        SCOPED_TRACE(closed.name);
        TransformSteps placement;
        placement.steps = {Scale{scale}};
        if (moved)
          placement.steps = {Scale{Vec3d{2, -0.5, 0.7}}, RotateDegrees{{20, 30, 40}}, Scale{scale},
                             Translate{Vec3d{3, -4, 5} * scale}};
        Scene scene;
        scene.objects = {object_of(closed.mesh, placement)};
        const World world = compile(scene);
        const Affine map = placement.affine();
        for (int i = 0; i < rays_a_mesh / lanes<Wide>; ++i) {
          const Vec3d origin = map.point(random.point(2e-4));
          std::vector<Ray<float>> rays;
          for (int k = 0; k < lanes<Wide>; ++k) {
            const Vec3d target = map.point(point_of_edge(closed.mesh, random));
            const Ray<double> ray{origin, normalize(target - origin)};
            rays.push_back(ray_in<float>(ray));
            ASSERT_LT(hit_of(world, ray).t, infinity);
            ASSERT_LT(hit_of(world, rays.back()).t, infinity);
          }
          const Hit<Wide> hits = hit_of(world, test::packed(rays));
          for (int k = 0; k < lanes<Wide>; ++k) {
            const Hit<float> alone = hit_of(world, rays[static_cast<std::size_t>(k)]);
            ASSERT_EQ(test::all_of(lane_of(hits, k)), test::all_of(alone));
          }
        }
      }
    }
  }
}

// From outside, a ray at an edge that faces it meets the near side: not later than the edge. Along
// the axes too, where coordinates across the ray are whole numbers.
TEST(Mesh, RaysAtEdgesAndVerticesFromOutsideNeverPassThroughTheNearSide) {
  Random random(401);
  for (const Closed& closed : closed_meshes()) {
    SCOPED_TRACE(closed.name);
    Scene scene;
    scene.objects = {object_of(closed.mesh)};
    const World world = compile(scene);
    for (int i = 0; i < rays_a_mesh; ++i) {
      const Vec3d target = point_of_edge(closed.mesh, random);
      // Towards a point well inside, through the edge: all that is seen faces the ray.
      const Vec3d within = random.point(2e-4);
      const Vec3d origin = target + (target - within) * random.in(0.5, 5);
      const Ray<double> ray{origin, normalize(within - origin)};
      const double t = length(target - origin);
      ASSERT_LE(hit_of(world, ray).t, t * (1 + 1e-9));
      ASSERT_LE(double(hit_of(world, ray_in<float>(ray)).t), t * (1 + 1e-3));
    }
  }
}

TEST(Mesh, AxisParallelRayThroughAVertexHits) {
  Scene scene;
  scene.objects = {object_of(ball_mesh(2))};
  const World world = compile(scene);
  for (const Vec3d& way : {Vec3d{1, 0, 0}, Vec3d{0, 1, 0}, Vec3d{0, 0, 1}})
    for (const double sign : {-1.0, 1.0}) {
      const Ray<double> ray{way * (sign * 5), way * -sign};
      EXPECT_EQ(hit_of(world, ray).t, 4);
      EXPECT_EQ(hit_of(world, ray_in<float>(ray)).t, 4);
      EXPECT_EQ(hit_of(world, Ray<double>{{0, 0, 0}, way * sign}).t, 1);
    }
}

TEST(Mesh, EdgeThatTwoTrianglesShareIsOneCrossingOfAll) {
  Scene scene;
  scene.objects = {object_of(box_mesh({1, 1, 1}))};
  const World world = compile(scene);
  // Through both diagonals' middles, along z.
  const auto hits = all_hits(world, {{0, 0, 5}, {0, 0, -1}});
  ASSERT_EQ(hits.size(), 2U);
  EXPECT_EQ(hits[0].t, 4);
  EXPECT_EQ(hits[1].t, 6);
  EXPECT_EQ(hits[0].normal, (Vec3d{0, 0, 1}));
  EXPECT_TRUE(hits[0].front);
  EXPECT_FALSE(hits[1].front);
}

}  // namespace
}  // namespace tia
